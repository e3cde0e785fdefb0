"""Flaps that would reach beyond the ends of f: cut off where the columns end, if they still lock.

At lock a flap lies in the plane of its column, moved along the bisectors of the column's zigzag.
Towards the end of f to which it folds these run outwards, below the feet of an arch. A corner that
is moved back along its row crease stays in its panels' planes, so a cut changes nothing in the
motion but the flap's outline.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any, Literal

import numpy as np
from pydantic_core import PydanticCustomError

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.record import record
from orishell.curves import Curve, Trace, remembered, run_along_axis, trace_curve
from orishell.design import Parameter
from orishell.families.orthodiagonal.mechanism import Orthodiagonal
from orishell.families.pattern import Auto
from orishell.families.shared.staircases import Followed
from orishell.numerics.arrays import Array, Complex
from orishell.polylines import (
    Closeness,
    Placement,
    Spacing,
    measure_chords,
    measure_closeness,
    place_chords,
    xi_limit,
)

SMALLEST_KEPT = 0.1
"""A cut flap keeps this share of every row crease: panels that meet along less lock nothing."""
SHORTEST = 0.2
"""Its end edges keep this share of the column's."""
KEPT = 32
"""Mechanisms whose flaps are remembered: each is asked about several times."""
BEYOND = 1e-9
"""Flaps that reach below the feet by less than this share of the height count as level."""


def cut_flaps(mechanism: Orthodiagonal, planes: Sequence[complex | None]) -> Orthodiagonal | None:
    """The sheet with its flaps cut where its columns end; None if too little of them is left.

    planes: For both ends of f the normal of the plane in which columns end, or None.
    """
    kept = np.ones((2, mechanism.grid.rows))
    for flap, column, whole in _in_plane(mechanism):
        for end, normal in zip((0, -1), planes, strict=True):
            if normal is None:
                continue
            share = _share(column, whole, normal, end)
            if share is None:
                return None
            kept[flap] = np.minimum(kept[flap], share)
    return replace(mechanism, kept=kept) if (kept < 1).any() else mechanism


def depth_below_feet(mechanism: Orthodiagonal) -> float:
    """How far the flaps reach below the first and the last column at lock (length)."""
    if not any(mechanism.flaps):
        return 0.0
    height = _ends(mechanism)[..., 2]
    inner = height[:, 1:-1]
    below = float(inner.min() - height.min())
    return below if below > BEYOND * np.ptp(inner) else 0.0


@lru_cache(KEPT)
def _ends(mechanism: Orthodiagonal) -> Array:
    """Vertices (m+2, 4, 3) of the first and the last column and their flaps at lock."""
    sheet = replace(mechanism, points=mechanism.points[[0, -1]])
    return sheet.positions(sheet.target_drive)


def _in_plane(mechanism: Orthodiagonal) -> list[tuple[int, Complex, Complex]]:
    """Every flap's number, and the vertices (m+2,) in f's plane of its column and of its edge."""
    t = np.exp(-1j * mechanism.heading)
    locked = _ends(mechanism)
    across = ((locked[..., 0] + 1j * locked[..., 1]) * t.conjugate()).real
    plane = across + 1j * locked[..., 2]
    return [
        (flap, plane[:, near], plane[:, edge])
        for flap, (near, edge) in enumerate(((1, 0), (-2, -1)))
        if mechanism.flaps[flap]
    ]


