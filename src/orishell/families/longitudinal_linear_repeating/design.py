"""From a convex curve and a line to a sheet of this type, or to the reason why not."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from orishell.curves import Curve, trace_curve
from orishell.design import Design
from orishell.errors import DesignError, InputError
from orishell.families.longitudinal_linear_repeating.choice import (
    AUTO_SHARES,
    auto_solution,
    choose_solution,
)
from orishell.families.longitudinal_linear_repeating.even_lengths import (
    InnerLengths,
    advance_range,
    find_even_lengths,
)
from orishell.families.longitudinal_linear_repeating.mechanism import LongitudinalLinearRepeating
from orishell.families.longitudinal_linear_repeating.placement import place
from orishell.families.longitudinal_linear_repeating.program import Wanted
from orishell.families.longitudinal_linear_repeating.sectors import Sectors
from orishell.families.longitudinal_linear_repeating.sheet import (
    require_flat_sheet,
    require_size,
    with_fitting_border,
)
from orishell.families.longitudinal_linear_repeating.solutions import Solution
from orishell.families.longitudinal_linear_repeating.stage import Stage, find_stage
from orishell.families.longitudinal_linear_repeating.target import Line, Profile
from orishell.families.longitudinal_linear_repeating.tessellation import (
    Columns,
    Coupling,
    Directions,
    RowKind,
    continue_columns,
    repeat_columns,
)
from orishell.motion import require_resolution
from orishell.quoting import tidy_degrees

Array = NDArray[np.float64]
Auto = Literal["auto"]
Periodic = Literal["periodic"]
EVEN_ENOUGH = 8.0
"""Sector angles "auto" are the widest whose longest inner crease is at most this many times the
shortest."""


def design_longitudinal_linear_repeating(
    f: Curve,
    g: Curve,
    *,
    rows: int,
    columns: int,
    sectors: Sectors | Auto,
    solution: int = 0,
    couplings: Sequence[Coupling] | Periodic = "periodic",
    first_row: RowKind = "F",
    row_lengths: Sequence[float] | Auto = "auto",
    column_lengths: Sequence[float] | Auto = "auto",
    stage: float | Auto = "auto",
    flap: float | Auto = "auto",
) -> Design:
    """Design a shell whose column 1 follows a convex f, swept along a straight g (section 4).

    Parameters
    ----------
    f
        The swept curve: convex, run through in the direction of its x axis, upright on g.
    g
        The line that it is swept along; the middle row advances by its length at the stage.
    rows, columns
        Inner vertices m and n.
    sectors
        Sector angles of column 1, or "auto".
    solution
        Which solution of (4), in the order of ``find_solutions``.
    couplings
        "periodic" as in the paper's Figure 3, or how each column continues in the next (n-1):
        "solve" by a solution of (4) anew, "parallel" by its degenerate one (Remark 1).
    first_row
        Kind of the first row.
    row_lengths
        Ratios of the middle row's lengths (n-1), or "auto" for the most even sheet.
    column_lengths
        Ratios of column 1's lengths (m+1), or "auto" for those that follow f.
    stage
        The drive v_1 at which the shell is to meet f (radians), or "auto" for the one at which
        column 1 turns as much as f.
    flap
        Length of the row creases at the left and right border, in the unit of the curves, or
        "auto".

    Raises
    ------
    CurveError
        If f or g is not a usable curve.
    InputError
        If couplings or ratios of lengths are not as many as the sheet needs.
    DesignError
        If the family cannot reach the target: the condition, where, by how much, what works.

    Examples
    --------
    >>> from orishell.curves import curve_from_formulas, parse_formula
    >>> f = curve_from_formulas(parse_formula("cos(t)"), parse_formula("sin(t)"), 0.3, 2.8)
    >>> g = curve_from_formulas(None, parse_formula("0*x"), 0, 3)
    >>> design = design_longitudinal_linear_repeating(
    ...     f, g, rows=9, columns=9, sectors=Sectors.from_degrees([85, 80, 95, 100])
    ... )
    >>> design.mechanism.grid
    Grid(rows=11, columns=11)
    """
    profile, line = Profile.of(trace_curve(f, "f")), Line.along(trace_curve(g, "g"))
    request = _Request(
        profile=profile,
        line=line,
        rows=rows,
        columns=columns,
        first_row=first_row,
        couplings=couplings,
        row_lengths=_ratios("row_lengths", row_lengths, columns - 1),
        column_lengths=_ratios("column_lengths", column_lengths, rows + 1),
        stage=None if stage == "auto" else stage,
        flap=flap,
    )
    chosen = _choose_sectors(request) if sectors == "auto" else choose_solution(sectors, solution)
    found, mechanism = request.build(chosen)
    placed = place(mechanism, profile, line, found)
    return Design(
        mechanism=placed.mechanism,
        parameters={
            "sector_deg": [tidy_degrees(np.deg2rad(angle)) for angle in chosen.first.degrees],
            "second_sector_deg": [
                tidy_degrees(np.deg2rad(angle)) for angle in chosen.second.degrees
            ],
            "version": chosen.version,
            "c": chosen.c,
            "couplings": couplings
            if couplings == "periodic"
            else [str(each) for each in couplings],
            "first_row": first_row,
            "stage_deg": tidy_degrees(found.drive),
            "motion_end_deg": tidy_degrees(mechanism.crease_end),
            "longest_to_shortest": _evenness(mechanism),
            "row_lengths": mechanism.lengths.row[rows // 2, 1:-1].tolist(),
            "column_lengths": mechanism.lengths.column[:, 0].tolist(),
            "flap": float(mechanism.lengths.row[0, 0]),
            **placed.measures,
        },
        targets=placed.targets,
        closeness=placed.closeness,
        surface=placed.surface,
        approached=placed.approached,
        warnings=(),
        lock_drive=mechanism.crease_end,
    )


@dataclass(frozen=True, slots=True, eq=False)
class _Request:
    """What was asked for, but for the sector angles."""

    profile: Profile
    line: Line
    rows: int
    columns: int
    first_row: RowKind
    couplings: Sequence[Coupling] | Periodic
    row_lengths: Array | None
    column_lengths: Array | None
    stage: float | None
    flap: float | Auto

    def build(self, solution: Solution) -> tuple[Stage, LongitudinalLinearRepeating]:
        """The stage and the sheet that a solution of (4) gives."""
        if solution.version == "sine":
            raise DesignError(
                "a solution of (4) in its sine version folds its S rows to alternate sides, so "
                "that no column follows a convex curve",
                nearest="a solution of the cosine version (orishell solve lists them first), or "
                'sector_deg = "auto"',
            )
        columns = self._coupled(solution)
        require_size(columns, self.rows, self.first_row)
        stage = find_stage(
            self.profile,
            columns,
            self.rows,
            self.first_row,
            drive=self.stage,
            lengths=self.column_lengths,
        )
        inner = self._lengths(columns, stage)
        mechanism = with_fitting_border(
            columns,
            self.first_row,
            inner,
            (float(stage.lengths[0]), float(stage.lengths[-1])),
            self.flap,
            side=stage.side,
        )
        require_flat_sheet(mechanism)
        require_resolution(mechanism, "change rows, columns, flap or the lengths given")
        return stage, mechanism

    def _coupled(self, solution: Solution) -> Columns:
        if self.couplings == "periodic":
            return repeat_columns(solution, self.columns)
        if len(self.couplings) != self.columns - 1:
            raise InputError(
                "couplings do not fit",
                got=f"{len(self.couplings)} entries",
                expected=f'{self.columns - 1}, one fewer than columns, or "periodic"',
            )
        return continue_columns(solution, self.couplings)

    def _lengths(self, columns: Columns, stage: Stage) -> InnerLengths:
        """Lengths of the inner creases: column 1 follows f, the middle row is as long as g."""
        directions = Directions.of(columns, self.rows, self.first_row)
        row, column = self.row_lengths, stage.lengths[1:-1]
        weights = stage.section.advance
        if self.rows == 1:
            row = np.ones(self.columns - 1) if row is None else row
            scale = self.line.length / float(weights @ row)
            return InnerLengths.marched(directions, scale * row, column)
        ends = (float(stage.lengths[0]), float(stage.lengths[-1]))
        free = Wanted(row=row, column=column, ends=ends)
        found = find_even_lengths(directions, replace(free, advance=(weights, self.line.length)))
        if found is not None:
            return found
        limits = advance_range(directions, free, weights)
        if limits is None:
            given = "these row_lengths" if row is not None else "column 1 following f"
            raise DesignError(
                f"no lengths keep all creases of the sheet positive with {given}",
                nearest='row_lengths = "auto"'
                if row is not None
                else 'fewer rows or columns, or sector_deg = "auto"',
            )
        low, high = limits
        nearest = low if self.line.length < low else high
        raise DesignError(
            "no lengths keep all creases of the sheet positive with a middle row as long as g",
            size=f"g is {self.line.length:.6g} long, and with column 1 following f the row may "
            f"be {low:.6g} to {high:.6g}",
            nearest=f"scale in [target.g] times {nearest / self.line.length:.6g} (scale is 1 "
            "where none is given)",
        )


def _choose_sectors(request: _Request) -> Solution:
    """The widest angles for which the sheet exists: the fewest panels would do with them."""
    failure: DesignError | None = None
    for share in AUTO_SHARES:
        solution = auto_solution(share)
        try:
            _, mechanism = request.build(solution)
        except DesignError as error:
            failure = error
            continue
        if _evenness(mechanism) <= EVEN_ENOUGH or share == AUTO_SHARES[-1]:
            return solution
    raise failure if failure is not None else DesignError("no sector angles were tried")


def _evenness(mechanism: LongitudinalLinearRepeating) -> float:
    lengths = mechanism.lengths
    return InnerLengths(lengths.row[:, 1:-1], lengths.column[1:-1]).ratio


def _ratios(name: str, lengths: Sequence[float] | Auto, count: int) -> Array | None:
    """Given lengths as an array, or None for "auto"."""
    if lengths == "auto":
        return None
    array = np.asarray(lengths, dtype=np.float64)
    if array.shape != (count,) or not (array > 0).all():
        raise InputError(
            f"{name} does not fit",
            got=f"{array.size} entries",
            expected=f"{count} positive lengths",
        )
    return array
