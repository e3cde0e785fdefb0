"""The sheet that meets a convex curve and a line, or the reason why there is none."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from itertools import chain

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.record import record
from orishell.families.longitudinal_linear_repeating.equation.choice import (
    AUTO_SECTORS,
)
from orishell.families.longitudinal_linear_repeating.equation.solutions import Solution
from orishell.families.longitudinal_linear_repeating.motion.mechanism import (
    LongitudinalLinearRepeating,
)
from orishell.families.longitudinal_linear_repeating.sheet import SheetRequest
from orishell.families.longitudinal_linear_repeating.target import Line, Profile
from orishell.families.longitudinal_linear_repeating.target_state import (
    TargetState,
    find_target_state,
)
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Columns,
)
from orishell.families.longitudinal_linear_repeating.tessellation.even_lengths import (
    UNTRIED,
    Wanted,
    advance_range,
    find_even_lengths,
    fits_program,
)
from orishell.families.longitudinal_linear_repeating.tessellation.lengths import InnerLengths
from orishell.families.shared.candidates import sizes, smaller
from orishell.numerics.bisection import bisect


@record
class Target:
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
