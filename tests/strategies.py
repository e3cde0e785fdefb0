"""Hypothesis strategies: curves, and whole requests for designs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, reject
from hypothesis import strategies as st

from orishell.conventions.errors import DesignError, Remedy
from orishell.curves import (
    Curve,
    curve_from_formulas,
    curve_from_points,
    parse_formula,
    trace_curve,
)
from orishell.design import Design
from orishell.families.orthodiagonal import OrthodiagonalPattern, design_orthodiagonal
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.families.pattern import Pattern


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
    """Curves and keys of a family's function, which can be changed as the design file can."""

    make: Callable[..., Design]
    table: Callable[..., Pattern]
    f: Curve
    g: Curve
    options: dict[str, Any]

    def design(self) -> Design:
        return self.make(self.f, self.g, self.table(**self.options))

    def refusal(self) -> DesignError:
        with pytest.raises(DesignError) as caught:
            self.design()
        return caught.value

    def changed(self, remedy: Remedy) -> Request:
        """The request with other values at keys of the design file."""
        curves, options = {"f": self.f, "g": self.g}, dict(self.options)
        value: Any
        for key, value in remedy.changes.items():
            table, _, name = key.rpartition(".")
            if table == "pattern":
                options[name] = value
            else:
                curve = curves[table[-1]]
                if name == "scale":
                    changed = curve.scaled(float(str(value)) / curve.scale[0])
                else:
                    changed = curve.part_of_drawn(*value)
                curves[table[-1]] = changed
        return Request(self.make, self.table, curves["f"], curves["g"], options)

    def candidates(self, error: DesignError) -> list[Request]:
        """The requests with each change that a refusal leaves open, the family kept."""
        return [self.changed(each) for each in error.candidates if _plain(each)]

    def mended(self) -> Request:
        """The request, or what its refusals leave open, as often as needed (at most 4 times)."""
        return self._mended()[0]

    def _mended(self) -> tuple[Request, Design | None]:
        """The same, and its design if it was made on the way."""
        request, found = self, None
        for _ in range(4):
            try:
                return request, request.design() if found is None else found
            except DesignError as error:
                request, found = request._improved(error)
        return request, found

    def improved(self, error: DesignError) -> Request:
        """The first candidate with a design, or the first of all, which has another fault."""
        return self._improved(error)[0]

    def _improved(self, error: DesignError) -> tuple[Request, Design | None]:
        """The same, and its design if it has one; no more candidates are computed than needed."""
        first = None
        for remedy in filter(_plain, error.candidates):
            request = self.changed(remedy)
            try:
                return request, request.design()
            except DesignError:
                first = first or request
        if first is None:
            raise error
        return first, None

    def feasible(self) -> Design:
        """The design of the request as mended; one that stays refused is no example."""
        try:
            request, found = self._mended()
            return request.design() if found is None else found
        except DesignError:
            reject()


def parallel_repeating(f: Curve, g: Curve, **options: Any) -> Request:
    return Request(design_parallel_repeating, ParallelRepeatingPattern, f, g, options)


def orthodiagonal(f: Curve, g: Curve, **options: Any) -> Request:
    return Request(design_orthodiagonal, OrthodiagonalPattern, f, g, options)


def _plain(remedy: Remedy) -> bool:
    """Whether the family stays."""
    return not any(key.startswith("shell.") for key in remedy.changes)


@st.composite
def requests(draw: st.DrawFn) -> Request:
    """Curves that meet the paper's condition for f, any xi below the limit, any plane angle."""
    f, g = draw(curves()), draw(curves())
    g = g.scaled(draw(numbers(2, 20)))
    low, high = trace_curve(f).heading_range()
    middle = 0.5 * (low + high)
    limit = np.pi - (high - low)
    assume(limit > np.deg2rad(2))
    tilt = draw(numbers(-0.4, 0.4)) * limit / 2
    xi = draw(numbers(0.1, 0.95)) * (limit - 2 * abs(tilt))
    theta = tilt - (middle - np.round(middle / np.pi) * np.pi)
    options = {
        "rows": 2 * draw(st.integers(0, 12)) + 1,
        "columns": draw(st.integers(2, 24)),
        "xi_deg": float(np.rad2deg(xi)),
        "theta_deg": float(np.rad2deg(theta)),
        "plane_deg": draw(numbers(40, 140)),
        "flap": draw(st.sampled_from(["auto", 0.05, 0.5, 0.0])),
        "flap_side": (
            draw(st.sampled_from(["start", "end"])),
            draw(st.sampled_from(["start", "end"])),
        ),
        "spacing": draw(st.sampled_from(["curvature", "equal"])),
        "placement": draw(st.sampled_from(["inscribed", "balanced"])),
    }
    return parallel_repeating(f, g, **options)


@st.composite
def orthodiagonal_requests(draw: st.DrawFn) -> Request:
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
        "heading_deg": draw(st.one_of(st.just("auto"), numbers(30, 150))),
        "flap": draw(st.sampled_from(["auto", 0.05, 0.5, 0.0])),
        "flap_side": (draw(side), draw(side)),
        "spacing": draw(st.sampled_from(["curvature", "equal"])),
        "placement": draw(st.sampled_from(["inscribed", "balanced"])),
    }
    return orthodiagonal(f, g, **options)
