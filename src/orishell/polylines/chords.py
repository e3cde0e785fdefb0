"""Polylines that follow a curve, their vertices placed where the curve bends.

The first guess puts vertices as dense as the square root of the curvature. On coarse polylines and
near inflections that is not yet even, so it is corrected by the edges' errors, until all leave the
curve by the same distance.

A balanced polyline errs on both sides: its vertices overshoot the curve as far as its edges
undershoot it. That halves the distance on the inside of a curve; the ends, which are kept, cost a
little of that. An edge that crosses an inflection goes from one side of the curve to the other.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from orishell.conventions.record import record
from orishell.curves import Trace, remembered
from orishell.curves.nearest import Closeness
from orishell.curves.plane import normals_at
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import first_largest, first_smallest
from orishell.polylines.closeness import measure_closeness, measure_edges, thinned

Spacing = Literal["curvature", "equal"]
Placement = Literal["inscribed", "balanced"]

SPARSEST = 0.2
"""Straight parts keep vertices at this share of the mean density."""
SAMPLE_NOISE = 1e-12
"""Turns from sample to sample below this are noise of a straight piece (radians), errors below
this share of the length are noise of an exact polyline."""
SWEEPS = 60
"""Corrections at most: enough for five digits where there are few inflections."""
IDLE_SWEEPS, GAIN = 20, 1e-4
"""They end after this many in a row that did not bring the polyline closer by this share."""
EVEN = 1e-6
"""The errors are even when they agree to this, relative to the largest."""
LARGEST_CORRECTION = 2.0
"""A sweep changes the density of vertices by at most this factor."""
DAMPING = 20
"""Sweeps after which corrections are half of what they are at first: edges that cross inflections
change too much with their place to follow at once."""
SMALLEST_STEP = 0.3
"""Share of a correction that is always made."""
OFFSET_STEP = 2 / 3
"""Share of a vertex's bias by which it moves: two thirds is stable and quickest where all edges are
alike, since a vertex takes half of the adjacent edges' errors along."""
LARGEST_OFFSET = 0.25
"""A vertex stays within this share of its shorter piece of the curve."""


@record
class Chords:
    """A polyline along a curve."""

    # parameters (n,) of the points of the curve that the vertices belong to, both ends included
    parameters: Array
    vertices: Array  # vertices (n, 2): those points, or points on the curve's normals there


@remembered
def place_chords(
    trace: Trace,
    count: int,
    spacing: Spacing = "curvature",
    placement: Placement = "inscribed",
) -> Chords:
    """Return a polyline that follows a curve from end to end.

    Parameters
    ----------
    count
        Number of vertices, at least 2.
    spacing
        ``"curvature"``: edges of equal distance from the curve (equal sagittas), but never sparser
        than :data:`SPARSEST` of the mean, and a vertex on every corner of the curve if there are
        enough. ``"equal"``: equal arc lengths.
    placement
        ``"inscribed"``: vertices on the curve. ``"balanced"``: they overshoot it as far as the
        edges undershoot it, but for the ends and the vertices on corners, which stay; on curves
        that this brings no closer it is the same as ``"inscribed"``.
    """
    trace = thinned(trace)
    inscribed = _evened_out(trace, count, spacing, "inscribed")
    if placement == "inscribed":
        return inscribed
    balanced = _evened_out(trace, count, spacing, "balanced")
    distances = [measure_chords(trace, each).max for each in (balanced, inscribed)]
    return balanced if distances[0] < distances[1] else inscribed


@remembered
def measure_chords(trace: Trace, chords: Chords) -> Closeness:
    """Return how close a polyline is to its curve, as :func:`measure_closeness` does."""
    return measure_closeness(trace, chords.vertices)


def _evened_out(trace: Trace, count: int, spacing: Spacing, placement: Placement) -> Chords:
    """The closest polyline of the first guess and its corrections, sweep by sweep."""
    bend, corners = _bends(trace, count)
    kept = trace.t[trace.corners]
    offsets = np.zeros(count)
    best, least, gained = None, np.inf, 0
    for sweep in range(SWEEPS):
        t = _equal(trace, count) if spacing == "equal" else _cut(trace, bend, corners, count)
        vertices = trace.curve.position(t)
        if placement == "balanced":
            offsets = _admissible(trace, t, offsets, kept)
            vertices = vertices + offsets[:, None] * normals_at(trace, t)
        errors = measure_edges(trace, t, vertices, offsets)
        distance = float(errors.largest.max())
        if distance < (1 - GAIN) * least:
            gained = sweep
        if best is None or distance < least:
            best, least = Chords(t, vertices), distance
        uneven = errors.largest if placement == "inscribed" else errors.half_range
        spread = float(np.ptp(uneven)) if spacing == "curvature" else 0.0
        bias = float(np.abs(errors.bias[1:-1]).max(initial=0.0)) if placement == "balanced" else 0.0
        if max(spread, bias) <= EVEN * distance or distance <= SAMPLE_NOISE * trace.length:
            break
        if sweep - gained >= IDLE_SWEEPS:
            break
        step = max(SMALLEST_STEP, 1 / (1 + sweep / DAMPING))
        bend = bend * _correction(trace, t, uneven) ** step
        if placement == "balanced":
            offsets = offsets - OFFSET_STEP * errors.bias
    assert best is not None
    return best


