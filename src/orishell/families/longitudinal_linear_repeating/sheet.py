"""What is asked for, and what a sheet must satisfy: positive lengths, convex panels, no overlap."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from itertools import chain
from typing import Literal

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.curves.plane import is_simple_polygon
from orishell.design import Parameter
from orishell.families.longitudinal_linear_repeating.equation.choice import (
    AUTO_SECTORS,
    nearer_to_90,
)
from orishell.families.longitudinal_linear_repeating.equation.solutions import Sectors, Solution
from orishell.families.longitudinal_linear_repeating.motion.mechanism import (
    LongitudinalLinearRepeating,
)
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Columns,
    Coupling,
    Directions,
    RowKind,
    continue_columns,
    repeat_columns,
)
from orishell.families.longitudinal_linear_repeating.tessellation.even_lengths import (
    UNTRIED,
    fits_program,
    largest_size,
    largest_square,
    sheet_exists,
)
from orishell.families.longitudinal_linear_repeating.tessellation.lengths import (
    InnerLengths,
    with_border,
)
from orishell.families.pattern import Auto
from orishell.families.shared.candidates import smaller, values
from orishell.motion import require_resolution
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import largest_below
from orishell.numerics.equals import first_smallest

SMALLEST_SHARE = 1e-30
"""No smaller share of a given flap is looked for."""
SLENDER = 1e-6
"""Sines of panels' corners are larger: rounding shows in the fold angles of slenderer ones."""
LARGEST_SEARCH = 99
"""Rows and columns beyond which no larger sheet is looked for."""


def require_size(columns: Columns, rows: int, first_row: RowKind) -> None:
    """Refuse a size that no lengths make a sheet of; name the largest sizes that exist."""
    if sheet_exists(columns, rows, first_row):
        return
    n = len(columns)
    square = largest_square(columns, first_row, LARGEST_SEARCH)
    fewer_rows = largest_size(
        lambda size: sheet_exists(columns, size, first_row), min(rows, LARGEST_SEARCH)
    )
    choices = [Remedy({"pattern.rows": square, "pattern.columns": square})] if square > 1 else []
    if fewer_rows > 1 or not choices:
        choices.insert(0, Remedy({"pattern.rows": fewer_rows}))
    if min(rows, n) <= LARGEST_SEARCH:
        fewer_columns = largest_size(
            lambda size: sheet_exists(columns.first(size), rows, first_row), min(n, LARGEST_SEARCH)
        )
        if fewer_columns > 1:
            choices.append(Remedy({"pattern.columns": fewer_columns}))
    condition = (
        f"no sheet of {rows} x {n} inner vertices exists for these sector angles: rows and columns "
        "converge, so that creases would have zero or negative length"
        if fits_program(rows, n, following=False)
        else f"no sheet of {rows} x {n} inner vertices was found for these sector angles: {UNTRIED}"
    )
    raise DesignError(
        condition,
        candidates=chain(choices, nearer_to_90(columns.sectors[0])),
        excess=rows / max(fewer_rows, 1) - 1,
    )


def with_fitting_border(
    columns: Columns,
    first_row: RowKind,
    inner: InnerLengths,
    ends: tuple[float, float],
    flap: float | Auto,
    *,
    side: int = 1,
) -> LongitudinalLinearRepeating:
    """Complete the inner creases by a border whose panels are convex; refuse one that has none.

    ends: Lengths of column 1's first and last crease.
    flap: Length of the row creases at the left and right border; "auto" takes the mean of column 1,
        or half of what leaves the panels convex if that is less.
    """
    given = float(np.mean([*inner.column[:, 0], *ends])) if flap == "auto" else flap
    directions = Directions.of(columns, len(inner.row), first_row)
    lengths = with_border(directions, inner, ends, given)
    mechanism = LongitudinalLinearRepeating(columns, first_row, lengths, side)

    def works(share: float) -> bool:
        return bool((_corner_turns(_with_flap(mechanism, share * given))[:, [0, -1]] > 0).all())

    if not works(1.0):
        share = largest_below(works, 1.0, smallest=SMALLEST_SHARE) or SMALLEST_SHARE
        if flap != "auto":
            raise DesignError(
                "the flap panels are not convex: their row creases meet",
                keys=("pattern.flap",),
                size=f"flap = {plain(given)} is too wide",
                candidates=values("flap", 0.0, share * given, given),
                excess=1 / share - 1,
            )
        mechanism = _with_flap(mechanism, 0.5 * share * given)
    return mechanism


