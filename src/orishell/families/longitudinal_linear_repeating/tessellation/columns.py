"""Columns and rows of the tessellation, and the directions of all creases in the flat sheet.

All angles are deviations from pi/2 (see ``sectors``). A row crease's direction, run to the right,
is R from the x axis; a column crease's, run downwards, is D from the negative y axis. With the
sectors RU, LU, LD, RD of vertex (i, j),

    R_right = R_left - (RU + LU),   D_below = R_right - RD,   D_above = R_right + RU.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Literal

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.record import record
from orishell.families.longitudinal_linear_repeating.equation.solutions import (
    Solution,
    Version,
    find_solutions,
)
from orishell.numerics.arrays import Array, Booleans

RowKind = Literal["F", "S"]
Coupling = Literal["solve", "parallel"]

KEPT = 2
"""Sheets whose directions are kept: every state of a sheet asks for them."""


@record
class Columns:
    """The columns of a sheet."""

    version: Version  # version of (4) that couples them
    sectors: Array  # deviations of alpha, beta, gamma, delta of every column (n, 4) (radians)
    multipliers: Array  # tan(v_j/2) / tan(v_1/2) of every column (n,), constant through the motion

    def __post_init__(self) -> None:
        for array in (self.sectors, self.multipliers):
            array.flags.writeable = False

    def __len__(self) -> int:
        return len(self.multipliers)

    def first(self, count: int) -> Columns:
        """The first ``count`` columns."""
        return Columns(self.version, self.sectors[:count], self.multipliers[:count])


def repeat_columns(solution: Solution, count: int) -> Columns:
    """Columns 1, 2, 2', 1', 1, ...: the paper's Figure 3(a), with multipliers 1, c, -c, -1."""
    first, second = solution.first, solution.second
    period = np.stack(
        [each.deviations for each in (first, second, second.opposite, first.opposite)]
    )
    multipliers = np.array([1.0, solution.c, -solution.c, -1.0])
    index = np.arange(count) % 4
    return Columns(solution.version, period[index], multipliers[index])


def continue_columns(solution: Solution, couplings: Sequence[Coupling]) -> Columns:
    """Columns that continue each other as asked for, not periodically (the paper's Remark 1).

    "solve" continues a column by a solution of (4) from its own sectors, in the version of the
    first solution; "parallel" by the degenerate one, which always exists. The paper's Figure 3(a)
    is solve, parallel, solve, parallel; other sequences make other sheets.

    couplings: Of each column with the next (n-1); a "solve" that is the first takes the solution.
    """
    sectors, multipliers = [solution.first], [1.0]
    for number, coupling in enumerate(couplings):
        if coupling == "parallel":
            sectors.append(sectors[-1].opposite)
            multipliers.append(-multipliers[-1])
            continue
        further = [solution] if number == 0 else find_solutions(sectors[-1])
        further = [each for each in further if each.version == solution.version]
        if not further:
            ends = ["parallel"] * (len(couplings) - number)
            shown = ", ".join(f"{angle:.4f}" for angle in sectors[-1].degrees)
            raise DesignError(
                "equation (4) has no further solution, so no column can follow",
                place=f"at column {number + 2}",
                size=f"column {number + 1} has the sector angles ({shown})",
                candidates=[
                    Remedy({"pattern.couplings": [*couplings[:number], *ends]}),
                    Remedy({"pattern.couplings": "periodic"}),
                ],
                excess=1 - (number + 1) / (len(couplings) + 1),
            )
        sectors.append(further[0].second)
        multipliers.append(multipliers[-1] * further[0].c)
    return Columns(
        solution.version, np.stack([each.deviations for each in sectors]), np.array(multipliers)
    )


def flat_foldable_rows(rows: int, first_row: RowKind) -> Booleans:
    """Which of the rows (m,) are F rows: every second, the others are S rows."""
    return np.asarray((np.arange(rows) % 2 == 0) == (first_row == "F"))


def sector_table(columns: Columns, rows: int, first_row: RowKind) -> Array:
    """Deviations of RU, LU, LD, RD of all inner vertices (m, n, 4), in the paper's order."""
    alpha, beta, gamma, delta = columns.sectors.T
    f = np.stack([-alpha, -beta, alpha, beta], axis=-1)
    s = np.stack([-gamma, -delta, delta, gamma], axis=-1)
    return np.where(flat_foldable_rows(rows, first_row)[:, None, None], f, s)


@record
class Directions:
    """Directions of the creases in the flat sheet (radians), the middle row's mean being 0."""

    row: Array  # R (m, n+1) of every row crease, from the left border to the right
    column: Array  # D (m+1, n) of every column crease, from the top border to the bottom

    @classmethod
    @lru_cache(KEPT)
    def of(cls, columns: Columns, rows: int, first_row: RowKind) -> Directions:
        """The directions in a sheet."""
        ru, lu, _, rd = np.moveaxis(sector_table(columns, rows, first_row), -1, 0)
        down = np.concatenate([[0.0], -np.cumsum(rd[:-1, 0] + ru[1:, 0])])
        # The crease right of column 1, and from it all others of its row.
        turns = np.concatenate([np.zeros((rows, 1)), -np.cumsum(ru + lu, axis=1)], axis=1)
        row = down[:, None] + turns - turns[:, 1:2]
        row = row - row[rows // 2].mean()
        column = np.concatenate([row[:1, 1:] + ru[:1], row[:, 1:] - rd])
        for array in (row, column):
            array.flags.writeable = False
        return cls(row, column)
