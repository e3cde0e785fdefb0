"""Staircases: polylines of constant angle xi that follow a curve.

Edges alternate between the two directions that enclose half the angle pi - xi on either side of
the axis t (the x axis of the curve as it is given here). In the oblique coordinates along those
two directions the curve is monotone (the paper's condition under equation (1)) and the polyline
is a staircase that crosses it on every edge.

The Hausdorff distance of such a staircase to the curve is the largest distance of its corners to
the curve: along an edge the signed distance is monotone, and a point of the curve between two
crossings is never farther from the edges than the corner between them is from the curve. It is
least when all corners are equally far, alternately on both sides.

Limit: a staircase meets f to first order only: the distance falls like 1/rows. A zigzag stays
``depth`` away from f.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from typing import TypeVar

import numpy as np

from orishell.conventions.record import record
from orishell.curves import Trace
from orishell.curves.nearest import Nearest
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import smallest_of
from orishell.polylines.zigzag import alternating

T = TypeVar("T")

Search = Generator[Array, tuple[Array, Array], T]
"""Yields points (P, 2), is sent the nearest points (P, 2) of a curve and the distances (P,)."""


def batched(searches: Sequence[Search[T]]) -> Search[list[T]]:
    """Join searches into one, which asks the questions of all of them together."""
    found: dict[int, T] = {}
    answers: dict[int, tuple[Array, Array] | None] = dict.fromkeys(range(len(searches)))
    while True:
        asked: dict[int, Array] = {}
        for k, answer in answers.items():
            try:
                asked[k] = next(searches[k]) if answer is None else searches[k].send(answer)
            except StopIteration as end:
                found[k] = end.value
        if not asked:
            return [found[k] for k in range(len(searches))]
        feet, distances = yield np.concatenate(list(asked.values()))
        ends = np.cumsum([len(points) for points in asked.values()])[:-1]
        parts = zip(np.split(feet, ends), np.split(distances, ends), strict=True)
        answers = dict(zip(asked, parts, strict=True))


def rotated_search(search: Search[T], angle: float) -> Search[T]:
    """Make a search of a curve turned by an angle (radians) ask the curve that is not turned."""
    cos, sin = np.cos(angle), np.sin(angle)
    turn = np.array([[cos, sin], [-sin, cos]])
    try:
        points = next(search)
        while True:
            feet, distances = yield points @ turn.T
            points = search.send((feet @ turn, distances))
    except StopIteration as end:
        found: T = end.value
        return found


def run_search(search: Search[T], nearest: Callable[[Array], tuple[Array, Array]]) -> T:
    """Run a search to its end; ``nearest`` answers it, and what it finds is returned."""
    try:
        points = next(search)
        while True:
            points = search.send(nearest(points))
    except StopIteration as end:
        found: T = end.value
        return found


MAX_ITERATIONS = 60
SMALLEST_STEP = 1e-3
"""Share of a Newton step that is taken even if it does not bring the corners closer to balance."""
DENSE = 64
"""Systems up to this size are solved as dense ones, which is quicker."""
BALANCE = 1e-9
"""Corners are balanced when their distances agree to this, relative to the distance."""


@record
class Staircase:
    """A polyline of constant angle from the curve's first point to its last."""

    xi: float  # angle between adjacent edges (radians)
    first: int  # +1 if the first edge leaves to the left of the axis (upwards), -1 if to the right
    lengths: Array  # edge lengths (m+1,), in the unit of the curve
    vertices: Array  # vertices (m+2, 2)
    distance: float  # Hausdorff distance to the curve
    # whether all corners reached the same distance (they do unless the curve is pathological;
    # otherwise the distance is the largest, and not proved least)
    balanced: bool

    @property
    def evenness(self) -> float:
        """Shortest edge relative to the mean."""
        return float(self.lengths.min() / self.lengths.mean())


def fit_staircase(trace: Trace, xi: float, edges: int) -> Staircase:
    """The staircase of least Hausdorff distance to a curve, ends kept.

    Parameters
    ----------
    trace
        The curve; its tangents must lie within (pi - xi)/2 of the x axis.
    xi
        Angle between adjacent edges, in (0, limit) (radians).
    edges
        Number of edges, at least 2.

    Returns
    -------
    Staircase
        The better one of those that begin upwards and downwards.
    """
    return run_search(search_staircase(trace, xi, edges), Nearest.to(trace))


def search_staircase(trace: Trace, xi: float, edges: int) -> Search[Staircase]:
    """The search behind :func:`fit_staircase`, which asks for the curve's nearest points."""
    both = [_balance(_Levels.of(trace, xi, edges, first)) for first in (1, -1)]
    candidates = yield from batched(both)
    return smallest_of(candidates, lambda staircase: staircase.distance)


