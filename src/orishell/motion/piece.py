"""Some rows of a sheet as a sheet of their own, which folds by the same angles."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.mechanism import Mechanism, mechanism_in_one_line
from orishell.numerics.arrays import Array


@record
class SheetPiece:
    """A run of rows of panels of a sheet without flaps."""

    whole: Mechanism
    rows: slice  # of panels

    def __repr__(self) -> str:
        return mechanism_in_one_line(self)

    @property
    def grid(self) -> Grid:
        """The grid of its vertices."""
        return Grid(self.rows.stop - self.rows.start + 1, self.whole.grid.columns)

    @property
    def inner_columns(self) -> slice:
        """Those of the sheet."""
        return self.whole.inner_columns

    @property
    def flap_columns(self) -> tuple[int, ...]:
        """Those of the sheet."""
        return self.whole.flap_columns

    def without_flaps(self) -> Mechanism:
        """These rows of the sheet without flaps."""
        return SheetPiece(self.whole.without_flaps(), self.rows)

    def with_stop(self, stop: float) -> Mechanism:
        """These rows of the sheet whose flaps stop short of folding flat."""
        return SheetPiece(self.whole.with_stop(stop), self.rows)

    @property
    def least_turning(self) -> Mechanism:
        """These rows of the sheet that turns as little as possible."""
        return SheetPiece(self.whole.least_turning, self.rows)

    @property
    def target_drive(self) -> float:
        """That of the sheet."""
        return self.whole.target_drive

    @property
    def end_drive(self) -> float:
        """That of the sheet."""
        return self.whole.end_drive

    def positions(self, drive: ArrayLike) -> Array:
        """Positions (..., rows, columns, 3) of its vertices."""
        vertices = slice(self.rows.start, self.rows.stop + 1)
        return np.asarray(self.whole.positions(drive)[..., vertices, :, :])

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of its creases."""
        folds = self.whole.fold_angles(drive)
        inner = slice(self.rows.start, self.rows.stop - 1)
        return CreaseValues(folds.row[..., inner, :], folds.column[..., self.rows, :])

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the accelerations of its edges."""
        along, down = self.whole.edge_accelerations(start, stop)
        return along, down[:, self.rows]
