"""Pieces of a drawing joined to one curve, and the direction in which it is run through."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from orishell.conventions.errors import CurveError
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.curves.curve import Curve
from orishell.curves.interpolation import curve_from_points
from orishell.curves.memo import remembered
from orishell.curves.pieces import MAX_PIECES, Affine, Arc, Bezier, Piece
from orishell.curves.piecewise import PieceArrays, curve_from_pieces
from orishell.curves.trace import Trace
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import classes, first_smallest


@remembered
def run_along_axis(trace: Trace, theta: float = 0.0) -> Trace:
    """The curve run through in the direction of its x axis, whichever way it was drawn.

    Parameters
    ----------
    theta
        Rotation that is going to be made (radians): it is the rotated x axis that counts.

    Returns
    -------
    Trace
        The curve, or its reverse, with tangents that after the rotation are nearer to the x axis
        than to its opposite, and directions on the branch about 0.
    """
    low, high = trace.heading_range()
    turns = np.round((0.5 * (low + high) + theta) / np.pi)
    if int(turns) % 2:
        return run_along_axis(trace.reversed(), theta)
    return replace(
        trace, heading=trace.heading - turns * np.pi, arriving=trace.arriving - turns * np.pi
    )


Place = Callable[[Array], str]
"""How messages name a point (2,) of the drawing."""

TOLERANCE = 1e-6
"""Ends that are nearer than this, relative to the diagonal of the drawing, are joined."""
LARGEST = 1e50
"""Coordinates beyond this count as not finite."""
CHOOSE = "choose its pieces"
"""Part of a remedy; where it is known how to choose them, that takes its place."""
SMOOTH_TURN = 0.1
"""A bent piece turns by at most this from point to point of a spline through it (radians)."""
MOST_BETWEEN = 64
"""A spline takes at most this many points of one piece."""


@record
class Chain:
    """Pieces in their order, each turned to begin where the one before ends."""

    pieces: tuple[Piece, ...]  # the pieces (N,)
    joints: Array  # where they begin, meet and end (N+1, 2)

    def reversed(self) -> Chain:
        """The same points, from the last to the first."""
        turned = tuple(piece.reversed() for piece in self.pieces[::-1])
        return Chain(turned, self.joints[::-1])

    def scaled(self, factor: float) -> Chain:
        """The drawing enlarged about the origin by ``factor`` > 0."""
        if factor == 1.0:
            return self
        affine = Affine(factor * np.eye(2), np.zeros(2))
        return Chain(tuple(p.transformed(affine) for p in self.pieces), factor * self.joints)

    def curve(self) -> Curve:
        """The curve exactly as it is drawn; its parameter is about the arc length."""
        return curve_from_pieces(PieceArrays.of(self.pieces), self.joints)

    def spline(self) -> Curve:
        """A cubic spline, twice continuously differentiable, through the drawing.

        It goes through all joints, and through points of bent pieces every :data:`SMOOTH_TURN`.
        """
        arrays = PieceArrays.of(self.pieces)
        points = [self.joints[:1]]
        for k, piece in enumerate(self.pieces):
            share = np.arange(1, _parts(piece)) / _parts(piece)
            if len(share):
                points.append(arrays.jet(np.full(len(share), k), share)[0])
            points.append(self.joints[k + 1 : k + 2])
        return curve_from_points(np.concatenate(points), smooth=True)


def join_pieces(pieces: Sequence[Piece], place: Place) -> Chain:
    """Order and turn pieces so that they make one curve; CurveError if they do not.

    Ends nearer than :data:`TOLERANCE` times the diagonal of all pieces are joined. Pieces shorter
    than that, and pieces that are drawn twice, are dropped. The curve begins at the end with the
    smaller x, or if they have the same, the smaller y.
    """
    require_pieces(pieces)
    arrays = PieceArrays.of(pieces)
    marks = [arrays.at(share) for share in (0.0, 0.5, 1.0)]
    diagonal = float(np.hypot(*np.ptp(np.concatenate(marks), axis=0)))
    tolerance = TOLERANCE * max(diagonal, 0.01 * float(arrays.lengths.max()))
    kept = np.flatnonzero(arrays.lengths > tolerance)
    if not len(kept):
        raise CurveError("the drawing is a single point", where=place(marks[0][0]))
    begin, middle, end = (mark[kept] for mark in marks)
    node = _cluster(np.concatenate([begin, end]), tolerance).reshape(2, -1)
    same = np.column_stack([np.sort(node, axis=0).T, _cluster(middle, tolerance)])
    single = np.sort(np.unique(same, axis=0, return_index=True)[1])
    kept, node = kept[single], node[:, single]
    both = np.concatenate([begin[single], end[single]])
    count = np.maximum(np.bincount(node.ravel()), 1)
    where = np.column_stack(
        [np.bincount(node.ravel(), both[:, axis], len(count)) / count for axis in (0, 1)]
    )
    grid = 1e-3 * tolerance  # so that messages do not quote rounding

    def rounded(point: Array) -> str:
        return place(np.round(point / grid) * grid + 0.0)

    first = _first_end(node, where, tolerance, rounded)
    walk = _walk(node, first)
    chain = tuple(pieces[kept[k]].reversed() if back else pieces[kept[k]] for k, back, _ in walk)
    return Chain(chain, where[[first, *(stop for _, _, stop in walk)]])


def require_pieces(pieces: Sequence[Piece]) -> None:
    """Refuse a drawing of no pieces, or too many, or some that are not finite."""
    if not pieces:
        raise CurveError(
            "nothing is drawn here",
            expected="lines, arcs, polylines, paths, ellipses or splines",
        )
    if len(pieces) > MAX_PIECES:
        raise CurveError(
            "the drawing has too many pieces",
            got=str(len(pieces)),
            expected=f"at most {MAX_PIECES}",
            remedy="simplify it",
        )
    if not all(piece.reach < LARGEST for piece in pieces):  # nan, too
        raise CurveError(
            "a coordinate is not finite, or too large", expected=f"numbers up to {LARGEST:g}"
        )


def _cluster(points: Array, tolerance: float) -> Integers:
    """Numbers (P,) of points (P, 2), the same for those that are within a tolerance."""
    from scipy.spatial import cKDTree

    # One point for each cell of a grid, so that however many coincide, few pairs are left.
    cells = np.floor((points - points.min(axis=0)) / tolerance)
    _, first, cell = np.unique(cells, axis=0, return_index=True, return_inverse=True)
    sites = points[first]
    pairs = cKDTree(sites).query_pairs(tolerance, output_type="ndarray")
    return _components(pairs.T, len(sites))[cell.ravel()]


def _first_end(node: Integers, where: Array, tolerance: float, place: Place) -> int:
    """The end (a node's number) at which the one chain of pieces begins."""
    degree = np.bincount(node.ravel(), minlength=len(where))
    if degree.max() > 2:
        nodes = np.flatnonzero(degree > 2)
        at = int(nodes[np.lexsort((where[nodes, 1], classes(where[nodes, 0])))[0]])  # the leftmost
        raise CurveError(
            "the curve branches",
            where=f"at {place(where[at])}",
            got=f"{degree[at]} ends that meet",
            expected="at most 2",
            remedy=f"{CHOOSE}, or remove what does not belong to it",
        )
    chain = _components(node, len(where))
    free = np.flatnonzero(degree == 1)
    closed = np.setdiff1d(node.ravel(), np.flatnonzero(np.isin(chain, chain[free])))
    if len(closed):
        at = int(node[0, np.argmax(np.isin(node[0], closed))])
        raise CurveError(
            "the curve is closed",
            where=f"from {place(where[at])} back to there",
            expected="a curve with two ends",
            remedy="remove a piece of it",
        )
    if len(free) > 2:
        a, b, distance = _nearest_ends(free, chain, where)
        raise CurveError(
            "the curve has gaps",
            where=f"between {place(where[a])} and {place(where[b])}",
            got=f"{len(free) // 2} separate parts, the nearest ends {plain(distance, 3)} apart",
            expected="one curve",
            remedy=f"make ends meet to {plain(tolerance, 1)}, or {CHOOSE}",
        )
    a, b = (int(each) for each in free)
    across = where[b] - where[a]
    forwards = across[1] > 0 if abs(across[0]) <= tolerance else across[0] > 0
    return a if forwards else b


def _components(links: Integers, count: int) -> Integers:
    """Numbers (count,) of connected components under links (2, L)."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    graph = coo_array((np.ones(links.shape[1]), links), shape=(count, count))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.intp)


def _nearest_ends(free: Integers, chain: Integers, where: Array) -> tuple[int, int, float]:
    """The nearest two free ends of different chains, and their distance."""
    from scipy.spatial import cKDTree

    # Of the three nearest ends one is the end itself, and one may be the other of its chain.
    distances, near = (np.asarray(each) for each in cKDTree(where[free]).query(where[free], k=3))
    other = chain[free][near] != chain[free][:, None]
    distances = np.where(other, distances, np.inf)
    k, column = divmod(first_smallest(distances), 3)
    return int(free[k]), int(free[near[k, column]]), float(distances[k, column])


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


def _parts(piece: Piece) -> int:
    """Into how many parts a piece is cut for a spline, by how much it turns."""
    turn = abs(piece.sweep) if isinstance(piece, Arc) else _polygon_turn(piece)
    return min(MOST_BETWEEN, 1 + int(np.ceil(turn / SMOOTH_TURN))) if turn > 1e-9 else 1


def _polygon_turn(piece: Bezier) -> float:
    """Total turning of the control polygon, which is no less than that of the curve."""
    steps = np.diff(piece.control[:, :2] / piece.control[:, 2:], axis=0)
    steps = steps[np.hypot(steps[:, 0], steps[:, 1]) > 0]
    directions = np.arctan2(steps[:, 1], steps[:, 0])
    turns = np.mod(np.diff(directions) + np.pi, 2 * np.pi) - np.pi
    return float(np.abs(turns).sum())
