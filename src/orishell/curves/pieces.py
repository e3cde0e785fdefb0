"""Pieces that drawings are made of: straight lines, Bezier curves, elliptical arcs, NURBS.

All are exact, and stay so under affine maps: a circle is an arc, not a Bezier curve near it.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.errors import CurveError
from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers

MAX_PIECES = 50_000
"""Most pieces that a drawing may have."""
SIMPLIFY = "draw it with fewer points (Path > Simplify in Inkscape, Rebuild in Rhino)"
MAX_DEGREE = 11
"""Highest degree of a NURBS."""
FLATTEST_BULGE = 1e-9
"""An arc with a smaller bulge is a straight line but for rounding."""


@record
class Affine:
    """A map of the plane: points (..., 2) as rows go to ``points @ matrix + offset``."""

    matrix: Array
    offset: Array

    @classmethod
    def of(cls, *numbers: float) -> Affine:
        """From a, b, c, d, e, f the map x' = a x + c y + e, y' = b x + d y + f, as in SVG."""
        rows = np.reshape(np.array(numbers, dtype=np.float64), (3, 2))
        return cls(rows[:2], rows[2])

    def after(self, inner: Affine) -> Affine:
        """First ``inner``, then this."""
        return Affine(inner.matrix @ self.matrix, inner.offset @ self.matrix + self.offset)


@record
class Bezier:
    """A Bezier curve on [0, 1], rational or not; of degree 1, a straight line."""

    control: Array  # control points (degree + 1, 3) as weight times x, weight times y, weight

    @property
    def reach(self) -> float:
        """The largest of its numbers, which bounds its coordinates if its weights are 1."""
        return float(np.abs(self.control).max())

    def transformed(self, affine: Affine) -> Bezier:
        """The curve under an affine map."""
        weight = self.control[:, 2:]
        plane = self.control[:, :2] @ affine.matrix + weight * affine.offset
        return Bezier(np.concatenate([plane, weight], axis=1))

    def reversed(self) -> Bezier:
        """The curve, from its last point to its first."""
        return Bezier(self.control[::-1])


@record
class Arc:
    """An elliptical arc: centre + cos(a) u + sin(a) v, the angle a running over an interval."""

    centre: Array  # centre (2,)
    axes: Array  # two conjugate half diameters u and v (2, 2), a row each
    # the angle at the beginning and what is added to it up to the end (radians)
    start: float
    sweep: float

    @property
    def reach(self) -> float:
        """The largest of its numbers: half a bound of its coordinates, at least."""
        return float(max(np.abs(self.centre).max(), np.abs(self.axes).max()))

    def transformed(self, affine: Affine) -> Arc:
        """The arc under an affine map."""
        centre = self.centre @ affine.matrix + affine.offset
        return Arc(centre, self.axes @ affine.matrix, self.start, self.sweep)

    def reversed(self) -> Arc:
        """The arc, from its last point to its first."""
        return Arc(self.centre, self.axes, self.start + self.sweep, -self.sweep)


Piece: TypeAlias = Bezier | Arc


def bezier(points: ArrayLike) -> Bezier:
    """The Bezier curve with control points (degree + 1, 2); two points give a straight line."""
    array = np.asarray(points, dtype=np.float64)
    return Bezier(np.concatenate([array, np.ones((len(array), 1))], axis=1))


def polyline(points: ArrayLike) -> list[Piece]:
    """The straight lines between successive points (N, 2)."""
    control = bezier(points).control
    return [Bezier(control[k : k + 2]) for k in range(len(control) - 1)]


def circular_arc(centre: ArrayLike, radius: float, start: float, sweep: float) -> Arc:
    """An arc of a circle; angles counter-clockwise from the x axis (radians)."""
    return Arc(np.asarray(centre, dtype=np.float64), radius * np.eye(2), start, sweep)


def bulge_arc(start: ArrayLike, end: ArrayLike, bulge: float) -> Piece:
    """The arc between two points whose sweep is four times the arctangent of ``bulge``.

    Positive bulges turn left. A bulge too flat to tell from a line gives the line.
    """
    p, q = np.asarray(start, dtype=np.float64), np.asarray(end, dtype=np.float64)
    if abs(bulge) < FLATTEST_BULGE:
        return bezier([p, q])
    half = 0.5 * (q - p)
    left = np.array([-half[1], half[0]])
    centre = 0.5 * (p + q) + (1 - bulge) * (1 + bulge) / (2 * bulge) * left
    u = p - centre
    return Arc(centre, np.array([u, [-u[1], u[0]]]), 0.0, float(4 * np.arctan(bulge)))


def nurbs(
    degree: int, knots: ArrayLike, points: ArrayLike, weights: ArrayLike | None = None
) -> list[Piece]:
    """A NURBS with knots (n + degree + 1,), control points (n, 2) and weights (n,), 1 if None.

    Returned are rational Bezier curves, one for every span between its knots.
    """
    t = np.asarray(knots, dtype=np.float64)
    plane = np.asarray(points, dtype=np.float64).reshape(-1, 2)
    w = np.ones(len(plane)) if weights is None else np.asarray(weights, dtype=np.float64)
    _require_nurbs(degree, t, plane, w)
    control = np.concatenate([plane * w[:, None], w[:, None]], axis=1)
    span: Integers = np.flatnonzero(np.diff(t) > 0)
    span = span[(span >= degree) & (span < len(plane))]
    low, high = t[span], t[span + 1]
    corners = [
        _blossom(t, control, span, [high] * k + [low] * (degree - k)) for k in range(degree + 1)
    ]
    return [Bezier(each) for each in np.stack(corners, axis=1)]


def _blossom(t: Array, control: Array, span: Integers, at: list[Array]) -> Array:
    """The polar form of a spline on each of its spans (S, 3), by de Boor's triangle."""
    degree = len(at)
    d = [control[span - degree + j] for j in range(degree + 1)]
    for r, x in enumerate(at, start=1):
        for j in range(degree, r - 1, -1):
            low, high = t[span - degree + j], t[span + 1 + j - r]
            share = ((x - low) / (high - low))[:, None]
            d[j] = (1 - share) * d[j - 1] + share * d[j]
    return d[degree]


def _require_nurbs(degree: int, knots: Array, points: Array, weights: Array) -> None:
    if not 1 <= degree <= MAX_DEGREE:
        raise CurveError(
            "this degree of a spline is not supported",
            got=str(degree)[:20],
            expected=f"a number from 1 to {MAX_DEGREE}",
            remedy="rebuild it with degree 3 (Rebuild in Rhino, SPLINEDIT in AutoCAD)",
        )
    counts = f"{len(points)} control points, {len(weights)} weights and {len(knots)} knots"
    if len(points) <= degree or len(weights) != len(points):
        raise CurveError(
            "a spline has too few control points or weights",
            got=counts,
            expected=f"at least {degree + 1} of each, equally many",
        )
    if len(knots) != len(points) + degree + 1:
        raise CurveError(
            "a spline's knots do not fit its control points",
            got=counts,
            expected=f"{len(points) + degree + 1} knots at degree {degree}",
        )
    if not (np.isfinite(knots).all() and (np.diff(knots) >= 0).all()):
        raise CurveError("a spline's knots must not decrease")
    if not knots[degree] < knots[len(points)]:
        raise CurveError("a spline's knots are all the same")
    if not (weights > 0).all():
        raise CurveError(
            "a spline's weights must be positive", got=f"{weights[np.argmin(weights > 0)]:g}"
        )
