"""Plane geometry: distances, extents, overlap."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def distances_to_polyline(points: Array, vertices: Array) -> Array:
    """Distances (P,) of points (P, 2) to the nearest point of a polyline (K, 2).

    Parameters
    ----------
    points
        The points (P, 2).
    vertices
        Vertices (K, 2) of the polyline.
    """
    import shapely

    edges = shapely.linestrings(np.stack([vertices[:-1], vertices[1:]], axis=1))
    tree = shapely.STRtree(np.asarray(edges, dtype=object))
    index, distance = tree.query_nearest(
        shapely.points(points), return_distance=True, all_matches=False
    )
    result = np.empty(len(points))
    result[index[0]] = distance
    return result


def is_simple_polygon(corners: Array) -> bool:
    """Whether the closed polygon (K, 2) neither crosses nor touches itself.

    Parameters
    ----------
    corners
        Its corners (K, 2) in order.
    """
    import shapely

    return bool(shapely.LinearRing(corners).is_simple)


def rise(points: Array) -> float:
    """Extent of points (P, 2) across their longest direction: zero if they are on a line.

    Parameters
    ----------
    points
        The points (P, 2).
    """
    centred = points - points.mean(axis=0)
    across = np.linalg.svd(centred, full_matrices=False)[2][1]
    return float(np.ptp(centred @ across))
