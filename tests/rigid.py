"""Shapes compared whatever their place in space."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def distance_after_motion(moved: Array, fixed: Array) -> float:
    """Largest distance of points (V, 3) from their fellows after the best motion (Kabsch, 1976).

    Proper motions only: a mirror image is another shape.
    """
    start, end = moved - moved.mean(axis=0), fixed - fixed.mean(axis=0)
    left, _, right = np.linalg.svd(start.T @ end)
    handed = np.diag([1.0, 1.0, np.linalg.det(left @ right)])
    return float(np.linalg.norm(start @ left @ handed @ right - end, axis=1).max())
