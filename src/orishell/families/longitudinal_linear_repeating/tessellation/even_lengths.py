"""Which sheets exist: the most even lengths of all creases, by a linear program.

Lengths may be scaled, so let the shortest inner crease be at least 1 and make the longest as short
as possible, under the closing of all panels (``lengths``). The program has a solution exactly where
a sheet with positive lengths exists, and its solution is the sheet whose longest and shortest
inner crease differ least.
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
from orishell.families.longitudinal_linear_repeating.tessellation.lengths import (
    END_SHARE,
    InnerLengths,
    PanelFactors,
    end_limits,
)
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.bisection import bisect_integers

LARGEST_RATIO = 1000.0
"""A sheet whose longest inner crease is more than this times the shortest does not count."""
REASONABLE = 10.0
"""The length of a row is quoted for creases between a tenth of column 1's mean and ten times it."""
PROGRAM_PANELS = 12_000
"""Sheets of more inner panels are too large for the program; they get equal lengths or none."""


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
    """The linear program; its variables are all lengths, two scales and the longest length.

    The scales are those of the wanted row and column.
    """

    def __init__(self, directions: Directions, wanted: Wanted) -> None:
        m, n = directions.row.shape[0], directions.column.shape[1]
        rows = np.arange(m * (n - 1)).reshape(m, n - 1)
        columns = rows.size + np.arange((m - 1) * n).reshape(m - 1, n)
        self.lengths = rows.size + columns.size
        self.middle, self.first_column = rows[m // 2], columns[:, 0]
        self.row_scale, self.column_scale, self.longest = self.lengths + np.arange(3)
        self._entries: list[tuple[Integers, Integers, Array]] = []
        self._count = 0

        factors = PanelFactors.of(directions)
        top, left = rows[:-1], columns[:, :-1]
        self._equal((rows[1:], 1.0), (top, -factors.bottom_top), (left, -factors.bottom_left))
        self._equal((columns[:, 1:], 1.0), (top, -factors.right_top), (left, -factors.right_left))
        if wanted.row is not None:
            self._equal((self.middle, 1.0), (np.full(n - 1, self.row_scale), -wanted.row))
        if wanted.column is not None:
            scale = np.full(m - 1, self.column_scale)
            self._equal((self.first_column, 1.0), (scale, -wanted.column))
        if wanted.advance is not None:
            weights, total = wanted.advance
            self._add(
                np.zeros(n, np.intp),
                np.append(self.middle, self.column_scale),
                np.append(weights, -total),
            )
            self._count += 1
        self._room: list[tuple[int, float, float]] = []
        if wanted.ends is not None:
            ends = zip((False, True), wanted.ends, (rows[0, 0], rows[-1, 0]), strict=True)
            for bottom, end, crease in ends:
                limit = END_SHARE * end_limits(directions, np.ones((m, n - 1)), bottom)[0]
                if np.isfinite(limit):
                    self._room.append((int(crease), float(limit), end))

    def _equal(self, *terms: tuple[Integers, Array | float]) -> None:
        """Add one equation per element: coefficients times variables sum to 0."""
        size = terms[0][0].size
        for variables, coefficients in terms:
            values = np.broadcast_to(coefficients, variables.shape).ravel()
            self._add(np.arange(size), variables.ravel(), values)
        self._count += size

    def _add(self, equations: Integers, variables: Integers, values: Array) -> None:
        self._entries.append((self._count + equations, variables, values))

    def most_even(self) -> tuple[Array, Array] | None:
        """Lengths (n-1,) of the middle row and (m-1,) of column 1, the shortest of all being 1."""
        from scipy import sparse

        longest = sparse.csc_array(
            (-np.ones(self.lengths), (np.arange(self.lengths), np.full(self.lengths, 2))),
            shape=(self.lengths, 3),
        )
        at_most = sparse.hstack([sparse.eye_array(self.lengths), longest])
        bounds = [(1.0, None)] * self.lengths + [(0.0, None)] * 3
        cost = np.zeros(self.lengths + 3)
        cost[self.longest] = 1.0
        x = self._solve(cost, bounds, at_most)
        return None if x is None else (x[self.middle], x[self.first_column])

    def advance_limits(self, weights: Array, low: float, high: float) -> tuple[float, float] | None:
        """Least and greatest weighted sum of the middle row, with column 1 as long as wanted.

        low, high: Bounds of all lengths.
        """
        from scipy import sparse

        bounds = [(low, high)] * self.lengths + [(0.0, None), (1.0, 1.0), (0.0, None)]
        limits = []
        for sign in (1.0, -1.0):
            cost = np.zeros(self.lengths + 3)
            cost[self.middle] = sign * weights
            x = self._solve(cost, bounds, sparse.csc_array((0, self.lengths + 3)))
            if x is None:
                return None
            limits.append(float(x[self.middle] @ weights))
        return limits[0], limits[1]

    def _solve(self, cost: Array, bounds: list[Any], at_most: Any) -> Array | None:
        from scipy import sparse
        from scipy.optimize import linprog

        equations, variables, values = (
            np.concatenate(part) for part in zip(*self._entries, strict=True)
        )
        equal = sparse.csc_array(
            (values, (equations, variables)), shape=(self._count, self.lengths + 3)
        )
        room = sparse.lil_array((len(self._room), self.lengths + 3))
        for number, (crease, limit, end) in enumerate(self._room):
            room[number, self.column_scale], room[number, crease] = end, -limit
        at_most = sparse.vstack([at_most, room], format="csc")
        solve: Callable[..., Any] = linprog  # the stubs of scipy know no sparse constraints
        result = solve(
            cost,
            A_ub=at_most,
            b_ub=np.zeros(at_most.shape[0]),
            A_eq=equal,
            b_eq=np.zeros(self._count),
            bounds=bounds,
        )
        return np.asarray(result.x) if result.success else None


def find_even_lengths(directions: Directions, wanted: Wanted) -> InnerLengths | None:
    """The most even lengths, or None if no sheet has positive ones.

    Scaled as ``wanted.column`` if that is given, else so that the mean column crease is 1, or the
    mean row crease if there is none.
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
    if (m - 1) * (n - 1) > PROGRAM_PANELS or wanted.column is None:
        return None
    mean = float(wanted.column.mean())
    program = LengthsProgram(directions, wanted)
    limits = program.advance_limits(weights, mean / REASONABLE, mean * REASONABLE)
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
