"""The table [pattern] of the longitudinal family, and how it is listed."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import Field, model_validator

from orishell.conventions.table import Knob, Number
from orishell.curves import Curve
from orishell.design import Design
from orishell.families.longitudinal_linear_repeating.design import (
    STAGE,
    SolutionNumber,
    design_longitudinal_linear_repeating,
    require_entries,
)
from orishell.families.longitudinal_linear_repeating.equation.solutions import Sectors
from orishell.families.longitudinal_linear_repeating.tessellation.columns import Coupling, RowKind
from orishell.families.longitudinal_linear_repeating.variants import (
    distance_from_f,
    open_sectors,
    open_stages,
)
from orishell.families.pattern import Auto, Family, Length, Pattern, Tolerance, Variants
from orishell.families.shared.candidates import forgiving

Angle = Annotated[Number, Field(gt=0, lt=180)]
STAGED = 3
"""Sector angles, the first that are tried, for which other stages are tried, too."""


class LongitudinalPattern(Pattern):
    """Parameters of the longitudinal linear repeating family."""

    most: ClassVar[int] = 25
    row_step: ClassVar[int] = 1
    needs_target: ClassVar[bool] = False

    sector_deg: Annotated[
        Annotated[list[Angle], Field(min_length=4, max_length=4)] | Auto,
        Knob("Sector angles", "Four angles at the first vertex", "angles4", True, "deg"),
    ]
    solution: Annotated[
        SolutionNumber,
        Knob(
            "Solution",
            "Which solution of equation (4), as `orishell solve` lists them",
            "integer",
            slider=(0, 1),
            step=1,
        ),
    ] = 0
    couplings: list[Coupling] | Literal["periodic"] = "periodic"
    first_row: Annotated[
        RowKind,
        Knob(
            "First row",
            "Kind of the vertices of row 1: flat-foldable or column-straight",
            "choice",
            choices=("F", "S"),
        ),
    ] = "F"
    row_lengths: list[Length] | Auto = "auto"
    column_lengths: list[Length] | Auto = "auto"
    stage_deg: Annotated[
        Annotated[Number, Field(**STAGE)] | Auto,
        Knob.angle(
            "Stage", "Fold angle of column 1 at which the shell stands", (0.1, 60), step=0.1
        ),
    ] = "auto"
    flap: Annotated[
        Length | Auto,
        Knob("Border", "Length of the row creases at both borders", "number", True, "length"),
    ] = "auto"

    @model_validator(mode="after")
    def _check(self) -> Self:
        require_entries(self)
        return self

    def arguments(self) -> dict[str, Any]:
        """The keys as the function takes them, see :meth:`Pattern.arguments`."""
        angles = self.sector_deg
        values = super().arguments()
        del values["sector"]
        return {**values, "sectors": angles if angles == "auto" else Sectors.from_degrees(angles)}

    def variants(self, f: Curve, tolerance: Tolerance) -> Variants[Self]:
        """Sector angles that "auto" chooses from, and stages about column 1's own."""
        angles = [self]
        if self.sector_deg == "auto":
            angles += [self.model_copy(update={"sector_deg": each}) for each in open_sectors()]
        if self.stage_deg != "auto":
            return Variants(angles[:2], angles[2:])
        # Column 1 comes as near to f with all of them, but the others follow it better near 90.
        known = [each for each in angles if each.sector_deg != "auto"]
        stages = [
            each.model_copy(update={"stage_deg": stage})
            for each in known[:STAGED]
            for stage in open_stages(f, each.arguments())
        ]
        return Variants([*angles[:2], *stages[:2]], [*angles[2:], *stages[2:]])

    def distance_from_f(self, f: Curve) -> float:
        """Distance of column 1 from f; 0 where its sector angles are chosen with the sheet."""
        return 0.0 if self.sector_deg == "auto" else distance_from_f(f, self.arguments())

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell."""
        return forgiving(
            self, lambda: design_longitudinal_linear_repeating(f, g, **self.arguments()), (f, g)
        )

    def design_without_target(self) -> Design:
        """Design the sheet alone."""
        return forgiving(self, lambda: design_longitudinal_linear_repeating(**self.arguments()))


FAMILY = Family(
    name="longitudinal-linear-repeating",
    pattern=LongitudinalPattern,
    label="Longitudinal",
    what="A convex f along a straight line, growing or shrinking",
    starter=Path(__file__).with_name("starter.toml"),
    borders="strips along its border",
)
