"""Plane geometry: extents, overlap."""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array


def is_simple_polygon(corners: Array) -> bool:
    """Whether the closed polygon (K, 2) neither crosses nor touches itself.

    corners: Its corners (K, 2) in order.
    """
    import shapely

    return bool(shapely.LinearRing(corners).is_simple)


def extent_across(points: Array) -> float:
    """Extent of points (P, 2) across their longest direction: zero if they are on a line.

    points: The points (P, 2).
    """
    centred = points - points.mean(axis=0)
    across = np.linalg.svd(centred, full_matrices=False)[2][1]
    return float(np.ptp(centred @ across))
