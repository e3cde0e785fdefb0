"""The table [pattern] of the T-hedral family (not in the paper), and how it is listed."""

from __future__ import annotations

from pathlib import Path as FilePath
from typing import Annotated

import numpy as np

from orishell.conventions.arguments import checked
from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.table import Knob
from orishell.curves import Curve, Trace, run_along_axis, trace_curve
from orishell.design import (
    Design,
    FlapSide,
    Path,
    PiecedSurface,
    Surface,
    Turning,
    warn_of_no_lock,
)
from orishell.families.pattern import (
    FLAP_SIDE,
    PLACEMENT,
    ROWS,
    SPACING,
    Family,
    OddRowCount,
    Pattern,
    Width,
)
from orishell.families.shared.candidates import forgiving, smaller
from orishell.families.shared.row import Planes, Row
from orishell.families.shared.sheets import upright
from orishell.families.shared.sweep_fit import SweepLimits
from orishell.families.shared.sweeps import design_sweep
from orishell.families.t_hedral.mechanism import THedral
from orishell.motion import require_resolution
from orishell.numerics.arrays import Array
from orishell.polylines import (
    Placement,
    Spacing,
    measure_closeness,
    place_chords,
    warn_of_coarse_row,
)

SWEEPS = (SweepLimits("moulding", steepest=4.0), SweepLimits("cylinder", steepest=4.0))
"""What f along g can be: edges of columns are as steep as f is, which is no matter."""
FLATTEST = 1e-6
"""An edge that rises by less for each unit along f's axis is level, and ends the motion there."""


class THedralPattern(Pattern):
    """Parameters of the T-hedral family."""

    rows: Annotated[OddRowCount, ROWS]
    flap_side: Annotated[FlapSide, FLAP_SIDE] = "end"
    depth: Annotated[
        Width,
        Knob("Depth", "How far columns stand off g, left and right in turn", "length"),
    ] = 0.0
    plane: Annotated[
        Planes,
        Knob("Planes follow", "g's tangent, or the angles of its polyline", advanced=True),
    ] = "tangent"
    spacing: Annotated[Spacing, SPACING] = "curvature"
    placement: Annotated[Placement, PLACEMENT] = "inscribed"

    def column(self, f: Curve) -> tuple[Trace, Array]:
        """f as it is swept, and the vertices (m+2, 2) of column 1 on it."""
        trace = run_along_axis(trace_curve(f, "f").in_own_frame())
        return trace, place_chords(trace, self.rows + 2, self.spacing, "inscribed").vertices

    def distance_from_f(self, f: Curve) -> float:
        """Distance of column 1 from f."""
        trace, vertices = self.column(f)
        return measure_closeness(trace, vertices).max

    def distance_from_g(self, g: Curve) -> float:
        """Distance of the middle row from g."""
        row = self.row(g)
        return measure_closeness(row.trace, row.chords.vertices).max

    def row(self, g: Curve) -> Row:
        """The middle row, and the planes of the columns."""
        return Row.on(
            trace_curve(g, "g").in_own_frame(),
            self.columns,
            np.pi / 2,
            self.plane,
            spacing=self.spacing,
            placement=self.placement,
            depth=self.depth,
        )

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell."""
        return forgiving(self, design_t_hedral, f, g)

    def design_on(self, surface: PiecedSurface, progress: Progress = no_progress) -> Design:
        """Design the shell over the moulding surface, or the cylinder, that is nearest."""
        return design_sweep(surface, SWEEPS, lambda f, g, _: self.design(f, g))


@checked()
def design_t_hedral(f: Curve, g: Curve, pattern: THedralPattern) -> Design:
    """Design a shell whose columns have their vertices on f, and stand along g.

    Parameters
    ----------
    f, g
        The swept curve and the curve that it is swept along, in one unit of length. f is run
        through in the direction of its x axis; at lock this axis lies to the right of g, seen along
        g, and f's y axis points up.
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
    """
    f_trace, vertices = pattern.column(f)
    row = pattern.row(g)
    row.require_crossing(turnable=False)
    edges = np.diff(vertices, axis=0)
    _require_slopes(edges, pattern)
    slopes = edges[:, 1] / edges[:, 0]
    lengths = np.hypot(*edges.T)
    width = float(lengths.mean()) if pattern.flap == "auto" else pattern.flap
    mechanism = THedral(
        lengths=lengths,
        slopes=slopes,
        points=row.chords.vertices @ np.array([1, 1j]),
        axes=np.exp(1j * (row.heading - row.plane)),
        flaps=(0.0, 0.0),
        flap_sides=(pattern.flap_side, pattern.flap_side),
    ).with_flaps(width)
    require_resolution(mechanism.without_flaps(), smaller(pattern.rows, pattern.columns))
    g_trace, scales = row.trace, mechanism.column_scales()
    middle = vertices[len(vertices) // 2]
    closeness = {
        "f": measure_closeness(f_trace, vertices),
        "g": measure_closeness(g_trace, row.chords.vertices),
    }
    return Design(
        mechanism=mechanism,
        parameters={
            "column_scale": [float(scales.min()), float(scales.max())],
            "flap": width,
            "flap_side": [str(pattern.flap_side)] * 2,
            "depth": pattern.depth,
            "plane": pattern.plane,
            "plane_off_deg": tidy_degrees(row.off),
            "spacing": pattern.spacing,
            "placement": pattern.placement,
        },
        targets={
            "f": upright(f_trace, middle, mechanism.points[0], mechanism.axes[0]),
            "g": np.concatenate([g_trace.points, np.zeros((len(g_trace.points), 1))], axis=-1),
        },
        closeness=closeness,
        swept=Surface(f_trace, middle, Turning(Path.of(g_trace), np.pi / 2)),
        origin=np.append(g_trace.origin, 0.0),
        warnings=(
            *warn_of_coarse_row(g_trace, closeness["g"].max, pattern.columns),
            *warn_of_no_lock(width),
        ),
    )


def _require_slopes(edges: Array, pattern: THedralPattern) -> None:
    """Refuse edges that go back along f's axis, or are level: there the motion turns back."""
    ways = edges / np.hypot(*edges.T)[:, None]
    if ways[:, 0].min() <= FLATTEST:
        raise DesignError(
            "f goes back along its axis, or straight up: edges of a column have to go on",
            place=f"at edge {int(ways[:, 0].argmin())} of column 1",
            excess=float(FLATTEST - ways[:, 0].min()),
        )
    level = int(np.abs(ways[:, 1]).argmin())
    if abs(ways[level, 1]) <= FLATTEST:
        more = (2, -2, 4, -4)
        raise DesignError(
            "an edge of column 1 is level at the target, so that the motion turns back there",
            place=f"at edge {level} of column 1, of {len(edges)}",
            candidates=(Remedy({"pattern.rows": max(pattern.rows + k, 1)}) for k in more),
        )


FAMILY = Family(
    name="t-hedral",
    pattern=THedralPattern,
    label="T-hedral",
    what="Vertices on f, along any g; made in strips",
    starter=FilePath(__file__).with_name("starter.toml"),
    in_strips=True,
)
