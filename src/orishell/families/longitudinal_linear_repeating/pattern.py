"""The table [pattern] of the longitudinal family, and how it is listed."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import Field, model_validator

from orishell.conventions.arguments import checked
from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.table import Knob, Number, misfit
from orishell.curves import Curve, trace_curve
from orishell.design import Design, PiecedSurface
from orishell.families.longitudinal_linear_repeating.equation.choice import (
    AUTO_SHARES,
    auto_sectors,
    choose_sheet,
    choose_solution,
)
from orishell.families.longitudinal_linear_repeating.equation.solutions import Sectors
from orishell.families.longitudinal_linear_repeating.placement import place
from orishell.families.longitudinal_linear_repeating.sheet import SheetRequest
from orishell.families.longitudinal_linear_repeating.target import Line, Profile
from orishell.families.longitudinal_linear_repeating.target_sheet import Target
from orishell.families.longitudinal_linear_repeating.target_state import (
    TargetState,
    find_target_state,
)
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Coupling,
    RowKind,
    repeat_columns,
)
from orishell.families.longitudinal_linear_repeating.without_target import design_without_target
from orishell.families.pattern import Auto, Family, Length, Pattern, in_radians
from orishell.families.shared.candidates import forgiving
from orishell.families.shared.sweep_fit import SweepLimits
from orishell.families.shared.sweeps import design_sweep
from orishell.families.tolerance import Tolerance, Variants
from orishell.polylines import measure_closeness

Angle = Annotated[Number, Field(gt=0, lt=180)]
SWEEPS = (
    SweepLimits("cylinder", convex=True),
    SweepLimits("cylinder", steepest=4.0, convex=True),
)
"""What f along a straight g can be."""
STAGED = 3
"""Sector angles, the first that are tried, for which other stages are tried, too."""
STAGE_SHARES = (1.1, 0.9, 1.2, 0.8, 1.05, 0.95, 1.3, 0.7, 1.4, 0.6)
"""Stages that are tried, as shares of the one at which column 1 turns as much as f."""


class LongitudinalPattern(Pattern):
    """Parameters of the longitudinal linear repeating family (the paper's section 4)."""

    most: ClassVar[int] = 25
    row_step: ClassVar[int] = 1
    unasked: ClassVar[Mapping[str, Any]] = {"sector_deg": "auto"}

    sector_deg: Annotated[
        Annotated[list[Angle], Field(min_length=4, max_length=4)] | Auto,
        Knob("Sector angles", "Four angles at the first vertex", "deg"),
    ]
    solution: Annotated[
        Annotated[int, Field(ge=0)],
        Knob(
            "Solution",
            "Which solution of equation (4), as `orishell solve` lists them",
            slider=(0, 1),
            step=1,
            advanced=True,
        ),
    ] = 0
    couplings: list[Coupling] | Literal["periodic"] = "periodic"
    first_row: Annotated[
        RowKind,
        Knob(
            "First row",
            "Kind of the vertices of row 1: flat-foldable or column-straight",
            advanced=True,
        ),
    ] = "F"
    row_lengths: list[Length] | Auto = "auto"
    column_lengths: list[Length] | Auto = "auto"
    stage_deg: Annotated[
        Annotated[Number, Field(gt=0, le=180)] | Auto,
        Knob.angle(
            "Stage", "Fold angle of column 1 at which the shell stands", (0.1, 60), step=0.1
        ),
    ] = "auto"
    flap: Annotated[
        Length | Auto,
        Knob("Border", "Length of the row creases at both borders", "length"),
    ] = "auto"

    @model_validator(mode="after")
    def _check(self) -> Self:
        for key, count in (
            ("row_lengths", self.columns - 1),
            ("column_lengths", self.rows + 1),
            ("couplings", self.columns - 1),
        ):
            entries = getattr(self, key)
            if not isinstance(entries, str) and len(entries) != count:
                raise misfit(f"{count} entries", len(entries), key)
        return self

    def sectors(self) -> Sectors | Auto:
        """The sector angles of column 1, or "auto"."""
        angles = self.sector_deg
        return angles if isinstance(angles, str) else Sectors.from_degrees(angles)

    def request(self) -> SheetRequest:
        """What is asked for, apart from the sector angles and the target."""
        stage = in_radians(self.stage_deg)
        return SheetRequest(
            rows=self.rows,
            columns=self.columns,
            first_row=self.first_row,
            couplings=self.couplings,
            row_lengths=None if self.row_lengths == "auto" else np.array(self.row_lengths),
            column_lengths=None if self.column_lengths == "auto" else np.array(self.column_lengths),
            stage=None if isinstance(stage, str) else stage,
            flap=self.flap,
        )

    def variants(self, f: Curve, tolerance: Tolerance) -> Variants[Self]:
        """Sector angles that "auto" chooses from, and stages about column 1's own."""
        angles = [self]
        if self.sector_deg == "auto":
            # Very near to 90, half way, then the others.
            apart = AUTO_SHARES[-3::-4]
            shares = (*apart, *(share for share in AUTO_SHARES if share not in apart))
            every = [auto_sectors(share).degrees for share in shares]
            angles += [self.model_copy(update={"sector_deg": each}) for each in every]
        if self.stage_deg != "auto":
            return Variants(angles[:2], angles[2:])
        # Column 1 comes as near to f with all of them, but the others follow it better near 90.
        known = [each for each in angles if each.sector_deg != "auto"]
        stages = [
            each.model_copy(update={"stage_deg": stage})
            for each in known[:STAGED]
            for stage in each._open_stages(f)
        ]
        return Variants([*angles[:2], *stages[:2]], [*angles[2:], *stages[2:]])

    def distance_from_f(self, f: Curve) -> float:
        """Distance of column 1 from f; 0 where its sector angles are chosen with the sheet."""
        if self.sector_deg == "auto":
            return 0.0
        profile, state = self._column(f)
        return measure_closeness(profile.trace, state.polygon).max

    def _open_stages(self, f: Curve) -> list[float]:
        """Stages to try (degrees); none where column 1 has no stage of its own."""
        try:
            own = self._column(f)[1].drive
        except DesignError:
            return []
        return [float(np.rad2deg(share * own)) for share in STAGE_SHARES]

    def _column(self, f: Curve) -> tuple[Profile, TargetState]:
        """Column 1: how near it comes to f does not depend on the columns beside it."""
        asked, sectors = self.request(), self.sectors()
        assert sectors != "auto"
        profile = Profile.of(trace_curve(f, "f").in_own_frame())
        return profile, find_target_state(
            profile,
            repeat_columns(choose_solution(sectors, self.solution), 2),
            self.rows,
            self.first_row,
            drive=asked.stage,
            lengths=asked.column_lengths,
        )

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell."""
        return forgiving(self, design_longitudinal_linear_repeating, f, g)

    def design_on(self, surface: PiecedSurface, progress: Progress = no_progress) -> Design:
        """Design the shell over the convex cylinder that is nearest."""
        return design_sweep(surface, SWEEPS, lambda f, g, _: self.design(f, g))

    def design_without_target(self) -> Design:
        """Design the sheet alone."""
        return forgiving(self, partial(design_longitudinal_linear_repeating, None, None))


@checked()
def design_longitudinal_linear_repeating(
    f: Curve | None, g: Curve | None, pattern: LongitudinalPattern
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
    pattern
        Rows, columns, sector angles, and what else may be asked of the sheet.

    Raises
    ------
    CurveError
        If f or g is not a usable curve.
    InputError
        If an argument has no meaning, or only one of f and g is given.
    DesignError
        If the family cannot reach the target, or there is no such sheet: the condition, where, by
        how much, what works.

    Examples
    --------
    >>> from orishell.curves import curve_from_formulas, parse_formula
    >>> f = curve_from_formulas(parse_formula("cos(t)"), parse_formula("sin(t)"), 0.3, 2.8)
    >>> g = curve_from_formulas(None, parse_formula("0*x"), 0, 3)
    >>> pattern = LongitudinalPattern(rows=9, columns=9, sector_deg=[85, 80, 95, 100])
    >>> design_longitudinal_linear_repeating(f, g, pattern).mechanism.grid
    Grid(rows=11, columns=11)
    """
    request, sectors = pattern.request(), pattern.sectors()
    if f is None and g is None:
        return design_without_target(request, sectors, pattern.solution)
    if f is None or g is None:
        raise InputError(
            "f and g belong together",
            where="design_longitudinal_linear_repeating: f, g",
            got="one of them",
            expected="both, or None for no target",
        )
    f_trace, g_trace = trace_curve(f, "f").in_own_frame(), trace_curve(g, "g").in_own_frame()
    target = Target(Profile.of(f_trace), Line.along(g_trace), request)
    chosen, (state, mechanism) = choose_sheet(
        sectors, pattern.solution, target.build, lambda made: made[1].lengths.inner_ratio
    )
    described = request.describe(chosen, mechanism)
    return place(mechanism, target.profile, target.line, state, described)


FAMILY = Family(
    name="longitudinal-linear-repeating",
    pattern=LongitudinalPattern,
    label="Longitudinal",
    what="A convex f along a straight line, growing or shrinking",
    starter=Path(__file__).with_name("starter.toml"),
    borders="strips along its border",
)
