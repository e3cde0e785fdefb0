"""The swept curve f: its rotation and the condition for its staircase."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import chain

import numpy as np

from orishell.conventions.formatting import in_degrees
from orishell.curves import Curve, Trace, remembered, run_along_axis, trace_curve
from orishell.errors import DesignError, Remedy
from orishell.families.candidates import angles, part
from orishell.families.parameters import Auto
from orishell.polylines import (
    Closeness,
    Staircase,
    choose_theta,
    choose_xi,
    fit_staircase,
    measure_closeness,
    theta_interval,
    xi_limit,
)

NARROWEST_XI = np.deg2rad(0.1)
"""Angles below this are not offered: the corrugation would be deeper than the shell is wide."""
ROOM = (0.95, 0.8, 0.6)
"""Shares of the admissible turning that parts of f use: some must be left for xi."""
ORTHODIAGONAL = Remedy(
    {
        "shell.family": "orthodiagonal",
        **dict.fromkeys(("pattern.xi_deg", "pattern.theta_deg", "pattern.plane_deg")),
    }
)
"""The family that takes an f of walls near vertical, or beyond."""


@dataclass(frozen=True, slots=True, eq=False)
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
    trace, theta = _rotated(trace_curve(f, "f").in_own_frame(), theta, angle, edges)
    require_staircase(trace, angle, theta)
    staircase = fit_staircase(trace, choose_xi(trace, edges) if angle is None else angle, edges)
    return Profile(trace, theta, staircase, measure_closeness(trace, staircase.vertices))


def _rotated(
    trace: Trace, theta: float | Auto, xi: float | None, edges: int
) -> tuple[Trace, float]:
    """The rotated trace, run through along the x axis, and the rotation."""
    given = 0.0 if theta == "auto" else theta
    trace = run_along_axis(trace, given)
    if theta == "auto":
        low, high = trace.heading_range()
        begin, end = theta_interval(low, high, 0.0 if xi is None else xi)
        if end - begin <= NARROWEST_XI:
            raise _too_much_turning(trace, high - low, xi)
        given = choose_theta(trace, edges, xi)
    return trace.rotated(given), given


def require_staircase(trace: Trace, xi: float | None, theta: float) -> None:
    """The paper's condition under equation (1): every tangent within (pi - xi)/2 of the axis.

    Without xi: some xi must satisfy it.
    """
    low, high = trace.heading_range()
    limit = xi_limit(low, high)
    if (NARROWEST_XI if xi is None else xi) < limit:
        return
    reached = f"its tangents reach {in_degrees(max(-low, high))} degrees from the axis"
    begin, end = theta_interval(low - theta, high - theta, xi or 0.0)
    if limit > NARROWEST_XI and xi is not None:
        raise DesignError(
            f"xi_deg = {in_degrees(xi)} is too large for f",
            keys=("pattern.xi_deg",),
            place=_steepest_place(trace, theta),
            size=f"{reached} and may reach only {in_degrees((np.pi - xi) / 2)}; xi_deg must stay "
            f"below {in_degrees(limit)}",
            candidates=chain(
                angles("xi_deg", 0.0, limit, xi), angles("theta_deg", begin, end, theta)
            ),
        )
    if end - begin <= NARROWEST_XI:
        raise _too_much_turning(trace, high - low, xi)
    raise DesignError(
        f"f has no staircase for theta_deg = {in_degrees(theta)}, whatever xi_deg is",
        keys=("pattern.theta_deg",),
        place=_steepest_place(trace, theta),
        size=f"{reached} and must stay below 90; theta_deg must lie between "
        f"{in_degrees(begin)} and {in_degrees(end)}",
        candidates=angles("theta_deg", begin, end, theta),
    )


def _too_much_turning(trace: Trace, spread: float, xi: float | None) -> DesignError:
    allowed = np.pi - (xi or 0.0)
    both = np.stack([trace.heading, trace.arriving])
    so_far = np.maximum.accumulate(both.max(axis=0)) - np.minimum.accumulate(both.min(axis=0))
    rotated = Remedy({"pattern.theta_deg": "auto"})
    candidates = []
    if xi is not None and np.pi - spread > NARROWEST_XI:
        candidates += [each | rotated for each in angles("xi_deg", 0.0, np.pi - spread, xi)]
    for room in ROOM:
        k = int(np.flatnonzero(so_far < room * allowed)[-1])
        candidates.append(part("f", trace.curve, trace.t[0], trace.t[k]) | rotated)
    walls = spread >= np.pi
    candidates.insert(0 if walls else len(candidates), ORTHODIAGONAL)
    return DesignError(
        "f turns too much for a staircase, whatever its rotation",
        size=f"its tangents spread over {in_degrees(spread)} degrees and may spread over less than "
        f"{in_degrees(allowed)}" + ("; the orthodiagonal family takes such an f" if walls else ""),
        candidates=candidates,
    )


def _steepest_place(trace: Trace, theta: float) -> str:
    """Where on f, as it was drawn, the tangent is farthest from the axis."""
    k = int(np.argmax(np.maximum(np.abs(trace.heading), np.abs(trace.arriving))))
    drawn = trace.rotated(-theta)
    x, y = drawn.points[k] + drawn.origin
    return f"at the point ({x:.6g}, {y:.6g}) of f"
