"""What a sheet is asked for, with a target or without one."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Literal

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.record import record
from orishell.design import Parameter
from orishell.families.longitudinal_linear_repeating.equation.solutions import Sectors, Solution
from orishell.families.longitudinal_linear_repeating.motion.mechanism import (
    LongitudinalLinearRepeating,
)
from orishell.families.longitudinal_linear_repeating.sheet import require_size
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Columns,
    Coupling,
    RowKind,
    continue_columns,
    repeat_columns,
)
from orishell.families.pattern import Auto
from orishell.numerics.arrays import Array

Periodic = Literal["periodic"]


@record
class SheetRequest:
    """What was asked for, apart from the sector angles and the target.

    rows, columns: Inner vertices m and n.
    first_row: Kind of the first row.
    couplings: How columns follow each other.
    row_lengths, column_lengths: Of the middle row (n-1) and of column 1 (m+1), or None for "auto".
    stage: The drive at which the frames end (radians), or None for "auto".
    flap: Length of the row creases at the left and right border.
    """

    rows: int
    columns: int
    first_row: RowKind
    couplings: Sequence[Coupling] | Periodic
    row_lengths: Array | None
    column_lengths: Array | None
    stage: float | None
    flap: float | Auto

    def coupled(self, solution: Solution) -> Columns:
        """The columns that a solution of (4) gives.

        Raises DesignError if they end before the sheet does.
        """
        if self.couplings == "periodic":
            return repeat_columns(solution, self.columns)
        return continue_columns(solution, self.couplings)

    @contextmanager
    def size_blamed(self, columns: Columns) -> Iterator[None]:
        """Where no sheet is found, say first whether any lengths make one of this size.

        Raises DesignError if none do, instead of what was raised.
        """
        try:
            yield
        except DesignError:
            require_size(columns, self.rows, self.first_row)
            raise

    def describe(
        self, solution: Solution, mechanism: LongitudinalLinearRepeating
    ) -> dict[str, Parameter]:
        """The parameters that were given or found, by their names in the report."""
        lengths = mechanism.lengths
        return {
            "sector_deg": _tidy(solution.first),
            "second_sector_deg": _tidy(solution.second),
            "version": solution.version,
            "c": solution.c,
            "couplings": self.couplings
            if self.couplings == "periodic"
            else [str(each) for each in self.couplings],
            "first_row": self.first_row,
            "stage_deg": tidy_degrees(mechanism.target_drive),
            "motion_end_deg": tidy_degrees(mechanism.end_drive),
            "longest_to_shortest": lengths.inner_ratio,
            "row_lengths": lengths.row[self.rows // 2, 1:-1].tolist(),
            "column_lengths": lengths.column[:, 0].tolist(),
            "flap": float(lengths.row[0, 0]),
        }


def _tidy(sectors: Sectors) -> list[float]:
    return [tidy_degrees(np.deg2rad(angle)) for angle in sectors.degrees]
