"""The curves f and g: the swept profile, the middle row and the planes of the columns."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Literal

import numpy as np

from orishell.conventions.errors import Remedy
from orishell.conventions.formatting import in_degrees, rounded, tidy_degrees
from orishell.conventions.record import record
from orishell.curves import Curve, Trace, remembered, run_along_axis, trace_curve
from orishell.design import Approached, Path, Surface, Turning
from orishell.families.pattern import Auto
from orishell.families.shared.candidates import angles, does_not_cross
from orishell.families.shared.staircases import Followed
from orishell.motion.lattice import InnerStaircase
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import bisect_integers
from orishell.numerics.equals import first_largest
from orishell.polylines import (
    Chords,
    Closeness,
    Placement,
    Spacing,
    Staircase,
    choose_theta,
    measure_closeness,
    place_chords,
    widest_angle,
)

ORTHODIAGONAL = Remedy(
    {
        "shell.family": "orthodiagonal",
        **{f"pattern.{key}": None for key in ("xi_deg", "theta_deg", "plane_deg", "plane")},
    }
)
"""The family that takes an f of walls near vertical, or beyond."""
F = Followed(
    name="f",
    xi="xi_deg",
    theta="theta_deg",
    unturned=0.0,
    farthest=np.inf,
    axis="the axis",
    instead=ORTHODIAGONAL,
)
INNER = replace(F, name="inner", instead=Remedy({"target.inner": None}))
"""That of a second skin."""


@record
class Profile:
    """f as it is swept, and the staircase that takes its place."""

    trace: Trace  # f, rotated and run through along its x axis
    theta: float  # Its rotation (radians)
    staircase: Staircase  # Column 1 at lock
    closeness: Closeness  # The staircase's distance from f


@remembered
def fit_profile(f: Curve, edges: int, xi: float | Auto, theta: float | Auto) -> Profile:
    """Rotate f and fit its staircase; refuse an f that has none of this angle."""
    angle = None if xi == "auto" else xi
    trace = run_along_axis(trace_curve(f, "f").in_own_frame(), 0.0 if theta == "auto" else theta)
    if theta == "auto":
        F.turns(trace, angle)
        theta = choose_theta(trace, edges, angle)
    trace = trace.rotated(theta)
    staircase = F.fit(trace, theta, angle, edges)
    return Profile(trace, theta, staircase, measure_closeness(trace, staircase.vertices))


def inner_staircase(profile: Profile, inner: Curve) -> InnerStaircase:
    """A staircase of the same angle and directions along another curve, drawn where f was.

    Its edges are about as long as those of column 1, in pairs that rise and fall.
    """
    trace = trace_curve(inner, "inner").in_own_frame()
    trace = run_along_axis(trace, profile.theta).rotated(profile.theta)
    outer = profile.staircase
    pairs = max(1, round(0.5 * trace.length / profile.trace.length * len(outer.lengths)))
    found = INNER.fit(trace, profile.theta, outer.xi, 2 * pairs)
    begin = found.vertices[0] + trace.origin - profile.trace.origin - outer.vertices[0]
    rising = np.arange(2 * pairs) % 2 == (0 if found.first > 0 else 1)
    x, y = begin / np.array([np.sin(outer.xi / 2), np.cos(outer.xi / 2)])
    steps = found.lengths[:, None] * np.stack([rising, ~rising], axis=-1)
    first = 0.5 * np.array([[x + y, x - y]])
    return InnerStaircase(np.cumsum(np.concatenate([first, steps]), axis=0), found.distance)


def widest_xi(f: Curve, theta: float | Auto) -> float:
    """The widest angle xi that f admits, rotated by theta or as is best for it (radians)."""
    trace = run_along_axis(trace_curve(f, "f").in_own_frame(), 0.0 if theta == "auto" else theta)
    low, high = trace.heading_range()
    turned = 0.5 * (low + high) if theta == "auto" else -theta
    return widest_angle(low - turned, high - turned)


STRETCHED = 1e-9
"""A stretch that differs from 1 by less than this counts as none."""


def approach(f: Trace, origin: Array, g: Trace, plane: float) -> Approached | None:
    """What finer shells approach where ``plane`` is no right angle: f stretched along its plane.

    None where that is f swept rigidly, or where g has corners that f's plane does not cross.
    """
    path = Path.of(g)
    if plane == np.pi / 2 or np.abs(path.corner_turns()).max(initial=0) / 2 >= min(
        plane, np.pi - plane
    ):
        return None
    rail = Turning(path, plane, affine=True)
    low, high = rail.scale_range()
    if max(abs(low - 1), abs(high - 1)) < STRETCHED:
        return None
    return Approached(
        "f's plane is not square to g, so f is not swept rigidly but stretched along its plane, "
        f"to between {low:.4g} and {high:.4g} of its width",
        Surface(f, origin, rail),
    )


Planes = Literal["tangent", "bisector"]
"""What the planes of columns 2 ... n-1 follow: g's tangent, or the angle of its polyline."""

