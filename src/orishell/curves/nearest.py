"""Nearest points on a curve (feet): found on its trace, then refined on the curve itself."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.curves.memo import remembered
from orishell.curves.trace import Trace
from orishell.numerics.arrays import Array, Integers

if TYPE_CHECKING:
    from shapely import STRtree

POLISHING_STEPS = 6
POLISHED = 1e-13
"""A step in the parameter below this, relative to its range, ends the polishing."""
NEWTON = 0.01
"""Newton's step is taken where the squared distance curves upwards by at least this share of what
it does beside a straight line."""


@record
class Nearest:
    """Answers which points of a curve are nearest to given points; made by :meth:`to`."""

    trace: Trace
    cells: STRtree

    @classmethod
    def to(cls, trace: Trace) -> Nearest:
        """Prepare for questions about one curve."""
        return cls(trace, _tree_of(trace))

    def __call__(self, points: Array) -> tuple[Array, Array]:
        """Feet (P, 2) and distances (P,) of points (P, 2)."""
        import shapely

        trace = self.trace
        last = len(trace.t) - 2
        cell = self.cells.query_nearest(shapely.points(points), all_matches=False)[1]
        # The chord's nearest point is next to the curve's: Newton from there and in both
        # neighbouring cells, each on its own so that corners between cells do no harm, and the
        # samples themselves.
        cell = np.clip(cell + np.array([[-1], [0], [1]]), 0, last)
        low, high = trace.t[cell], trace.t[cell + 1]
        t = low + (high - low) * self._shares(cell, points)
        for _ in range(POLISHING_STEPS):
            position, first, second = trace.curve.jet(t)
            away, speed = points - position, _dot(first, first)
            bend = speed - _dot(away, second)
            # Newton; Gauss-Newton where the curve bends around the point, or more than is finite.
            step = _dot(away, first) / np.where(bend > NEWTON * speed, bend, speed)
            better = np.clip(t + step, low, high)
            moved = np.abs(better - t).max()
            t = better
            if moved <= POLISHED * (trace.t[-1] - trace.t[0]):
                break
        feet = np.concatenate([trace.curve.position(t), trace.points[cell], trace.points[cell + 1]])
        distances = np.hypot(*np.moveaxis(feet - points, -1, 0))
        best = distances.argmin(axis=0)
        column = np.arange(len(points))
        return feet[best, column], distances[best, column]

    def _shares(self, cell: Integers, points: Array) -> Array:
        """Where on the chords of cells (3, P), from 0 to 1, the points nearest to (P, 2) are."""
        start = self.trace.points[cell]
        chord = self.trace.points[cell + 1] - start
        squares = np.maximum(_dot(chord, chord), np.finfo(float).tiny)
        return np.clip(_dot(points - start, chord) / squares, 0.0, 1.0)


@remembered
def _tree_of(trace: Trace) -> STRtree:
    """A search tree over the chords between samples."""
    import shapely

    ends = np.stack([trace.points[:-1], trace.points[1:]], axis=1)
    return shapely.STRtree(np.asarray(shapely.linestrings(ends), dtype=object))


def _dot(u: Array, v: Array) -> Array:
    """Scalar products (...) of vectors (..., 2)."""
    return np.asarray(u[..., 0] * v[..., 0] + u[..., 1] * v[..., 1])


@dataclass(frozen=True, slots=True)
class Closeness:
    """Distances between a curve and a polyline, in the unit of their coordinates."""

    max: float  # the Hausdorff distance: the largest distance of a point of either to the other
    rms: float  # root mean square over the curve's length of the distance to the polyline
