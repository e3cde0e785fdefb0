"""Sheets by a few numbers: Miura-ori, and sheets that grade from it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.families.flat_foldable.net import Net
from orishell.numerics.arrays import Array
from orishell.polylines import alternating


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
        Lengths of edges along the middle row.
    column_lengths
        Lengths of edges down the middle column.
    """
    tangents = np.tan(0.5 * _gone_through(folds, rows))
    angles = _gone_through(sectors, columns)
    x = tangents * alternating(rows)
    y = tangents[rows // 2] * np.cos(angles) * alternating(columns)
    along = _gone_through(row_lengths, columns + 1)
    down = _gone_through(column_lengths, rows + 1)
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


def _gone_through(values: Sequence[float], count: int) -> Array:
    return np.resize(np.asarray(values, dtype=np.float64), count)
