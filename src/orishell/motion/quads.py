"""Quadrilateral panels by their corners (..., 4, 3), and polygons of the flat sheet."""

from __future__ import annotations

import numpy as np

from orishell.motion.grid import Positions
from orishell.numerics.arrays import Array, Booleans, Integers

Vectors = Array
"""Vectors (..., 3)."""
Corners = Array
"""Corners (..., 4, 3) of panels, in order around each."""

ALIKE = 1e-9
"""Squares of lengths that differ by no more than this share are alike."""


def dots(first: Vectors, second: Vectors) -> Array:
    """Scalar products (...) of vectors (..., 3).

    To the last bit NumPy's sum over the last axis, which is slow where that is so short.
    """
    product = first * second
    return np.asarray(product[..., 0] + product[..., 1] + product[..., 2])


def lengths(vectors: Vectors) -> Array:
    """Lengths (...) of vectors (..., 3)."""
    return np.asarray(np.sqrt(dots(vectors, vectors)))


def units(vectors: Vectors) -> Array:
    """Unit vectors (..., 3) along vectors; zero along none."""
    length = lengths(vectors)[..., None]
    return np.asarray(vectors / np.where(length > 0, length, 1.0))


def corner_distances(corners: Corners) -> Array:
    """The six distances (..., 6) of every panel's corners."""
    pairs = [(a, b) for a in range(4) for b in range(a)]
    return np.stack([lengths(corners[..., a, :] - corners[..., b, :]) for a, b in pairs], axis=-1)


def area_vectors(corners: Corners) -> Array:
    """Vectors (..., 3) normal to panels, as long as their areas: half the product of diagonals."""
    p, q, r, s = (corners[..., k, :] for k in range(4))
    (a, b, c), (d, e, f) = (np.moveaxis(each, -1, 0) for each in (r - p, s - q))
    return np.asarray(0.5 * np.stack([b * f - c * e, c * d - a * f, a * e - b * d], axis=-1))


def longer_diagonals(corners: Corners) -> Integers:
    """The corner (F,) at which the longer diagonal of every panel begins: 0 or 1.

    0 where both are as long but for rounding.
    """
    diagonals = corners[:, 2:] - corners[:, :2]
    first, second = (diagonals**2).sum(axis=-1).T
    return np.asarray(second > (1 + ALIKE) * first, dtype=np.int64)


def unit_normals(corners: Corners) -> Array:
    """Unit normals (..., 3), counter-clockwise seen from their tips; zero without an area."""
    return units(area_vectors(corners))


def diagonal_gaps(corners: Corners) -> Array:
    """Distances (...) between the two diagonals of every panel: zero if it is plane."""
    side = corners[..., 1, :] - corners[..., 0, :]
    return np.asarray(np.abs(np.einsum("...i,...i->...", unit_normals(corners), side)))


def sector_angles(corners: Corners) -> Array:
    """Angles (..., 4) between the two edges at every corner, in [0, pi] (radians)."""
    after, before = _edges_at(corners)
    return np.asarray(np.arctan2(lengths(np.cross(after, before)), dots(after, before)))


def reflex_corners(corners: Corners) -> Booleans:
    """Which corners (..., 4) point into their panel: its sector there is above pi."""
    after, before = _edges_at(corners)
    normals = area_vectors(corners)[..., None, :]
    return dots(np.cross(after, before), normals) < 0


def _edges_at(corners: Corners) -> tuple[Vectors, Vectors]:
    """From every corner to the next one and to the one before."""
    return np.roll(corners, -1, axis=-2) - corners, np.roll(corners, 1, axis=-2) - corners


def grid_corners(positions: Positions) -> Array:
    """Corners (..., rows-1, columns-1, 4, 3) of every panel of a grid: top left first."""
    upper, lower = positions[..., :-1, :, :], positions[..., 1:, :, :]
    left, right = slice(None, -1), slice(1, None)
    sides = (upper, left), (lower, left), (lower, right), (upper, right)
    return np.stack([row[..., side, :] for row, side in sides], axis=-2)


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


LEVEL = 1e-12
"""Points whose heights differ by less than this share of their diagonal are level."""


def is_level(points: Array) -> bool:
    """Whether points (..., 3) lie in one horizontal plane.

    Parameters
    ----------
    points
        The points (..., 3).
    """
    sizes = np.ptp(points.reshape(-1, 3), axis=0)
    return bool(sizes[2] <= LEVEL * np.linalg.norm(sizes))
