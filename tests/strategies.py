"""Hypothesis strategies: curves, and whole requests for designs."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from hypothesis import strategies as st

from orishell.curves import (
    Curve,
    curve_from_formulas,
    curve_from_points,
    parse_formula,
    trace_curve,
)
from orishell.design import Design
from orishell.errors import DesignError
from orishell.families.orthodiagonal import design_orthodiagonal
from orishell.families.parallel_repeating import design_parallel_repeating


def graph(text: str, start: float, stop: float) -> Curve:
    return curve_from_formulas(None, parse_formula(text), start, stop)


def pair(x: str, y: str, start: float, stop: float) -> Curve:
    return curve_from_formulas(parse_formula(x), parse_formula(y), start, stop)


def numbers(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high, allow_nan=False).map(lambda x: round(x, 4))


@st.composite
def graphs(draw: st.DrawFn) -> Curve:
    """Cubics and waves, asymmetric, with and without inflections."""
    a, b, c, d = (draw(numbers(-0.5, 0.5)) for _ in range(4))
    width = draw(numbers(0.5, 4))
    start = draw(numbers(-3, 1))
    return graph(f"{a}*x + {b}*x**2 + {c}*x**3/3 + {d}*sin(2*x)", start, start + width)


@st.composite
def arcs(draw: st.DrawFn) -> Curve:
    """Parts of ellipses, run through in either direction."""
    a, b = draw(numbers(0.5, 3)), draw(numbers(0.3, 3))
    start, span = draw(numbers(-3, 3)), draw(numbers(0.2, 2.2))
    sign = draw(st.sampled_from([1, -1]))
    return pair(f"{a}*cos(t)", f"{sign * b}*sin(t)", start, start + span)


@st.composite
def points(draw: st.DrawFn, *, smooth: bool) -> Curve:
    """Splines or polylines through points that go to the right."""
    steps = draw(st.lists(numbers(0.3, 1.5), min_size=2, max_size=7))
    heights = draw(st.lists(numbers(-0.6, 0.6), min_size=len(steps) + 1, max_size=len(steps) + 1))
    x = np.concatenate([[0.0], np.cumsum(steps)])
    return curve_from_points(np.stack([x, heights], axis=-1), smooth=smooth)


@st.composite
def cycloids(draw: st.DrawFn) -> Curve:
    """Parametric curves that are no graphs of simple functions."""
    a, b, c = draw(numbers(-0.7, 0.7)), draw(numbers(-1, 1)), draw(numbers(0.3, 1.5))
    return pair(f"t + {a}*sin(t)", f"{b}*cos({c}*t)", -1.0, draw(numbers(0.5, 4)))


def curves() -> st.SearchStrategy[Curve]:
    return st.one_of(graphs(), arcs(), points(smooth=True), points(smooth=False), cycloids())


@dataclass(frozen=True)
class Request:
    """Arguments of ``design_parallel_repeating``."""

    f: Curve
    g: Curve
    options: dict[str, Any]

    def design(self) -> Design:
        return design_parallel_repeating(self.f, self.g, **self.options)

    def mended(self, error: DesignError) -> Request:
        """The request with the nearest value that the error says works."""
        options = dict(self.options)
        if match := re.search(r"scale in \[target.f\] times ([^\s,]+)", error.nearest):
            return replace(self, f=self.f.scaled(float(match[1])))
        if match := re.search(r"plane_deg between (\S+) and (\S+)$", error.nearest):
            options["plane"] = np.deg2rad(0.5 * (float(match[1]) + float(match[2])))
        elif match := re.search(r"^columns = (\d+)$", error.nearest):
            options["columns"] = int(match[1])
        elif match := re.search(r'^spacing = "curvature" with columns = (\d+)$', error.nearest):
            options["spacing"], options["columns"] = "curvature", int(match[1])
        elif match := re.search(r"^plane_deg = (\S+) with columns = (\d+)$", error.nearest):
            options["plane"], options["columns"] = np.deg2rad(float(match[1])), int(match[2])
        elif match := re.search(r"^flap between (\S+) and (\S+)$", error.nearest):
            options["flap"] = float(np.sqrt(float(match[1]) * float(match[2])))
        elif match := re.search(r"^flap = (\S+)$", error.nearest):
            options["flap"] = float(match[1])
        elif match := re.search(r"part of g from parameter (\S+) to (\S+)$", error.nearest):
            return replace(self, g=replace(self.g, start=float(match[1]), stop=float(match[2])))
        elif match := re.search(r"^xi_deg below ([^\s,]+)", error.nearest):
            options["xi"] = np.deg2rad(0.98 * float(match[1]))
        elif match := re.search(r"theta_deg between (\S+) and (\S+)$", error.nearest):
            options["theta"] = np.deg2rad(0.5 * (float(match[1]) + float(match[2])))
        else:
            raise error
        return replace(self, options=options)


@st.composite
def requests(draw: st.DrawFn) -> Request:
    """Curves that meet the paper's condition for f, any xi below the limit, any plane angle."""
    f, g = draw(curves()), draw(curves())
    g = g.scaled(draw(numbers(2, 20)))
    low, high = trace_curve(f).heading_range()
    middle = 0.5 * (low + high)
    limit = np.pi - (high - low)
    tilt = draw(numbers(-0.4, 0.4)) * limit / 2
    xi = draw(numbers(0.1, 0.95)) * (limit - 2 * abs(tilt))
    theta = tilt - (middle - np.round(middle / np.pi) * np.pi)
    options = {
        "rows": 2 * draw(st.integers(0, 12)) + 1,
        "columns": draw(st.integers(2, 24)),
        "xi": float(xi),
        "theta": float(theta),
        "plane": np.deg2rad(draw(numbers(40, 140))),
        "flap": draw(st.sampled_from(["auto", 0.05, 0.5, 0.0])),
        "flap_sides": (
            draw(st.sampled_from(["start", "end"])),
            draw(st.sampled_from(["start", "end"])),
        ),
        "spacing": draw(st.sampled_from(["curvature", "equal"])),
        "placement": draw(st.sampled_from(["inscribed", "balanced"])),
    }
    return Request(f, g, options)


