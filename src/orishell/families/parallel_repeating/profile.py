"""The curves f and g: the swept profile, the middle row and the planes of the columns."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.errors import Remedy
from orishell.conventions.record import record
from orishell.curves import Curve, Trace, remembered, run_along_axis, trace_curve
from orishell.design import Approached, Path, Surface, Turning
from orishell.families.pattern import Auto
from orishell.families.shared.staircases import Followed
from orishell.motion.lattice import InnerStaircase
from orishell.numerics.arrays import Array
from orishell.polylines import (
    Closeness,
    Staircase,
    choose_theta,
    measure_closeness,
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