def _equal(trace: Trace, count: int) -> Array:
    """Parameters (count,) at equal arc lengths."""
    t = trace.parameter_at(np.linspace(0.0, trace.length, count))
    t[0], t[-1] = trace.t[0], trace.t[-1]
    return t


def _bends(trace: Trace, count: int) -> tuple[Array, Integers]:
    """Square root of curvature over every cell (N-1,), and the samples that take a vertex."""
    corners = trace.corners
    turn = np.maximum(np.abs(trace.turns) - SAMPLE_NOISE, 0.0)
    if len(corners) + 2 > count:
        # Too many corners for one vertex each: see them as curvature spread over a chord.
        turn = _spread_turn(trace, trace.length / (count - 1))
        corners = corners[:0]
    return np.sqrt(turn * np.diff(trace.arc)), corners


def _cut(trace: Trace, bend: Array, corners: Integers, count: int) -> Array:
    """Parameters (count,) at equal steps of the summed bend (N-1,), never sparser than a limit."""
    cells = np.diff(trace.arc)
    measure = bend if bend.sum() > 0 else cells
    while True:
        sparsest = SPARSEST * measure.sum() / trace.length * cells
        if (measure >= (1 - SAMPLE_NOISE) * sparsest).all():
            break
        measure = np.maximum(measure, sparsest)
    progress = np.concatenate([[0.0], np.cumsum(measure)])
    nodes = np.concatenate([[0], corners, [len(progress) - 1]])
    chords = _share_out(np.diff(progress[nodes]), count - 1)
    targets = [
        np.linspace(progress[a], progress[b], k + 1)[:-1]
        for a, b, k in zip(nodes[:-1], nodes[1:], chords, strict=True)
    ]
    t: Array = np.interp(np.concatenate([*targets, progress[-1:]]), progress, trace.t)
    t[np.concatenate([[0], np.cumsum(chords)])] = trace.t[nodes]
    return t


def _correction(trace: Trace, t: Array, uneven: Array) -> Array:
    """Factors (N-1,) of the density: the square roots of the edges' errors over their mean."""
    factor = np.sqrt(uneven)
    factor = np.clip(factor / factor.mean(), 1 / LARGEST_CORRECTION, LARGEST_CORRECTION)
    middle = 0.5 * (trace.t[:-1] + trace.t[1:])
    return np.asarray(factor[np.searchsorted(t, middle) - 1])


def _admissible(trace: Trace, t: Array, offsets: Array, kept: Array) -> Array:
    """The offsets (n,), limited by the pieces beside them, 0 at ends and where kept (K,)."""
    pieces = np.diff(np.interp(t, trace.t, trace.arc))
    limit = np.zeros(len(t))
    limit[1:-1] = LARGEST_OFFSET * np.minimum(pieces[1:], pieces[:-1])
    limit[np.isin(t, kept)] = 0.0
    return np.asarray(np.clip(offsets, -limit, limit))


def _spread_turn(trace: Trace, window: float) -> Array:
    """Absolute turning of every cell (N-1,) if it is averaged over a window of arc length."""
    steps = np.abs(np.diff(trace.heading))
    total = np.concatenate([[0.0], np.cumsum(steps)])
    middle = 0.5 * (trace.arc[1:] + trace.arc[:-1])
    low = np.clip(middle - window / 2, 0.0, trace.length)
    high = np.clip(middle + window / 2, 0.0, trace.length)
    density = (np.interp(high, trace.arc, total) - np.interp(low, trace.arc, total)) / (high - low)
    return np.asarray(density * np.diff(trace.arc))


def _share_out(shares: Array, total: int) -> Integers:
    """Whole numbers (K,), each at least 1, of the given sum, as near to the shares as possible."""
    ideal = shares / shares.sum() * total
    numbers: Integers = np.maximum(np.floor(ideal), 1).astype(np.intp)
    while numbers.sum() < total:
        numbers[first_largest(ideal / numbers)] += 1
    while numbers.sum() > total:
        spare = np.where(numbers > 1, ideal / numbers, np.inf)
        numbers[first_smallest(spare)] -= 1
    return numbers