MORE_COLUMNS = (1.25, 1.6, 2.5)
"""Shares of the fewest columns that are enough, where these are not."""


@record
class Row:
    """The middle row on g's polyline."""

    chords: Chords  # g's polyline
    # directions (n,) that the planes follow at the vertices (radians): g's own, or those that
    # bisect the angles of its polyline, but for its ends
    heading: Array
    plane: float  # angle from f's plane to these (radians)
    planes: Planes  # which of the two
    off: float  # the largest angle between these and g's own (radians)
    # how g's vertices were placed
    trace: Trace
    spacing: Spacing
    placement: Placement

    @classmethod
    def on(
        cls,
        trace: Trace,
        columns: int,
        plane: float,
        planes: Planes,
        *,
        spacing: Spacing,
        placement: Placement,
    ) -> Row:
        """Place the vertices along g."""
        chords = place_chords(trace, columns, spacing, placement)
        heading = trace.heading_at(chords.parameters)
        off = np.zeros(len(heading))
        if planes == "bisector":
            edge = np.diff(chords.vertices @ np.array([1, 1j]))
            turn = np.angle(edge[1:] * edge[:-1].conj())
            off[1:-1] = _wrapped(np.angle(edge[:-1]) + turn / 2 - heading[1:-1])
        most = float(np.abs(off).max())
        return cls(chords, heading + off, plane, planes, most, trace, spacing, placement)

    def turns(self) -> Array:
        """Angles (2, n-1) of every chord from g's direction at its first and its last vertex."""
        chord = np.diff(self.chords.vertices, axis=0)
        direction = np.arctan2(chord[:, 1], chord[:, 0])
        return _wrapped(direction - np.stack([self.heading[:-1], self.heading[1:]]))

    def require_crossing(self) -> None:
        """Refuse chords that do not run from one column plane to the next (0 < delta < pi)."""
        delta = self.turns() + self.plane
        outside = np.maximum(-delta, delta - np.pi)
        worst = np.unravel_index(first_largest(outside, size=np.pi), outside.shape)
        if outside[worst] < 0:
            return
        low, high = _planes_that_cross(self.turns())
        turnable = self.planes == "tangent" and low < high
        limits = (
            f"; plane_deg must lie between {in_degrees(low)} and {in_degrees(high)}"
            if turnable
            else "; no plane_deg fits all columns"
        )
        raise does_not_cross(
            int(worst[1]),
            delta[worst],
            limits if self.planes == "tangent" else "",
            angles("plane_deg", low, high, self.plane) if turnable else self._enough_columns(),
        )

    def _enough_columns(self) -> Iterator[Remedy]:
        count = len(self.heading)

        def turns(columns: int, spacing: Spacing = self.spacing) -> Array:
            how = self.placement
            return Row.on(
                self.trace, columns, self.plane, self.planes, spacing=spacing, placement=how
            ).turns()

        def works(columns: int, spacing: Spacing = self.spacing) -> bool:
            delta = turns(columns, spacing) + self.plane
            return bool((delta > 0).all() and (delta < np.pi).all())

        # Powers of two, so that refusals of one g try the same numbers and find them remembered.
        columns = 2 ** count.bit_length()
        for _ in range(8):
            if works(columns):
                fewest = bisect_integers(works, columns, columns // 2)
                if fewest > count:
                    # More columns than are just enough leave more room for the panels.
                    for enough in (fewest, *(math.ceil(more * fewest) for more in MORE_COLUMNS)):
                        yield Remedy({"pattern.columns": enough})
                    return
            columns *= 2
        columns //= 2
        for more in (count, columns):
            if self.spacing == "equal" and works(more, "curvature"):
                yield Remedy({"pattern.spacing": "curvature", "pattern.columns": more})
        if self.planes == "bisector":
            return
        least, most = _planes_that_cross(turns(columns))
        if least < most:
            plane = rounded(tidy_degrees(0.5 * (least + most)), 6)
            yield Remedy({"pattern.plane_deg": plane, "pattern.columns": columns})


def _planes_that_cross(turns: Array) -> tuple[float, float]:
    """The interval of the angle ``plane`` in which f's plane crosses chords of these turns."""
    return float((-turns).max()), float(np.pi - turns.max())


def _wrapped(angle: Array) -> Array:
    return np.asarray(np.mod(angle + np.pi, 2 * np.pi) - np.pi)
