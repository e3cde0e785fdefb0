"""Which sheets exist: the most even lengths of all creases, by a linear program.

Lengths may be scaled, so let the shortest inner crease be at least 1 and make the longest as short
as possible, under the closing of all panels (``lengths``). The program has a solution exactly where
a sheet with positive lengths exists, and its solution is the sheet whose longest and shortest
inner crease differ least.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from orishell.conventions.formatting import inside
from orishell.conventions.record import record
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Columns,
    Directions,
    RowKind,
)
from orishell.families.longitudinal_linear_repeating.tessellation.lengths import march
from orishell.families.longitudinal_linear_repeating.tessellation.program import (
    LengthsProgram,
    Wanted,
)
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import bisect_integers

LARGEST_RATIO = 1000.0
"""A sheet whose longest inner crease is more than this times the shortest does not count."""
REASONABLE = 10.0
"""The length of a row is quoted for creases between a tenth of column 1's mean and ten times it."""
PROGRAM_PANELS = 12_000
"""Sheets of more inner panels are too large for the program; they get equal lengths or none."""


@record
class InnerLengths:
    """Lengths of the inner creases of a sheet.

    row, column: Of the row creases (m, n-1) and of the column creases (m-1, n).
    """

    row: Array
    column: Array

    @classmethod
    def marched(cls, directions: Directions, row: Array, column: Array) -> InnerLengths:
        """The lengths that those of the middle row and column 1 determine; some may be negative."""
        return cls(*march(directions, row, column))

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

    def with_mean_column(self) -> InnerLengths:
        """Scaled so that the mean column crease is 1; the mean row crease if there is none."""
        return self.scaled(float(1 / (self.column if self.column.size else self.row).mean()))


def find_even_lengths(directions: Directions, wanted: Wanted) -> InnerLengths | None:
    """The most even lengths, or None if no sheet has positive ones.

    Scaled as ``wanted.column`` if that is given, else to a mean column crease of 1.
    """
    m, n = directions.row.shape[0], directions.column.shape[1]
    if (m - 1) * (n - 1) > PROGRAM_PANELS:
        solved: tuple[Array, Array] | None = (
            np.ones(n - 1) if wanted.row is None else wanted.row,
            np.ones(m - 1) if wanted.column is None else wanted.column,
        )
    else:
        solved = LengthsProgram(directions, wanted).most_even()
    if solved is None:
        return None
    # The program closes panels to its tolerance; marching closes them to rounding.
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
    return found if wanted.column is not None else found.with_mean_column()


def advance_range(
    directions: Directions, wanted: Wanted, weights: Array
) -> tuple[float, float] | None:
    """Least and greatest weighted sum of the middle row's lengths, with a given column 1.

    Of sheets whose inner creases are not out of all proportion to the column's. None if there is
    no such sheet, or it is too large for the program.
    """
    m, n = directions.row.shape[0], directions.column.shape[1]
    if (m - 1) * (n - 1) > PROGRAM_PANELS or wanted.column is None:
        return None
    mean = float(wanted.column.mean())
    program = LengthsProgram(directions, wanted)
    limits = program.advance_limits(weights, mean / REASONABLE, mean * REASONABLE)
    if limits is None:
        return None
    least, greatest = limits
    return inside(least, greatest), inside(greatest, least)


def largest_size(works: Callable[[int], bool], most: int) -> int:
    """The largest working size in 1 ... most, if all sizes below a working one work too."""
    good, bad = 1, 2
    while bad <= most and works(bad):
        good, bad = bad, 2 * bad
    return bisect_integers(works, good, min(bad, most + 1))


def largest_square(columns: Columns, first_row: RowKind, most: int) -> int:
    """Size of the largest square sheet, at most ``most`` and the number of columns."""

    def works(size: int) -> bool:
        directions = Directions.of(columns.first(size), size, first_row)
        return find_even_lengths(directions, Wanted()) is not None

    return largest_size(works, min(most, len(columns)))