def feasible_design(request: Request) -> Design:
    """The design of a request, mended as the errors say as often as needed (at most 4 times)."""
    for _ in range(4):
        try:
            return request.design()
        except DesignError as error:
            request = request.mended(error)
    return request.design()


@dataclass(frozen=True)
class OrthodiagonalRequest:
    """Arguments of ``design_orthodiagonal``."""

    f: Curve
    g: Curve
    options: dict[str, Any]

    def design(self) -> Design:
        return design_orthodiagonal(self.f, self.g, **self.options)

    def remedies(self, error: DesignError) -> list[OrthodiagonalRequest]:
        """The requests with each of the nearest values that the error says work."""
        mended = []
        for text in error.nearest.split(", or "):
            options = dict(self.options)
            remedy = text.removesuffix(' with flap = "auto"')
            if remedy != text:
                options["flap"] = "auto"
            if match := re.search(r" with depth = ([\d.e+-]+)$", remedy):
                options["depth"] = float(match[1])
                remedy = remedy[: match.start()]
            if match := re.search(r" with heading_deg = ([\d.]+)( and flap = .*)?$", remedy):
                options["heading"] = np.deg2rad(float(match[1]))
                options |= {"flap": "auto"} if match[2] else {}
                remedy = remedy[: match.start()]
            f, g = self.f, self.g
            if match := re.match(r"heading_deg between (\S+) and (\S+)$", remedy):
                mended += [
                    replace(self, options={**options, "heading": np.deg2rad(float(degrees))})
                    for degrees in match.groups()
                ]
                continue
            if match := re.match(r"(depth|flap) = (\S+)$", remedy):
                options[match[1]] = float(match[2])
            elif match := re.match(r"scale in \[target.g\] times (\S+) ", remedy):
                g = g.scaled(float(match[1]))
            elif match := re.match(r'rows = (\d+) with depth = "auto"$', remedy):
                options |= {"rows": int(match[1]), "depth": "auto"}
            elif match := re.match(r"the part of g from parameter (\S+) to (\S+) with", remedy):
                g = replace(g, start=float(match[1]), stop=float(match[2]), breaks=())
                options["heading"] = "auto"
            else:
                raise error
            mended.append(OrthodiagonalRequest(f, g, options))
        return mended

    def feasible(self) -> Design:
        """The design, mended as the errors say as often as needed (at most 4 times)."""
        request = self
        for _ in range(4):
            try:
                return request.design()
            except DesignError as error:
                request = request.remedies(error)[0]
        return request.design()


@st.composite
def orthodiagonal_requests(draw: st.DrawFn) -> OrthodiagonalRequest:
    """Any two curves, any depth and heading: most need the values that the errors name."""
    f = draw(curves())
    g = draw(curves()).scaled(draw(numbers(0.2, 3)))
    length = trace_curve(f).length
    rows = 2 * draw(st.integers(0, 12)) + 1
    side = st.sampled_from(["start", "end", "auto"])
    options = {
        "rows": rows,
        "columns": draw(st.integers(2, 24)),
        "depth": draw(st.one_of(st.just("auto"), numbers(0.1, 1).map(lambda x: x * length / rows))),
        "heading": draw(st.one_of(st.just("auto"), numbers(30, 150).map(np.deg2rad))),
        "flap": draw(st.sampled_from(["auto", 0.05, 0.5, 0.0])),
        "flap_sides": (draw(side), draw(side)),
        "spacing": draw(st.sampled_from(["curvature", "equal"])),
        "placement": draw(st.sampled_from(["inscribed", "balanced"])),
    }
    return OrthodiagonalRequest(f, g, options)
