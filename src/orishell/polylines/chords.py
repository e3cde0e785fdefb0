"""Polylines inscribed in a curve, their vertices placed where the curve bends."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from orishell.curves import Trace
from orishell.curves.jets import Array

Spacing = Literal["curvature", "equal"]

STRAIGHT_SHARE = 0.25
"""Weight of arc length beside curvature: straight parts keep vertices at this share of the mean
density."""
ROUNDING = 1e-12
"""Turns from sample to sample below this are noise of a straight piece (radians)."""


def place_vertices(trace: Trace, count: int, spacing: Spacing = "curvature") -> Array:
    """Parameters (count,) of the vertices of an inscribed polyline, both ends included.

    Parameters
    ----------
    trace
        The curve.
    count
        Number of vertices, at least 2.
    spacing
        ``"curvature"``: chords of equal sagitta, that is, vertices as dense as the square root
        of the curvature (never sparser than :data:`STRAIGHT_SHARE` of the mean), and a vertex on
        every corner of the curve if there are enough. ``"equal"``: equal arc lengths.
    """
    if spacing == "equal":
        t = trace.parameter_at(np.linspace(0.0, trace.length, count))
    else:
        t = _by_curvature(trace, count)
    t[0], t[-1] = trace.t[0], trace.t[-1]
    return t


def _by_curvature(trace: Trace, count: int) -> Array:
    corners = trace.corners
    fit = len(corners) + 2 <= count
    turn = np.maximum(np.abs(trace.arriving[1:] - trace.heading[:-1]) - ROUNDING, 0.0)
    if not fit:
        # Too many corners for one vertex each: see them as curvature spread over a chord.
        turn = _spread_turn(trace, trace.length / (count - 1))
        corners = corners[:0]
    cells = np.diff(trace.arc)
    bend = np.sqrt(turn * cells)
    mean = bend.sum() / trace.length
    weight = bend + STRAIGHT_SHARE * mean * cells if mean > 0 else cells
    progress = np.concatenate([[0.0], np.cumsum(weight)])

    nodes = np.concatenate([[0], corners, [len(progress) - 1]])
    shares = np.diff(progress[nodes])
    chords = _share_out(shares, count - 1)
    targets = [
        np.linspace(progress[a], progress[b], k + 1)[:-1]
        for a, b, k in zip(nodes[:-1], nodes[1:], chords, strict=True)
    ]
    goals = np.concatenate([*targets, progress[-1:]])
    t: Array = np.interp(goals, progress, trace.t)
    at_corner = np.cumsum(chords)[:-1]
    t[at_corner] = trace.t[corners]
    return t


def _spread_turn(trace: Trace, window: float) -> Array:
    """Absolute turning of every cell (N-1,) if it is averaged over a window of arc length."""
    steps = np.abs(np.diff(trace.heading))
    total = np.concatenate([[0.0], np.cumsum(steps)])
    middle = 0.5 * (trace.arc[1:] + trace.arc[:-1])
    low = np.clip(middle - window / 2, 0.0, trace.length)
    high = np.clip(middle + window / 2, 0.0, trace.length)
    density = (np.interp(high, trace.arc, total) - np.interp(low, trace.arc, total)) / (high - low)
    return np.asarray(density * np.diff(trace.arc))


def _share_out(shares: Array, total: int) -> NDArray[np.intp]:
    """Whole numbers (K,), each at least 1, of the given sum, as near to the shares as possible."""
    ideal = shares / shares.sum() * total
    numbers: NDArray[np.intp] = np.maximum(np.floor(ideal), 1).astype(np.intp)
    while numbers.sum() < total:
        numbers[np.argmax(ideal / numbers)] += 1
    while numbers.sum() > total:
        spare = np.where(numbers > 1, ideal / numbers, np.inf)
        numbers[np.argmin(spare)] -= 1
    return numbers
