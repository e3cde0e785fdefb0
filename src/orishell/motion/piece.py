"""Some rows of a sheet as a sheet of their own, which folds by the same angles."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.on_sheet import OnSheet
from orishell.numerics.arrays import Array


@record
class SheetPiece(OnSheet):
    """A run of rows of panels of a sheet without flaps."""

    rows: slice  # of panels

    @property
    def grid(self) -> Grid:
        """The grid of its vertices."""
        return Grid(self.rows.stop - self.rows.start + 1, self.sheet.grid.columns)

    def without_flaps(self) -> SheetPiece:
        """These rows of the sheet without flaps."""
        return self.on(self.sheet.without_flaps())

    def with_stop(self, stop: float) -> SheetPiece:
        """These rows of the sheet whose flaps stop short of folding flat."""
        return self.on(self.sheet.with_stop(stop))

    def positions(self, drive: ArrayLike) -> Array:
        """Positions (..., rows, columns, 3) of its vertices."""
        vertices = slice(self.rows.start, self.rows.stop + 1)
        return np.asarray(self.sheet.positions(drive)[..., vertices, :, :])

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of its creases."""
        folds = self.sheet.fold_angles(drive)
        inner = slice(self.rows.start, self.rows.stop - 1)
        return CreaseValues(folds.row[..., inner, :], folds.column[..., self.rows, :])

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the accelerations of its edges."""
        along, down = self.sheet.edge_accelerations(start, stop)
        return along, down[:, self.rows]
