"""Quadrilateral panels by their corners (..., 4, 3), in order around each panel."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def corner_distances(corners: Array) -> Array:
    """The six distances (..., 6) of every panel's corners.

    Parameters
    ----------
    corners
        Corners (..., 4, 3) of every panel in order around it.
    """
    pairs = [(a, b) for a in range(4) for b in range(a)]
    first = corners[..., [a for a, _ in pairs], :]
    second = corners[..., [b for _, b in pairs], :]
    return np.asarray(np.linalg.norm(first - second, axis=-1))


def area_vectors(corners: Array) -> Array:
    """Vectors (..., 3) square to every panel, as long as its area: half the diagonals' product.

    Parameters
    ----------
    corners
        Corners (..., 4, 3) of every panel in order around it.
    """
    p, q, r, s = (corners[..., k, :] for k in range(4))
    (a, b, c), (d, e, f) = (np.moveaxis(each, -1, 0) for each in (r - p, s - q))
    return np.asarray(0.5 * np.stack([b * f - c * e, c * d - a * f, a * e - b * d], axis=-1))


def unit_normals(corners: Array) -> Array:
    """Unit normals (..., 3), counter-clockwise seen from their tips; zero without an area.

    Parameters
    ----------
    corners
        Corners (..., 4, 3) of every panel in order around it.
    """
    vectors = area_vectors(corners)
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.asarray(vectors / np.where(length > 0, length, 1.0))


def diagonal_gaps(corners: Array) -> Array:
    """Distances (...) between the two diagonals of every panel: zero if it is plane.

    Parameters
    ----------
    corners
        Corners (..., 4, 3) of every panel in order around it.
    """
    gap = np.einsum(
        "...i,...i->...", unit_normals(corners), corners[..., 1, :] - corners[..., 0, :]
    )
    return np.asarray(np.abs(gap))


def sector_angles(corners: Array) -> Array:
    """Angles (..., 4) between the two edges at every corner, in [0, pi] (radians).

    Parameters
    ----------
    corners
        Corners (..., 4, 3) of every panel in order around it.
    """
    after, before = _edges_at(corners)
    sine = np.linalg.norm(np.cross(after, before), axis=-1)
    return np.asarray(np.arctan2(sine, (after * before).sum(axis=-1)))


def reflex_corners(corners: Array) -> NDArray[np.bool_]:
    """Which corners (..., 4) point into their panel: its sector there is above pi.

    Parameters
    ----------
    corners
        Corners (..., 4, 3) of every panel in order around it.
    """
    after, before = _edges_at(corners)
    normals = area_vectors(corners)[..., None, :]
    return np.asarray((np.cross(after, before) * normals).sum(axis=-1) < 0)


def _edges_at(corners: Array) -> tuple[Array, Array]:
    """From every corner to the next one and to the one before."""
    return np.roll(corners, -1, axis=-2) - corners, np.roll(corners, 1, axis=-2) - corners
