"""The table [pattern] of the parallel repeating family, and how it is listed."""

from __future__ import annotations

import math
from pathlib import Path as FilePath
from typing import Annotated, ClassVar, Self

import numpy as np
from pydantic import Field, model_validator

from orishell.conventions.arguments import checked
from orishell.conventions.errors import Remedy
from orishell.conventions.formatting import in_degrees, tidy_degrees
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.table import Knob, Number, misfit
from orishell.curves import Curve, trace_curve
from orishell.design import (
    Design,
    FlapSide,
    Parameter,
    Path,
    PiecedSurface,
    Surface,
    Turning,
    warn_of_no_lock,
)
from orishell.families.parallel_repeating.mechanism import ParallelRepeating
from orishell.families.parallel_repeating.profile import (
    F,
    Profile,
    approach,
    fit_profile,
    inner_staircase,
    widest_xi,
)
from orishell.families.parallel_repeating.sheet import (
    less_sheet,
    require_flap_resolution,
    require_flat_sheet,
    require_row_edges,
    warn_of_stretched_columns,
)
from orishell.families.pattern import (
    FLAP_SIDE,
    PLACEMENT,
    ROWS,
    SPACING,
    Auto,
    Family,
    OddRowCount,
    Pattern,
    in_radians,
)
from orishell.families.shared.candidates import forgiving, smaller
from orishell.families.shared.row import Planes, Row
from orishell.families.shared.sheets import middle_vertex, upright
from orishell.families.shared.sweep_fit import SweepLimits
from orishell.families.shared.sweeps import design_sweep
from orishell.families.tolerance import Tolerance, Variants, placement_variants
from orishell.motion import require_resolution
from orishell.motion.lattice import InnerStaircase
from orishell.polylines import (
    Placement,
    Spacing,
    fit_staircase,
    measure_chords,
    place_chords,
    theta_interval,
    warn_of_coarse_row,
    xi_limit,
)

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
    """Parameters of the parallel repeating family (the paper's section 2)."""

    closing: ClassVar[Remedy | None] = Remedy({"pattern.plane": "bisector"})

    ripple: ClassVar[float] = 1.15
    orderly: ClassVar[bool] = True

    rows: Annotated[OddRowCount, ROWS]
    flap_side: Annotated[
        FlapSide | Annotated[list[FlapSide], Field(min_length=2, max_length=2)], FLAP_SIDE
    ] = "end"
    xi_deg: Annotated[
        Annotated[Number, Field(ge=0.1, le=179.9)] | Auto,
        Knob.angle(
            "Crease angle ξ",
            "Angle between the creases of column 1 when locked; wider is closer to f",
            (1, 179),
        ),
    ] = "auto"
    theta_deg: Annotated[
        Annotated[Number, Field(ge=-360, le=360)] | Auto,
        Knob.angle(
            "Turn of f θ", "Turns f in its own plane before it is swept", (-90, 90), advanced=True
        ),
    ] = 0.0
    plane_deg: Annotated[
        Number,
        Field(gt=0, lt=180),
        Knob.angle("Plane angle", "Angle from f's plane to g's tangent", (20, 160), advanced=True),
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
        if self.plane == "bisector" and self.plane_deg != 90.0:
            raise misfit('90 beside plane = "bisector"', self.plane_deg, "plane_deg")
        return self

    def sides(self) -> tuple[FlapSide, FlapSide]:
        """End of f to which the left and the right flap fold."""
        side: FlapSide | list[FlapSide] = self.flap_side if self.flap else "end"
        left, right = side if isinstance(side, list) else (side, side)
        return left, right

    def profile(self, f: Curve) -> Profile:
        """The staircase that column 1 follows, and f turned to it."""
        return fit_profile(f, self.rows + 1, in_radians(self.xi_deg), in_radians(self.theta_deg))

    def inner_staircase(self, f: Curve, inner: Curve) -> InnerStaircase:
        """The staircase of a second skin that follows a curve of its own."""
        return inner_staircase(self.profile(f), inner)

    def variants(self, f: Curve, tolerance: Tolerance) -> Variants[Self]:
        """Vertices of g in the best ways, and angles xi up to the widest that f admits."""
        ways = placement_variants(self, tolerance)
        if self.xi_deg != "auto":
            return Variants(ways[:1], ways[1:])
        theta = in_radians(self.theta_deg)
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
        return self.profile(f).staircase.distance

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


@checked()
def design_parallel_repeating(f: Curve, g: Curve, pattern: ParallelRepeatingPattern) -> Design:
    """Design a shell that sweeps f along g (the paper's section 2).

    Parameters
    ----------
    f, g
        The swept curve and the curve that it is swept along, in one unit of length. f is run
        through in the direction of its (rotated) x axis; at lock this axis lies to the right of
        g, seen along g, and f's y axis points up.
    pattern
        Rows, columns, and what else may be asked of the sheet.

    Raises
    ------
    InputError
        If an argument has no meaning.
    CurveError
        If f or g is not a usable curve.
    DesignError
        If the family cannot reach the target: the condition, where, by how much, what works.

    Examples
    --------
    >>> from orishell.curves import curve_from_formulas, parse_formula
    >>> f = curve_from_formulas(None, parse_formula("-x**2"), -1, 1)
    >>> g = curve_from_formulas(None, parse_formula("5*sin(pi*x/10)"), 0, 20)
    >>> design = design_parallel_repeating(f, g, ParallelRepeatingPattern(rows=9, columns=11))
    >>> design.mechanism.positions(np.pi).shape
    (11, 13, 3)
    """
    rows, plane = pattern.rows, in_radians(pattern.plane_deg)
    sides = pattern.sides()
    profile = pattern.profile(f)
    f_trace, theta = profile.trace, profile.theta
    staircase, xi = profile.staircase, profile.staircase.xi

    g_trace = trace_curve(g, "g").in_own_frame()
    row = Row.on(
        g_trace,
        pattern.columns,
        plane,
        pattern.plane,
        spacing=pattern.spacing,
        placement=pattern.placement,
    )
    row.require_crossing()
    width = float(staircase.lengths.mean()) if pattern.flap == "auto" else pattern.flap
    mechanism = ParallelRepeating(
        xi=xi,
        lengths=staircase.lengths,
        first=staircase.first,
        points=row.chords.vertices @ np.array([1, 1j]),
        axes=np.exp(1j * (row.heading - row.plane)),
        flaps=(0.0, 0.0),
        flap_sides=sides,
    ).with_flaps(width)
    require_row_edges(mechanism, f, g)
    require_flap_resolution(mechanism, width)
    require_resolution(mechanism.without_flaps(), smaller(rows, pattern.columns))
    require_flat_sheet(
        mechanism,
        width,
        row.chords.parameters,
        lambda angle: fit_staircase(f_trace, angle, rows + 1),
        g,
    )

    closeness = {"f": profile.closeness, "g": measure_chords(g_trace, row.chords)}
    low, high = f_trace.heading_range()
    interval = theta_interval(low - theta, high - theta, xi)
    scales = mechanism.column_scales()
    bisecting: dict[str, Parameter] = {}
    if pattern.plane == "bisector":
        bisecting = {"plane": pattern.plane, "plane_off_deg": tidy_degrees(row.off)}
    origin = middle_vertex(staircase)
    return Design(
        mechanism=mechanism,
        parameters={
            "xi_deg": tidy_degrees(xi),
            "xi_limit_deg": tidy_degrees(xi_limit(low, high)),
            "theta_deg": tidy_degrees(theta),
            "theta_interval_deg": [tidy_degrees(angle) for angle in interval],
            "plane_deg": tidy_degrees(plane),
            **bisecting,
            "column_scale": [float(scales.min()), float(scales.max())],
            "flap": width,
            "flap_side": [str(side) for side in sides],
            "spacing": pattern.spacing,
            "placement": pattern.placement,
        },
        targets={
            "f": upright(f_trace, origin, mechanism.points[0], mechanism.axes[0]),
            "g": np.concatenate([g_trace.points, np.zeros((len(g_trace.points), 1))], axis=-1),
        },
        closeness=closeness,
        swept=Surface(f_trace, origin, Turning(Path.of(g_trace), plane)),
        approached=approach(f_trace, origin, g_trace, plane),
        tilted=f"f is turned in its plane by {in_degrees(theta)} degrees" if theta else "",
        smaller_by=less_sheet(tidy_degrees(xi), tidy_degrees(xi_limit(low, high))),
        origin=np.append(g_trace.origin, 0.0),
        warnings=(
            *warn_of_coarse_row(g_trace, closeness["g"].max, pattern.columns),
            *warn_of_stretched_columns(mechanism, plane),
            *F.warn_of_imbalance(staircase),
            *warn_of_no_lock(width),
        ),
    )


FAMILY = Family(
    name="parallel-repeating",
    pattern=ParallelRepeatingPattern,
    label="Parallel repeating",
    what="Any f along any g, at right angles or oblique",
    starter=FilePath(__file__).with_name("starter.toml"),
)
