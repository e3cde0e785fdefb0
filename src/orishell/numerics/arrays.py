"""Types of arrays by what they hold, and frames in which points far from the origin keep digits.

Shapes of arrays are given in the docstrings.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Booleans = NDArray[np.bool_]
Complex = NDArray[np.complex128]
Integers = NDArray[np.int64]


def nearby_origin(points: Array) -> Array:
    """The origin (D,) of a frame in which points (P, D) have small coordinates.

    Along every axis it is a multiple of a power of two of four to eight times the points' extent,
    so that subtracting it loses nothing; points within two extents of the old origin keep that one.

    Parameters
    ----------
    points
        The points (P, D), finite.
    """
    low, high = points.min(axis=0), points.max(axis=0)
    extent = float((high - low).max())
    if not extent:
        return np.asarray(low)
    step = np.exp2(np.ceil(np.log2(4.0 * extent)))
    return np.asarray(np.round(0.5 * (low + high) / step) * step)
