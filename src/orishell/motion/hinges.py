"""Hinges beside the creases of a sheet: whole boards fold as its panels do, and are shifted.

Panels fold as without a thickness, by the same angles, about hinges that stand at heights h over
the flat sheet, parallel to their creases. A point of a hinge is one of its crease and h n, as seen
from either panel beside it, n being the panel's unit normal. So a panel q beyond a hinge from a
panel p is shifted, from where its crease would have it, by

    s_q = s_p + h (n_p - n_q).

Around a vertex these steps sum up to nothing in all states if the heights fulfil two conditions
(:mod:`~orishell.solids.hinged.conditions`).

A sheet in pieces has joints in place of the hinges of some rows. The heights there are those at
which hinges would let the pieces move as one, so the pieces fit each other exactly at the target.
Folded up further they are drawn apart, each behind a plane.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field
from itertools import pairwise
from typing import Any, Protocol, runtime_checkable

import numpy as np

from orishell.conventions.record import record
from orishell.motion.boards import Boards
from orishell.motion.grid import CreaseValues, Grid, Positions
from orishell.motion.hinge_lines import HingeLines
from orishell.motion.mechanism import Mechanism, panel_normals
from orishell.motion.quads import grid_corners
from orishell.numerics.arrays import Array, Integers

FURTHER = 1e-12
"""Joints are folded further than at the target if the cosine of their fold angles is as much less.
Up to there rounding decides."""


@runtime_checkable
class Straightened(Protocol):
    """A mechanism whose columns may be straight but for the digits of the curves it follows."""

    def straightened(self) -> Mechanism:
        """The mechanism with columns that are straight to the last digit, where they nearly are."""


@runtime_checkable
class FreeLengths(Protocol):
    """A mechanism whose edges may have other lengths while all its angles stay, in all states.

    Those of a row and of a column are free, and the others follow. Vertices at the target are
    affine in them.
    """

    def free_lengths(self) -> Mapping[str, Array]:
        """The lengths that are free, by name."""

    def with_lengths(self, lengths: Mapping[str, Array]) -> Mechanism:
        """The mechanism with other lengths of the same names."""

    def described_lengths(self) -> Mapping[str, Any]:
        """What the report of a design says of them, beside what does not change with them."""


@record
class Joints:
    """Row creases along which pieces are joined at the target, and no hinges are."""

    rows: tuple[int, ...]  # their numbers, ascending
    # how far boards are cut back from them (2, J, columns-1), those above and below (length)
    cuts: Array
    # the mean cosine (J,) of the fold angles of each at the target
    cosines: Array


@record
class Hinges(HingeLines):
    """Where the hinges of whole boards are, and where the boards lie in the flat sheet."""

    signs: CreaseValues  # of all creases: +1 valley, -1 mountain, 0 where one does not fold
    heights: CreaseValues  # of the hinges of all creases over the flat sheet (length)
    levels: Array  # heights (rows-1, columns-1) of the undersides of boards over it (length)
    thickness: float  # of the boards (length)
    # how far each hinge stands off the faces of the two boards that it joins (length): off the
    # board above and the one below (2, rows-2, columns-1), left and right (2, rows-1, columns-2)
    arms: tuple[Array, Array]
    # radius of knuckles, by which axes stand off what carries them: the boards' faces, or arms that
    # end there (length)
    knuckle: float = 0.0
    # by how much all boards are moved together (3,), so that they meet the target (length)
    place: Array = field(default_factory=lambda: np.zeros(3))
    joints: Joints | None = None  # where pieces are joined; None if the sheet is one piece

    @property
    def beside(self) -> bool:
        """Whether they lie beside the creases: they do."""
        return True

    @property
    def joint_rows(self) -> tuple[int, ...]:
        """Numbers of the row creases along which pieces are joined at the target."""
        return () if self.joints is None else self.joints.rows

    @property
    def pieces(self) -> list[slice]:
        """Rows of panels of every piece."""
        return self.pieces_of(len(self.levels))

    @property
    def cut_back(self) -> Array:
        """How far boards stand back from the sides of their panels at joints (F, 4) (length)."""
        back = np.zeros((*self.levels.shape, 4))
        if self.joints is not None:
            above = list(self.joints.rows)
            back[above, :, 1], back[[row + 1 for row in above], :, 3] = self.joints.cuts
        return back.reshape(-1, 4)

    @property
    def sides(self) -> CreaseValues:
        """On which side of the boards hinges are: +1 top, -1 bottom, 0 where there is none."""
        row = self.signs.row.copy()
        row[list(self.joint_rows)] = 0.0
        return CreaseValues(row, self.signs.column)

    def of_piece(self, rows: slice) -> Hinges:
        """The hinges of a piece by its rows of panels."""
        inner = slice(rows.start, rows.stop - 1)

        def part(values: CreaseValues) -> CreaseValues:
            return CreaseValues(values.row[inner], values.column[rows])

        return Hinges(
            part(self.signs),
            part(self.heights),
            self.levels[rows],
            self.thickness,
            (self.arms[0][:, inner], self.arms[1][:, rows]),
            self.knuckle,
        )

    @property
    def grid(self) -> Grid:
        """The grid of the sheet."""
        rows, columns = self.levels.shape
        return Grid(rows + 1, columns + 1)

    @property
    def longest_arm(self) -> float:
        """The farthest that a hinge stands off a board (length)."""
        return float(max(each.max(initial=0.0) for each in self.arms))

    def shifts(self, normals: Array) -> Array:
        """Shifts (..., F, 3) of all panels in states with these unit normals (..., F, 3).

        But for ``place`` they leave the panels' mean where it is.
        """
        n = normals.reshape(*normals.shape[:-2], *self.levels.shape, 3)
        down, across = self._steps(n)
        shifts = np.zeros_like(n)
        np.cumsum(down[..., 0, :], axis=-2, out=shifts[..., 1:, 0, :])
        shifts[..., 1:, :] = shifts[..., :1, :] + np.cumsum(across, axis=-2)
        shifts += self.place - shifts.mean(axis=(-3, -2), keepdims=True)
        return shifts.reshape(normals.shape)

    def drawn(self, corners: Array, normals: Array) -> Array:
        """The shifts (F, 3) with which a state is drawn: pieces that lie in one place apart.

        Folded up further than at the target, pieces are moved along the mean of their normals, the
        one that all panels share when they are folded flat, until a plane parts each two of them.

        corners, normals: Those of all panels (F, 4, 3) and (F, 3) in the state, not shifted.
        """
        shifts = self.shifts(normals)
        if self.joints is None:
            return shifts
        n = normals.reshape(*self.levels.shape, 3)
        if not self._beyond_target(n, self.joints):
            return shifts
        apart = self._apart(corners + shifts[:, None], n)
        return shifts + np.repeat(apart, n.shape[1], axis=0)

    def accelerations(self, normals: Array, swings: Array) -> Array:
        """Bounds (S,) of what shifts add to vectors from the feet, which are on boards as well.

        By the shift of any board from where the first one is shifted.
        """
        n = normals.reshape(len(normals), *self.levels.shape)
        down = np.abs(self.heights.row[:, 0]) * (n[:, :-1, 0] + n[:, 1:, 0])
        across = np.abs(self.heights.column) * (n[:, :, :-1] + n[:, :, 1:])
        return np.asarray(swings + 2 * (down.sum(axis=1) + across.sum(axis=2).max(axis=1)))

    def middles(self, normals: Array) -> Array:
        """How far (..., rows-1, columns-1, 3) boards are, half way up, from their panels.

        In states with these unit normals (..., rows-1, columns-1, 3).
        """
        listed = normals.reshape(*normals.shape[:-3], -1, 3)
        over = (self.levels + 0.5 * self.thickness)[..., None] * normals
        return np.asarray(self.shifts(listed).reshape(normals.shape) + over)

    def boards(self, positions: Positions) -> Array:
        """Corners (..., rows-1, columns-1, 4, 3) of all boards, half way up, in states (...)."""
        middles = self.middles(panel_normals(positions))
        return np.asarray(grid_corners(positions) + middles[..., None, :])

    def drawn_boards(self, positions: Positions) -> Array:
        """Corners (rows-1, columns-1, 4, 3) of all boards, half way up, as a state is drawn."""
        listed, corners = panel_normals(positions).reshape(-1, 3), grid_corners(positions)
        moved = self.drawn(corners.reshape(-1, 4, 3), listed) - self.shifts(listed)
        return self.boards(positions) + moved.reshape(*self.levels.shape, 1, 3)

    def vertices(self, positions: Positions) -> Array:
        """Means (rows, columns, 3) of the corners of boards, half way up, that meet at vertices."""
        boards = self.boards(positions)
        sums, counts = np.zeros_like(positions), np.zeros(positions.shape[:2])
        for corner, part in enumerate(_at_corners(self.grid)):
            sums[part] += boards[:, :, corner]
            counts[part] += 1
        return np.asarray(sums / counts[..., None])

    def lowest(self, positions: Positions) -> Array:
        """Heights (rows, columns) of the lowest corners of boards at the vertices of a state.

        Boards do not meet there. How far they are below or above it depends on normals alone.
        """
        over = 0.5 * self.thickness * np.abs(panel_normals(positions)[..., 2:])
        height = self.boards(positions)[..., 2] - over
        lowest = np.full(positions.shape[:2], np.inf)
        for corner, part in enumerate(_at_corners(self.grid)):
            np.minimum(lowest[part], height[..., corner], out=lowest[part])
        return lowest

    def _steps(self, n: Array) -> tuple[Array, Array]:
        """Steps of the shift from panels to those below and to their right, by normals."""
        down = self.heights.row[..., None] * (n[..., :-1, :, :] - n[..., 1:, :, :])
        across = self.heights.column[..., None] * (n[..., :-1, :] - n[..., 1:, :])
        return down, across

    def _beyond_target(self, n: Array, joints: Joints) -> bool:
        """Whether a state is folded up further than the target, by normals."""
        rows = list(joints.rows)
        cosines = (n[rows] * n[[row + 1 for row in rows]]).sum(axis=-1).mean(axis=1)
        return bool((joints.cosines - cosines > FURTHER).any())

    def _apart(self, corners: Array, n: Array) -> Array:
        """How far rows of panels (rows-1, 3) are moved apart with their pieces.

        corners: Those of all panels (F, 4, 3), shifted.
        """
        along = (self._sides()[..., None] * n).mean(axis=(0, 1))
        along /= np.linalg.norm(along)
        # All that is on a panel is between two heights over it.
        beyond = self.longest_arm + 2 * self.knuckle
        ends = np.stack([self.levels - beyond, self.levels + self.thickness + beyond], axis=-1)
        at = (corners @ along).reshape(*self.levels.shape, 4, 1)
        seen = at + (ends * (n @ along)[..., None])[..., None, :]
        room = self.thickness + beyond
        moved, offset = np.zeros(len(n)), 0.0
        for before, piece in pairwise(self.pieces):
            overlap = seen[before].max() - seen[piece].min() + room
            offset += max(0.0, float(overlap))
            moved[piece] = offset
        moved -= moved.mean()
        return np.asarray(moved[:, None] * along)

    def _sides(self) -> Array:
        """1 or -1 (rows-1, columns-1): the way panels face, folded flat, as the first or not."""
        down, across = (
            np.where(signs != 0, -1.0, 1.0) for signs in (self.signs.row[:, :1], self.signs.column)
        )
        first = np.concatenate([[[1.0]], down.cumprod(axis=0)])
        return np.concatenate([first, first * across.cumprod(axis=1)], axis=1)

    def gap(self, positions: Positions) -> float:
        """How far the loop around any inner vertex is from closing in a state (length)."""
        down, across = self._steps(panel_normals(positions))
        around = across[:-1] + down[:, 1:] - down[:, :-1] - across[1:]
        return float(np.sqrt((around**2).sum(axis=-1)).max(initial=0.0))


def _at_corners(grid: Grid) -> Iterator[tuple[slice, slice]]:
    """Which vertices are corners of panels: left above, left below, right below, right above."""
    for row, column in ((0, 0), (1, 0), (1, 1), (0, 1)):
        yield slice(row, row + grid.rows - 1), slice(column, column + grid.columns - 1)


def piece_numbers(boards: Boards) -> Integers:
    """The piece (B,) that every board belongs to, from 0."""
    hinges = boards.hinges
    assert isinstance(hinges, Hinges)
    ends = [rows.stop for rows in hinges.pieces]
    rows = boards.panels // hinges.levels.shape[1]
    return np.asarray(np.searchsorted(ends, rows, side="right"))
