"""From two curves to a mechanism of the orthodiagonal type, or to the reason why not."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Final

import numpy as np
from pydantic import Field

from orishell.conventions.arguments import checked
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.quantities import plain
from orishell.conventions.table import Number
from orishell.curves import Curve, Trace, run_along_axis, trace_curve
from orishell.design import Design, FlapSide, Path, Sliding, Surface, warn_of_no_lock
from orishell.families.orthodiagonal.flaps import choose_flaps
from orishell.families.orthodiagonal.headings import (
    HeadingConditions,
    SideChoice,
    describe_heading,
)
from orishell.families.orthodiagonal.mechanism import Orthodiagonal
from orishell.families.orthodiagonal.profile import (
    EndPlanes,
    approach,
    require_zigzags,
    tilted,
)
from orishell.families.orthodiagonal.refusal import refuse
from orishell.families.orthodiagonal.row import (
    Row,
    RowKind,
    require_one_kind,
)
from orishell.families.pattern import (
    Auto,
    ColumnCount,
    Length,
    Limits,
    OddRowCount,
    Width,
    in_radians,
)
from orishell.families.shared.candidates import smaller
from orishell.families.shared.sheets import middle_vertex, upright
from orishell.motion import require_resolution
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_largest, largest_of
from orishell.polylines import (
    Placement,
    Spacing,
    Zigzag,
    measure_closeness,
    warn_of_coarse_row,
)

HEADING: Final[Limits] = {"ge": 0, "le": 180}
ROW_ANGLE: Final[Limits] = {"ge": 0.1, "le": 179.9}
"""Limits of the angles (degrees)."""
Heading = Annotated[Number, in_radians(HEADING)]
RowAngle = Annotated[Number, in_radians(ROW_ANGLE)]
ChosenSides = Annotated[Sequence[FlapSide | Auto], Field(min_length=2, max_length=2)]
"""Where the left and the right flap fold to, chosen if "auto"."""

LEVEL = 1e-12
"""A middle row that rises by less than this is level (radians)."""


@checked(require_one_kind("row_angle"))
def design_orthodiagonal(
    f: Curve,
    g: Curve,
    *,
    rows: OddRowCount,
    columns: ColumnCount,
    depth: Length | Auto = "auto",
    heading: Heading | Auto = np.pi / 2,
    row: RowKind = "chords",
    row_angle: RowAngle | Auto = "auto",
    flap: Width | Auto = "auto",
    flap_sides: ChosenSides = ("auto", "auto"),
    spacing: Spacing = "curvature",
    placement: Placement = "inscribed",
) -> Design:
    """Design a shell that sweeps f along g (the paper's section 3).

    Parameters
    ----------
    f, g
        The swept curve and the curve that it is swept along, in one unit of length. Both are run
        through in the direction of their x axes, whichever way they were drawn; at lock f's x axis
        lies to the right of g, seen along g, and f's y axis points up.
    rows, columns
        Inner vertices: rows m, odd; columns n, at least 2.
    depth
        Distance h of column 1's inner vertices from f, alternately on both sides; "auto" makes
        their mean angle 90 degrees, or takes 0.9 of f's smallest radius of curvature if less.
    heading
        Angle from f's plane to g's x axis, in [0, pi] (radians); "auto" takes a right angle if
        that is admissible, otherwise the middle of the widest admissible interval; with a zigzag
        row it makes f's plane square to g's chord from end to end, or nearly.
    row
        "chords": the middle row's edges are chords of g. "zigzag": they lie alternately at one
        angle to either side of the normal of f's plane, so that the crease pattern is
        flat-foldable: without flaps all row creases close at once. It needs 3 columns.
    row_angle
        Angle between adjacent edges of a zigzag row (radians); "auto" takes the widest that g
        admits, at most 150 degrees, whose shortest edge keeps a quarter of the mean.
    flap
        Width of the flaps in the flat sheet; "auto" takes the mean length of column 1's creases,
        or half of what there is room for if that is less. 0 leaves them out: then nothing locks the
        shell.
    flap_sides
        End of f to which the left and the right flap fold; "auto" is where there is more room,
        unless they would reach below the feet there and not at the other end.
    spacing
        How the vertices of chords are spread along g.
    placement
        Whether they lie on g or as far beyond it as the edges stay behind.

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
    >>> design = design_orthodiagonal(f, g, rows=9, columns=13, depth=0.12)
    >>> design.mechanism.positions(np.pi).shape
    (11, 15, 3)
    """
    f_trace = run_along_axis(trace_curve(f, "f").in_own_frame())
    middle = (
        Row.of_chords(g, columns, heading, spacing, placement)
        if row == "chords"
        else Row.of_zigzag(g, columns, heading, row_angle)
    )
    g_trace, vertices, heading = middle.trace, middle.vertices, middle.heading
    zigzags = require_zigzags(f_trace, rows, depth)
    left, right = (None if side == "auto" else side for side in flap_sides)
    width = None if flap == "auto" else flap
    demands = [headings_of(zigzag, vertices, width, (left, right)) for zigzag in zigzags]
    if heading == "auto":
        heading = _choose_heading(demands)
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
        raise refuse(f_trace, g_trace, zigzags, demands, heading, refitted=row == "zigzag")
    zigzag, headings, flaps = largest_of(candidates, lambda each: each[2].footing)
    mechanism = Orthodiagonal(
        lengths=zigzag.lengths,
        angles=zigzag.angles,
        first=zigzag.first,
        tilt=0.0 if abs(zigzag.axis) < LEVEL else zigzag.axis,
        points=headings.points,
        heading=heading,
        flaps=(flaps.width, flaps.width),
        flap_sides=flaps.sides,
        trims=flaps.trims,
        kept=flaps.kept,
    )
    require_resolution(mechanism, smaller(rows, columns))

    closeness = {"f": measure_closeness(f_trace, zigzag.vertices), "g": middle.closeness}
    origin, axis = middle_vertex(zigzag), complex(np.exp(-1j * mechanism.heading))
    raised = _tilt(g_trace, mechanism)
    return Design(
        mechanism=mechanism,
        parameters={
            "depth": zigzag.depth,
            "zigzag_deg": [tidy_degrees(angle) for angle in zigzag.angles],
            **describe_heading(heading, zigzag, headings, demands, refitted=row == "zigzag"),
            "flap": mechanism.flaps[0],
            "flap_side": [str(side) for side in mechanism.flap_sides],
            "ends": [str(end) for end in flaps.ends],
            "tilt_deg": tidy_degrees(mechanism.tilt),
            **middle.parameters,
        },
        targets={"f": upright(f_trace, origin, mechanism.points[0], axis), "g": raised},
        closeness=closeness,
        swept=Surface(f_trace, origin, Sliding(Path.of(g_trace), axis, mechanism.tilt)),
        approached=approach(f_trace, origin, g_trace, axis),
        tilted=tilted(raised, mechanism.tilt),
        smaller_by=f"shallower folds, by a smaller depth (it is {plain(zigzag.depth, 3)}),",
        levelled_by="other rows, another depth or narrower flaps",
        origin=np.append(g_trace.origin, 0.0),
        warnings=(
            *warn_of_coarse_row(g_trace, closeness["g"].max, columns),
            *middle.warnings,
            *warn_of_no_lock(mechanism.flaps[0]),
        ),
    )


def headings_of(
    zigzag: Zigzag,
    vertices: Array,
    flap: float | None = None,
    sides: tuple[SideChoice, SideChoice] = (None, None),
) -> HeadingConditions:
    """The conditions on the heading that a zigzag and g's polyline (n, 2) set."""
    points = vertices @ np.array([1, 1j])
    return HeadingConditions(points, 1.0, (-np.inf, np.inf), flap, sides).of(zigzag)


def _choose_heading(demands: Sequence[HeadingConditions]) -> float:
    """A right angle if it is admissible, else the middle of the widest admissible interval."""
    right = float(np.pi / 2)
    intervals = np.concatenate([headings.intervals() for headings in demands])
    if not len(intervals) or any(headings.admit(right) for headings in demands):
        return right
    return float(intervals[first_largest(np.diff(intervals)[:, 0])].mean())


def _tilt(g: Trace, mechanism: Orthodiagonal) -> Array:
    """g (N, 3) in the plane of the middle row."""
    t = np.exp(-1j * mechanism.heading)
    points = g.points @ np.array([1, 1j])
    along = ((points - mechanism.points[0]) * t.conj()).real
    plan = points + (np.cos(mechanism.tilt) - 1) * along * t
    return np.stack([plan.real, plan.imag, np.sin(mechanism.tilt) * along], axis=-1)
