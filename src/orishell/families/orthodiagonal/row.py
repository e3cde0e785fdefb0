"""The middle row at lock: chords of g, or a zigzag about the normal of f's plane."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.record import record
from orishell.curves import Curve, Trace, remembered, run_along_axis, trace_curve
from orishell.design import Parameter
from orishell.families.pattern import Auto
from orishell.families.shared.staircases import Followed
from orishell.numerics.arrays import Array
from orishell.polylines import (
    Closeness,
    Placement,
    Spacing,
    measure_chords,
    measure_closeness,
    place_chords,
    xi_limit,
)

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
