r"""When whole boards on hinges at heights of their own fold as panels without a thickness do.

At an inner vertex with the sectors left-down a, right-down b, right-up pi - a and left-up pi - b,
as one that folds flat has them (Kawasaki), and hinges at the heights h of the creases up, down,
left and right of it, the loop of its four boards stays closed in all states, with the fold angles
of the sheet, if and only if

    h_D + h_U = h_L + h_R,     (h_D - h_L) / sin a = -+ (h_R - h_D) / sin b,

"-" where its row creases have the same sign, "+" where its column creases have: it is a linkage of
Bennett's (Y. Chen, R. Peng and Z. You, Science 349 (2015) 396, for one vertex). Mobile loops of
four hinges are plane, spherical or Bennett's, so no other sheet has such hinges. Over R x C inner
vertices the conditions are independent: R + C heights are free.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.conventions.record import record
from orishell.motion.grid import CreaseValues, Grid, Positions
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.equals import first_largest

FLAT_FOLDABLE = 1e-9
"""Opposite sectors may miss half a turn together by so much (radians)."""


@record
class Vertices:
    """The inner vertices (R, C) of a sheet that folds flat, and the signs of its creases."""

    a: Array  # sectors left-down (R, C) (radians)
    b: Array  # sectors right-down (R, C) (radians)
    # whether both row creases of a vertex (R, C) have the same sign; otherwise its columns' have
    row_mode: Booleans
    signs: CreaseValues  # +1 valley, -1 mountain, 0 where a crease does not fold

    @classmethod
    def of(cls, flat: Positions, signs: CreaseValues) -> Vertices:
        """Those of a flat sheet (rows, columns, 3).

        Raises
        ------
        DesignError
            If it does not fold flat.
        """
        sectors = measure_sectors(flat[..., :2])
        _require_flat_foldable(sectors)
        row_mode = signs.row[:, :-1] == signs.row[:, 1:]
        return cls(sectors[0], sectors[1], np.asarray(row_mode), signs)

    @property
    def shape(self) -> tuple[int, int]:
        """Numbers of rows R and columns C."""
        rows, columns = self.a.shape
        return rows, columns

    @property
    def still(self) -> Booleans:
        """Vertices (R, C) two of whose creases do not fold."""
        row, column = self.signs.row, self.signs.column
        return np.asarray((row[:, :-1] == 0) | (column[:-1] == 0))

    def conditions(self) -> Any:
        """The conditions as a sparse matrix (2 R C, E) on the heights of :func:`crease_numbers`.

        Where two creases of a vertex do not fold, the others are one straight hinge, and those two
        may lie at any height: they are given the same.
        """
        from scipy.sparse import csr_array

        (rows, columns), count = self.shape, self.a.size
        row, column = crease_numbers(Grid(rows + 2, columns + 2))
        up, down, left, right = column[:-1], column[1:], row[:, :-1], row[:, 1:]
        sine_a = np.sin(self.a) * np.where(self.row_mode, 1.0, -1.0)
        sine_b, one = np.sin(self.b), np.ones(self.a.shape)
        still, zero = self.still, 0.0 * one
        of_sum = [
            (down, np.where(still, zero, one)),
            (up, np.where(still, zero, one)),
            (left, -one),
            (right, np.where(still, one, -one)),
        ]
        of_ratio = [
            (down, np.where(still, one, sine_b - sine_a)),
            (up, np.where(still, -one, zero)),
            (left, np.where(still, zero, -sine_b)),
            (right, np.where(still, zero, sine_a)),
        ]
        entries = [(0, *each) for each in of_sum] + [(count, *each) for each in of_ratio]
        place = np.arange(count)
        return csr_array(
            (
                np.concatenate([value.ravel() for _, _, value in entries]),
                (
                    np.concatenate([first + place for first, _, _ in entries]),
                    np.concatenate([number.ravel() for _, number, _ in entries]),
                ),
            ),
            shape=(2 * count, row.size + column.size),
        )


def crease_numbers(grid: Grid) -> tuple[Integers, Integers]:
    """Numbers of row creases (rows-2, columns-1) and column creases (rows-1, columns-2)."""
    row = np.arange((grid.rows - 2) * (grid.columns - 1)).reshape(grid.rows - 2, -1)
    count = (grid.rows - 1) * (grid.columns - 2)
    return row, row.size + np.arange(count).reshape(grid.rows - 1, -1)


def measure_sectors(flat: Array) -> Array:
    """Sectors (4, R, C) left-down, right-down, right-up, left-up at inner vertices (radians).

    flat: Vertices (rows, columns, 2).
    """
    here = flat[1:-1, 1:-1]
    ends = flat[1:-1, :-2], flat[2:, 1:-1], flat[1:-1, 2:], flat[:-2, 1:-1]
    arms = [each - here for each in ends]
    return np.stack([_angle(u, v) for u, v in zip(arms, [*arms[1:], arms[0]], strict=True)])


def _angle(u: Array, v: Array) -> Array:
    """Angles (...) in [0, 2 pi) by which plane vectors (..., 2) turn to the left."""
    across = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    return np.asarray(np.arctan2(across, (u * v).sum(axis=-1)) % (2 * np.pi))


def _require_flat_foldable(sectors: Array) -> None:
    away = np.abs(sectors[:2] + sectors[2:] - np.pi).max(axis=0)
    if not away.size or away.max() <= FLAT_FOLDABLE:
        return
    row, column = np.unravel_index(first_largest(away), away.shape)
    raise DesignError(
        "whole boards on hinges need a sheet that folds flat",
        place=f"at vertex [{row + 1}, {column + 1}]",
        keys=("panel.construction",),
        size=f"opposite sectors miss 180 degrees together by {np.rad2deg(away.max()):.3g} degrees",
        excess=float(away.max()) / np.pi,
    )
