"""The table [pattern] of the orthodiagonal family, and how it is listed."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path as FilePath
from typing import Annotated, ClassVar, Final, Self

import numpy as np
from pydantic import Field, model_validator

from orishell.conventions.arguments import checked
from orishell.conventions.errors import InputError, Remedy
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.quantities import plain
from orishell.conventions.table import Knob, Number, misfit
from orishell.curves import Curve, run_along_axis, trace_curve
from orishell.design import Design, FlapSide, Path, PiecedSurface, Sliding, Surface, warn_of_no_lock
from orishell.families.orthodiagonal.flaps import choose_flaps
from orishell.families.orthodiagonal.headings import (
    SideChoice,
    choose_heading,
    describe_heading,
    headings_of,
)
from orishell.families.orthodiagonal.mechanism import Orthodiagonal
from orishell.families.orthodiagonal.profile import (
    EndPlanes,
    approach,
    raised,
    require_zigzags,
    tilt_of,
    tilted,
    zigzag_distance,
)
from orishell.families.orthodiagonal.refusal import refuse
from orishell.families.orthodiagonal.row import Row, RowKind
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
    in_radians,
)
from orishell.families.shared.candidates import forgiving, smaller
from orishell.families.shared.sheets import middle_vertex, upright
from orishell.families.shared.sweep_fit import SweepLimits
from orishell.families.shared.sweeps import design_sweep
from orishell.families.tolerance import Tolerance, Variants, placement_variants
from orishell.motion import require_resolution
from orishell.numerics.equals import largest_of
from orishell.polylines import Placement, Spacing, measure_closeness, warn_of_coarse_row

G_SHARE = 0.8
"""A shell is at such a share of the distance from its surface at least that the middle row has from
g: of 270 random ones none was nearer than 0.83 of it."""
DEPTH_SHARES = (0.9, 0.3, 0.6, 0.99, 0.95, 0.8, 0.7, 0.5, 0.4, 0.2, 0.1)
"""Depths that are tried beside "auto" to meet a tolerance, as shares of it."""
SWEEPS = (SweepLimits("cylinder"), SweepLimits("cylinder", steepest=4.0))
"""What f along a straight g can be; a steeper f comes nearer, but reaches farther."""
ONLY: Final[Mapping[RowKind, Mapping[str, str]]] = {
    "chords": {"spacing": "curvature", "placement": "inscribed"},
    "zigzag": {"row_angle_deg": "auto"},
}
"""Keys that only one kind of row has, and what they are for the other."""
TELLING = 4
"""The first of them, which tell whether others may do."""


class OrthodiagonalPattern(Pattern):
    """Parameters of the orthodiagonal family (the paper's section 3)."""

    closing: ClassVar[Remedy | None] = Remedy({"pattern.row": "zigzag"})

    rows: Annotated[OddRowCount, ROWS]
    flap_side: Annotated[
        FlapSide | Auto | Annotated[list[FlapSide | Auto], Field(min_length=2, max_length=2)],
        FLAP_SIDE,
    ] = "auto"
    depth: Annotated[
        Length | Auto,
        Knob("Depth", "Distance of the zigzag's vertices from f, on both sides", "length"),
    ] = "auto"
    heading_deg: Annotated[
        Annotated[Number, Field(ge=0, le=180)] | Auto,
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
        Annotated[Number, Field(ge=0.1, le=179.9)] | Auto,
        Knob.angle(
            "Row angle", "Angle between the edges of a zigzag row; wider is closer to g", (1, 179)
        ),
    ] = "auto"
    spacing: Annotated[Spacing, SPACING] = "curvature"
    placement: Annotated[Placement, PLACEMENT] = "inscribed"

    @model_validator(mode="after")
    def _check(self) -> Self:
        other: RowKind = "zigzag" if self.row == "chords" else "chords"
        for key, usual in ONLY[other].items():
            got = getattr(self, key)
            if got != usual:
                raise misfit(f"'{usual}', or row = \"{other}\"", got, key)
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
        return G_SHARE * self.middle_row(g).closeness.max

    def sides(self) -> tuple[SideChoice, SideChoice]:
        """End of f to which the left and the right flap fold; None where it is chosen."""
        side: FlapSide | Auto | list[FlapSide | Auto] = self.flap_side if self.flap else "auto"
        left, right = side if isinstance(side, list) else (side, side)
        return None if left == "auto" else left, None if right == "auto" else right

    def middle_row(self, g: Curve) -> Row:
        """The middle row at lock, on g or beside it."""
        heading = in_radians(self.heading_deg)
        if self.row == "zigzag":
            return Row.of_zigzag(g, self.columns, heading, in_radians(self.row_angle_deg))
        return Row.of_chords(g, self.columns, heading, self.spacing, self.placement)

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell."""
        return forgiving(self, design_orthodiagonal, f, g)

    def design_on(self, surface: PiecedSurface, progress: Progress = no_progress) -> Design:
        """Design the shell over the cylinder that is nearest; its lines are square to f.

        Raises
        ------
        InputError
            If the table says the heading.
        """
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


@checked()
def design_orthodiagonal(f: Curve, g: Curve, pattern: OrthodiagonalPattern) -> Design:
    """Design a shell that sweeps f along g (the paper's section 3).

    Parameters
    ----------
    f, g
        The swept curve and the curve that it is swept along, in one unit of length. Both are run
        through in the direction of their x axes, whichever way they were drawn; at lock f's x axis
        lies to the right of g, seen along g, and f's y axis points up.
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

    Notes
    -----
    Six zigzags are tried, that begin to either side of f with end edges of three lengths. Of those
    that admit the heading the one is taken whose shell can be cut off level at f's ends, or at
    least straight, and of equals the one that allows g the widest stretch along f's plane. Flaps
    are cut off there, too.

    Examples
    --------
    >>> from orishell.curves import curve_from_formulas, parse_formula
    >>> f = curve_from_formulas(None, parse_formula("-x**2"), -1, 1)
    >>> g = curve_from_formulas(None, parse_formula("0.25*sin(pi*x/2)"), 0, 4)
    >>> pattern = OrthodiagonalPattern(rows=9, columns=13, depth=0.12)
    >>> design = design_orthodiagonal(f, g, pattern)
    >>> design.mechanism.positions(np.pi).shape
    (11, 15, 3)
    """
    f_trace = run_along_axis(trace_curve(f, "f").in_own_frame())
    middle = pattern.middle_row(g)
    g_trace, vertices, heading = middle.trace, middle.vertices, middle.heading
    zigzags = require_zigzags(f_trace, pattern.rows, pattern.depth)
    width = None if pattern.flap == "auto" else pattern.flap
    zigzag_row = pattern.row == "zigzag"
    demands = [headings_of(zigzag, vertices, width, pattern.sides()) for zigzag in zigzags]
    if heading == "auto":
        heading = choose_heading(demands)
    candidates = [
        (
            zigzag,
            headings,
            choose_flaps(EndPlanes.of(f_trace, zigzag), zigzag, headings, heading, width),
        )
        for zigzag, headings in zip(zigzags, demands, strict=True)
        if headings.admit(heading)
    ]
    if not candidates:
        raise refuse(f_trace, g_trace, zigzags, demands, heading, refitted=zigzag_row)
    zigzag, headings, flaps = largest_of(candidates, lambda each: each[2].footing)
    mechanism = Orthodiagonal(
        lengths=zigzag.lengths,
        angles=zigzag.angles,
        first=zigzag.first,
        tilt=tilt_of(zigzag),
        points=headings.points,
        heading=heading,
        flaps=(flaps.width, flaps.width),
        flap_sides=flaps.sides,
        trims=flaps.trims,
        kept=flaps.kept,
    )
    require_resolution(mechanism, smaller(pattern.rows, pattern.columns))

    closeness = {"f": measure_closeness(f_trace, zigzag.vertices), "g": middle.closeness}
    origin, axis = middle_vertex(zigzag), complex(np.exp(-1j * mechanism.heading))
    g_raised = raised(g_trace, mechanism.points[0], heading, mechanism.tilt)
    return Design(
        mechanism=mechanism,
        parameters={
            "depth": zigzag.depth,
            "zigzag_deg": [tidy_degrees(angle) for angle in zigzag.angles],
            **describe_heading(heading, zigzag, headings, demands, refitted=zigzag_row),
            "flap": mechanism.flaps[0],
            "flap_side": [str(side) for side in mechanism.flap_sides],
            "ends": [str(end) for end in flaps.ends],
            "tilt_deg": tidy_degrees(mechanism.tilt),
            **middle.parameters,
        },
        targets={"f": upright(f_trace, origin, mechanism.points[0], axis), "g": g_raised},
        closeness=closeness,
        swept=Surface(f_trace, origin, Sliding(Path.of(g_trace), axis, mechanism.tilt)),
        approached=approach(f_trace, origin, g_trace, axis),
        tilted=tilted(g_raised, mechanism.tilt),
        smaller_by=f"shallower folds, by a smaller depth (it is {plain(zigzag.depth, 3)}),",
        levelled_by="other rows, another depth or narrower flaps",
        origin=np.append(g_trace.origin, 0.0),
        warnings=(
            *warn_of_coarse_row(g_trace, closeness["g"].max, pattern.columns),
            *middle.warnings,
            *warn_of_no_lock(mechanism.flaps[0]),
        ),
    )


FAMILY = Family(
    name="orthodiagonal",
    pattern=OrthodiagonalPattern,
    label="Orthodiagonal",
    what="A wavy cylinder: f along g, in parallel planes",
    starter=FilePath(__file__).with_name("starter.toml"),
)
