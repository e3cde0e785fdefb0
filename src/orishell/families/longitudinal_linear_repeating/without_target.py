"""A sheet from sector angles and the lengths of a row and a column, with no target to meet."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import rounded
from orishell.conventions.quantities import plain
from orishell.design import Design, Parameter
from orishell.families.longitudinal_linear_repeating.equation.choice import choose_sheet
from orishell.families.longitudinal_linear_repeating.equation.solutions import Sectors, Solution
from orishell.families.longitudinal_linear_repeating.motion.mechanism import (
    LongitudinalLinearRepeating,
    Pose,
)
from orishell.families.longitudinal_linear_repeating.placement import (
    describe_radii,
    measure_departures,
    pose_of,
    section_radii,
)
from orishell.families.longitudinal_linear_repeating.section import Section
from orishell.families.longitudinal_linear_repeating.sheet import SheetRequest
from orishell.families.longitudinal_linear_repeating.target_state import require_before_end
from orishell.families.longitudinal_linear_repeating.tessellation.columns import Columns, Directions
from orishell.families.longitudinal_linear_repeating.tessellation.even_lengths import (
    UNTRIED,
    Wanted,
    advance_range,
    find_even_lengths,
    fits_program,
)
from orishell.families.longitudinal_linear_repeating.tessellation.lengths import (
    END_SHARE,
    InnerLengths,
    end_limits,
)
from orishell.families.pattern import Auto
from orishell.motion.grid import UNFOLDED

LEVEL = 1e-9
"""Rows beside the middle one are level with it below this share of the sheet's size."""


def design_without_target(
    request: SheetRequest, sectors: Sectors | Auto, solution: int = 0
) -> Design:
    """The sheet of given sector angles and lengths, folded to the stage or as far as it goes.

    solution: Which solution of (4), of either version.
    """
    chosen, sheet = choose_sheet(
        sectors, solution, partial(_build, request), lambda made: made.lengths.inner_ratio
    )

    def stopped(drive: float) -> Design:
        placed = _level(sheet, drive)
        return Design(
            mechanism=placed,
            parameters={**request.describe(chosen, placed), **_measures(placed)},
            targets={},
            closeness={},
            swept=None,
            warnings=(),
            ending_at=stopped if request.stage is None else None,
            folded_by="stage_deg",
        )

    if request.stage is None:
        return stopped(sheet.end_drive)
    require_before_end(request.stage, sheet.end_drive)
    _require_folded(sheet, request.stage)
    return stopped(request.stage)


def _build(request: SheetRequest, solution: Solution) -> LongitudinalLinearRepeating:
    """The sheet that a solution of (4) gives."""
    columns = request.coupled(solution)
    with request.size_blamed(columns):
        inner = _inner_lengths(request, columns)
        if inner is None or inner.shortest <= 0:
            raise _refusal(request, columns, inner)
    return request.completed(columns, inner, _ends(request, request.directions(columns), inner))


