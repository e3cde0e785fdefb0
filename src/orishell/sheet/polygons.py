"""Polygons in the plane of the flat sheet, by their corners (..., k, 2)."""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array


def signed_areas(corners: Array) -> Array:
    """Areas (...) of polygons, positive if they go round counter-clockwise.

    Parameters
    ----------
    corners
        Corners (..., k, 2) of every polygon in order around it.
    """
    local = corners - corners[..., :1, :]
    after = np.roll(local, -1, axis=-2)
    cross = local[..., 0] * after[..., 1] - local[..., 1] * after[..., 0]
    return np.asarray(0.5 * cross.sum(axis=-1))
