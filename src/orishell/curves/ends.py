"""Ends of pieces: which of them are one, and in which order the pieces are then one curve."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from orishell.conventions.errors import CurveError
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.curves.pieces import Piece
from orishell.curves.piecewise import PieceArrays
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.components import find_components
from orishell.numerics.equals import classes, first_largest, first_smallest

Place = Callable[[Array], str]
"""How messages name a point (2,) of the drawing; it is rounded to the digits that count."""

CHOOSE = "choose its pieces"
"""Part of a remedy; where it is known how to choose them, that takes its place."""
DIGITS = 6
"""Digits of the size of a drawing that messages give of its points."""
STRAIGHT = 1e-6
"""A piece whose length exceeds its chord by no more than this share is a straight line."""


class GapError(CurveError):
    """Pieces that do not meet."""

    gap: float = np.inf  # how far the nearest ends are apart


@record
class Marks:
    """Where pieces (N,) begin, are halfway and end, and how long they are."""

    begin: Array  # (N, 2)
    middle: Array  # (N, 2)
    end: Array  # (N, 2)
    lengths: Array  # (N,)

    @classmethod
    def of(cls, pieces: Sequence[Piece]) -> Marks:
        """Those of pieces."""
        arrays = PieceArrays.of(pieces)
        return cls(arrays.at(0.0), arrays.at(0.5), arrays.at(1.0), arrays.lengths)

    @property
    def size(self) -> float:
        """The diagonal of the drawing, about: what tolerances are shares of."""
        every = np.concatenate([self.begin, self.middle, self.end])
        diagonal = float(np.hypot(*np.ptp(every, axis=0)))
        return max(diagonal, 0.01 * float(self.lengths.max()))

    def said(self, place: Place, point: Array, apart: float = np.inf) -> str:
        """A point in as many digits as tell it from others that are so far ``apart``."""
        size = self.size or float(np.abs(self.begin).max()) or 1.0
        digits = DIGITS - int(np.ceil(np.log10(size)))
        if 0 < apart < size:
            digits = max(digits, 1 - int(np.floor(np.log10(apart))))
        return place(np.round(point, digits) + 0.0)


@record
class Course:
    """Pieces in the order and the direction in which they make one curve."""

    pieces: Integers  # their numbers (K,)
    back: Booleans  # whether each (K,) is run through from its end to its beginning
    joints: Array  # where they begin, meet and end (K+1, 2)
    bridged: float  # how far ends were apart, at most, that are one here


@record
class _Nodes:
    """Points at which pieces end."""

    kept: Integers  # numbers (K,) of the pieces that count
    ends: Integers  # the points (2, K) that these begin and end at
    where: Array  # the points (P, 2)
    bridged: float

    @property
    def degree(self) -> Integers:
        """How many pieces end at each point (P,)."""
        return np.bincount(self.ends.ravel(), minlength=len(self.where))


def find_course(marks: Marks, least: float, join: float, place: Place) -> Course:
    """The order in which pieces make one curve with two ends; CurveError if they make none.

    Parameters
    ----------
    marks
        Of the pieces. Those no longer than ``least``, and all but one of those with the same ends
        and the same middle, do not count.
    least
        Ends that are nearer to each other than this are one.
    join
        Ends that are left alone by that, and nearer to each other than this, are one as well.
    """
    nodes = _joined(_nodes(marks, least, place), join)
    first = _first_end(nodes, marks, least, place)
    walk = _walk(nodes.ends, first)
    return Course(
        nodes.kept[[k for k, _, _ in walk]],
        np.array([back for _, back, _ in walk]),
        nodes.where[[first, *(stop for _, _, stop in walk)]],
        nodes.bridged,
    )


def next_ends(marks: Marks, least: float) -> Array:
    """Distances (L, 2) of ends (L,) that are left alone to the two next ones, nearest first."""
    nodes = _nodes(marks, least, lambda _: "")
    return _next(nodes.where[nodes.degree == 1])[0]


def _nodes(marks: Marks, least: float, place: Place) -> _Nodes:
    kept = np.flatnonzero(marks.lengths > least)
    if not len(kept):
        raise CurveError(
            "the drawing is a single point",
            where=marks.said(place, marks.begin[0]),
            remedy="draw a line or a curve",
        )
    begin, middle, end = (each[kept] for each in (marks.begin, marks.middle, marks.end))
    ends = _cluster(np.concatenate([begin, end]), least).reshape(2, -1)
    same = np.column_stack([np.sort(ends, axis=0).T, _cluster(middle, least)])
    single = np.sort(np.unique(same, axis=0, return_index=True)[1])
    ends = ends[:, single]
    both = np.concatenate([begin[single], end[single]])
    return _Nodes(kept[single], ends, _means(ends.ravel(), both), 0.0)


def _joined(nodes: _Nodes, join: float) -> _Nodes:
    """The nodes, with one for those that are nearer than ``join`` and have one piece each."""
    loose = np.flatnonzero(nodes.degree == 1)
    if len(loose) <= 2:
        return nodes
    ends = nodes.where[loose]
    distances, near = _next(ends)
    close = distances <= join
    pairs = np.stack([np.nonzero(close)[0], near[close]], axis=1)
    group = find_components(pairs, len(loose))
    middle = _means(group, ends)
    numbers = np.arange(len(nodes.where))
    numbers[loose] = len(numbers) + group
    bridged = 2 * float(np.hypot(*(ends - middle[group]).T).max())
    where = np.concatenate([nodes.where, middle])
    return _Nodes(nodes.kept, numbers[nodes.ends], where, bridged)


def _means(numbers: Integers, points: Array) -> Array:
    """The means (P, 2) of points (N, 2) that have the same number (N,)."""
    count = np.maximum(np.bincount(numbers), 1)
    return np.column_stack(
        [np.bincount(numbers, points[:, axis], len(count)) / count for axis in (0, 1)]
    )


def _next(points: Array) -> tuple[Array, Integers]:
    """Distances (N, 2) of points (N, 2) to the two nearest others, and their numbers (N, 2)."""
    from scipy.spatial import cKDTree

    # No two of them are one, so that the first that is found is the point itself.
    distances, near = cKDTree(points).query(points, k=3)
    return np.asarray(distances, dtype=np.float64)[:, 1:], np.asarray(near, dtype=np.intp)[:, 1:]


def _cluster(points: Array, tolerance: float) -> Integers:
    """Numbers (P,) of points (P, 2), the same for those that are within a tolerance."""
    from scipy.spatial import cKDTree

    # One point for each cell of a grid, so that however many coincide, few pairs are left.
    cells = np.floor((points - points.min(axis=0)) / tolerance)
    _, first, cell = np.unique(cells, axis=0, return_index=True, return_inverse=True)
    sites = points[first]
    pairs = cKDTree(sites).query_pairs(tolerance, output_type="ndarray")
    return find_components(pairs, len(sites))[cell.ravel()]


def _first_end(nodes: _Nodes, marks: Marks, least: float, place: Place) -> int:
    """The end (a point's number) at which the one chain of pieces begins."""
    degree, where = nodes.degree, nodes.where
    if degree.max() > 2:
        many = np.flatnonzero(degree > 2)
        at = int(many[np.lexsort((where[many, 1], classes(where[many, 0])))[0]])  # the leftmost
        raise CurveError(
            "the curve branches",
            where=f"at {marks.said(place, where[at])}",
            got=f"{degree[at]} ends that meet",
            expected="at most 2",
            remedy=f"{CHOOSE}, or remove what does not belong to it",
        )
    chain = find_components(nodes.ends.T, len(where))
    free = np.flatnonzero(degree == 1)
    closed = ~np.isin(chain[nodes.ends[0]], chain[free])
    if closed.any():
        at = int(nodes.ends[0, np.argmax(closed)])
        alone = (chain[nodes.ends[0]] == chain[at]).all()
        raise CurveError(
            "the curve is closed",
            where=f"from {marks.said(place, where[at])} back to there",
            expected="a curve with two ends",
            remedy=_opened(nodes.kept, marks, place) if alone else CHOOSE,
        )
    if len(free) > 2:
        raise _gap(nodes, free, chain, marks, place)
    a, b = (int(each) for each in free)
    across = where[b] - where[a]
    forwards = across[1] > 0 if abs(across[0]) <= least else across[0] > 0
    return a if forwards else b


def _opened(pieces: Integers, marks: Marks, place: Place) -> str:
    """What opens a closed chain of pieces: without one of them it has two ends."""
    if len(pieces) == 1:
        return "draw a part of it, with two ends, in its place"
    begin, end = marks.begin[pieces], marks.end[pieces]
    chords = np.hypot(*(end - begin).T)
    straight = marks.lengths[pieces] <= (1 + STRAIGHT) * chords
    if not straight.any():
        return "remove a piece of it"
    longest = first_largest(np.where(straight, chords, 0.0))
    ends = " to ".join(marks.said(place, each[longest]) for each in (begin, end))
    return f"remove a piece of it, as the straight line from {ends}"


def _gap(nodes: _Nodes, free: Integers, chain: Integers, marks: Marks, place: Place) -> GapError:
    """About the nearest two free ends (F,) of different chains (P,)."""
    where = nodes.where
    # Of the two nearest ends one may be the other of its chain.
    distances, near = _next(where[free])
    other = chain[free][near] != chain[free][:, None]
    distances = np.where(other, distances, np.inf)
    k, column = divmod(first_smallest(distances), 2)
    distance = float(distances[k, column])
    ends = (marks.said(place, where[each], distance) for each in (free[k], free[near[k, column]]))
    error = GapError(
        "the curve has gaps",
        where=f"between {' and '.join(ends)}",
        got=f"{len(free) // 2} separate parts, the nearest ends {plain(distance, 3)} apart",
        expected="one curve",
        remedy=f"make ends meet, or {CHOOSE}",
    )
    error.gap = distance
    return error


def _walk(node: Integers, first: int) -> list[tuple[int, bool, int]]:
    """The pieces from one end on, whether each is run through backwards, and where it ends."""
    at: dict[int, list[int]] = {}
    for k, (a, b) in enumerate(node.T.tolist()):
        at.setdefault(a, []).append(k)
        at.setdefault(b, []).append(k)
    walk: list[tuple[int, bool, int]] = []
    here, last = first, -1
    while ahead := [k for k in at[here] if k != last]:
        last = ahead[0]
        back = int(node[1, last]) == here
        here = int(node[0 if back else 1, last])
        walk.append((last, back, here))
    return walk
