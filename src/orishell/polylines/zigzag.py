"""Zigzags: polylines that follow a curve turning left and right alternately.

The ends lie on the curve, the vertices between them alternately on its two offsets at +h and -h
(h is the depth). They stand at equal steps of an integral along the curve whose density is the
cube root of curvature plus mean curvature: that evens out the angles at which the zigzag turns,
and even angles let the columns of the orthodiagonal family be shifted far before a crease
vanishes. The first and the last edge are half a step long, as steep then as the others, or more.
"""

from __future__ import annotations

from dataclasses import field

import numpy as np

from orishell.conventions.record import record
from orishell.curves import Trace
from orishell.curves.plane import normals_at
from orishell.numerics.arrays import Array, Complex
from orishell.numerics.equals import first_largest

MEAN_ANGLE = np.pi / 2
""""auto" makes the mean angle of the zigzag this: half way from a flat sheet to a closed one."""
END_STEPS = (0.5, 1.0, 1.5)
"""Lengths tried for the end edges, in steps."""
DEEPEST_SHARE = 0.9
""""auto" takes at most this share of the smallest radius of curvature."""
SHALLOWEST_STEPS = 0.05
"""The search for it begins at this depth, in mean steps along the curve."""
KEPT = 1e-6
"""A column edge must keep this share of the length that it has in column 1."""


