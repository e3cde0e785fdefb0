"""Which sheets exist: the most even lengths of all creases, by linear programs.

Lengths may be scaled, so let the shortest inner crease be at least 1 and make the longest as short
as possible, under the closing of all panels (``lengths``). The program has a solution exactly where
a sheet with positive lengths exists, and its solution is the sheet whose longest and shortest
inner crease differ least. Where column 1 is given it has few unknowns (``following_sheets``).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from orishell.conventions.formatting import inside
from orishell.conventions.record import record
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Columns,
    Directions,
    RowKind,
)
from orishell.families.longitudinal_linear_repeating.tessellation.following_sheets import (
    LARGEST_RATIO,
    FollowingSheets,
)
from orishell.families.longitudinal_linear_repeating.tessellation.lengths import (
    InnerLengths,
    PanelFactors,
)
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.bisection import bisect_integers

REASONABLE = 10.0
"""The length of a row is quoted for creases between a tenth of column 1's mean and ten times it."""
PROGRAM_PANELS = 12_000
"""Sheets of more inner panels are too large for a program; they get equal lengths or none."""
FOLLOWING_COLUMNS = 500
"""So are those of more columns whose column 1 is given: its unknowns are in all conditions."""
UNTRIED = "with equal lengths creases would have zero or negative length, and others were not tried"
"""What is known of such a sheet that was not found."""


@record
class Wanted:
    """What the lengths must satisfy, up to a common scale."""

    row: Array | None = None  # ratios of the middle row's lengths (n-1,)
    column: Array | None = None  # ratios of column 1's inner lengths (m-1,)
    # with a column: column 1's first and last length in its unit, for which there must be room,
    # that is, their panels must be convex
    ends: tuple[float, float] | None = None
    # with a column: weights (n-1,) of the middle row's lengths, and their weighted sum in its unit
    advance: tuple[Array, float] | None = None


