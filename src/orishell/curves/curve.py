"""Planar parametric curves with exact first and second derivatives."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from orishell.curves.formula import Formula
from orishell.curves.jets import Array
from orishell.errors import CurveError

CurveJet = Callable[[Array], tuple[Array, Array, Array]]
"""Position, first and second derivative, each (..., 2), at parameters (...)."""


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """A planar curve t -> (x(t), y(t)) on [start, stop].

    Parameters
    ----------
    jet
        Position, first and second derivative, each (..., 2), at parameters (...).
    start, stop
        The range of the parameter, start < stop.
    breaks
        Parameters strictly inside the range where the tangent may jump (the corners of a
        polyline), increasing. There the derivatives are those of the later side.
    """

    jet: CurveJet
    start: float
    stop: float
    breaks: tuple[float, ...] = ()

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
        """The same points, run through from stop to start."""
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

        return type(self)(jet, self.start, self.stop, breaks)

    def scaled(self, factor: float) -> Self:
        """The curve enlarged about the origin by ``factor`` > 0."""

        def jet(t: Array) -> tuple[Array, Array, Array]:
            position, first, second = self.jet(t)
            return position * factor, first * factor, second * factor

        return type(self)(jet, self.start, self.stop, self.breaks)

    def rotated(self, angle: float) -> Self:
        """The curve turned counter-clockwise about the origin by ``angle`` (radians)."""
        cos, sin = np.cos(angle), np.sin(angle)
        turn = np.array([[cos, sin], [-sin, cos]])

        def jet(t: Array) -> tuple[Array, Array, Array]:
            position, first, second = self.jet(t)
            return position @ turn, first @ turn, second @ turn

        return type(self)(jet, self.start, self.stop, self.breaks)


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
        If the range is empty, reversed or not finite, or the two formulas name different variables.
    """
    names = {formula.variable for formula in (x, y) if formula is not None} - {None}
    if len(names) > 1:
        raise CurveError(
            "x(t) and y(t) have different variables",
            got=" and ".join(sorted(repr(name) for name in names)),
            expected="one variable",
        )

    def jet(t: Array) -> tuple[Array, Array, Array]:
        t = np.asarray(t, dtype=np.float64)
        across = x.jet(t) if x is not None else (t, np.ones_like(t), np.zeros_like(t))
        along = y.jet(t)
        position, first, second = (
            np.stack(np.broadcast_arrays(u, v), axis=-1) for u, v in zip(across, along, strict=True)
        )
        return position, first, second

    return Curve(jet, float(start), float(stop))


def curve_from_points(points: ArrayLike, *, smooth: bool) -> Curve:
    """Curve through points (N, 2) in their order, N at least 2.

    The parameter is the chord length from the first point. ``smooth`` gives the cubic spline
    (twice continuously differentiable, not-a-knot ends), otherwise the polyline itself.

    Parameters
    ----------
    points
        Points (N, 2) in their order.
    smooth
        Whether a spline goes through them; else the polyline.

    Raises
    ------
    CurveError
        If there are fewer than two points, a coordinate is not finite, or two successive points
        coincide.
    """
    array = np.asarray(points, dtype=np.float64)
    if array.ndim != 2 or array.shape[1] != 2 or len(array) < 2:
        raise CurveError("too few points for a curve", got=f"{len(array)}", expected="at least 2")
    if not np.isfinite(array).all():
        row = int(np.argmin(np.isfinite(array).all(axis=1)))
        raise CurveError("a point is not finite", where=f"point {row + 1}", got=str(array[row]))
    chords = np.hypot(*np.diff(array, axis=0).T)
    knots = np.concatenate([[0.0], np.cumsum(chords)])
    smallest = 1e-12 * np.ptp(array, axis=0).max()
    apart = (chords > smallest) & (np.diff(knots) > 0)
    if not apart.all():
        row = int(np.argmin(np.where(apart, np.inf, chords)))
        raise CurveError(
            "two successive points coincide",
            where=f"points {row + 1} and {row + 2}",
            got=f"({array[row, 0]:g}, {array[row, 1]:g})",
            remedy="remove one of them",
        )
    return _spline(knots, array) if smooth and len(array) > 2 else _polyline(knots, array)


def _spline(knots: Array, points: Array) -> Curve:
    from scipy.interpolate import CubicSpline

    # Of the size of 1, or the system behind a spline is singular in very large units; a power of
    # two, so that not a bit is lost.
    unit = np.exp2(np.round(np.log2(knots[-1])))
    spline = CubicSpline(knots / unit, points)

    def jet(t: Array) -> tuple[Array, Array, Array]:
        s = t / unit
        return spline(s), spline(s, 1) / unit, spline(s, 2) / unit**2

    return Curve(jet, 0.0, float(knots[-1]))


def _polyline(knots: Array, points: Array) -> Curve:
    slopes = np.diff(points, axis=0) / np.diff(knots)[:, None]
    last = len(slopes) - 1

    def jet(t: Array) -> tuple[Array, Array, Array]:
        cell: NDArray[np.intp] = np.clip(np.searchsorted(knots, t, side="right") - 1, 0, last)
        position = points[cell] + (t - knots[cell])[..., None] * slopes[cell]
        position = np.where((t == knots[-1])[..., None], points[-1], position)
        first = slopes[cell]
        return position, first, np.zeros_like(first)

    return Curve(jet, 0.0, float(knots[-1]), tuple(knots[1:-1].tolist()))