def require_flat_sheet(mechanism: LongitudinalLinearRepeating) -> None:
    """Refuse panels that are not convex or too slender, and a flat sheet that overlaps itself."""
    turns = _corner_turns(mechanism)
    for row, name in ((0, "first"), (-1, "last")):
        worst = first_smallest(turns[row].min(axis=-1), size=1.0)
        if turns[row, worst].min() <= 0:
            raise DesignError(
                f"the {name} row of panels is not convex: its column creases meet",
                place=f"at column {max(worst, 1)}",
                candidates=[
                    *(Remedy({"pattern.rows": len(turns) - 1 + more}) for more in (2, 4, 8)),
                    Remedy({"pattern.column_lengths": "auto"}),
                ],
                excess=-turns[row, worst].min(),
            )
    if turns.min() < SLENDER:
        panel = np.argwhere(turns == turns.min())[0, :2].tolist()
        raise DesignError(
            "a panel is so slender that rounding would bend it",
            place=f"panel {panel}",
            size=f"the sine of a corner is {turns.min():.1g} and must be at least {SLENDER:g}",
            candidates=[*(Remedy({"pattern.solution": other}) for other in (0, 1)), AUTO_SECTORS],
            excess=1 - turns.min() / SLENDER,
        )
    flat = mechanism.positions(0.0)[..., :2]
    border = np.concatenate([flat[0], flat[1:, -1], flat[-1, -2::-1], flat[-2:0:-1, 0]])
    if not is_simple_polygon(border):
        raise DesignError(
            "the flat sheet overlaps itself: its rows or columns fan out too far",
            candidates=chain(
                smaller(len(turns) - 1, turns.shape[1] - 1),
                nearer_to_90(mechanism.columns.sectors[0]),
            ),
        )


def _with_flap(mechanism: LongitudinalLinearRepeating, flap: float) -> LongitudinalLinearRepeating:
    row = mechanism.lengths.row.copy()
    row[:, [0, -1]] = flap
    return replace(mechanism, lengths=replace(mechanism.lengths, row=row))


def _corner_turns(mechanism: LongitudinalLinearRepeating) -> Array:
    """Sines of the turns at all panels' corners (m+1, n+1, 4), positive where they are convex.

    They are no numbers where an edge is nothing beside the size of the sheet, or too long for one.
    """
    flat = mechanism.positions(0.0)[..., :2] @ np.array([1, 1j])
    corners = np.stack([flat[:-1, :-1], flat[1:, :-1], flat[1:, 1:], flat[:-1, 1:]], axis=-1)
    edges = np.roll(corners, -1, axis=-1) - corners
    with np.errstate(over="ignore", invalid="ignore"):
        turned = edges * np.roll(edges, 1, axis=-1).conj()
        sines: Array = turned.imag / np.abs(turned)
    return sines


Periodic = Literal["periodic"]


@record
class SheetRequest:
    """What was asked for, apart from the sector angles and the target."""

    # inner vertices m and n
    rows: int
    columns: int
    first_row: RowKind
    couplings: Sequence[Coupling] | Periodic  # how columns follow each other
    row_lengths: Array | None  # of the middle row (n-1,), or None for "auto"
    column_lengths: Array | None  # of column 1 (m+1,), or None for "auto"
    stage: float | None  # the drive at which the frames end, or None for "auto"
    flap: float | Auto  # length of the row creases at the left and right border

    def coupled(self, solution: Solution) -> Columns:
        """The columns that a solution of (4) gives; refuse one that gives too few."""
        if self.couplings == "periodic":
            return repeat_columns(solution, self.columns)
        return continue_columns(solution, self.couplings)

    def directions(self, columns: Columns) -> Directions:
        """The directions of the creases in the flat sheet."""
        return Directions.of(columns, self.rows, self.first_row)

    def completed(
        self, columns: Columns, inner: InnerLengths, ends: tuple[float, float], *, side: int = 1
    ) -> LongitudinalLinearRepeating:
        """The sheet with its border; refuse one that cannot be made."""
        mechanism = with_fitting_border(columns, self.first_row, inner, ends, self.flap, side=side)
        require_flat_sheet(mechanism)
        require_resolution(mechanism, smaller(self.rows, self.columns))
        return mechanism

    @contextmanager
    def size_blamed(self, columns: Columns) -> Iterator[None]:
        """Where no sheet is found, refuse the size instead if no lengths make one."""
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
