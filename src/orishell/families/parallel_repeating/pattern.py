"""The table [pattern] of the parallel repeating family, and how it is listed."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated, Any, ClassVar, Self

import numpy as np
from pydantic import Field, model_validator

from orishell.conventions.errors import Remedy
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.table import Knob, Number
from orishell.curves import Curve, trace_curve
from orishell.design import Design, FlapSide, PiecedSurface
from orishell.families.parallel_repeating.design import (
    PLANE,
    THETA,
    XI,
    design_parallel_repeating,
    require_square,
)
from orishell.families.parallel_repeating.profile import Planes, fit_profile, widest_xi
from orishell.families.pattern import (
    FLAP_SIDE,
    PLACEMENT,
    ROWS,
    SPACING,
    Auto,
    Family,
    OddRowCount,
    Pattern,
)
from orishell.families.shared.candidates import forgiving
from orishell.families.shared.sweep_fit import SweepLimits
from orishell.families.shared.sweeps import design_sweep
from orishell.families.tolerance import Tolerance, Variants, placement_variants
from orishell.polylines import Placement, Spacing, measure_chords, place_chords

XI_SHARES = (0.9, 0.75, 0.5, 0.95, 0.85, 0.8, 0.7, 0.6)
"""Angles xi that are tried to meet a tolerance, as shares of the widest: beside that and "auto",
which keeps edges even."""
NARROWER = 3
"""Number of them that are tried where edges may have any length."""
SWEEPS = (SweepLimits("moulding"), SweepLimits("cylinder"))
"""What f along g can be."""
WIDER = 1e-3
"""The widest is tried where it is wider than "auto" by this share."""


class ParallelRepeatingPattern(Pattern):
    """Parameters of the parallel repeating family."""

    closing: ClassVar[Remedy | None] = Remedy({"pattern.plane": "bisector"})

    ripple: ClassVar[float] = 1.15
    orderly: ClassVar[bool] = True

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
        Knob.angle(
            "Turn of f θ", "Turns f in its own plane before it is swept", (-90, 90), advanced=True
        ),
    ] = 0.0
    plane_deg: Annotated[
        Number,
        Field(**PLANE),
        Knob.angle(
            "Plane angle",
            "Angle from f's plane to g's tangent",
            (20, 160),
            advanced=True,
        ),
    ] = 90.0
    plane: Annotated[
        Planes,
        Knob(
            "Planes follow",
            "g's tangent, or the angles of its polyline: then the shell folds flat without flaps",
            advanced=True,
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
        plane = float(np.deg2rad(self.plane_deg))
        return {**super().arguments(), "planes": self.plane, "plane": plane}

    def variants(self, f: Curve, tolerance: Tolerance) -> Variants[Self]:
        """Vertices of g in the best ways, and angles xi up to the widest that f admits."""
        ways = placement_variants(self, tolerance)
        if self.xi_deg != "auto":
            return Variants(ways[:1], ways[1:])
        theta = self.arguments()["theta"]
        best = fit_profile(f, self.rows + 1, "auto", theta)
        widest, own = widest_xi(f, theta), best.staircase.xi
        wide = [{"xi_deg": tidy_degrees(widest)}] if widest > own * (1 + WIDER) else []
        # Narrower angles are farther from f, but their edges are more alike.
        limited = tolerance.limits_edges
        shares = XI_SHARES if limited else XI_SHARES[:NARROWER]
        # The rotation is chosen once for all of these: it is what takes the time.
        turned = {"theta_deg": tidy_degrees(best.theta)} if theta == "auto" else {}
        narrow = ({"xi_deg": tidy_degrees(share * widest)} | turned for share in shares)
        angles = [{}, *wide, *narrow]
        every = [way.model_copy(update=each) for way in ways for each in angles]
        telling = every[: 1 + len(wide)]
        if limited:
            evenly = every[len(angles) :] if tolerance.panel_max < math.inf else every
            telling += evenly[: 1 + len(wide) + NARROWER]
        return Variants(telling, [each for each in every if each not in telling])

    def distance_from_f(self, f: Curve) -> float:
        """Distance of column 1 from f."""
        asked = self.arguments()
        return fit_profile(f, self.rows + 1, asked["xi"], asked["theta"]).staircase.distance

    def distance_from_g(self, g: Curve) -> float:
        """Distance of the middle row from g."""
        trace = trace_curve(g, "g").in_own_frame()
        chords = place_chords(trace, self.columns, self.spacing, self.placement)
        return measure_chords(trace, chords).max

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell."""
        return forgiving(self, design_parallel_repeating, f, g)

    def design_on(self, surface: PiecedSurface, progress: Progress = no_progress) -> Design:
        """Design the shell over the moulding surface, or the cylinder, that is nearest."""
        return design_sweep(surface, SWEEPS, lambda f, g, _: self.design(f, g))


FAMILY = Family(
    name="parallel-repeating",
    pattern=ParallelRepeatingPattern,
    label="Parallel repeating",
    what="Any f along any g, at right angles or oblique",
    starter=Path(__file__).with_name("starter.toml"),
)
