"""The table [pattern] of the parallel repeating family, and how it is listed."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, ClassVar, Self

import numpy as np
from pydantic import Field, model_validator

from orishell.conventions.table import Number
from orishell.curves import Curve
from orishell.design import Design, FlapSide
from orishell.errors import Remedy
from orishell.families.parallel_repeating.design import (
    PLANE,
    THETA,
    XI,
    design_parallel_repeating,
    require_square,
)
from orishell.families.parallel_repeating.row import Planes
from orishell.families.parameters import (
    FLAP_SIDE,
    PLACEMENT,
    ROWS,
    SPACING,
    Auto,
    Knob,
    OddRowCount,
)
from orishell.families.pattern import Family, Pattern, Tolerance, placement_variants
from orishell.families.slips import forgiving
from orishell.polylines import Placement, Spacing


class ParallelRepeatingPattern(Pattern):
    """Parameters of the parallel repeating family."""

    closing: ClassVar[Remedy | None] = Remedy({"pattern.plane": "bisector"})

    rows: Annotated[OddRowCount, ROWS]
    flap_side: Annotated[
        FlapSide | Annotated[list[FlapSide], Field(min_length=2, max_length=2)], FLAP_SIDE
    ] = "end"
    xi_deg: Annotated[
        Annotated[Number, Field(**XI)] | Auto,
        Knob.angle(
            "Crease angle ξ",
            "Angle between the creases of column 1 when locked; wider is closer to f",
            (1, 179),
        ),
    ] = "auto"
    theta_deg: Annotated[
        Annotated[Number, Field(**THETA)] | Auto,
        Knob.angle("Turn of f θ", "Turns f in its own plane before it is swept", (-90, 90)),
    ] = 0.0
    plane_deg: Annotated[
        Number,
        Field(**PLANE),
        Knob.angle("Plane angle", "Angle from f's plane to g's tangent", (20, 160), auto=False),
    ] = 90.0
    plane: Annotated[
        Planes,
        Knob(
            "Planes follow",
            "g's tangent, or the angles of its polyline: then the shell folds flat without flaps",
            "choice",
            choices=("tangent", "bisector"),
        ),
    ] = "tangent"
    spacing: Annotated[Spacing, SPACING] = "curvature"
    placement: Annotated[Placement, PLACEMENT] = "inscribed"

    @model_validator(mode="after")
    def _check(self) -> Self:
        require_square("plane", "plane_deg", 90.0)(self)
        return self

    def arguments(self) -> dict[str, Any]:
        """The keys as the function takes them, see :meth:`Pattern.arguments`."""
        angle = float(np.deg2rad(self.plane_deg))
        return {**super().arguments(), "planes": self.plane, "plane": angle}

    def variants(self, tolerance: Tolerance) -> list[Self]:
        """Vertices of g balanced; where panels must not be long, also equally far apart."""
        return placement_variants(self, tolerance)

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell."""
        return forgiving(self, lambda: design_parallel_repeating(f, g, **self.arguments()), (f, g))


FAMILY = Family(
    name="parallel-repeating",
    pattern=ParallelRepeatingPattern,
    label="Parallel repeating",
    what="Any f along any g, at right angles or oblique",
    starter=Path(__file__).with_name("starter.toml"),
)
