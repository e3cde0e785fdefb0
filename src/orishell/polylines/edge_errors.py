"""How far the edges of a polyline leave a curve that they follow, edge by edge and to each side."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.curves import Trace
from orishell.numerics.arrays import Array

SAMPLES_PER_EDGE = 12
"""Points of the curve taken along every edge, besides the samples of its trace."""
REACH = 3.0
"""Errors count for a vertex in full up to two thirds along its edges (1 - 1/REACH), then less and
less: those at the far end are the next vertex's."""


@record
class EdgeErrors:
    """Errors of a polyline of n vertices, each belonging to a point of the curve.

    Parameters
    ----------
    largest
        Largest distance (n-1,) between each edge and its piece of the curve.
    half_range
        Half of the way (n-1,) from the largest error of each edge on one side to that on the other,
        those at its far ends left out.
    bias
        Errors (n,) around each vertex: the largest to the left plus the largest to the right of the
        curve (negative). Zero where they balance.
    """

    largest: Array
    half_range: Array
    bias: Array


def measure_edges(trace: Trace, t: Array, vertices: Array, offsets: Array) -> EdgeErrors:
    """Return how far every edge of a polyline leaves its piece of the curve.

    Parameters
    ----------
    t
        Parameters (n,) to which the vertices belong, increasing, from end to end.
    vertices
        Vertices (n, 2).
    offsets
        Their distances (n,) from the curve, positive to its left.
    """
    part = np.arange(1, SAMPLES_PER_EDGE) / SAMPLES_PER_EDGE
    between = trace.curve.position(t[:-1, None] * (1 - part) + t[1:, None] * part)
    # Edge by edge: the points between its ends, then the samples of the trace on it.
    begin = np.searchsorted(trace.t, t[1:-1])
    counts = np.diff(np.concatenate([[0], begin, [len(trace.t)]]))
    edge = np.repeat(np.arange(len(counts)), counts)
    counts += len(part)
    first = np.concatenate([[0], np.cumsum(counts[:-1])])
    x, y = points = np.empty((2, int(counts.sum())))
    points[:, first[:, None] + np.arange(len(part))] = np.moveaxis(between, -1, 0)
    points[:, np.arange(len(edge)) + len(part) * (edge + 1)] = trace.points.T

    span = np.diff(vertices, axis=0).T
    length = np.hypot(*span)
    ends = np.concatenate([vertices[:-1].T, span / length, [length]])
    from_x, from_y, unit_x, unit_y, size = np.repeat(ends, counts, axis=1)
    x -= from_x
    y -= from_y
    along, error = x * unit_x + y * unit_y, unit_y * x - unit_x * y  # positive: left of the curve
    beyond = np.maximum(np.maximum(-along, along - size), 0.0)
    place = np.clip(along / size, 0.0, 1.0)
    left, right = np.minimum(1.0, REACH * (1 - place)), np.minimum(1.0, REACH * place)

    # To the left and to the right of the curve, around the first and the last vertex of each edge.
    ends = np.stack([offsets[:-1], offsets[1:]])
    counted = error * np.stack([left, right])
    high = np.maximum(np.maximum.reduceat(counted, first, axis=1), ends)
    low = np.minimum(np.minimum.reduceat(counted, first, axis=1), ends)
    highest, lowest = offsets.copy(), offsets.copy()
    for side, vertex in enumerate((slice(None, -1), slice(1, None))):
        highest[vertex] = np.maximum(highest[vertex], high[side])
        lowest[vertex] = np.minimum(lowest[vertex], low[side])
    largest = np.maximum.reduceat(np.hypot(error, beyond), first)
    half_range = np.hypot(0.5 * (high - low).max(axis=0), np.maximum.reduceat(beyond, first))
    return EdgeErrors(np.maximum(largest, np.abs(ends).max(axis=0)), half_range, highest + lowest)
