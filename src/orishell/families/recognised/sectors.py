"""The sector angles of a flat sheet of quadrilaterals, which say all about its family."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import CreaseValues
from orishell.numerics.arrays import Array, Booleans


@record
class Sectors:
    """Sector angles (R, C) at inner vertices, between creases of rows and columns (radians)."""

    ru: Array  # right-up
    lu: Array  # left-up
    ld: Array  # left-down
    rd: Array  # right-down
    # whether row creases are of one sign (R, C), which fold more then; None if that is not said
    row_mode: Booleans | None

    @property
    def straight(self) -> Array:
        """By how much (R, C) column creases are bent, half of it on either side."""
        return np.stack([self.ru + self.rd, self.lu + self.ld]) - np.pi

    @property
    def kawasaki(self) -> Array:
        """By how much (R, C) opposite sectors miss 180 degrees together."""
        return np.stack([self.lu + self.rd, self.ru + self.ld]) - np.pi

    def part(self, top: int, bottom: int, left: int, right: int) -> Sectors:
        """Those of a sheet that is cut off by so many rows and columns at its sides."""
        rows, columns = self.ru.shape
        place = slice(top, rows - bottom), slice(left, columns - right)
        mode = None if self.row_mode is None else self.row_mode[place]
        return Sectors(self.ru[place], self.lu[place], self.ld[place], self.rd[place], mode)


def sectors_of(flat: Array, signs: CreaseValues | None) -> Sectors:
    """Measure a flat sheet, drawn from either side.

    Parameters
    ----------
    flat
        Vertices (rows, columns, 2).
    signs
        Of the creases, NaN where none is said.
    """
    inner = flat[1:-1, 1:-1]
    around = [flat[1:-1, 2:], flat[:-2, 1:-1], flat[1:-1, :-2], flat[2:, 1:-1]]
    heading = [np.arctan2(*np.moveaxis(each - inner, -1, 0)[::-1]) for each in around]
    across, down = flat[:-1, 1:] - flat[:-1, :-1], flat[1:, :-1] - flat[:-1, :-1]
    seen = np.sign(np.sum(down[..., 0] * across[..., 1] - down[..., 1] * across[..., 0]))
    ru, lu, ld, rd = (
        np.mod(seen * (after - before), 2 * np.pi)
        for before, after in zip(heading, heading[1:] + heading[:1], strict=True)
    )
    return Sectors(ru, lu, ld, rd, None if signs is None else _row_mode(signs))


def _row_mode(signs: CreaseValues) -> Booleans | None:
    row, column = signs.row[:, :-1] * signs.row[:, 1:], signs.column[:-1] * signs.column[1:]
    if np.isnan(row).any() and np.isnan(column).any():
        return None
    return np.asarray(np.where(np.isnan(row), -column, row) > 0)
