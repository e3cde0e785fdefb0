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

    @property
    def inner_ratio(self) -> float:
        """The longest inner crease over the shortest."""
        inner = np.concatenate([self.row[:, 1:-1].ravel(), self.column[1:-1].ravel()])
        return float(inner.max() / inner.min())


@record
class PanelFactors:
    """Coefficients (m-1, n-1) of the equations that close the inner panels.

    Bottom = ``bottom_top`` top + ``bottom_left`` left, right = ``right_top`` top + ``right_left``
    left.
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


@record
class InnerLengths:
    """Lengths of the inner creases of a sheet, or of several."""

    row: Array  # of the row creases (..., m, n-1)
    column: Array  # of the column creases (..., m-1, n)

    @classmethod
    def marched(cls, directions: Directions, row: Array, column: Array) -> InnerLengths:
        """The lengths that those of middle rows (..., n-1) and of columns 1 (..., m-1) determine.

        Not all are positive where no such sheet exists.
        """
        factors = PanelFactors.of(directions)
        m, n = directions.row.shape[0], directions.column.shape[1]
        rows, columns = np.empty((*row.shape[:-1], m, n - 1)), np.empty((*row.shape[:-1], m - 1, n))
        middle = m // 2
        rows[..., middle, :], columns[..., 0] = row, column
        for i in range(middle, m - 1):
            gain = factors.right_top[i] * rows[..., i, :]
            columns[..., i, :] = left = _across(factors.right_left[i], gain, column[..., i, None])
            rows[..., i + 1, :] = (
                factors.bottom_top[i] * rows[..., i, :] + factors.bottom_left[i] * left[..., :-1]
            )
        for i in range(middle - 1, -1, -1):
            # The same closing, solved for the top: bottom and left are known.
            share = factors.right_top[i] / factors.bottom_top[i]
            below = rows[..., i + 1, :]
            factor = factors.right_left[i] - share * factors.bottom_left[i]
            columns[..., i, :] = left = _across(factor, share * below, column[..., i, None])
            rows[..., i, :] = (below - factors.bottom_left[i] * left[..., :-1]) / (
                factors.bottom_top[i]
            )
        return cls(rows, columns)

    @property
    def shortest(self) -> float:
        """Length of the shortest crease."""
        return float(min(self.row.min(), self.column.min(initial=np.inf)))

    @property
    def ratio(self) -> float:
        """The longest length over the shortest; infinite where one is not positive."""
        longest = max(self.row.max(), self.column.max(initial=0.0))
        return float(longest / self.shortest) if self.shortest > 0 else np.inf

    def scaled(self, factor: float) -> InnerLengths:
        """All lengths times a factor."""
        return InnerLengths(self.row * factor, self.column * factor)


def _across(factor: Array, gain: Array, first: Array) -> Array:
    """The sequences (..., K+1) of x_0 = first (..., 1) and x_{j+1} = factor_j x_j + gain_j.

    The products of the factors stay bounded, because column directions return every period.
    """
    product = np.concatenate([[1.0], np.cumprod(factor)])
    found = np.empty((*gain.shape[:-1], len(product)))
    found[..., :1] = first
    found[..., 1:] = first + np.cumsum(gain / product[1:], axis=-1)
    return product * found


def end_limits(directions: Directions, rows: Array, bottom: bool) -> Array:
    """Lengths (n,) at which the column creases at one end would meet those beside them.

    With w the border edge of an end panel, w must lie to the same side of both column creases
    beside it; both conditions have one of the two lengths in them. Infinite where column creases
    diverge. ``rows``: Lengths (m, n-1) of the inner row creases.
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
    directions: Directions, inner: InnerLengths, ends: tuple[float, float], flap: float
) -> EdgeLengths:
    """Lengths of all creases, the border's included.

    ends: Lengths of column 1's first and last crease; those of other columns are to it as their
        nearest inner creases, or shorter, so that the panels stay convex.
    flap: Length of the row creases at the left and the right border.
    """
    rows, columns, border = inner.row, inner.column, []
    for bottom, end in zip((False, True), ends, strict=True):
        near = columns[-1 if bottom else 0] if len(columns) else np.ones(columns.shape[1])
        length = end * near / near[0]
        length = np.minimum(length, END_SHARE * end_limits(directions, rows, bottom))
        length[0] = end
        border.append(length[None])
    side = np.full((len(rows), 1), flap)
    return EdgeLengths(
        row=np.concatenate([side, rows, side], axis=1),
        column=np.concatenate([border[0], columns, border[1]]),
    )
