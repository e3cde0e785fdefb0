"""Degrees of freedom of a folding sheet: how many motions it has, and what folds by itself.

They are counted in folded states on the way to the target, where its panels and all of its creases
are hinged, those that stay unfolded included. Whole boards on hinges beside their creases have as
many: at a vertex where panels move, the conditions under which boards move with them
(:mod:`orishell.motion.hinges`) hold for any multiple of that motion.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Literal

import numpy as np

from orishell.conventions.record import record
from orishell.motion.crease_pattern import CreasePattern, FoldedPattern
from orishell.motion.following.couplings import Coupled, find_couplings
from orishell.motion.following.dofs import Freedom, find_freedom, least_count
from orishell.motion.following.followed import FREEDOM_AT
from orishell.motion.following.system import Closure
from orishell.motion.grid import Grid
from orishell.motion.hinge_lines import IN_CREASES, HingeLines
from orishell.motion.layout import Layout, edge_folds, mesh_of, points_of
from orishell.motion.mechanism import Mechanism
from orishell.motion.quads import is_level
from orishell.numerics.arrays import Booleans, Integers

Lines = Literal["rows", "columns"]


@record
class FreedomOfSheet:
    """How many motions a sheet has, and what folds by itself."""

    REPORTED = ("one_motion", "nearly", "lines", "parts", "states", "largest_zero", "least_other")

    # degrees of freedom: the least of the states that were looked at, of the piece that has most;
    # None if no gap tells them
    count: int | None
    # how many there would be without couplings too weak to be felt; None if that is not known
    nearly: int | None
    lines: (
        Lines | None
    )  # what folds by itself; None if it is one motion, or parts of no whole lines
    # first and last row or column of inner vertices (the grid's numbers) of each part that folds by
    # itself
    parts: tuple[tuple[int, int], ...]
    states: int  # in how many folded states they were counted
    largest_zero: float  # the largest number that counts as zero there
    least_other: float | None  # the least that does not; None if there is none

    @property
    def one_motion(self) -> bool:
        """Whether the sheet has one motion only, in which all of it is felt to move."""
        return self.count == 1 and self.nearly in {1, None}

    def in_words(self) -> str:
        """How many there are, and what they are of: "5 degrees of freedom, ...", in a line."""
        if self.count is None:
            return "degrees of freedom not known: no gap tells them"
        if self.count == 1 and not self.one_motion:
            weak = "some creases that join its parts hardly fold"
            return f"1 degree of freedom, but nearly {self.nearly}: {self._parts(weak)}"
        if self.count == 1:
            return "1 degree of freedom"
        return f"{self.count} degrees of freedom: {self._parts('parts of it fold by themselves')}"

    def _parts(self, otherwise: str) -> str:
        if self.lines is None:
            return otherwise
        if all(first == last for first, last in self.parts):
            numbers = [first for first, _ in self.parts]
            ends = f"{numbers[0]} to {numbers[-1]}"
            if numbers != list(range(numbers[0], numbers[-1] + 1)):
                ends = ", ".join(map(str, numbers))
            return f"{self.lines} {ends} fold by themselves"
        groups = (str(a) if a == b else f"{a} to {b}" for a, b in self.parts)
        return f"{self.lines} {'; '.join(groups)} fold each by themselves"


def find_freedom_of_sheet(mechanism: Mechanism, hinges: HingeLines = IN_CREASES) -> FreedomOfSheet:
    """Count the motions of a sheet in folded states on the way to its target.

    A state with one motion, in which all of it is felt to move, settles it: the others are not
    looked at.

    Parameters
    ----------
    hinges
        Those of whole boards: pieces that are joined at the target fold by themselves before. Then
        it is that of the piece that has most.
    """
    whole = _pattern(mechanism)
    found = [_counted(mechanism, each) for each in _of_pieces(whole, mechanism, hinges)]
    return max(found, key=lambda each: (each.count is None, each.count, each.nearly or 0))


def held_by_flaps(mechanism: Mechanism) -> bool:
    """Whether all of a sheet stands still at its target while its flaps stay as they are there.

    So no part of it closes further: at a vertex beside a flap that is shut, the sheet is as far
    closed as it goes.
    """
    pattern = _pattern(mechanism)
    flaps = np.append(Layout.of(mechanism).flaps, False)
    return _stands_still(mechanism, pattern, np.asarray(flaps[pattern.edge_faces].all(axis=1)))


def held_at(mechanism: Mechanism, vertices: Integers) -> bool:
    """Whether all of a sheet stands still at its target while creases at some vertices do.

    Flaps do if the sheet between them does. At a vertex beside a flap the angle between both edges
    of the column is then fixed, and so is a triangle on a sphere with this side and the two angles
    of the flap. Creases of a flap that is shut take no part in the sheet's motion to first order,
    as there a triangle has no height; so flaps are left out.

    Parameters
    ----------
    vertices
        Numbers (k,) of the vertices at which no crease turns, none of them a flap's alone.
    """
    pattern = _between_flaps(mechanism)
    return _stands_still(
        mechanism, pattern, np.asarray(np.isin(pattern.edges, vertices).any(axis=1))
    )


def hold_alone(mechanism: Mechanism, vertices: Integers) -> Booleans:
    """Which of some vertices (k,) hold all of a sheet still at its target, each by itself.

    As :func:`held_at` says of one: it does if the sheet has one motion, in which a crease there
    turns.
    """
    pattern = _between_flaps(mechanism)
    closure, found = _coupled(mechanism, pattern, np.zeros(len(pattern.edges), np.bool_))
    turns = np.zeros(len(pattern.vertices), np.bool_)
    if found is not None and found.count == 1:
        turns[pattern.edges[closure.edges[found.turning]]] = True
    return np.asarray(turns[vertices])


def _stands_still(mechanism: Mechanism, pattern: CreasePattern, shut: Booleans) -> bool:
    """Whether a sheet stands still at its target while edges (E,) that are shut do not turn."""
    _, found = _coupled(mechanism, pattern, shut)
    return found is not None and found.count == 0


def _coupled(
    mechanism: Mechanism, pattern: CreasePattern, shut: Booleans
) -> tuple[Closure, Coupled | None]:
    """What moves by itself at the target while edges (E,) that are shut do not turn."""
    folds, closure = edge_folds(mechanism, mechanism.target_drive), Closure.of(pattern)
    _, along = closure.turns(folds[closure.edges])
    return closure, find_couplings(closure, along, (shut & pattern.crease)[closure.edges])


def _pattern(mechanism: Mechanism) -> CreasePattern:
    """The sheet, all of its creases hinged."""
    mesh, points = mesh_of(mechanism), points_of(mechanism, 0.0)
    letters = np.where(mesh.crease, "U", "B")
    of_mesh = mesh.edges, letters, mesh.loops, mesh.edge_faces
    if is_level(points):
        return CreasePattern(points[:, :2], *of_mesh)
    row, column = np.divmod(np.arange(len(points)), mechanism.grid.columns)
    return FoldedPattern(np.stack([column, -row], axis=1), *of_mesh, points)


def _between_flaps(mechanism: Mechanism) -> CreasePattern:
    """The flat sheet, flaps cut off it and each other."""
    whole = _pattern(mechanism)
    flaps = np.append(Layout.of(mechanism).flaps, False)
    beside = flaps[whole.edge_faces].any(axis=1)
    return replace(whole, letters=np.where(whole.crease & beside, "C", whole.letters))


def _of_pieces(
    whole: CreasePattern, mechanism: Mechanism, hinges: HingeLines
) -> Iterator[CreasePattern]:
    """The sheet, or each of its pieces, parted from all others."""
    if not hinges.joint_rows:
        yield whole
        return
    rows = whole.edge_faces // (mechanism.grid.columns - 1)
    for piece in hinges.pieces_of(mechanism.grid.rows - 1):
        inside = ((rows >= piece.start) & (rows < piece.stop)).all(axis=1)
        yield replace(whole, letters=np.where(whole.crease & ~inside, "C", whole.letters))


def _counted(mechanism: Mechanism, pattern: CreasePattern) -> FreedomOfSheet:
    """The motions of a pattern, in as few states as settle them."""
    closure, found = Closure.of(pattern), []
    for share in FREEDOM_AT:
        folds = edge_folds(mechanism, share * mechanism.target_drive)
        found.append(find_freedom(closure, folds[closure.edges]))
        if found[-1].count == found[-1].nearly == 1:
            break
    felt = [each.nearly for each in found if each.nearly is not None]
    least = min((each for each in found if each.parts is not None), key=_felt, default=None)
    lines, parts = (None, ()) if least is None else _in_lines(least.parts, closure, mechanism.grid)
    other = min(each.least_other for each in found)
    return FreedomOfSheet(
        count=least_count(found),
        nearly=min(felt, default=None),
        lines=lines,
        parts=parts,
        states=len(found),
        largest_zero=max(each.largest_zero for each in found),
        least_other=other if np.isfinite(other) else None,
    )


def _felt(found: Freedom) -> int:
    return found.nearly or 0


def _in_lines(
    parts: Integers | None, closure: Closure, grid: Grid
) -> tuple[Lines | None, tuple[tuple[int, int], ...]]:
    """Rows or columns of inner vertices that each part is of, if it is of whole ones.

    parts: The part (I,) of every inner vertex; -1 where it stands still.
    """
    if parts is None:
        return None, ()
    if not len(parts):  # a strip, whose creases go from border to border
        strips: Lines = "rows" if grid.columns == 2 else "columns"
        count = (grid.rows if grid.columns == 2 else grid.columns) - 2
        return (strips, tuple((k, k) for k in range(1, count + 1))) if count > 1 else (None, ())
    inside = (closure.vertices < grid.vertex_count) & (parts >= 0)
    labels = parts[inside]
    kinds: tuple[Lines, ...] = ("rows", "columns")
    for name, lines in zip(kinds, np.divmod(closure.vertices[inside], grid.columns), strict=True):
        pairs = np.unique(np.stack([labels, lines], axis=1), axis=0)
        if len(np.unique(pairs[:, 1])) < len(pairs) or len(np.unique(labels)) < 2:
            continue
        ends = sorted((int(own.min()), int(own.max()), len(own)) for own in _by_label(pairs))
        if all(last - first + 1 == count for first, last, count in ends):
            return name, tuple((first, last) for first, last, _ in ends)
    return None, ()


def _by_label(pairs: Integers) -> list[Integers]:
    """Lines of each part, of pairs (N, 2) of part and line that are sorted."""
    return np.split(pairs[:, 1], np.flatnonzero(np.diff(pairs[:, 0])) + 1)
