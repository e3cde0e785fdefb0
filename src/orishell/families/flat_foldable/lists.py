"""Sheets by their lists: as the design file gives them, and as the report shows those of any."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.design import Parameter
from orishell.families.flat_foldable.march import Numbers
from orishell.families.flat_foldable.net import Net, Sheet
from orishell.numerics.arrays import Array

CORNERS = (1.0,) * 8
"""Corners of parallelograms."""
LISTS = {
    "row_folds_deg": 0,
    "column_folds_deg": 1,
    "row_angles_deg": 1,
    "column_angles_deg": 0,
    "left_lengths": 0,
    "right_lengths": 0,
    "top_lengths": 1,
    "bottom_lengths": 1,
}
"""Lists with an entry for every row (0) or every column (1)."""
SHORTER = {"row_lengths": 1, "column_lengths": 0}
"""Lists with an entry between one column and the next, or one row and the next."""


@record
class Lists:
    """What makes a sheet, in the order of the rows and columns; None where it is chosen here."""

    # fold angles of each row's and column's first crease at the target, valley positive (radians)
    row_folds: Sequence[float]
    column_folds: Sequence[float]
    # sectors left-down of the vertices of the middle row and of the middle column (radians)
    row_angles: Sequence[float] | None
    column_angles: Sequence[float] | None
    # lengths of inner edges along the middle row and down the middle column
    row_lengths: Sequence[float]
    column_lengths: Sequence[float]
    # lengths of the creases that end at the border; None: as long as those before them
    top: Sequence[float] | None
    bottom: Sequence[float] | None
    left: Sequence[float] | None
    right: Sequence[float] | None
    corners: Sequence[float] | None  # as in Net, one after the other

    def net(self) -> Net:
        """The net of these lists."""
        rows, columns = len(self.row_folds), len(self.column_folds)
        along, down = _column(self.row_lengths), _column(self.column_lengths)
        net = Net(
            x=np.tan(0.5 * _column(self.row_folds)),
            y=np.tan(0.5 * _column(self.column_folds)),
            row_angles=np.zeros((columns, 1)),
            column_angles=np.zeros((rows, 1)),
            row_lengths=along,
            column_lengths=down,
            top=_border(self.top, columns, down[:1] if rows > 1 else along.mean(axis=0)),
            bottom=_border(self.bottom, columns, down[-1:] if rows > 1 else along.mean(axis=0)),
            left=_border(self.left, rows, along[:1]),
            right=_border(self.right, rows, along[-1:]),
            corners=np.reshape(CORNERS if self.corners is None else self.corners, (4, 2, 1)),
        )
        straight = net.with_straight_columns()
        row = straight.row_angles if self.row_angles is None else _logs(self.row_angles)
        column = straight.column_angles.copy()
        if self.column_angles is not None:
            column = _logs(self.column_angles)
        i, j = net.middle
        column[i] = row[j]
        return replace(net, row_angles=row, column_angles=column)


def describe(sheet: Sheet) -> dict[str, Parameter]:
    """The lists of a sheet as the table [pattern] takes them, and what it looks like.

    Degrees, and lengths in the unit of the design.
    """
    net = sheet.net
    flat = np.moveaxis(sheet.flat()[..., 0], 0, -1)
    edges = np.concatenate(
        [np.linalg.norm(np.diff(flat, axis=axis), axis=-1).ravel() for axis in (0, 1)]
    )
    sectors = np.rad2deg(np.stack([sheet.a, sheet.b]))
    return {
        "row_folds_deg": _degrees(2 * np.arctan(net.x)),
        "column_folds_deg": _degrees(2 * np.arctan(net.y)),
        "row_angles_deg": _degrees(2 * np.arctan(np.exp(net.row_angles))),
        "column_angles_deg": _degrees(2 * np.arctan(np.exp(net.column_angles))),
        "row_lengths": net.row_lengths[:, 0].tolist(),
        "column_lengths": net.column_lengths[:, 0].tolist(),
        "top_lengths": net.top[:, 0].tolist(),
        "bottom_lengths": net.bottom[:, 0].tolist(),
        "left_lengths": net.left[:, 0].tolist(),
        "right_lengths": net.right[:, 0].tolist(),
        "corners": net.corners[..., 0].ravel().tolist(),
        "sector_interval_deg": [float(sectors.min()), float(sectors.max())],
        "edge_ratio": float(edges.max() / edges.min()),
    }


def _column(values: Sequence[float]) -> Array:
    return np.asarray(values, dtype=np.float64).reshape(-1, 1)


def _border(given: Sequence[float] | None, count: int, beside: Array) -> Array:
    return np.full((count, 1), beside) if given is None else _column(given)


def _logs(angles: Sequence[float]) -> Array:
    return np.asarray(np.log(np.tan(0.5 * _column(angles))))


def _degrees(angles: Numbers) -> list[float]:
    found: list[float] = np.rad2deg(angles[:, 0]).tolist()
    return found
