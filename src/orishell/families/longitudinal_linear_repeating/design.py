"""From a convex curve and a line to a sheet of this type, or to the reason why not."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache
from itertools import chain
from typing import Annotated, Any, Final

import numpy as np
from pydantic import Field
from pydantic_core import PydanticCustomError

from orishell.conventions.arguments import checked
from orishell.conventions.errors import DesignError, InputError, Remedy
from orishell.conventions.record import record
from orishell.conventions.table import Number
from orishell.curves import Curve, trace_curve
from orishell.design import Design
from orishell.families.longitudinal_linear_repeating.equation.choice import (
    AUTO_SECTORS,
    choose_sheet,
)
from orishell.families.longitudinal_linear_repeating.equation.solutions import Sectors, Solution
from orishell.families.longitudinal_linear_repeating.motion.mechanism import (
    LongitudinalLinearRepeating,
)
from orishell.families.longitudinal_linear_repeating.placement import place
from orishell.families.longitudinal_linear_repeating.sheet import Periodic, SheetRequest
from orishell.families.longitudinal_linear_repeating.target import Line, Profile
from orishell.families.longitudinal_linear_repeating.target_state import (
    TargetState,
    find_target_state,
)
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Columns,
    Coupling,
    RowKind,
)
from orishell.families.longitudinal_linear_repeating.tessellation.even_lengths import (
    UNTRIED,
    Wanted,
    advance_range,
    find_even_lengths,
    fits_program,
)
from orishell.families.longitudinal_linear_repeating.tessellation.lengths import InnerLengths
from orishell.families.longitudinal_linear_repeating.without_target import design_without_target
from orishell.families.pattern import Auto, ColumnCount, Length, Limits, RowCount, in_radians
from orishell.families.shared.candidates import sizes, smaller
from orishell.numerics.bisection import bisect

STAGE: Final[Limits] = {"gt": 0, "le": 180}
"""Limits of the drive (degrees)."""
Drive = Annotated[Number, in_radians(STAGE)]
SolutionNumber = Annotated[int, Field(ge=0)]


def require_entries(asked: Any) -> None:
    """Refuse lists that are not as long as the sheet needs, in [pattern] or among arguments."""
    for key, count in (
        ("row_lengths", asked.columns - 1),
        ("column_lengths", asked.rows + 1),
        ("couplings", asked.columns - 1),
    ):
        entries = getattr(asked, key)
        if not isinstance(entries, str) and len(entries) != count:
            raise PydanticCustomError(
                "entries", "{count} entries", {"count": count, "key": key, "got": len(entries)}
            )


@checked(require_entries)
def design_longitudinal_linear_repeating(
    f: Curve | None = None,
    g: Curve | None = None,
    *,
    rows: RowCount,
    columns: ColumnCount,
    sectors: Sectors | Auto,
    solution: SolutionNumber = 0,
    couplings: Sequence[Coupling] | Periodic = "periodic",
    first_row: RowKind = "F",
    row_lengths: Sequence[Length] | Auto = "auto",
    column_lengths: Sequence[Length] | Auto = "auto",
    stage: Drive | Auto = "auto",
    flap: Length | Auto = "auto",
) -> Design:
    """Design a shell whose column 1 follows a convex f, swept along a straight g (section 4).

    Without f and g, the sector angles and the lengths of a row and a column determine the sheet, as
    in the paper. Then every solution may be taken, ``row_lengths`` and ``column_lengths`` are true
    lengths, not ratios, and the design has no surface to be compared with.

    Parameters
    ----------
    f
        The swept curve: convex, run through in the direction of its x axis, upright on g.
    g
        The line that it is swept along; the middle row advances by its length at the target state.
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
        If an argument has no meaning, couplings or lengths are not as many as the sheet needs, or
        only one of f and g is given.
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
        row_lengths=None if row_lengths == "auto" else np.array(row_lengths),
        column_lengths=None if column_lengths == "auto" else np.array(column_lengths),
        stage=None if stage == "auto" else stage,
        flap=flap,
    )
    if f is None and g is None:
        return design_without_target(request, sectors, solution)
    if f is None or g is None:
        raise InputError(
            "f and g belong together",
            where="design_longitudinal_linear_repeating: f, g",
            got="one of them",
            expected="both, or none for no target",
        )
    f_trace, g_trace = trace_curve(f, "f").in_own_frame(), trace_curve(g, "g").in_own_frame()
    target = _Target(Profile.of(f_trace), Line.along(g_trace), request)
    chosen, (state, mechanism) = choose_sheet(
        sectors, solution, target.build, lambda made: made[1].lengths.inner_ratio
    )
    described = request.describe(chosen, mechanism)
    return place(mechanism, target.profile, target.line, state, described)


