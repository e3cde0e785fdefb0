"""The table [pattern] of the orthodiagonal family, and how it is listed."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, ClassVar, Self

from pydantic import Field, model_validator

from orishell.conventions.table import Number
from orishell.curves import Curve
from orishell.design import Design, FlapSide
from orishell.errors import Remedy
from orishell.families.orthodiagonal.design import HEADING, ROW_ANGLE, design_orthodiagonal
from orishell.families.orthodiagonal.row import RowKind, require_one_kind
from orishell.families.parameters import (
    FLAP_SIDE,
    PLACEMENT,
    ROWS,
    SPACING,
    Auto,
    Knob,
    Length,
    OddRowCount,
)
from orishell.families.pattern import Family, Pattern, Tolerance, placement_variants
from orishell.families.slips import forgiving
from orishell.polylines import Placement, Spacing


class OrthodiagonalPattern(Pattern):
    """Parameters of the orthodiagonal family."""

    closing: ClassVar[Remedy | None] = Remedy({"pattern.row": "zigzag"})

    rows: Annotated[OddRowCount, ROWS]
    flap_side: Annotated[
        FlapSide | Auto | Annotated[list[FlapSide | Auto], Field(min_length=2, max_length=2)],
        FLAP_SIDE,
    ] = "auto"
    depth: Annotated[
        Length | Auto,
        Knob(
            "Depth",
            "Distance of the zigzag's vertices from f, on both sides",
            "number",
            True,
            "length",
        ),
    ] = "auto"
    heading_deg: Annotated[
        Annotated[Number, Field(**HEADING)] | Auto,
        Knob.angle("Heading", "Angle between f's plane and g's x axis", (0, 180)),
    ] = 90.0
    row: Annotated[
        RowKind,
        Knob(
            "Middle row",
            "Chords of g, or a zigzag of two headings: then the shell folds flat without flaps",
            "choice",
            choices=("chords", "zigzag"),
        ),
    ] = "chords"
    row_angle_deg: Annotated[
        Annotated[Number, Field(**ROW_ANGLE)] | Auto,
        Knob.angle(
            "Row angle", "Angle between the edges of a zigzag row; wider is closer to g", (1, 179)
        ),
    ] = "auto"
    spacing: Annotated[Spacing, SPACING] = "curvature"
    placement: Annotated[Placement, PLACEMENT] = "inscribed"

    @model_validator(mode="after")
    def _check(self) -> Self:
        require_one_kind("row_angle_deg")(self)
        return self

    def variants(self, tolerance: Tolerance) -> list[Self]:
        """As for parallel repeating, and with zigzags somewhat less deep than the tolerance."""
        ways = [self] if self.row == "zigzag" else placement_variants(self, tolerance)
        if "depth" in self.model_fields_set:
            return ways
        depths = [share * tolerance.surface for share in (0.9, 0.7)]
        return [
            *ways,
            *(each.model_copy(update={"depth": depth}) for each in ways for depth in depths),
        ]

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell."""
        return forgiving(self, lambda: design_orthodiagonal(f, g, **self.arguments()), (f, g))


FAMILY = Family(
    name="orthodiagonal",
    pattern=OrthodiagonalPattern,
    label="Orthodiagonal",
    what="A wavy cylinder: f along g, in parallel planes",
    starter=Path(__file__).with_name("starter.toml"),
)