@record
class Zigzag:
    """A polyline that is meant to turn left and right alternately at its inner vertices 1 ... m."""

    vertices: Array  # vertices (m+2, 2)
    feet: Array  # points (m+2, 2) of the curve that they belong to
    # +1 if vertex 1 lies to the left of the curve, so that the zigzag turns right there, or -1
    first: int
    depth: float  # distance h of the inner vertices from their feet, in the unit of the curve
    lengths: Array = field(init=False, repr=False)  # edge lengths (m+1,)
    # angles beta (m,) on alternating sides, below pi where it turns as meant (radians)
    angles: Array = field(init=False, repr=False)

    def __post_init__(self) -> None:
        edges = self._edges()
        turn = np.angle(edges[1:] * edges[:-1].conj())
        object.__setattr__(self, "lengths", np.abs(edges))
        object.__setattr__(self, "angles", np.pi + self.first * alternating(len(turn)) * turn)

    @property
    def axis(self) -> float:
        """Direction of the bisector t of the two edges at the middle vertex (radians)."""
        edges = self._edges()
        edges = edges / np.abs(edges)
        middle = len(edges) // 2
        return float(np.angle(edges[middle - 1] + edges[middle]))

    @property
    def is_alternating(self) -> bool:
        """Whether it turns as meant at every inner vertex and goes on along the curve."""
        along = (np.diff(self.vertices, axis=0) * np.diff(self.feet, axis=0)).sum(axis=1)
        return bool((self.angles < np.pi).all() and (along > 0).all())

    def shift_limits(self) -> tuple[float, float]:
        """How far a column may be shifted against this one: the open interval of K.

        A column is this zigzag with its edge from vertex i to i+1 (both inner) longer by
        K (T_{i+1} - T_i), T_i = tan(beta_i/2). Every edge is affine in K, so the interval in which
        all keep the share :data:`KEPT` of their length is exact; it may be infinite.
        """
        growth = np.diff(np.tan(self.angles / 2))
        length = (1 - KEPT) * self.lengths[1:-1]
        with np.errstate(divide="ignore"):
            limit = -length / growth
        low, high = limit[growth > 0], limit[growth < 0]
        return float(np.max(low, initial=-np.inf)), float(np.min(high, initial=np.inf))

    def reach(self) -> float:
        """The largest extent of g along t that the columns can follow."""
        low, high = self.shift_limits()
        return float((high - low) / np.cos(self.angles[len(self.angles) // 2] / 2))

    def _edges(self) -> Complex:
        return np.asarray(np.diff(self.vertices @ np.array([1, 1j])))


def alternating(count: int) -> Array:
    """Alternating signs (count,): 1, -1, 1 and so on.

    Parameters
    ----------
    count
        Number of signs.
    """
    return np.where(np.arange(count) % 2 == 0, 1.0, -1.0)


def place_zigzags(trace: Trace, inner: int, depth: float) -> list[Zigzag]:
    """The zigzags of a given depth that turn left and right alternately.

    Parameters
    ----------
    inner
        Number m of inner vertices, at least 1.
    depth
        Distance h of the inner vertices from the curve, in its unit.

    Returns
    -------
    list
        Of those that begin to the left and to the right with end edges of :data:`END_STEPS`, the
        ones that turn alternately, that of the widest reach first.
    """
    every = [
        place_zigzag(trace, inner, depth, first, steps) for steps in END_STEPS for first in (1, -1)
    ]
    good = [zigzag for zigzag in every if zigzag.is_alternating]
    # Rounded, so that the order does not hang on rounding where a curve is symmetric or straight.
    return sorted(good, key=lambda zigzag: -float(f"{zigzag.reach():.6g}"))


def place_zigzag(
    trace: Trace, inner: int, depth: float, first: int = 1, end_steps: float = 0.5
) -> Zigzag:
    """The zigzag that begins to the left (+1) or right (-1), its end edges so many steps long.

    Parameters
    ----------
    inner
        Number m of inner vertices, at least 1.
    depth
        Distance h of the inner vertices from the curve, in its unit.
    first
        +1 if vertex 1 lies to the left, -1 if to the right.
    end_steps
        Length of the end edges in steps.
    """
    return _offset(*_place_feet(trace, inner, end_steps), depth, first)


def smallest_radius(trace: Trace) -> tuple[float, float]:
    """Smallest radius of curvature and the parameter where it is; corners do not count.

    Both offsets of the curve at a smaller distance are regular.
    """
    curvature = np.abs(trace.turns) / np.diff(trace.arc)
    at = first_largest(curvature)
    radius = float(1 / curvature[at]) if curvature[at] > 0 else np.inf
    return radius, float(0.5 * (trace.t[at] + trace.t[at + 1]))


def choose_depth(trace: Trace, inner: int) -> float:
    """The depth at which the mean angle of the zigzags is :data:`MEAN_ANGLE`.

    Where the offsets do not exist at that depth, :data:`DEEPEST_SHARE` of the smallest radius of
    curvature.

    Parameters
    ----------
    inner
        Number m of inner vertices.
    """
    from scipy.optimize import brentq

    feet, normal = _place_feet(trace, inner, END_STEPS[0])

    def excess(depth: float) -> float:
        both = [_offset(feet, normal, depth, first).angles.mean() for first in (1, -1)]
        return float(0.5 * sum(both) - MEAN_ANGLE)

    most = min(DEEPEST_SHARE * smallest_radius(trace)[0], 2 * trace.length)
    deep = SHALLOWEST_STEPS * trace.length / inner
    while deep < most and excess(deep) > 0:
        deep *= 1.5
    if excess(min(deep, most)) > 0:
        return most
    return float(brentq(excess, 0.0, min(deep, most), xtol=1e-13 * trace.length))


def _place_feet(trace: Trace, inner: int, end_steps: float) -> tuple[Array, Array]:
    """Feet (m+2, 2) of the vertices on the curve, and unit normals (m+2, 2) to the left there."""
    cells = np.diff(trace.arc)
    turns = np.abs(trace.turns)
    corners = np.abs(trace.heading - trace.arriving).sum()
    mean = (turns.sum() + corners) / trace.length
    weight = np.cbrt(turns / cells + mean) * cells if mean > 1e-9 / trace.length else cells
    progress = np.concatenate([[0.0], np.cumsum(weight)])
    steps = np.concatenate([[0.0], np.arange(inner) + end_steps, [inner - 1 + 2 * end_steps]])
    t = np.interp(steps / steps[-1] * progress[-1], progress, trace.t)
    t[0], t[-1] = trace.t[0], trace.t[-1]
    return trace.curve.position(t), normals_at(trace, t)


def _offset(feet: Array, normal: Array, depth: float, first: int) -> Zigzag:
    vertices = feet.copy()
    side = first * alternating(len(feet) - 2)
    vertices[1:-1] += depth * side[:, None] * normal[1:-1]
    return Zigzag(vertices, feet, first, depth)
