"""From two curves to a mechanism of the parallel repeating type, or to the reason why not."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any, Final

import numpy as np
from pydantic_core import PydanticCustomError

from orishell.conventions.arguments import checked
from orishell.conventions.formatting import in_degrees, tidy_degrees
from orishell.conventions.table import Number
from orishell.curves import Curve, trace_curve
from orishell.design import Design, Parameter, Path, Surface, Turning, warn_of_no_lock
from orishell.families.parallel_repeating.mechanism import ParallelRepeating
from orishell.families.parallel_repeating.profile import (
    F,
    Planes,
    Row,
    approach,
    fit_profile,
)
from orishell.families.parallel_repeating.sheet import (
    require_flap_resolution,
    require_flat_sheet,
    require_row_edges,
    warn_of_stretched_columns,
)
from orishell.families.pattern import (
    Auto,
    ColumnCount,
    FlapSides,
    Limits,
    OddRowCount,
    Width,
    in_radians,
)
from orishell.families.shared.candidates import smaller
from orishell.families.shared.sheets import middle_vertex, upright
from orishell.motion import require_resolution
from orishell.polylines import (
    Placement,
    Spacing,
    fit_staircase,
    measure_chords,
    theta_interval,
    warn_of_coarse_row,
    xi_limit,
)

XI: Final[Limits] = {"ge": 0.1, "le": 179.9}
THETA: Final[Limits] = {"ge": -360, "le": 360}
PLANE: Final[Limits] = {"gt": 0, "lt": 180}
"""Limits of the angles (degrees)."""
WIDEST_XI = 0.95
"""Above this share of its limit a wider xi_deg gains next to nothing."""
Xi = Annotated[Number, in_radians(XI)]
Theta = Annotated[Number, in_radians(THETA)]
Plane = Annotated[Number, in_radians(PLANE)]


def require_square(planes: str, plane: str, right: float) -> Callable[[Any], None]:
    """The rule that planes which bisect the polyline's angles are not oblique as well.

    planes, plane: Names of the two: keys of the table [pattern], or arguments.
    """

    def rule(asked: Any) -> None:
        angle = getattr(asked, plane)
        if getattr(asked, planes) == "bisector" and angle != right:
            raise PydanticCustomError(
                "oblique",
                '{right} beside {planes} = "bisector"',
                {"right": f"{right:g}", "planes": planes, "key": plane, "got": angle},
            )

    return rule


@checked(require_square("planes", "plane", np.pi / 2))
def design_parallel_repeating(
    f: Curve,
    g: Curve,
    *,
    rows: OddRowCount,
    columns: ColumnCount,
    flap: Width | Auto = "auto",
    xi: Xi | Auto = "auto",
    theta: Theta | Auto = 0.0,
    plane: Plane = np.pi / 2,
    planes: Planes = "tangent",
    flap_sides: FlapSides = ("end", "end"),
    spacing: Spacing = "curvature",
    placement: Placement = "inscribed",
) -> Design:
    """Design a shell that sweeps f along g (the paper's section 2).

    Parameters
    ----------
    f, g
        The swept curve and the curve that it is swept along, in one unit of length. f is run
        through in the direction of its (rotated) x axis; at lock this axis lies to the right of
        g, seen along g, and f's y axis points up.
    rows, columns
        Inner vertices: rows m, odd; columns n, at least 2.
    flap
        Width of the flaps in the flat sheet, square to their column; "auto" takes the mean length
        of column 1's creases, 0 leaves them out: then nothing locks the shell.
    xi
        Angle between adjacent creases of column 1 at lock (radians), or "auto".
    theta
        Rotation of f in its plane, counter-clockwise (radians), or "auto".
    plane
        Angle from f's plane to g's tangent, in (0, pi) (radians).
    planes
        "tangent": all columns stand at that angle. "bisector": the planes of columns 2 ... n-1
        bisect the angles of g's polyline, so that the crease pattern is flat-foldable: without
        flaps all row creases close at once. Columns 1 and n stay square to g.
    flap_sides
        End of f to which the left and the right flap fold.
    spacing
        How g's vertices are spread along g.
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

    Examples
    --------
    >>> from orishell.curves import curve_from_formulas, parse_formula
    >>> f = curve_from_formulas(None, parse_formula("-x**2"), -1, 1)
    >>> g = curve_from_formulas(None, parse_formula("5*sin(pi*x/10)"), 0, 20)
    >>> design = design_parallel_repeating(f, g, rows=9, columns=11, xi=np.deg2rad(50))
    >>> design.mechanism.positions(np.pi).shape
    (11, 13, 3)
    """
    profile = fit_profile(f, rows + 1, xi, theta)
    f_trace, theta = profile.trace, profile.theta
    staircase, xi = profile.staircase, profile.staircase.xi

    g_trace = trace_curve(g, "g").in_own_frame()
    row = Row.on(g_trace, columns, plane, planes, spacing=spacing, placement=placement)
    row.require_crossing()
    width = float(staircase.lengths.mean()) if flap == "auto" else flap
    mechanism = ParallelRepeating(
        xi=xi,
        lengths=staircase.lengths,
        first=staircase.first,
        points=row.chords.vertices @ np.array([1, 1j]),
        axes=np.exp(1j * (row.heading - row.plane)),
        flaps=(0.0, 0.0),
        flap_sides=(flap_sides[0], flap_sides[1]),
    ).with_flaps(width)
    require_row_edges(mechanism, f, g)
    require_flap_resolution(mechanism, width)
    require_resolution(mechanism.without_flaps(), smaller(rows, columns))
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
    bisecting: dict[str, Parameter] = {"plane": planes, "plane_off_deg": tidy_degrees(row.off)}
    origin = middle_vertex(staircase)
    return Design(
        mechanism=mechanism,
        parameters={
            "xi_deg": tidy_degrees(xi),
            "xi_limit_deg": tidy_degrees(xi_limit(low, high)),
            "theta_deg": tidy_degrees(theta),
            "theta_interval_deg": [tidy_degrees(angle) for angle in interval],
            "plane_deg": tidy_degrees(plane),
            **(bisecting if planes == "bisector" else {}),
            "column_scale": [float(scales.min()), float(scales.max())],
            "flap": width,
            "flap_side": [str(side) for side in flap_sides],
            "spacing": spacing,
            "placement": placement,
        },
        targets={
            "f": upright(f_trace, origin, mechanism.points[0], mechanism.axes[0]),
            "g": np.concatenate([g_trace.points, np.zeros((len(g_trace.points), 1))], axis=-1),
        },
        closeness=closeness,
        swept=Surface(f_trace, origin, Turning(Path.of(g_trace), plane)),
        approached=approach(f_trace, origin, g_trace, plane),
        tilted=f"f is turned in its plane by {in_degrees(theta)} degrees" if theta else "",
        smaller_by=_smaller(tidy_degrees(xi), tidy_degrees(xi_limit(low, high))),
        origin=np.append(g_trace.origin, 0.0),
        warnings=(
            *warn_of_coarse_row(g_trace, closeness["g"].max, columns),
            *warn_of_stretched_columns(mechanism, plane),
            *F.warn_of_imbalance(staircase),
            *warn_of_no_lock(width),
        ),
    )


def _smaller(xi: float, limit: float) -> str:
    """What would make the flat sheet smaller; both angles in degrees."""
    if xi < WIDEST_XI * limit:
        return f"shallower folds, by a wider xi_deg ({xi:.4g} now, possible below {limit:.4g}),"
    return f"an f with less steep ends (they keep xi_deg below {limit:.4g})"
