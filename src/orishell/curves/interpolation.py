"""Curves through points: splines and polylines."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.errors import CurveError
from orishell.curves.curve import Curve
from orishell.numerics import Enclosure, Interval
from orishell.numerics.arrays import Array, Integers


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
    try:
        array = np.asarray(points, dtype=np.float64)
    except (TypeError, ValueError):
        array = np.zeros(0)
    if array.ndim != 2 or array.shape[1] != 2:
        raise CurveError("these are no points", got=repr(points)[:60], expected="pairs of numbers")
    if len(array) < 2:
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

    at_knots = spline(knots / unit, 2) / unit**2

    def enclosure(low: Array, high: Array) -> tuple[Enclosure, Enclosure]:
        # Linear from knot to knot: extreme at the ends and at the knots between.
        position, first, second = jet(low)
        least, most = _extremes(at_knots, knots, low, high)
        last = jet(high)[2]
        least = np.minimum(np.minimum(second, last), least)
        most = np.maximum(np.maximum(second, last), most)
        span = Interval(np.zeros_like(low), high - low)
        found = []
        for axis in (0, 1):
            bend = Interval(least[:, axis], most[:, axis])
            slope = (bend * span).plus(first[:, axis])
            found.append(Enclosure((slope * span).plus(position[:, axis]), slope, bend))
        return found[0], found[1]

    return Curve(jet, enclosure, 0.0, float(knots[-1]))


def _extremes(values: Array, knots: Array, low: Array, high: Array) -> tuple[Array, Array]:
    """The least and largest of values (K, 2) at knots inside ranges (S, 2); infinite if none is."""
    first = np.searchsorted(knots, low, side="right")
    last = np.searchsorted(knots, high, side="left")
    spans = np.stack([first, last], axis=-1).ravel()
    none = (first >= last)[:, None]
    padded = np.concatenate([values, values[-1:]])
    least = np.minimum.reduceat(padded, spans)[::2]
    most = np.maximum.reduceat(padded, spans)[::2]
    return np.where(none, np.inf, least), np.where(none, -np.inf, most)


def _polyline(knots: Array, points: Array) -> Curve:
    slopes = np.diff(points, axis=0) / np.diff(knots)[:, None]
    last = len(slopes) - 1

    def jet(t: Array) -> tuple[Array, Array, Array]:
        cell: Integers = np.clip(np.searchsorted(knots, t, side="right") - 1, 0, last)
        position = points[cell] + (t - knots[cell])[..., None] * slopes[cell]
        position = np.where((t == knots[-1])[..., None], points[-1], position)
        first = slopes[cell]
        return position, first, np.zeros_like(first)

    def enclosure(low: Array, high: Array) -> tuple[Enclosure, Enclosure]:
        cell = np.clip(np.searchsorted(knots, 0.5 * (low + high), side="right") - 1, 0, last)
        begin, end = (points[cell] + (t - knots[cell])[:, None] * slopes[cell] for t in (low, high))
        flat = Interval(np.zeros_like(low), np.zeros_like(low))
        x, y = (
            Enclosure(Interval.between(first, second), Interval(slope, slope), flat)
            for first, second, slope in zip(begin.T, end.T, slopes[cell].T, strict=True)
        )
        return x, y

    return Curve(jet, enclosure, 0.0, float(knots[-1]), tuple(knots[1:-1].tolist()))