@record
class _Levels:
    """Staircases along one curve, described by the levels of their edges.

    Edge e (0 ... m) lies at a constant value, its level, of one oblique coordinate: v for even e,
    which run along ``up``, u for odd e, along ``down``. Corner i (1 ... m) is where edges i-1 and
    i meet; odd ones lie on the side of the curve that ``up`` leads to.
    """

    trace: Trace
    xi: float
    first: int
    edges: int
    up: Array
    down: Array
    u: Array
    v: Array

    @classmethod
    def of(cls, trace: Trace, xi: float, edges: int, first: int) -> _Levels:
        """Directions of the edges, and the curve's samples in the oblique coordinates."""
        sin, cos = np.sin(xi / 2), np.cos(xi / 2)
        x, y = (trace.points - trace.points[0]).T
        u, v = 0.5 * (x / sin + first * y / cos), 0.5 * (x / sin - first * y / cos)
        up, down = np.array([sin, first * cos]), np.array([sin, -first * cos])
        return cls(trace, xi, first, edges, up, down, u, v)

    @property
    def last(self) -> tuple[float, float]:
        """The level of the last edge, and where on it the curve ends."""
        u, v = float(self.u[-1]), float(self.v[-1])
        return (v, u) if self.edges % 2 else (u, v)

    def signed_distances(self, level: Array) -> Search[tuple[Array, Array, Array]]:
        """Signed distances (m,) of the corners, and their derivatives by both levels of each."""
        uv = np.stack([level[:-1], level[1:]], axis=-1)
        uv[0::2] = uv[0::2, ::-1]
        points = self.trace.points[0] + uv[:, :1] * self.up + uv[:, 1:] * self.down
        foot, distance = yield points
        sign = np.where(uv[:, 0] >= np.interp(uv[:, 1], self.v, self.u), 1.0, -1.0)
        normal = sign[:, None] * (points - foot) / np.maximum(distance, 1e-300)[:, None]
        slope = np.stack([normal @ self.up, normal @ self.down], axis=-1)
        slope[0::2] = slope[0::2, ::-1]
        return sign * distance, slope[:, 0], slope[:, 1]

    def first_guess(self) -> Array:
        """Levels (m+1,) that balance a nearly straight curve.

        A pair of edges of overshoot h advances by 2 h sin(2 b)/(sin(b - w) sin(b + w)) along a
        curve of direction w, with b = (pi - xi)/2: spread the crossings evenly in its inverse.
        """
        trace, count = self.trace, self.edges
        cone = (np.pi - self.xi) / 2
        middle = 0.5 * (trace.heading[:-1] + trace.arriving[1:])
        density = np.sin(cone - middle) * np.sin(cone + middle)
        density = np.maximum(density, 1e-3 * density.max())
        progress = np.concatenate([[0.0], np.cumsum(density * np.diff(trace.arc))])
        crossing = np.linspace(0.0, progress[-1], count)
        level = np.where(
            np.arange(count) % 2 == 0,
            np.interp(crossing, progress, self.v),
            np.interp(crossing, progress, self.u),
        )
        level[0], level[-1] = 0.0, self.last[0]
        return level

    def staircase(self, level: Array, distance: float, balanced: bool) -> Staircase:
        """The polyline: each edge runs between its neighbours' levels, or the curve's ends."""
        ends = np.concatenate([[0.0], level, [self.last[1]]])
        lengths = ends[2:] - ends[:-2]
        directions = np.where((np.arange(self.edges) % 2 == 0)[:, None], self.up, self.down)
        along = np.cumsum(lengths[:, None] * directions, axis=0)
        vertices = self.trace.points[0] + np.concatenate([np.zeros((1, 2)), along])
        return Staircase(self.xi, self.first, lengths, vertices, distance, balanced)


def _balance(levels: _Levels) -> Search[Staircase]:
    """Move the inner edges until all corners are equally far from the curve (damped Newton)."""
    side, level = alternating(levels.edges - 1), levels.first_guess()  # +1 at odd corners
    distance, by_before, by_after = yield from levels.signed_distances(level)
    height = float(np.abs(distance).mean())
    best = (float(np.abs(distance).max()), level)
    for _ in range(MAX_ITERATIONS):
        residual = side * distance - height
        if np.abs(residual).max() <= BALANCE * abs(height):
            return levels.staircase(best[1], best[0], balanced=True)
        change, rise = _newton_step(side, by_before, by_after, residual)
        step = _longest_step(level, change)
        while True:
            trial = level.copy()
            trial[1:-1] += step * change
            distance, by_before, by_after = yield from levels.signed_distances(trial)
            new = side * distance - (height + step * rise)
            if new @ new < residual @ residual or step < SMALLEST_STEP:
                break
            step *= 0.5
        level, height = trial, height + step * rise
        worst = float(np.abs(distance).max())
        if worst < best[0]:
            best = (worst, level)
    return levels.staircase(best[1], best[0], balanced=False)


def _newton_step(side: Array, before: Array, after: Array, residual: Array) -> tuple[Array, float]:
    """Changes of the inner levels and of the common distance that cancel the residual."""
    m = len(side)
    corner = np.arange(m)
    rows = np.concatenate([corner[:-1], corner[1:], corner])
    columns = np.concatenate([corner[:-1], corner[:-1], np.full(m, m - 1)])
    entries = np.concatenate([(side * after)[:-1], (side * before)[1:], np.full(m, -1.0)])
    solution = _solve(entries, rows, columns, -residual)
    return solution[:-1], float(solution[-1])


def _solve(entries: Array, rows: Integers, columns: Integers, right: Array) -> Array:
    """The solution (m,) of a sparse system, nan where there is none."""
    if len(right) <= DENSE:
        matrix = np.zeros((len(right), len(right)))
        matrix[rows, columns] = entries
        try:
            return np.asarray(np.linalg.solve(matrix, right), dtype=np.float64)
        except np.linalg.LinAlgError:
            return np.full(len(right), np.nan)
    from scipy.sparse import coo_array
    from scipy.sparse.linalg import spsolve

    sparse = coo_array((entries, (rows, columns)), shape=(len(right), len(right))).tocsc()
    return np.asarray(spsolve(sparse, right))


def _longest_step(level: Array, change: Array) -> float:
    """The part of a step, at most 1, that keeps every inner edge's length positive."""
    lengths = level[2:] - level[:-2]
    padded = np.concatenate([[0.0], change, [0.0]])
    shrink = padded[:-2] - padded[2:]
    closing = shrink > 0
    return float(min(1.0, 0.9 * np.min(lengths[closing] / shrink[closing], initial=np.inf)))
