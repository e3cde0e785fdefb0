"""Lengths of the creases: marched from one row and one column, and completed at the border.

A panel with its upper left corner at vertex (i, j) closes when, with the directions R and D of
``tessellation`` (t and b its top and bottom crease, l and r its left and right one),

    L_b = (L_t cos(D_r - R_t) + L_l sin(D_r - D_l)) / cos(D_r - R_b),
    L_r = (L_l cos(D_l - R_b) - L_t sin(R_b - R_t)) / cos(D_r - R_b).

So all lengths are linear in those of one row and of column 1.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.families.longitudinal_linear_repeating.tessellation.columns import Directions
from orishell.numerics.arrays import Array

END_SHARE = 0.8
"""Column creases at the ends of the sheet are at most this share of the length at which they meet
those beside them."""


@record
class EdgeLengths:
    """Lengths of all creases."""

    row: Array  # of the row creases (m, n+1), from the left border to the right
    column: Array  # of the column creases (m+1, n), from the top border to the bottom

    def __post_init__(self) -> None:
        for array in (self.row, self.column):
            array.flags.writeable = False

    def shortest(self) -> float:
        """The shortest crease."""
        return float(min(self.row.min(), self.column.min()))

    @property
    def inner_ratio(self) -> float:
        """The longest inner crease over the shortest."""
        inner = np.concatenate([self.row[:, 1:-1].ravel(), self.column[1:-1].ravel()])
        return float(inner.max() / inner.min())


@record
class PanelFactors:
    """Coefficients (m-1, n-1) of the equations that close the inner panels.

    Bottom = ``bottom_top`` x top + ``bottom_left`` x left, right = ``right_top`` x top +
    ``right_left`` x left.
    """

    bottom_top: Array
    bottom_left: Array
    right_top: Array
    right_left: Array

    @classmethod
    def of(cls, directions: Directions) -> PanelFactors:
        """The coefficients for creases of given directions."""
        top, bottom = directions.row[:-1, 1:-1], directions.row[1:, 1:-1]
        left, right = directions.column[1:-1, :-1], directions.column[1:-1, 1:]
        closing = np.cos(right - bottom)
        return cls(
            bottom_top=np.cos(right - top) / closing,
            bottom_left=np.sin(right - left) / closing,
            right_top=-np.sin(bottom - top) / closing,
            right_left=np.cos(left - bottom) / closing,
        )


def march(directions: Directions, row: Array, column: Array) -> tuple[Array, Array]:
    """Lengths of all inner creases, from those of the middle row and of column 1.

    directions: Directions of the creases.
    row: Lengths (n-1,) of the middle row's inner creases.
    column: Lengths (m-1,) of column 1's inner creases.

    Returns rows, columns: Lengths (m, n-1) and (m-1, n); not positive where no such sheet exists.
    """
    factors = PanelFactors.of(directions)
    m, n = directions.row.shape[0], directions.column.shape[1]
    rows, columns = np.empty((m, n - 1)), np.empty((m - 1, n))
    middle = m // 2
    rows[middle], columns[:, 0] = row, column
    for i in range(middle, m - 1):
        columns[i] = _across(factors.right_left[i], factors.right_top[i] * rows[i], column[i])
        rows[i + 1] = factors.bottom_top[i] * rows[i] + factors.bottom_left[i] * columns[i, :-1]
    for i in range(middle - 1, -1, -1):
        # The same closing, solved for the top: bottom and left are known.
        share = factors.right_top[i] / factors.bottom_top[i]
        columns[i] = _across(
            factors.right_left[i] - share * factors.bottom_left[i], share * rows[i + 1], column[i]
        )
        rows[i] = (rows[i + 1] - factors.bottom_left[i] * columns[i, :-1]) / factors.bottom_top[i]
    return rows, columns


def _across(factor: Array, gain: Array, first: float) -> Array:
    """The sequence (K+1,) of x_0 = first and x_{j+1} = factor_j x_j + gain_j.

    The products of the factors stay bounded, because column directions return every period.
    """
    product = np.concatenate([[1.0], np.cumprod(factor)])
    return product * (first + np.concatenate([[0.0], np.cumsum(gain / product[1:])]))


def end_limits(directions: Directions, rows: Array, bottom: bool) -> Array:
    """Lengths (n,) at which the column creases at one end would meet those beside them.

    With w the border edge of an end panel, w must lie to the same side of both column creases
    beside it; both conditions have one of the two lengths in them. Infinite where column creases
    diverge.

    directions: Directions of the creases.
    rows: Lengths (m, n-1) of the inner row creases.
    bottom: Whether the end is the bottom.
    """
    last = -1 if bottom else 0
    row, column = directions.row[last, 1:-1], directions.column[last]
    converging = np.sin(np.diff(column)) * (-1 if bottom else 1)
    with np.errstate(divide="ignore"):
        reach = np.where(converging > 0, rows[last] / np.abs(converging), np.inf)
    as_left, as_right = reach * np.cos(row - column[1:]), reach * np.cos(row - column[:-1])
    limits: Array = np.minimum(np.append(as_left, np.inf), np.append(np.inf, as_right))
    return limits


def with_border(
    directions: Directions,
    rows: Array,
    columns: Array,
    ends: tuple[float, float],
    flap: float,
) -> EdgeLengths:
    """Lengths of all creases, the border's included.

    directions: Directions of the creases.
    rows, columns: Lengths of the inner creases (m, n-1) and (m-1, n).
    ends: Lengths of column 1's first and last crease; those of other columns are to it as their
        nearest inner creases, or shorter, so that the panels stay convex.
    flap: Length of the row creases at the left and the right border.
    """
    border = []
    for bottom, end in ((False, ends[0]), (True, ends[1])):
        inner = columns[-1 if bottom else 0] if len(columns) else np.ones(columns.shape[1])
        length = end * inner / inner[0]
        length = np.minimum(length, END_SHARE * end_limits(directions, rows, bottom))
        length[0] = end
        border.append(length[None])
    side = np.full((len(rows), 1), flap)
    return EdgeLengths(
        row=np.concatenate([side, rows, side], axis=1),
        column=np.concatenate([border[0], columns, border[1]]),
    )
