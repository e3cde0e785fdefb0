"""The table [pattern] of the orthodiagonal family, and how it is listed."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated, ClassVar, Self

import numpy as np
from pydantic import Field, model_validator

from orishell.conventions.errors import InputError, Remedy
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.table import Knob, Number
from orishell.curves import Curve, run_along_axis, trace_curve
from orishell.design import Design, FlapSide, PiecedSurface
from orishell.families.orthodiagonal.design import HEADING, ROW_ANGLE, design_orthodiagonal
from orishell.families.orthodiagonal.profile import zigzag_distance
from orishell.families.orthodiagonal.row import Row, RowKind, require_one_kind
from orishell.families.pattern import (
    FLAP_SIDE,
    PLACEMENT,
    ROWS,
    SPACING,
    Auto,
    Family,
    Length,
    OddRowCount,
    Pattern,
)
from orishell.families.shared.candidates import forgiving
from orishell.families.shared.sweep_fit import SweepLimits
from orishell.families.shared.sweeps import design_sweep
from orishell.families.tolerance import Tolerance, Variants, placement_variants
from orishell.polylines import Placement, Spacing

G_SHARE = 0.8
"""A shell is at such a share of the distance from its surface at least that the middle row has from
g: of 270 random ones none was nearer than 0.83 of it."""
DEPTH_SHARES = (0.9, 0.3, 0.6, 0.99, 0.95, 0.8, 0.7, 0.5, 0.4, 0.2, 0.1)
"""Depths that are tried beside "auto" to meet a tolerance, as shares of it."""
SWEEPS = (SweepLimits("cylinder"), SweepLimits("cylinder", steepest=4.0))
"""What f along a straight g can be; a steeper f comes nearer, but reaches farther."""
TELLING = 4
"""The first of them, which tell whether others may do."""


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

    def idle(self) -> set[str]:
        """Of a zigzag also the keys that place chords."""
        chords = {"spacing", "placement"} if self.row == "zigzag" else set()
        return super().idle() | chords

    def variants(self, f: Curve, tolerance: Tolerance) -> Variants[Self]:
        """As for parallel repeating, and zigzags of any depth below the tolerance."""
        ways = [self] if self.row == "zigzag" else placement_variants(self, tolerance)
        if self.depth != "auto":
            return Variants(ways[:1], ways[1:])
        shares = DEPTH_SHARES if math.isfinite(tolerance.surface) else ()
        depths = ["auto", *(share * tolerance.surface for share in shares)]
        every = [way.model_copy(update={"depth": depth}) for way in ways for depth in depths]
        return Variants(every[:TELLING], every[TELLING:])

    def distance_from_f(self, f: Curve) -> float:
        """Distance of column 1 from f, whichever zigzag it follows."""
        return zigzag_distance(
            run_along_axis(trace_curve(f, "f").in_own_frame()), self.rows, self.depth
        )

    def distance_from_g(self, g: Curve) -> float:
        """Most of the distance of the middle row from g, which may leave f's plane obliquely."""
        asked = self.arguments()
        if self.row == "zigzag":
            row = Row.of_zigzag(g, self.columns, asked["heading"], asked["row_angle"])
        else:
            row = Row.of_chords(g, self.columns, asked["heading"], self.spacing, self.placement)
        return G_SHARE * row.closeness.max

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell."""
        return forgiving(self, design_orthodiagonal, f, g)

    def design_on(self, surface: PiecedSurface, progress: Progress = no_progress) -> Design:
        """Design the shell over the cylinder that is nearest; its lines are square to f."""
        if "heading_deg" in self.model_fields_set:
            raise InputError(
                "f's plane is square to g where both are fitted to a surface",
                keys=("pattern.heading_deg",),
                got=f"{self.heading_deg}",
                remedy="remove heading_deg, or give f and g",
            )

        def heading(direction: float) -> float:
            return tidy_degrees(np.pi / 2 - direction)

        return design_sweep(
            surface,
            SWEEPS,
            lambda f, g, along: self.replace_unchecked(heading_deg=heading(along)).design(f, g),
            lambda along: {"pattern.heading_deg": heading(along)},
        )


FAMILY = Family(
    name="orthodiagonal",
    pattern=OrthodiagonalPattern,
    label="Orthodiagonal",
    what="A wavy cylinder: f along g, in parallel planes",
    starter=Path(__file__).with_name("starter.toml"),
)
