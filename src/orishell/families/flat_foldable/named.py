"""Sheets by a few numbers: Miura-ori, and sheets that grade from it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.families.flat_foldable.net import Net
from orishell.numerics.arrays import Array
from orishell.polylines import alternating

LEAST_SINE = 1e-9


def graded_net(
    rows: int,
    columns: int,
    *,
    folds: Sequence[float],
    sectors: Sequence[float],
    row_lengths: Sequence[float] = (1.0,),
    column_lengths: Sequence[float] = (1.0,),
) -> Net:
    """A sheet whose columns go straight through its middle row.

    Lists are gone through again and again. One number each makes a Miura-ori sheet.

    Parameters
    ----------
    rows, columns
        Numbers of inner vertices.
    folds
        Fold angles of the row creases at the target (radians).
    sectors
        Sector angles at the vertices of the middle row, to one side and the other of straight
        columns by turns (radians). There the row creases fold by 1/cos(sector) times as much as the
        column creases do, by the tangents of half the angles.
    row_lengths
        Lengths of edges along the middle row, border to border.
    column_lengths
        Lengths of edges down the middle column, border to border.
    """
    tangents = np.tan(0.5 * _cycled(folds, rows))
    angles = _cycled(sectors, columns)
    x = tangents * alternating(rows)
    y = tangents[rows // 2] * np.cos(angles) * alternating(columns)
    along = _cycled(row_lengths, columns + 1)
    down = _cycled(column_lengths, rows + 1)
    net = Net(
        x=x[:, None],
        y=y[:, None],
        row_angles=np.zeros((columns, 1)),
        column_angles=np.zeros((rows, 1)),
        row_lengths=along[1:-1, None],
        column_lengths=down[1:-1, None],
        top=np.full((columns, 1), down[0]),
        bottom=np.full((columns, 1), down[-1]),
        left=np.full((rows, 1), along[0]),
        right=np.full((rows, 1), along[-1]),
        corners=np.ones((4, 2, 1)),
    )
    return net.with_straight_columns()


@record
class NamedSheet:
    """What the numbers of a named sheet are (lengths; angles in radians)."""

    rows: int
    columns: int
    sector: float  # acute, between rows and columns
    fold: float  # the largest fold angle at the target
    row_length: float  # of the rows that fold most
    column_length: float  # of the first edge of a column
    growth: float  # of the last edge of a column by the first

    def miura(self) -> Net:
        """Miura-ori."""
        return self._net([self.fold], [self.sector])

    def arch(self, turn: float) -> Net:
        """Columns that turn by an angle from their first to their last row at the target.

        A straight column turns by delta at a row, to one side and the other by turns, with

            sin(delta/2) = sin(sector) sin(fold/2).

        If every second row folds less, what is left of two of them is the turn of the arch; those
        rows have another sector angle, as all columns fold alike, by tan(fold/2) cos(sector).
        """
        ahead = 2 * np.arcsin(np.sin(self.sector) * np.sin(0.5 * self.fold))
        # Rows that would have to turn back by less than nothing fold like the columns: no sheet.
        back = max(float(np.sin(0.5 * ahead - turn / self.rows)), 0.0)
        column = np.tan(0.5 * self.fold) * np.cos(self.sector)
        tangent = np.sqrt((column**2 + back**2) / (1 - back**2))
        less = 2 * float(np.arctan(tangent))
        # The first row is one of those that fold most, so that the arch ends steeply.
        middle = (
            self.sector if self.rows // 2 % 2 == 0 else float(np.arccos(min(column / tangent, 1)))
        )
        along = self.row_length * np.sin(self.sector) / max(np.sin(middle), LEAST_SINE)
        net = replace(self, row_length=float(along))._net([self.fold, less], [middle])
        # Rows of another sector are deeper, so that every second column has longer and shorter
        # edges by turns: half of that is for the columns between them.
        j = net.middle[1]
        more = np.diff(net.march().columns[:, [j, j - 1]], axis=1)[:, 0]
        return replace(net, column_lengths=net.column_lengths - 0.5 * more)

    def fan(self, turn: float) -> Net:
        """Columns that run apart downwards, the last from the first by an angle when flat.

        From one column to the next it is the difference of their sector angles.
        """
        half = 0.5 * turn / max(self.columns - 1, 1)
        return self._net([self.fold], [self.sector + half, self.sector - half])

    def _net(self, folds: Sequence[float], sectors: Sequence[float]) -> Net:
        lengths = self.column_length * np.geomspace(1.0, self.growth, self.rows + 1)
        return graded_net(
            self.rows,
            self.columns,
            folds=folds,
            sectors=sectors,
            row_lengths=[self.row_length],
            column_lengths=lengths.tolist(),
        )


def _cycled(values: Sequence[float], count: int) -> Array:
    return np.resize(np.asarray(values, dtype=np.float64), count)
