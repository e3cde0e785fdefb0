"""Nearest points on a curve: exact feet, found on the trace and polished on the curve."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from orishell.curves.jets import Array
from orishell.curves.trace import Trace

if TYPE_CHECKING:
    from shapely import STRtree

POLISHING_STEPS = 6
POLISHED = 1e-13
"""A step in the parameter below this, relative to its range, ends the polishing."""
NEWTON = 0.01
"""Newton's step is taken where the squared distance curves upwards by at least this share of what
it does beside a straight line."""


@dataclass(frozen=True, slots=True, eq=False)
class Nearest:
    """Answers which point of a curve is nearest to given points.

    Build it with :meth:`to`; call it with points (P, 2) to get feet (P, 2) and distances (P,).
    """

    trace: Trace
    cells: STRtree

    @classmethod
    def to(cls, trace: Trace) -> Nearest:
        """Prepare for questions about one curve."""
        import shapely

        ends = np.stack([trace.points[:-1], trace.points[1:]], axis=1)
        return cls(trace, shapely.STRtree(np.asarray(shapely.linestrings(ends), dtype=object)))

    def __call__(self, points: Array) -> tuple[Array, Array]:
        """Feet (P, 2) and distances (P,) of points (P, 2)."""
        import shapely

        trace = self.trace
        last = len(trace.t) - 2
        cell = self.cells.query_nearest(shapely.points(points), all_matches=False)[1]
        # The chord's nearest point is next to the curve's: Newton there and in both
        # neighbouring cells, each on its own so that corners between cells do no harm, and the
        # samples themselves.
        cell = np.clip(cell + np.array([[-1], [0], [1]]), 0, last)
        low, high = trace.t[cell], trace.t[cell + 1]
        t = 0.5 * (low + high)
        for _ in range(POLISHING_STEPS):
            position, first, second = trace.curve.jet(t)
            away, speed = points - position, (first * first).sum(axis=-1)
            bend = speed - (away * second).sum(axis=-1)
            # Newton; Gauss-Newton where the curve bends around the point, or more than is finite.
            step = (away * first).sum(axis=-1) / np.where(bend > NEWTON * speed, bend, speed)
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