def _inner_lengths(request: SheetRequest, columns: Columns) -> InnerLengths | None:
    """Lengths from those given, perhaps not all positive, or the most even; None if none exist."""
    row, column = request.row_lengths, request.column_lengths
    directions = request.directions(columns)
    if request.rows == 1 and row is None:
        row = np.full(request.columns - 1, 1.0 if column is None else column.mean())
    inner = np.empty(0) if request.rows == 1 else None if column is None else column[1:-1]
    if row is not None and inner is not None:
        return InnerLengths.marched(directions, row, inner)
    ends = None if column is None else (float(column[0]), float(column[-1]))
    found = find_even_lengths(directions, Wanted(row=row, column=inner, ends=ends))
    if found is None or row is None:
        return found
    return found.scaled(float(row.sum() / found.row[request.rows // 2].sum()))


def _ends(
    request: SheetRequest, directions: Directions, inner: InnerLengths
) -> tuple[float, float]:
    """Column 1's first and last length: as given, or as those beside them if there is room."""
    if request.column_lengths is not None:
        return float(request.column_lengths[0]), float(request.column_lengths[-1])
    beside = inner.column[[0, -1], 0] if inner.column.size else np.full(2, inner.row.mean())
    room = [END_SHARE * end_limits(directions, inner.row, bottom)[0] for bottom in (False, True)]
    first, last = np.minimum(beside, room)
    return float(first), float(last)


def _refusal(request: SheetRequest, columns: Columns, inner: InnerLengths | None) -> DesignError:
    """The error for given lengths that make no sheet."""
    row, column = request.row_lengths, request.column_lengths
    both = row is not None and column is not None
    which = "column_lengths" if row is None else "row_lengths"
    if inner is not None:
        size = f"the shortest crease would be {plain(inner.shortest)} long"
    elif fits_program(request.rows, request.columns, following=column is not None):
        size = "no positive lengths of the other creases close all panels"
    else:
        size = UNTRIED
    return DesignError(
        f"these {'lengths' if both else which} make no sheet of these sector angles",
        size=size,
        candidates=_candidates(request, columns),
        excess=None if inner is None else -inner.shortest / np.abs(inner.row).mean(),
    )


def _candidates(request: SheetRequest, columns: Columns) -> Iterator[Remedy]:
    """Row lengths in these ratios, the nearest scale first; "auto" for what is given."""
    row, column = request.row_lengths, request.column_lengths
    if row is not None and column is not None:
        wanted = Wanted(row=row, column=column[1:-1], ends=(float(column[0]), float(column[-1])))
        limits = advance_range(request.directions(columns), wanted, np.ones(len(row))) or ()
        for factor in sorted((limit / row.sum() for limit in limits), key=lambda x: abs(np.log(x))):
            scaled = [rounded(float(length), 8) for length in row * rounded(factor)]
            yield Remedy({"pattern.row_lengths": scaled})
    free = [Remedy({"pattern.row_lengths": "auto"})] if row is not None else []
    free += [Remedy({"pattern.column_lengths": "auto"})] if column is not None else []
    yield from free
    if len(free) > 1:
        yield free[0] | free[1]


def _require_folded(sheet: LongitudinalLinearRepeating, stage: float) -> None:
    """Refuse a stage at which a crease still counts as unfolded.

    Near the flat sheet all fold angles are in proportion to the drive.
    """
    angles = sheet.fold_angles(UNFOLDED)
    share = min(float(np.abs(angles.row).min()), float(np.abs(angles.column).min())) / UNFOLDED
    if stage * share <= UNFOLDED:
        raise DesignError(
            f"stage_deg = {np.rad2deg(stage):.4g} leaves creases unfolded",
            keys=("pattern.stage_deg",),
            size=f"one folds by {stage * share:.1g} rad, and must fold by {UNFOLDED:g} rad or more",
            candidates=[
                Remedy({"pattern.stage_deg": rounded(np.rad2deg(more * UNFOLDED / share))})
                for more in (1.01, 2.0)
            ],
            excess=1 - stage * share / UNFOLDED,
        )


def _level(sheet: LongitudinalLinearRepeating, drive: float) -> LongitudinalLinearRepeating:
    """The sheet with its motion ending at a drive, where it stands as an arch about the origin.

    There the middle row runs along the x axis, the columns across its middle along the y axis, and
    the rows beside it lie below.
    """
    free = replace(sheet, stop=drive, pose=Pose())
    shell = free.positions(drive)
    middle = len(shell) // 2
    along = shell[middle, -2] - shell[middle, 1]
    x = along / np.linalg.norm(along)
    back = (shell[middle - 1] - shell[middle + 1])[1:-1].mean(axis=0)
    back = back - (back @ x) * x
    size = np.linalg.norm(np.ptp(shell.reshape(-1, 3), axis=0))
    if np.linalg.norm(back) < LEVEL * size:  # folded flat about the middle row
        return free
    y = back / np.linalg.norm(back)
    axes = np.stack([x, y, np.cross(x, y)])
    beside = (shell[[middle - 1, middle + 1]] - shell[middle])[:, 1:-1] @ axes[2]
    if beside.mean() > LEVEL * size:
        return _level(replace(sheet, side=-sheet.side), drive)
    return replace(free, pose=pose_of(np.zeros(3), axes))


def _measures(mechanism: LongitudinalLinearRepeating) -> dict[str, Parameter]:
    """The shape in numbers, for the report: radii of convex sections, departures from planes."""
    measures: dict[str, Parameter] = {**measure_departures(mechanism)}
    if mechanism.columns.version == "sine":
        return measures
    drive, rows = mechanism.target_drive, mechanism.grid.rows - 2
    section = Section.of(mechanism.columns, rows, mechanism.first_row, drive, mechanism.side)
    across = np.stack([section.heading, np.cross(section.axis, section.heading)], axis=-1)
    seen = replace(mechanism, pose=Pose()).positions(drive) @ across
    return {**describe_radii(section_radii(seen)), **measures}