@record
class _Target:
    """A convex f, a straight g, and the sheet that is to meet them."""

    profile: Profile
    line: Line
    request: SheetRequest

    def build(self, solution: Solution) -> tuple[TargetState, LongitudinalLinearRepeating]:
        """The target state and the sheet that a solution of (4) gives."""
        request = self.request
        if solution.version == "sine":
            raise DesignError(
                "a solution of (4) in the sine version folds S rows to alternate sides, so no "
                "column follows a convex curve",
                candidates=[Remedy({"pattern.solution": 0}), AUTO_SECTORS],
            )
        columns = request.coupled(solution)
        with request.size_blamed(columns):
            state = find_target_state(
                self.profile,
                columns,
                request.rows,
                request.first_row,
                drive=request.stage,
                lengths=request.column_lengths,
            )
            inner = self._lengths(columns, state)
        sheet = request.completed(columns, inner, state.ends, side=state.side)
        return state, replace(sheet, stop=state.drive)

    def _lengths(self, columns: Columns, state: TargetState) -> InnerLengths:
        """Lengths of the inner creases: column 1 follows f, the middle row is as long as g."""
        request = self.request
        directions = request.directions(columns)
        row, column = request.row_lengths, state.lengths[1:-1]
        weights = state.section.advance
        if request.rows == 1:
            row = np.ones(request.columns - 1) if row is None else row
            scale = self.line.length / float(weights @ row)
            return InnerLengths.marched(directions, scale * row, column)
        free = Wanted(row=row, column=column, ends=state.ends)
        found = find_even_lengths(directions, replace(free, advance=(weights, self.line.length)))
        if found is not None:
            return found
        limits = advance_range(directions, free, weights)
        if limits is None:
            given = "these row_lengths" if row is not None else "column 1 following f"
            raise DesignError(
                f"a sheet with {given} would have creases of zero or negative length"
                if fits_program(request.rows, request.columns, following=True)
                else f"no sheet with {given} was found: {UNTRIED}",
                candidates=[Remedy({"pattern.row_lengths": "auto"})]
                if row is not None
                else chain(smaller(request.rows, request.columns), [AUTO_SECTORS]),
            )
        low, high = limits
        works_at = low if self.line.length < low else high

        def works(length: float) -> bool:
            wanted = replace(free, advance=(weights, length))
            return find_even_lengths(directions, wanted) is not None

        @cache
        def share() -> float | None:
            """How long g may be, of what it is; None if no length is found that works."""
            # The range is that of sheets in proportion; others are made, too.
            start = next((each for each in (works_at, 0.5 * (low + high)) if works(each)), None)
            return start and bisect(works, start, self.line.length) / self.line.length

        def candidates() -> Iterator[Remedy]:
            if (found := share()) is not None:
                yield from sizes("g", self.line.trace.curve, found)
            yield AUTO_SECTORS

        raise DesignError(
            "a sheet with a middle row as long as g would have creases of zero or negative length",
            size=f"g is {self.line.length:.6g} long, and with column 1 following f the middle row "
            f"may be {low:.6g} to {high:.6g} long",
            candidates=candidates(),
            excess=lambda: (found := share()) and max(found, 1 / found) - 1,
        )
