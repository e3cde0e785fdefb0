"""Whole boards as a tree of rigid bodies: the tests' own, beside the closed forms of shifts.

It turns each board about the axis of its hinge, by the fold angle of the sheet, and never looks at
positions of the folded sheet.
"""

from __future__ import annotations

import numpy as np

from orishell.motion import Mechanism, find_assignment
from orishell.motion.hinges import Hinges
from orishell.numerics.arrays import Array


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
