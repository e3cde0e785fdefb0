"""Sizes of a sheet in one state, measured on its positions."""

from __future__ import annotations

import numpy as np

from orishell.motion.quads import area_vectors, grid_corners
from orishell.numerics.arrays import Array

ROUNDING = 1e-13
"""Points nearer to each other than this share of an edge lie on each other but for rounding."""


def diagonal(flat: Array) -> float:
    """Diagonal of the flat sheet's bounding box, the length that residuals are relative to.

    Parameters
    ----------
    flat
        Vertices (rows, columns, 3) of the flat sheet.
    """
    return float(np.hypot(*extents(flat)[:2]))


def extents(positions: Array) -> tuple[float, float, float]:
    """Size of the bounding box along x, y and z.

    Parameters
    ----------
    positions
        Vertices (rows, columns, 3) in one state.
    """
    size = np.ptp(positions.reshape(-1, 3), axis=0)
    return float(size[0]), float(size[1]), float(size[2])


def sheet_area(positions: Array) -> float:
    """Area of all panels.

    Parameters
    ----------
    positions
        Vertices (rows, columns, 3) in any state.
    """
    return float(np.linalg.norm(area_vectors(grid_corners(positions)), axis=-1).sum())


def corrugation_depth(positions: Array) -> float:
    """Mean distance of inner vertices from the line between those above and below (length).

    Where these two lie on each other, the distance from them.

    Parameters
    ----------
    positions
        Vertices (rows, columns, 3) in one state.
    """
    inner = positions[:, 1:-1] if positions.shape[1] > 2 else positions
    base = inner[2:] - inner[:-2]
    arm = inner[1:-1] - inner[:-2]
    across = np.linalg.norm(np.cross(arm, base), axis=-1)
    apart, depth = np.linalg.norm(base, axis=-1), np.linalg.norm(arm, axis=-1)
    return float(np.divide(across, apart, out=depth, where=apart > ROUNDING * depth).mean())
