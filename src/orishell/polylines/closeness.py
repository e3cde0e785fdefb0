"""How close a polyline and a curve are, and whether that is close enough to recognise the curve."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from orishell.conventions.quantities import plain
from orishell.curves import Trace, remembered
from orishell.curves.nearest import Nearest
from orishell.curves.radians import look_like_degrees
from orishell.numerics.arrays import Array
from orishell.polylines.plane import extent_across

SAMPLES_PER_EDGE = 8
MOST_SAMPLES = 20_000
"""Traces of twice as many samples or more are thinned to this number, or little more; corners are
all kept."""
FEW = 200_000
"""Distances of points from edges that are all computed; of more, those that a search tree finds."""
COARSE_SHARE = 0.1
"""A polyline that leaves g by more than this share of g's rise draws a warning."""


@dataclass(frozen=True, slots=True)
class Closeness:
    """Distances between a curve and a polyline, in the unit of their coordinates.

    Parameters
    ----------
    max
        The Hausdorff distance: the largest distance of a point of either to the other.
    rms
        Root mean square over the curve's length of the distance to the polyline.
    """

    max: float
    rms: float


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
    if len(points) * len(vertices) <= FEW:
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
    """The same, with the distances from every edge: quicker for a few of them."""
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