class LengthsProgram:
    """The linear program; its variables are all lengths, a scale and the longest length.

    The scale is that of the wanted row.
    """

    def __init__(self, directions: Directions, row: Array | None) -> None:
        m, n = directions.row.shape[0], directions.column.shape[1]
        rows = np.arange(m * (n - 1)).reshape(m, n - 1)
        columns = rows.size + np.arange((m - 1) * n).reshape(m - 1, n)
        self.lengths = rows.size + columns.size
        self.middle, self.first_column = rows[m // 2], columns[:, 0]
        self.scale, self.longest = self.lengths + np.arange(2)
        self._entries: list[tuple[Integers, Integers, Array]] = []
        self._count = 0

        factors = PanelFactors.of(directions)
        top, left = rows[:-1], columns[:, :-1]
        self._equal((rows[1:], 1.0), (top, -factors.bottom_top), (left, -factors.bottom_left))
        self._equal((columns[:, 1:], 1.0), (top, -factors.right_top), (left, -factors.right_left))
        if row is not None:
            self._equal((self.middle, 1.0), (np.full(n - 1, self.scale), -row))

    def _equal(self, *terms: tuple[Integers, Array | float]) -> None:
        """Add one equation per element: coefficients times variables sum to 0."""
        size = terms[0][0].size
        for variables, coefficients in terms:
            values = np.broadcast_to(coefficients, variables.shape).ravel()
            self._entries.append((self._count + np.arange(size), variables.ravel(), values))
        self._count += size

    def most_even(self) -> tuple[Array, Array] | None:
        """Lengths (n-1,) of the middle row and (m-1,) of column 1, the shortest of all being 1."""
        from scipy import sparse
        from scipy.optimize import linprog

        longest = sparse.csc_array(
            (-np.ones(self.lengths), (np.arange(self.lengths), np.ones(self.lengths, np.intp))),
            shape=(self.lengths, 2),
        )
        equations, variables, values = (
            np.concatenate(part) for part in zip(*self._entries, strict=True)
        )
        cost = np.zeros(self.lengths + 2)
        cost[self.longest] = 1.0
        solve: Callable[..., Any] = linprog  # the stubs of scipy know no sparse constraints
        result = solve(
            cost,
            A_ub=sparse.hstack([sparse.eye_array(self.lengths), longest], format="csc"),
            b_ub=np.zeros(self.lengths),
            A_eq=sparse.csc_array(
                (values, (equations, variables)), shape=(self._count, self.lengths + 2)
            ),
            b_eq=np.zeros(self._count),
            bounds=[(1.0, None)] * self.lengths + [(0.0, None)] * 2,
        )
        return (result.x[self.middle], result.x[self.first_column]) if result.success else None


def fits_program(rows: int, columns: int, *, following: bool) -> bool:
    """Whether the most even lengths are looked for in a sheet of so many inner vertices.

    following: Whether its column 1 is given.
    """
    return (rows - 1) * (columns - 1) <= PROGRAM_PANELS and not (
        following and columns > FOLLOWING_COLUMNS
    )


def find_even_lengths(directions: Directions, wanted: Wanted) -> InnerLengths | None:
    """The most even lengths, or None if no sheet has positive ones.

    Scaled as ``wanted.column`` if that is given, else so that the mean column crease is 1, or the
    mean row crease if there is none.
    """
    m, n = directions.row.shape[0], directions.column.shape[1]
    if not fits_program(m, n, following=wanted.column is not None):
        solved: tuple[Array, Array] | None = (
            np.ones(n - 1) if wanted.row is None else wanted.row,
            np.ones(m - 1) if wanted.column is None else wanted.column,
        )
    else:
        solved = (
            LengthsProgram(directions, wanted.row).most_even()
            if wanted.column is None
            else FollowingSheets.of(
                directions, wanted.column, wanted.row, wanted.ends, wanted.advance
            ).most_even()
        )
    if solved is None:
        return None
    # A program closes panels to its tolerance; marching closes them to rounding.
    row, column = solved
    if wanted.column is not None and m > 1:
        row, column = row * (wanted.column.sum() / column.sum()), wanted.column
    if wanted.row is not None:
        row = wanted.row * (row.sum() / wanted.row.sum())
    if wanted.advance is not None:
        weights, total = wanted.advance
        row = row * (total / float(weights @ row))
    found = InnerLengths.marched(directions, row, column)
    if found.ratio > LARGEST_RATIO:
        return None
    if wanted.column is not None:
        return found
    return found.scaled(float(1 / (found.column if found.column.size else found.row).mean()))


def advance_range(
    directions: Directions, wanted: Wanted, weights: Array
) -> tuple[float, float] | None:
    """Least and greatest weighted sum of the middle row's lengths, with a given column 1.

    Only of sheets whose inner creases are in proportion to the column's. None if there is no such
    sheet, or it is too large for the program.
    """
    m, n = directions.row.shape[0], directions.column.shape[1]
    if wanted.column is None or not fits_program(m, n, following=True):
        return None
    mean = float(wanted.column.mean())
    sheets = FollowingSheets.of(directions, wanted.column, wanted.row, wanted.ends, None)
    limits = sheets.advance_limits(weights, mean / REASONABLE, mean * REASONABLE)
    if limits is None:
        return None
    least, greatest = limits
    return inside(least, greatest), inside(greatest, least)


def sheet_exists(columns: Columns, rows: int, first_row: RowKind) -> bool:
    """Whether any lengths make a sheet of these angles and size."""
    return find_even_lengths(Directions.of(columns, rows, first_row), Wanted()) is not None


def largest_size(works: Callable[[int], bool], most: int) -> int:
    """The largest working size in 1 ... most, if all sizes below a working one work too."""
    good, bad = 1, 2
    while bad <= most and works(bad):
        good, bad = bad, 2 * bad
    return bisect_integers(works, good, min(bad, most + 1))


def largest_square(columns: Columns, first_row: RowKind, most: int) -> int:
    """Size of the largest square sheet, at most ``most`` and the number of columns."""
    return largest_size(
        lambda size: sheet_exists(columns.first(size), size, first_row), min(most, len(columns))
    )
