"""Plane geometry: normals, extents, overlap."""

from __future__ import annotations

import numpy as np

from orishell.curves.trace import Trace
from orishell.numerics.arrays import Array


def normals_at(trace: Trace, t: Array) -> Array:
    """Unit normals (n, 2) to the left of a curve at parameters t (n,)."""
    heading = trace.heading_at(t)
    return np.stack([-np.sin(heading), np.cos(heading)], axis=-1)


def is_simple_polygon(corners: Array) -> bool:
    """Whether the closed polygon (K, 2) neither crosses nor touches itself."""
    import shapely

    return bool(shapely.LinearRing(corners).is_simple)


def extent_across(points: Array) -> float:
    """Extent of points (P, 2) across their longest direction: zero if they are on a line."""
    centred = points - points.mean(axis=0)
    across = np.linalg.svd(centred, full_matrices=False)[2][1]
    return float(np.ptp(centred @ across))
