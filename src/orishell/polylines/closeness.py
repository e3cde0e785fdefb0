"""How far the edges of a polyline leave a curve that they follow, edge by edge and to each side."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.curves import Trace, remembered
from orishell.curves.nearest import Closeness, Nearest
from orishell.curves.plane import extent_across
from orishell.curves.radians import look_like_degrees
from orishell.numerics.arrays import Array

CURVE_SAMPLES = 12
"""Points of the curve taken along every edge, besides the samples of its trace."""
REACH = 3.0
"""Errors count for a vertex in full up to two thirds along its edges (1 - 1/REACH), then less and
less: those at the far end are the next vertex's."""


@record
class EdgeErrors:
    """Errors of a polyline of n vertices, each belonging to a point of the curve."""

    largest: Array  # largest distance (n-1,) between each edge and its piece of the curve
    # half the way (n-1,) from the largest error of each edge on one side to that on the other,
    # without those at its far ends
    half_range: Array
    # errors (n,) around each vertex: the largest to the left plus the largest to the right of the
    # curve (negative); zero where they balance
    bias: Array


def measure_edges(trace: Trace, t: Array, vertices: Array, offsets: Array) -> EdgeErrors:
    """Return how far every edge leaves its piece of the curve.

    The vertices (n, 2) belong to the parameters t (n,), at distances ``offsets`` (n,) to the left.
    """
    part = np.arange(1, CURVE_SAMPLES) / CURVE_SAMPLES
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


SAMPLES_PER_EDGE = 8
MOST_SAMPLES = 20_000
"""Traces of twice as many samples or more are thinned to about this number; corners are kept."""
FEW_DISTANCES = 200_000
"""Distances of points from edges that are all computed; above, a search tree picks the edges."""
COARSE_SHARE = 0.1
"""A polyline that leaves g by more than this share of g's rise draws a warning."""


def measure_closeness(trace: Trace, vertices: Array) -> Closeness:
    """Return how close a polyline (K, 2) and a curve are, both ways.

    The curve is taken at the samples of its trace, 20,000 to 40,000 of them where there are more,
    the polyline at its vertices and :data:`SAMPLES_PER_EDGE` points on every edge.

    Parameters
    ----------
    vertices
        Vertices (K, 2) of the polyline.
    """
    nearest, trace = Nearest.to(trace), thinned(trace)
    to_polyline = distances_to_polyline(trace.points, vertices)
    part = np.arange(SAMPLES_PER_EDGE)[:, None, None] / SAMPLES_PER_EDGE
    along = (vertices[:-1] * (1 - part) + vertices[1:] * part).reshape(-1, 2)
    _, to_curve = nearest(np.concatenate([along, vertices[-1:]]))
    squares = to_polyline**2
    mean = float((0.5 * (squares[1:] + squares[:-1]) * np.diff(trace.arc)).sum() / trace.length)
    return Closeness(float(max(to_polyline.max(), to_curve.max())), float(np.sqrt(mean)))


def distances_to_polyline(points: Array, vertices: Array) -> Array:
    """Distances (P,) of points (P, 2) to the nearest point of a polyline (K, 2).

    Parameters
    ----------
    points
        The points (P, 2).
    vertices
        Vertices (K, 2) of the polyline.
    """
    if len(points) * len(vertices) <= FEW_DISTANCES:
        return _distances_to_edges(points, vertices)
    import shapely

    edges = shapely.linestrings(np.stack([vertices[:-1], vertices[1:]], axis=1))
    tree = shapely.STRtree(np.asarray(edges, dtype=object))
    index, distance = tree.query_nearest(
        shapely.points(points), return_distance=True, all_matches=False
    )
    result = np.empty(len(points))
    result[index[0]] = distance
    return result


def _distances_to_edges(points: Array, vertices: Array) -> Array:
    """Distances (P,) of points to a polyline by those to every edge: quicker for a few of them."""
    start, span = vertices[:-1].T[..., None], np.diff(vertices, axis=0).T[..., None]
    away = points.T[:, None] - start
    square = (span * span).sum(axis=0)
    share = (away * span).sum(axis=0) / np.maximum(square, np.finfo(float).tiny)
    away -= np.clip(share, 0.0, 1.0) * span
    return np.asarray(np.sqrt((away * away).sum(axis=0).min(axis=0)))


@remembered
def thinned(trace: Trace) -> Trace:
    """The trace, or every k-th of its samples and those at corners if it has very many."""
    stride = len(trace.t) // MOST_SAMPLES
    if stride < 2:
        return trace
    last = len(trace.t) - 1
    kept = np.unique(np.concatenate([np.arange(0, last, stride), trace.corners, [last]]))
    return replace(
        trace,
        t=trace.t[kept],
        points=trace.points[kept],
        arc=trace.arc[kept],
        heading=trace.heading[kept],
        arriving=trace.arriving[kept],
    )


def warn_of_coarse_row(trace: Trace, distance: float, columns: int) -> tuple[str, ...]:
    """Warn of a polyline that is too coarse to show the shape of g.

    Parameters
    ----------
    distance
        Distance of the polyline from it, in its unit.
    columns
        Number n of the polyline's vertices.
    """
    size = extent_across(trace.points)
    if distance <= COARSE_SHARE * size + 1e-9 * trace.length or size <= 1e-9 * trace.length:
        return ()  # a straight g has no shape to show
    curve = trace.curve
    degrees = curve.key == "range" and look_like_degrees(curve.start, curve.stop)
    return (
        f"the polyline of g with {columns} columns leaves g by {plain(distance)}, "
        f"{distance / size:.0%} of g's rise of {plain(size)} (more than {COARSE_SHARE:.0%}): "
        "the shell will not show g's shape; take more columns"
        + (", or give radians: its range looks like degrees" if degrees else ""),
    )
