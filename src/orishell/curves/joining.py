"""Pieces of a drawing joined to one curve, and the direction in which it is run through."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from orishell.conventions.errors import CurveError
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.curves.curve import Curve
from orishell.curves.ends import CHOOSE, Course, GapError, Marks, Place, find_course, next_ends
from orishell.curves.interpolation import curve_from_points
from orishell.curves.memo import remembered
from orishell.curves.pieces import MAX_PIECES, SIMPLIFY, Affine, Arc, Bezier, Piece
from orishell.curves.piecewise import PieceArrays, curve_from_pieces
from orishell.curves.trace import Trace
from orishell.numerics.arrays import Array


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


SAME_END = 1e-6
"""Ends that are nearer than this, relative to the diagonal of the drawing, are one."""
WIDEST = 0.02
UNASKED = 0.005
"""A distance that joins ends is offered up to the first share of the drawing's diagonal, and taken
up to the second one: pixels of a hand are one thing, a line that stops short another."""
FAR_APART = 4.0
"""What is meant to be apart is so many such distances apart."""
STEP = 1.2
"""By what factor the next distance that is tried exceeds the last one, at least."""
LARGEST_COORDINATE = 1e50
"""Coordinates beyond this count as not finite."""
SMOOTH_TURN = 0.1
"""A bent piece turns by at most this from point to point of a spline through it (radians)."""
MOST_BETWEEN = 64
"""A spline takes at most this many points of one piece."""


@record
class Chain:
    """Pieces in their order, each turned to begin where the one before ends."""

    pieces: tuple[Piece, ...]  # the pieces (N,)
    joints: Array  # where they begin, meet and end (N+1, 2)
    notes: tuple[str, ...] = ()  # what is to be said of how it was read

    def reversed(self) -> Chain:
        """The chain, from its last point to its first."""
        turned = tuple(piece.reversed() for piece in self.pieces[::-1])
        return replace(self, pieces=turned, joints=self.joints[::-1])

    def scaled(self, factor: float) -> Chain:
        """The drawing enlarged about the origin by ``factor`` > 0."""
        if factor == 1.0:
            return self
        affine = Affine(factor * np.eye(2), np.zeros(2))
        pieces = tuple(piece.transformed(affine) for piece in self.pieces)
        return replace(self, pieces=pieces, joints=factor * self.joints)

    def curve(self) -> Curve:
        """The curve exactly as it is drawn; its parameter is about the arc length."""
        curve = curve_from_pieces(PieceArrays.of(self.pieces), self.joints)
        return replace(curve, notes=self.notes)

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
        return replace(curve_from_points(np.concatenate(points), smooth=True), notes=self.notes)


def join_pieces(
    pieces: Sequence[Piece], place: Place, join: float | None = None, unit: str = ""
) -> Chain:
    """Order and turn pieces so that they make one curve; CurveError if they do not.

    Ends nearer than :data:`SAME_END` times the diagonal of all pieces are one. Pieces shorter
    than that, and pieces that are drawn twice, are dropped. The curve begins at the end with the
    smaller x, or if they have the same, the smaller y.

    Parameters
    ----------
    pieces
        What is drawn.
    place
        How messages name a point.
    join
        Ends that are still loose are joined up to this distance; None for the least with which
        they make one curve, where nothing else can be meant by them.
    unit
        Of what is drawn, for notes.
    """
    require_pieces(pieces)
    marks = Marks.of(pieces)
    least = SAME_END * marks.size
    try:
        course = find_course(marks, least, join or least, place)
    except GapError as error:
        course = _bridged(marks, least, join, place, error)
    turned = tuple(
        pieces[k].reversed() if back else pieces[k]
        for k, back in zip(course.pieces.tolist(), course.back.tolist(), strict=True)
    )
    note = f"ends up to {plain(course.bridged, 2)} {unit} apart were joined"
    return Chain(turned, course.joints, (note,) if course.bridged > least else ())


def _bridged(
    marks: Marks, least: float, join: float | None, place: Place, error: GapError
) -> Course:
    """The course with the first wider distance to join ends that makes any, if that is not asked.

    Raises GapError: The one given, with that distance as its remedy if something else may be meant.
    """
    wider, gap = join or least, error.gap
    while True:
        wider = _above(max(gap, STEP * wider))
        if wider > WIDEST * marks.size:
            raise error
        try:
            course = find_course(marks, least, wider, place)
            break
        except GapError as another:
            gap = another.gap
        except CurveError:
            raise error from None
    near = next_ends(marks, least)
    between = (near > wider) & (near < FAR_APART * wider)
    if join is None and wider <= UNASKED * marks.size and not between.any():
        return course
    error.remedy = f"join = {wider:g} joins them, or {CHOOSE}"
    error.changes = {"join": wider}
    raise error


def _above(length: float) -> float:
    """The next number of two digits; the same for what differs by rounding only."""
    length *= 1 + 1e-6
    last = 10.0 ** (np.floor(np.log10(length)) - 1)
    return float(f"{(np.floor(length / last) + 1) * last:.2g}")


def require_pieces(pieces: Sequence[Piece]) -> None:
    """Refuse a drawing of no pieces, or too many, or some that are not finite."""
    if not pieces:
        raise CurveError(
            "nothing is drawn here",
            expected="lines, arcs, polylines, paths, ellipses or splines",
            remedy="draw one of them",
        )
    if len(pieces) > MAX_PIECES:
        raise CurveError(
            "the drawing has too many pieces",
            got=str(len(pieces)),
            expected=f"at most {MAX_PIECES}",
            remedy=SIMPLIFY,
        )
    if not all(piece.reach < LARGEST_COORDINATE for piece in pieces):  # nan, too
        raise CurveError(
            "a coordinate is not finite, or too large",
            expected=f"numbers up to {LARGEST_COORDINATE:g}",
            remedy="draw it anew, in another unit",
        )


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