def _share(column: Complex, whole: Complex, normal: complex, end: int) -> Array | None:
    """Shares (m+2,) of its width that a flap cut by a plane keeps at every row; None if too small.

    The plane goes through the column's vertex ``end`` (0 or -1).
    """
    rows = len(column)
    side = np.arange(rows) < rows // 2 if end == 0 else np.arange(rows) > rows // 2
    beside = 1 if end == 0 else -2
    inwards = ((column[rows // 2] - column[end]) * normal.conjugate()).real
    normal = -normal / abs(normal) * np.sign(inwards)  # outwards
    room = ((column[end] - column) * normal.conjugate()).real
    reach = ((whole - column) * normal.conjugate()).real
    inner = side.copy()
    inner[end] = False
    beyond = inner & (reach > room)
    share = np.ones(rows)
    if (room[beyond] <= 0).any():
        return None
    share[beyond] = room[beyond] / reach[beyond]
    # The end's own corner lies in the plane; beside a crease that ends there, half as far out.
    if beyond[beside]:
        share[end] = 0.5 * share[beside]
        return share if (share[beyond] >= SMALLEST_KEPT).all() else None
    edge = (whole[end] - whole[beside]) / (column[end] - column[beside])
    return share if edge.real >= SHORTEST and (share[inner] >= SMALLEST_KEPT).all() else None


RowKind = Literal["chords", "zigzag"]
FEWEST = 3
"""Columns of a zigzag: it has a corner."""
MORE = (3, 5, 9)
"""Numbers of columns tried where there are fewer."""
MARGIN = 0.1
"""How far "auto" keeps from headings at which g has no zigzag, relative to their interval."""
SQUARE = np.pi / 2
"""The heading at which g is not turned before its zigzag is sought (radians)."""
G = Followed(
    name="g",
    xi="row_angle_deg",
    theta="heading_deg",
    unturned=SQUARE,
    farthest=SQUARE,
    axis="the normal of f's plane",
    instead=Remedy({"pattern.row": "chords", "pattern.row_angle_deg": "auto"}),
)


@record
class Row:
    """The middle row at lock."""

    trace: Trace  # g, run through along its x axis
    vertices: Array  # vertices (n, 2) of g's polyline
    closeness: Closeness  # the polyline's distance from g
    heading: float | Auto  # from f's plane to g's x axis; "auto" where the row leaves it open
    parameters: Mapping[str, Parameter]  # what the report says of it
    warnings: tuple[str, ...] = ()

    @classmethod
    def of_chords(
        cls, g: Curve, columns: int, heading: float | Auto, spacing: Spacing, placement: Placement
    ) -> Row:
        """The row whose edges are chords of g, or nearly."""
        trace = _traced(g)
        chords = place_chords(trace, columns, spacing, placement)
        found: dict[str, Parameter] = {"spacing": spacing, "placement": placement}
        return cls(trace, chords.vertices, measure_chords(trace, chords), heading, found)

    @classmethod
    def of_zigzag(cls, g: Curve, columns: int, heading: float | Auto, angle: float | Auto) -> Row:
        """The row whose edges lie alternately at one angle to either side of f's normal.

        It is the staircase of g, turned so that the normal of f's plane is the x axis. The heading
        "auto" brings that normal as near to g's chord from end to end as the zigzag allows.
        """
        if columns < FEWEST:
            raise DesignError(
                f'row = "zigzag" needs a corner, so at least {FEWEST} columns',
                keys=("pattern.columns",),
                size=f"there are {columns}",
                candidates=(Remedy({"pattern.columns": count}) for count in MORE),
                excess=1 - columns / FEWEST,
            )
        return _fit(g, columns, heading, angle)


@remembered
def _fit(g: Curve, columns: int, heading: float | Auto, angle: float | Auto) -> Row:
    trace, edges = _traced(g), columns - 1
    xi = None if angle == "auto" else angle
    theta = _along_the_chord(trace, xi) if heading == "auto" else heading - SQUARE
    turned = trace.rotated(theta)
    staircase = G.fit(turned, theta, xi, edges)
    cos, sin = np.cos(theta), np.sin(theta)
    vertices = staircase.vertices @ np.array([[cos, -sin], [sin, cos]])
    turns = G.interval(*trace.heading_range(), staircase.xi)
    found: dict[str, Parameter] = {
        "row": "zigzag",
        "row_angle_deg": tidy_degrees(staircase.xi),
        "row_angle_limit_deg": tidy_degrees(xi_limit(*turned.heading_range())),
        "row_heading_interval_deg": [tidy_degrees(SQUARE + turn) for turn in turns],
    }
    closeness = measure_closeness(trace, vertices)
    return Row(trace, vertices, closeness, SQUARE + theta, found, G.warn_of_imbalance(staircase))


def _along_the_chord(trace: Trace, xi: float | None) -> float:
    """The rotation that brings g's chord from end to end nearest to the zigzag's axis (radians).

    Rows then shift the least along f.
    """
    begin, end = G.turns(trace, xi)
    margin = MARGIN * (end - begin)
    along, across = trace.points[-1] - trace.points[0]
    return float(np.clip(-np.arctan2(across, along), begin + margin, end - margin))


def _traced(g: Curve) -> Trace:
    return run_along_axis(trace_curve(g, "g").in_own_frame())


def require_one_kind(angle: str) -> Callable[[Any], None]:
    """The rule that a row has only what its kind has: chords no angle, a zigzag no spacing.

    angle: Name of the zigzag's angle: a key of the table [pattern], or an argument.
    """

    def rule(asked: Any) -> None:
        other = "zigzag" if asked.row == "chords" else "chords"
        usual = {"spacing": "curvature", "placement": "inscribed"}
        for key, value in ({angle: "auto"} if other == "zigzag" else usual).items():
            got = getattr(asked, key)
            if got != value:
                raise PydanticCustomError(
                    "other_row",
                    "'{value}', or row = \"{other}\"",
                    {"value": value, "other": other, "key": key, "got": got},
                )

    return rule
