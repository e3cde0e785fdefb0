"""What a sheet must satisfy to be made: positive lengths, convex panels, no overlap."""

from __future__ import annotations

from dataclasses import replace
from itertools import chain

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.quantities import plain
from orishell.families.longitudinal_linear_repeating.equation.choice import (
    AUTO_SECTORS,
    nearer_to_90,
)
from orishell.families.longitudinal_linear_repeating.motion.mechanism import (
    LongitudinalLinearRepeating,
)
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Columns,
    Directions,
    RowKind,
)
from orishell.families.longitudinal_linear_repeating.tessellation.even_lengths import (
    PROGRAM_PANELS,
    InnerLengths,
    find_even_lengths,
    largest_size,
)
from orishell.families.longitudinal_linear_repeating.tessellation.lengths import with_border
from orishell.families.longitudinal_linear_repeating.tessellation.program import Wanted
from orishell.families.pattern import Auto
from orishell.families.shared.candidates import fewer, values
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import largest_below
from orishell.polylines.plane import is_simple_polygon

SMALLEST_SHARE = 1e-30
"""No smaller share of a given flap is looked for."""
SLENDER = 1e-6
"""Sines of panels' corners are larger: rounding shows in the fold angles of slenderer ones."""
LARGEST_SEARCH = 99
"""Rows and columns beyond which no larger sheet is looked for."""


def sheet_exists(columns: Columns, rows: int, first_row: RowKind) -> bool:
    """Whether any lengths make a sheet of these angles and size."""
    directions = Directions.of(columns, rows, first_row)
    return find_even_lengths(directions, Wanted()) is not None


def require_size(columns: Columns, rows: int, first_row: RowKind) -> None:
    """Refuse a size that no lengths make a sheet of; name the largest sizes that exist."""
    if sheet_exists(columns, rows, first_row):
        return
    n = len(columns)
    square = largest_size(
        lambda size: sheet_exists(columns.first(size), size, first_row), min(n, LARGEST_SEARCH)
    )
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
        if (rows - 1) * (n - 1) <= PROGRAM_PANELS
        else f"no sheet of {rows} x {n} inner vertices was found for these sector angles: with "
        "equal lengths creases would have zero or negative length, and others were not tried"
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
    """Complete the inner creases by a border whose panels are convex.

    columns, first_row, side: The sheet.
    inner: Lengths of its inner creases.
    ends: Lengths of column 1's first and last crease.
    flap: Length of the row creases at the left and right border; "auto" takes the mean of column 1,
        or half of what leaves the panels convex if that is less.

    Raises DesignError if the border's panels would not be convex.
    """
    given = float(np.mean([*inner.column[:, 0], *ends])) if flap == "auto" else flap
    directions = Directions.of(columns, len(inner.row), first_row)
    lengths = with_border(directions, inner.row, inner.column, ends, given)
    mechanism = LongitudinalLinearRepeating(columns, first_row, lengths, side)

    def works(share: float) -> bool:
        return _is_convex_at_sides(_with_flap(mechanism, share * given))

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
        worst = int(turns[row].min(axis=-1).argmin())
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
                fewer("rows", len(turns) - 1),
                fewer("columns", turns.shape[1] - 1),
                nearer_to_90(mechanism.columns.sectors[0]),
            ),
        )


def _with_flap(mechanism: LongitudinalLinearRepeating, flap: float) -> LongitudinalLinearRepeating:
    row = mechanism.lengths.row.copy()
    row[:, [0, -1]] = flap
    return replace(mechanism, lengths=replace(mechanism.lengths, row=row))


def _is_convex_at_sides(mechanism: LongitudinalLinearRepeating) -> bool:
    return bool((_corner_turns(mechanism)[:, [0, -1]] > 0).all())


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
