"""From a convex curve and a line to a sheet of this type, or to the reason why not."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain

import numpy as np

from orishell.curves import Curve, trace_curve
from orishell.design import Design
from orishell.errors import DesignError, InputError, Remedy
from orishell.families.candidates import bisect, fewer, sizes
from orishell.families.longitudinal_linear_repeating.choice import (
    AUTO_SECTORS,
    choose_auto,
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
from orishell.families.longitudinal_linear_repeating.request import (
    Auto,
    Periodic,
    SheetRequest,
    given_lengths,
)
from orishell.families.longitudinal_linear_repeating.sectors import Sectors
from orishell.families.longitudinal_linear_repeating.sheet import (
    require_flat_sheet,
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
)
from orishell.families.longitudinal_linear_repeating.without_target import design_without_target
from orishell.motion import require_resolution


def design_longitudinal_linear_repeating(
    f: Curve | None = None,
    g: Curve | None = None,
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

    Without f and g, what the sector angles and the lengths of a row and a column fold: the question
    that the paper asks. Then any solution will do, lengths are lengths, and the design has no
    surface to be compared with.

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
        Ratios of the middle row's lengths (n-1), or "auto" for the most even sheet. Without f and
        g the lengths themselves.
    column_lengths
        Ratios of column 1's lengths (m+1), or "auto" for those that follow f. Without f and g the
        lengths themselves, or "auto" for the most even sheet; its mean column crease is 1 long if
        both are "auto".
    stage
        The drive v_1 at which the shell is to meet f (radians), or "auto" for the one at which
        column 1 turns as much as f; without f and g, where a crease is folded flat.
    flap
        Length of the row creases at the left and right border, in the unit of the curves, or
        "auto".

    Raises
    ------
    CurveError
        If f or g is not a usable curve.
    InputError
        If couplings or lengths are not as many as the sheet needs, or only one of f and g is given.
    DesignError
        If the family cannot reach the target, or there is no such sheet: the condition, where, by
        how much, what works.

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
    request = SheetRequest(
        rows=rows,
        columns=columns,
        first_row=first_row,
        couplings=couplings,
        row_lengths=given_lengths("row_lengths", row_lengths, columns - 1),
        column_lengths=given_lengths("column_lengths", column_lengths, rows + 1),
        stage=None if stage == "auto" else stage,
        flap=flap,
    )
    if f is None and g is None:
        return design_without_target(request, sectors, solution)
    if f is None or g is None:
        raise InputError(
            "f and g belong together", got="one of them", expected="both, or none for no target"
        )
    f_trace, g_trace = trace_curve(f, "f").in_own_frame(), trace_curve(g, "g").in_own_frame()
    target = _Target(Profile.of(f_trace), Line.along(g_trace), request)
    if sectors == "auto":
        chosen, made = choose_auto(target.build, lambda made: made[1].lengths.inner_ratio)
    else:
        chosen = choose_solution(sectors, solution)
        made = target.build(chosen)
    found, mechanism = made
    placed = place(mechanism, target.profile, target.line, found)
    return Design(
        mechanism=placed.mechanism,
        parameters={**request.describe(chosen, placed.mechanism), **placed.measures},
        targets=placed.targets,
        closeness=placed.closeness,
        swept=placed.surface,
        approached=placed.approached,
        origin=np.append(g_trace.origin, 0.0),
        warnings=(),
        lock_drive=mechanism.crease_end,
    )


@dataclass(frozen=True, slots=True, eq=False)
class _Target:
    """A convex f, a straight g, and the sheet that is to meet them."""

    profile: Profile
    line: Line
    request: SheetRequest

    def build(self, solution: Solution) -> tuple[Stage, LongitudinalLinearRepeating]:
        """The stage and the sheet that a solution of (4) gives."""
        request = self.request
        if solution.version == "sine":
            raise DesignError(
                "a solution of (4) in its sine version folds its S rows to alternate sides, so "
                "that no column follows a convex curve",
                candidates=[Remedy({"pattern.solution": 0}), AUTO_SECTORS],
            )
        columns = request.coupled(solution)
        stage = find_stage(
            self.profile,
            columns,
            request.rows,
            request.first_row,
            drive=request.stage,
            lengths=request.column_lengths,
        )
        inner = self._lengths(columns, stage)
        mechanism = with_fitting_border(
            columns,
            request.first_row,
            inner,
            (float(stage.lengths[0]), float(stage.lengths[-1])),
            request.flap,
            side=stage.side,
        )
        require_flat_sheet(mechanism)
        require_resolution(
            mechanism, chain(fewer("rows", request.rows), fewer("columns", request.columns))
        )
        return stage, mechanism

    def _lengths(self, columns: Columns, stage: Stage) -> InnerLengths:
        """Lengths of the inner creases: column 1 follows f, the middle row is as long as g."""
        request = self.request
        directions = Directions.of(columns, request.rows, request.first_row)
        row, column = request.row_lengths, stage.lengths[1:-1]
        weights = stage.section.advance
        if request.rows == 1:
            row = np.ones(request.columns - 1) if row is None else row
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
                candidates=[Remedy({"pattern.row_lengths": "auto"})]
                if row is not None
                else chain(
                    fewer("rows", request.rows), fewer("columns", request.columns), [AUTO_SECTORS]
                ),
            )
        low, high = limits
        works_at = low if self.line.length < low else high

        def works(length: float) -> bool:
            wanted = replace(free, advance=(weights, length))
            return find_even_lengths(directions, wanted) is not None

        def candidates() -> Iterator[Remedy]:
            # The range is that of sheets in proportion; others are made, too.
            start = next((each for each in (works_at, 0.5 * (low + high)) if works(each)), None)
            if start is not None:
                length = bisect(start, self.line.length, works)
                yield from sizes("g", self.line.trace.curve, length / self.line.length)
            yield AUTO_SECTORS

        raise DesignError(
            "no lengths keep all creases of the sheet positive with a middle row as long as g",
            size=f"g is {self.line.length:.6g} long, and with column 1 following f the row may "
            f"be {low:.6g} to {high:.6g}",
            candidates=candidates(),
        )
