"""The swept curve f: its rotation, its staircase, and the surfaces that it sweeps."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import Remedy
from orishell.conventions.record import record
from orishell.curves import Curve, Trace, remembered, run_along_axis, trace_curve
from orishell.design import Approached, Path, Surface, Turning
from orishell.families.parameters import Auto
from orishell.families.shared.staircases import Followed
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
        **dict.fromkeys(
            ("pattern.xi_deg", "pattern.theta_deg", "pattern.plane_deg", "pattern.plane")
        ),
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


@record
class Profile:
    """f as it is swept, and the staircase that takes its place.

    Parameters
    ----------
    trace
        f, rotated and run through along its x axis.
    theta
        Its rotation (radians).
    staircase
        Column 1 at lock.
    closeness
        The staircase's distance from f.
    """

    trace: Trace
    theta: float
    staircase: Staircase
    closeness: Closeness


@remembered
def fit_profile(f: Curve, edges: int, xi: float | Auto, theta: float | Auto) -> Profile:
    """Rotate f and fit its staircase.

    Raises
    ------
    CurveError
        If f is not a usable curve.
    DesignError
        If it has no staircase of this angle.
    """
    angle = None if xi == "auto" else xi
    trace = run_along_axis(trace_curve(f, "f").in_own_frame(), 0.0 if theta == "auto" else theta)
    if theta == "auto":
        F.turns(trace, angle)
        theta = choose_theta(trace, edges, angle)
    trace = trace.rotated(theta)
    staircase = F.fit(trace, theta, angle, edges)
    return Profile(trace, theta, staircase, measure_closeness(trace, staircase.vertices))


def widest_xi(f: Curve, theta: float | Auto) -> float:
    """The widest angle xi that f admits, rotated by theta or as is best for it (radians)."""
    trace = run_along_axis(trace_curve(f, "f").in_own_frame(), 0.0 if theta == "auto" else theta)
    low, high = trace.heading_range()
    turned = 0.5 * (low + high) if theta == "auto" else -theta
    return widest_angle(low - turned, high - turned)


STRETCHED = 1e-9
"""A stretch that differs from 1 by less than this counts as none."""


def sweep(f: Trace, staircase: Staircase, g: Trace, plane: float) -> Surface:
    """f swept rigidly along g, in planes at the angle ``plane`` to it (radians).

    The staircase passes through g at its middle vertex.
    """
    return Surface(f, _origin(staircase), Turning(Path.of(g), plane))


def approach(f: Trace, staircase: Staircase, g: Trace, plane: float) -> Approached | None:
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
        f"f is not swept rigidly, for its plane is not square to g: it is stretched along its "
        f"plane to between {low:.4g} and {high:.4g} of its width",
        Surface(f, _origin(staircase), rail),
    )


def _origin(staircase: Staircase) -> np.ndarray:
    return np.asarray(staircase.vertices[len(staircase.vertices) // 2])
