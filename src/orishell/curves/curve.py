"""Planar parametric curves with exact first and second derivatives."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from numbers import Real
from typing import Literal, Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.errors import CurveError
from orishell.conventions.formatting import rounded
from orishell.conventions.record import record
from orishell.curves.formula import Formula
from orishell.curves.radians import note_degrees, require_radians
from orishell.numerics import Enclosure
from orishell.numerics.arrays import Array

CurveJet = Callable[[Array], tuple[Array, Array, Array]]
"""Position, first and second derivative, each (..., 2), at parameters (...)."""
CurveEnclosure = Callable[[Array, Array], tuple[Enclosure, Enclosure]]
"""Bounds of x and y and their derivatives between parameters ``low`` and ``high`` (S,)."""
Scale: TypeAlias = float | tuple[float, float]
"""A factor of size, or one along x and one along y."""

END = 1e-5
"""An end of a part that lies beyond the curve's by up to this share of its range is the curve's."""


@record
class Curve:
    """A planar curve t -> (x(t), y(t)) on [start, stop]."""

    jet: CurveJet  # position, first and second derivative, each (..., 2), at parameters (...)
    # bounds of these between parameters ``low`` and ``high`` (S,), x and y; no break lies inside
    enclosure: CurveEnclosure
    # the range of the parameter, start < stop
    start: float
    stop: float
    # Parameters strictly inside the range where the tangent may jump (the corners of a polyline),
    # increasing. There the derivatives are those of the later side.
    breaks: tuple[float, ...] = ()
    # the key of the design file that takes a part of the curve by its parameters as drawn
    key: Literal["range", "part"] = "part"
    # A parameter, what it is on the curve as drawn, and 1 or -1: what the latter grows by with t
    drawn: tuple[float, float, float] = (0.0, 0.0, 1.0)
    # how much the curve has been enlarged along x and y since it was drawn
    scale: tuple[float, float] = (1.0, 1.0)
    notes: tuple[str, ...] = ()  # what is to be said of how it was read

    def __post_init__(self) -> None:
        for name, value in (("start", self.start), ("stop", self.stop)):
            if not np.isfinite(value):
                raise CurveError(
                    f"the {name} is not a finite number", where="range", got=str(value)
                )
        if not self.start < self.stop:
            raise CurveError(
                "the range is empty" if self.start == self.stop else "the range is reversed",
                where="range",
                got=f"[{self.start:g}, {self.stop:g}]",
                expected="the smaller value first",
                remedy=f"write [{self.stop:g}, {self.start:g}]" if self.start != self.stop else "",
            )

    def __repr__(self) -> str:
        first, last = (
            "({:.6g}, {:.6g})".format(*self.position(t)) for t in (self.start, self.stop)
        )
        count = len(self.breaks)
        broken = f", {count} corner{'s' * (count > 1)}" if count else ""
        span = f"{self.start:.6g} to {self.stop:.6g}"
        return f"{type(self).__name__}(from {first} to {last}, parameter {span}{broken})"

    def position(self, t: ArrayLike) -> Array:
        """Points (..., 2) at parameters t (...)."""
        return self.jet(np.asarray(t, dtype=np.float64))[0]

    def tangent(self, t: ArrayLike) -> Array:
        """Unit tangents (..., 2) at parameters t (...)."""
        first = self.jet(np.asarray(t, dtype=np.float64))[1]
        unit: Array = first / np.hypot(first[..., 0], first[..., 1])[..., None]
        return unit

    def curvature(self, t: ArrayLike) -> Array:
        """Signed curvature (...) at parameters t (...), in 1/length, positive to the left."""
        _, first, second = self.jet(np.asarray(t, dtype=np.float64))
        cross = first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]
        curvature: Array = cross / np.hypot(first[..., 0], first[..., 1]) ** 3
        return curvature

    def reversed(self) -> Self:
        """The curve, run through from stop to start."""
        total = self.start + self.stop
        breaks = tuple(total - t for t in self.breaks[::-1])
        ends = np.array([self.start, *self.breaks, self.stop])

        def jet(t: Array) -> tuple[Array, Array, Array]:
            back = total - t
            if breaks:  # the later side of a break is the earlier side of what is reversed
                cell = len(breaks) - np.searchsorted(breaks, t, side="right")
                latest = np.nextafter(ends[cell + 1], -np.inf)
                back = np.clip(back, ends[cell], np.where(t > self.start, latest, back))
            position, first, second = self.jet(back)
            return position, -first, second

        def enclosure(low: Array, high: Array) -> tuple[Enclosure, Enclosure]:
            x, y = self.enclosure(total - high, total - low)
            return x.mirrored(), y.mirrored()

        drawn = self.start, float(self.as_drawn(self.stop)), -self.drawn[2]
        return replace(self, jet=jet, enclosure=enclosure, breaks=breaks, drawn=drawn)

    def part(self, first: float, last: float) -> Self:
        """The part of the curve between two parameters, with unchanged parameter.

        Parameters
        ----------
        first, last
            Its ends, first < last; rounded a little beyond the curve's, they are the curve's.

        Raises
        ------
        CurveError
            If it is empty, reversed or not within the curve.
        """
        whole = f"[{self.start:.10g}, {self.stop:.10g}]"
        got = f"[{first:.10g}, {last:.10g}]"
        slack = END * (self.stop - self.start)
        if not first < last:
            what = "the part is empty" if first == last else "the part is reversed"
            expected = f"the smaller value first, within {whole}"
        elif not (first >= self.start - slack and last <= self.stop + slack):
            what, expected = "the part reaches beyond the curve", f"values within {whole}"
        else:
            start, stop = max(first, self.start), min(last, self.stop)
            inner = tuple(t for t in self.breaks if start < t < stop)
            return replace(self, start=start, stop=stop, breaks=inner)
        raise CurveError(what, where="part", got=got, expected=expected)

    def as_drawn(self, t: ArrayLike) -> Array:
        """The parameters (...) that t (...) have on the curve as it was drawn, for messages."""
        at, drawn, way = self.drawn
        return drawn + way * (np.asarray(t, dtype=np.float64) - at)

    def drawn_part(self, first: float, last: float) -> tuple[float, float]:
        """Ends ``first`` and ``last`` of a part as parameters of ``key``, the smaller one first."""
        low, high = sorted(float(self.as_drawn(t)) for t in (first, last))
        return low, high

    def part_of_drawn(self, first: float, last: float) -> Self:
        """The part between ``first`` and ``last``, parameters of ``key``: of the curve as drawn."""
        at, drawn, way = self.drawn
        return self.part(*sorted(at + way * (t - drawn) for t in (first, last)))

    def scaled(self, factor: Scale) -> Self:
        """The curve enlarged about the origin by ``factor`` > 0, or by a pair along x and y."""
        along_x, along_y = factor if isinstance(factor, tuple) else (factor, factor)
        factors = np.array([along_x, along_y])
        scaled = self._mapped(
            lambda position, first, second: (position * factors, first * factors, second * factors),
            lambda x, y: (x.times(along_x), y.times(along_y)),
        )
        return replace(scaled, scale=(self.scale[0] * along_x, self.scale[1] * along_y))

    def scale_times(self, share: float) -> float | list[float]:
        """What the key ``scale`` says where the curve is to be ``share`` times as large."""
        along_x, along_y = (rounded(share * each) for each in self.scale)
        return along_x if along_x == along_y else [along_x, along_y]

    def shifted(self, offset: Array) -> Self:
        """The curve moved by a vector (2,) in its unit, ``offset``."""
        return self._mapped(
            lambda position, first, second: (position + offset, first, second),
            lambda x, y: (x.plus(offset[0]), y.plus(offset[1])),
        )

    def rotated(self, angle: float) -> Self:
        """The curve turned counter-clockwise about the origin by ``angle`` (radians)."""
        cos, sin = np.cos(angle), np.sin(angle)
        turn = np.array([[cos, sin], [-sin, cos]])
        return self._mapped(
            lambda position, first, second: (position @ turn, first @ turn, second @ turn),
            lambda x, y: (x.times(cos) - y.times(sin), x.times(sin) + y.times(cos)),
        )

    def _mapped(
        self,
        jet: Callable[[Array, Array, Array], tuple[Array, Array, Array]],
        boxes: Callable[[Enclosure, Enclosure], tuple[Enclosure, Enclosure]],
    ) -> Self:
        """The curve under a map of its points and derivatives, and of their bounds."""
        return replace(
            self,
            jet=lambda t: jet(*self.jet(t)),
            enclosure=lambda low, high: boxes(*self.enclosure(low, high)),
        )


def curve_from_formulas(x: Formula | None, y: Formula, start: float, stop: float) -> Curve:
    """Curve from formulas: (x(t), y(t)), or the graph of y if ``x`` is None.

    Parameters
    ----------
    x, y
        Coordinates as formulas of one variable, in the unit of the curve; None for ``x`` if it is
        the variable itself.
    start, stop
        Range of the variable.

    Raises
    ------
    CurveError
        If the range is empty, reversed, not finite or in degrees, or the two formulas name
        different variables.
    """
    for name, value, kind in (
        ("x", x, Formula | None),
        ("y", y, Formula),
        ("start", start, Real),
        ("stop", stop, Real),
    ):
        if not isinstance(value, kind):
            raise CurveError(
                "this value does not fit",
                where=f"curve_from_formulas: {name}",
                got=repr(value)[:60],
                expected="a number" if kind is Real else "a formula, which parse_formula makes",
            )
    names = {formula.variable for formula in (x, y) if formula is not None} - {None}
    if len(names) > 1:
        raise CurveError(
            "x(t) and y(t) have different variables",
            got=" and ".join(sorted(repr(name) for name in names)),
            expected="one variable",
        )

    def jet(t: Array) -> tuple[Array, Array, Array]:
        t = np.asarray(t, dtype=np.float64)
        both = np.empty((3, *t.shape, 2))
        for out, u, v in zip(both, (t, 1.0, 0.0) if x is None else x.jet(t), y.jet(t), strict=True):
            out[..., 0], out[..., 1] = u, v
        return both[0], both[1], both[2]

    def enclosure(low: Array, high: Array) -> tuple[Enclosure, Enclosure]:
        across = Enclosure.variable(low, high) if x is None else x.enclosure(low, high)
        return across, y.enclosure(low, high)

    texts = [y.text] if x is None else [x.text, y.text]
    notes = [note for text in texts for note in note_degrees(text, float(start), float(stop))]
    curve = Curve(jet, enclosure, float(start), float(stop), key="range", notes=tuple(notes[:1]))
    require_radians(jet, curve.start, curve.stop)
    return curve
