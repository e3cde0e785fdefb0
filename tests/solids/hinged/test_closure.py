"""Whole boards on hinges close all their loops while they fold: checked by a tree of rigid bodies.

The tree is the test's own: it turns each board about the axis of its hinge, by the fold angle of
the sheet, and never looks at positions of the folded sheet.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from flat_foldables import random_sheet
from orishell.design import PanelSpec
from orishell.motion import Mechanism, diagonal, drive_at_fold, find_assignment
from orishell.motion.grid import CreaseValues
from orishell.motion.hinges import Hinges
from orishell.motion.mechanism import panel_normals
from orishell.numerics.arrays import Array
from orishell.solids.hinged import find_hinges
from samples import thorough

DESIGNS = 200
QUICK = 12
LAST = np.deg2rad(179.9)
CLOSED = 1e-12
"""Of the diagonal, as asked; 2e-13 is the most that was seen, near 180 degrees."""

ZERO = 1e-13
"""Relative singular values below it are zero; 1e-7 is the least of the others that was seen."""


class Tree:
    """Boards of a sheet turned about their hinges, one after the other: down, then across."""

    def __init__(self, mechanism: Mechanism, hinges: Hinges) -> None:
        self.mechanism, self.hinges = mechanism, hinges
        self.flat = mechanism.positions(0.0)

    def axes(self, kind: str) -> tuple[Array, Array]:
        """A point and the direction of all hinges of rows or of columns in the flat sheet."""
        flat, heights = self.flat, self.hinges.heights
        if kind == "row":
            start, end, height = flat[1:-1, 1:], flat[1:-1, :-1], heights.row
        else:
            start, end, height = flat[:-1, 1:-1], flat[1:, 1:-1], heights.column
        along = (end - start) / np.linalg.norm(end - start, axis=-1, keepdims=True)
        return start + height[..., None] * [0.0, 0.0, 1.0], along

    def placed(self, drive: float) -> tuple[Array, Array]:
        """Rotations (rows-1, columns-1, 3, 3) and shifts (rows-1, columns-1, 3) of all boards."""
        folds = self.mechanism.fold_angles(drive)
        rows, columns = self.hinges.levels.shape
        turn, shift = np.zeros((rows, columns, 3, 3)), np.zeros((rows, columns, 3))
        turn[0, 0] = np.eye(3)
        row, column = self.axes("row"), self.axes("column")
        for i in range(rows - 1):
            turn[i + 1, 0], shift[i + 1, 0] = self._carried(
                (turn[i, 0], shift[i, 0]), [each[i, 0] for each in row], float(folds.row[i, 0])
            )
        for j in range(columns - 1):
            for i in range(rows):
                turn[i, j + 1], shift[i, j + 1] = self._carried(
                    (turn[i, j], shift[i, j]),
                    [each[i, j] for each in column],
                    float(folds.column[i, j]),
                )
        return turn, shift

    def _carried(
        self, board: tuple[Array, Array], hinge: list[Array], fold: float
    ) -> tuple[Array, Array]:
        """Rotation and shift of the board beyond a hinge."""
        (turn, shift), (point, along) = board, hinge
        turned = about(along, fold)
        return turn @ turned, turn @ (point - turned @ point) + shift

    def open(self, drive: float) -> float:
        """By how much ends of the hinges that the tree leaves out are apart (length)."""
        turn, shift = self.placed(drive)
        point, along = self.axes("row")
        apart = 0.0
        for at in (point, point + along):
            above, below = (
                np.einsum("rcij,rcj->rci", turn[part], at) + shift[part]
                for part in (slice(None, -1), slice(1, None))
            )
            apart = max(apart, float(np.abs(above - below).max()))
        return apart

    def freedoms(self, drive: float) -> tuple[float, float]:
        """The least two singular values of all loops together, relative to the largest.

        Each loop of four boards is closed for small turns of its hinges, six equations.
        """
        turn, shift = self.placed(drive)
        signs = find_assignment(self.mechanism)
        screws, numbers, count = [], [], 0
        for kind, sign in (("row", signs.row), ("column", signs.column)):
            point, along = self.axes(kind)
            own = turn[: sign.shape[0], : sign.shape[1]]
            direction = np.einsum("rcij,rcj->rci", own, along)
            at = np.einsum("rcij,rcj->rci", own, point) + shift[: sign.shape[0], : sign.shape[1]]
            screws.append(np.concatenate([direction, np.cross(at, direction)], axis=-1))
            folds = sign != 0
            number = np.where(folds, count + np.cumsum(folds).reshape(folds.shape) - 1, -1)
            numbers.append(number)
            count += int(folds.sum())
        (row, column), (of_row, of_column) = screws, numbers
        inner_rows, inner_columns = row.shape[0], column.shape[1]
        loops = np.zeros((inner_rows, inner_columns, 6, count + 1))
        for i in range(inner_rows):
            for j in range(inner_columns):
                # From left above to right above, down, back to the left, and up.
                for screw, number, way in (
                    (column[i, j], of_column[i, j], 1),
                    (row[i, j + 1], of_row[i, j + 1], 1),
                    (column[i + 1, j], of_column[i + 1, j], -1),
                    (row[i, j], of_row[i, j], -1),
                ):
                    loops[i, j, :, number] += way * screw
        values = np.linalg.svd(loops[..., :-1].reshape(-1, count), compute_uv=False)
        return float(values[-2] / values[0]), float(values[-1] / values[0])


def about(axis: Array, angle: float) -> Array:
    """The rotation (3, 3) about a unit vector (Rodrigues)."""
    across = np.cross(np.eye(3), axis)  # its columns are the axis times the unit vectors
    turned = np.eye(3) + np.sin(angle) * across + (1 - np.cos(angle)) * across @ across
    return np.asarray(turned)


def hinged(seed: int) -> tuple[Mechanism, Hinges, float]:
    sheet = random_sheet(seed)
    size = diagonal(sheet.positions(0.0))
    build = PanelSpec(thickness=2e-3 * size, construction="hinged")
    return sheet, find_hinges(sheet, build), size


@pytest.mark.parametrize(
    "seeds",
    [
        range(QUICK),
        *(pytest.param(range(k, k + QUICK), marks=thorough) for k in range(QUICK, DESIGNS, QUICK)),
    ],
    ids=lambda seeds: f"{seeds[0]}-",
)
def test_all_loops_stay_closed_with_one_degree_of_freedom(seeds: range) -> None:
    for seed in seeds:
        sheet, hinges, size = hinged(seed)
        tree = Tree(sheet, hinges)
        for drive in np.linspace(0.0, drive_at_fold(sheet, LAST), 7):
            assert tree.open(float(drive)) <= CLOSED * size, seed
            assert hinges.gap(sheet.positions(drive)) <= CLOSED * size, seed
        second, first = tree.freedoms(0.6 * sheet.target_drive)
        assert first < ZERO < 1e4 * ZERO < second, seed


@pytest.mark.parametrize("seed", range(4))
def test_boards_are_shifted_as_the_tree_has_them(seed: int) -> None:
    sheet, hinges, size = hinged(seed)
    drive = 0.7 * sheet.end_drive
    turn, shift = Tree(sheet, hinges).placed(drive)
    positions = sheet.positions(drive)
    shifts = hinges.shifts(panel_normals(positions).reshape(-1, 3)).reshape(shift.shape)
    carried = np.einsum("rcij,rcj->rci", turn, sheet.positions(0.0)[:-1, :-1]) + shift
    # Both are the same but for a motion of all: compared in the first board's frame.
    corners = positions[:-1, :-1] + shifts
    apart = np.linalg.norm(carried[:, :, None, None] - carried, axis=-1)
    assert np.abs(apart - np.linalg.norm(corners[:, :, None, None] - corners, axis=-1)).max() <= (
        1e-12 * size
    )


@pytest.mark.parametrize("seed", range(4))
def test_a_hinge_off_by_a_millimetre_opens_the_loops_beside_it(seed: int) -> None:
    sheet, hinges, size = hinged(seed)
    off = 1e-4 * size
    heights = hinges.heights
    moved = heights.row.copy()
    moved[len(moved) // 2, moved.shape[1] // 2] += off
    wrong = replace(hinges, heights=CreaseValues(moved, heights.column))
    assert wrong.gap(sheet.positions(0.9 * sheet.target_drive)) > 0.1 * off
    assert Tree(sheet, wrong).open(0.9 * sheet.target_drive) > 0.1 * off
