"""The swept curve f: its rotation and the condition for its staircase."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np

from orishell.curves import Trace, trace_curve
from orishell.errors import DesignError
from orishell.polylines import choose_theta, theta_interval, xi_limit
from orishell.quoting import in_degrees, inside

Auto = Literal["auto"]


def rotate_profile(
    trace: Trace, theta: float | Auto, xi: float | None, edges: int
) -> tuple[Trace, float]:
    """The rotated trace, run through along the x axis, and the rotation."""
    given = 0.0 if theta == "auto" else theta
    trace = _along_axis(trace, given)
    if theta == "auto":
        low, high = trace.heading_range()
        begin, end = theta_interval(low, high, 0.0 if xi is None else xi)
        if begin >= end:
            raise _too_much_turning(trace, high - low, xi)
        given = choose_theta(trace, edges, xi)
    return trace.rotated(given), given


def _along_axis(trace: Trace, theta: float) -> Trace:
    """The trace whose tangents, after rotation, are nearer to the x axis than to its opposite."""
    low, high = trace.heading_range()
    middle = 0.5 * (low + high) + theta
    turns = np.round(middle / np.pi)
    if int(turns) % 2:
        return _along_axis(trace_curve(trace.curve.reversed()), theta)
    return replace(
        trace, heading=trace.heading - turns * np.pi, arriving=trace.arriving - turns * np.pi
    )


def require_staircase(trace: Trace, xi: float | None, theta: float) -> None:
    """The paper's condition under equation (1): every tangent within (pi - xi)/2 of the axis.

    Without xi: some xi must satisfy it.
    """
    low, high = trace.heading_range()
    limit = xi_limit(low, high)
    if (xi or 0.0) < limit:
        return
    reached = f"its tangents reach {in_degrees(max(-low, high))} degrees from the axis"
    begin, end = theta_interval(low - theta, high - theta, xi or 0.0)
    rotation = f"theta_deg between {in_degrees(begin)} and {in_degrees(end)}"
    if limit > 0 and xi is not None:
        raise DesignError(
            f"xi_deg = {in_degrees(xi)} is too large for f",
            place=_steepest_place(trace),
            size=f"{reached} and may reach only {in_degrees((np.pi - xi) / 2)}",
            nearest=f"xi_deg below {in_degrees(limit)}"
            + (f", or {rotation}" if begin < end else ""),
        )
    if begin >= end:
        raise _too_much_turning(trace, high - low, xi)
    raise DesignError(
        f"f has no staircase for theta_deg = {in_degrees(theta)}, whatever xi_deg is",
        place=_steepest_place(trace),
        size=f"{reached} and must stay below 90",
        nearest=rotation,
    )


def _too_much_turning(trace: Trace, spread: float, xi: float | None) -> DesignError:
    allowed = np.pi - (xi or 0.0)
    both = np.stack([trace.heading, trace.arriving])
    so_far = np.maximum.accumulate(both.max(axis=0)) - np.minimum.accumulate(both.min(axis=0))
    last = trace.t[np.flatnonzero(so_far < allowed)[-1]]
    nearest = f"the part of f from parameter {trace.t[0]:.6g} to {inside(last, trace.t[0]):.6g}"
    if xi is not None and spread < np.pi:
        nearest = f'xi_deg below {in_degrees(np.pi - spread)} with theta_deg = "auto", or {nearest}'
    return DesignError(
        "f turns too much for a staircase, whatever its rotation",
        size=f"its tangents spread over {in_degrees(spread)} degrees and may spread over less than "
        f"{in_degrees(allowed)}",
        nearest=nearest,
    )


def _steepest_place(trace: Trace) -> str:
    """Where on f the tangent is farthest from the axis."""
    k = int(np.argmax(np.maximum(np.abs(trace.heading), np.abs(trace.arriving))))
    return f"at parameter {trace.t[k]:.6g} of f"
