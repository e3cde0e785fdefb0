"""Pairs of convex quadrilaterals in space: gaps along directions, distances, nearest points.

Corners are arrays (3, P, 4): coordinates first, so that every operation runs over whole arrays.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

PARALLEL = 1e-14
"""Edges whose directions differ by less (squared sine) are taken as parallel."""


def corners_of(points: Array, faces: NDArray[np.int64]) -> Array:
    """Corners (3, P, 4) of faces (P, 4), from vertices (V, 3)."""
    return np.ascontiguousarray(points.T)[:, faces]


def normals(corners: Array) -> Array:
    """Unit normals (3, P): across both diagonals."""
    normal = _cross(corners[..., 2] - corners[..., 0], corners[..., 3] - corners[..., 1])
    length = np.sqrt(_dot(normal, normal))
    return np.asarray(normal / np.where(length > 0, length, 1.0))


def gap_along(direction: Array, first: Array, second: Array) -> Array:
    """Gap (P,) between pairs seen along directions (3, P), negative if the views overlap."""
    a, b = _dot(direction[..., None], first), _dot(direction[..., None], second)
    return np.asarray(np.maximum(b.min(axis=-1) - a.max(axis=-1), a.min(axis=-1) - b.max(axis=-1)))


def common_gap(direction: Array, states: list[tuple[Array, Array]]) -> Array:
    """Gap (P,) along directions (3, P) that both states have on the same side."""
    above, below = [], []
    for first, second in states:
        a, b = _dot(direction[..., None], first), _dot(direction[..., None], second)
        above.append(b.min(axis=-1) - a.max(axis=-1))
        below.append(a.min(axis=-1) - b.max(axis=-1))
    return np.asarray(np.maximum(np.minimum(*above), np.minimum(*below)))


def nearest(first: Array, second: Array) -> tuple[Array, Array]:
    """Distance (P,) of the panels of every pair, and the vector (3, P) between nearest points.

    Both are zero where panels cross, touch or overlap. The nearest points of two convex
    polygons that are apart lie on two edges, or one is a corner.
    """
    square, between = _between_edges(first, second)
    for panel, other, sign in ((first, second, -1.0), (second, first, 1.0)):
        normal = normals(panel)
        height = _dot(normal[..., None], other - panel[..., :1])
        over = _inside(panel, normal, other)
        above = np.where(over, height**2, np.inf)
        corner = above.argmin(axis=-1)[:, None]
        best = np.take_along_axis(above, corner, axis=-1)[:, 0]
        closer = best < square
        square = np.where(closer, best, square)
        at = np.take_along_axis(height, corner, axis=-1)[:, 0]
        between = np.where(closer, -sign * at * normal, between)
        following = np.roll(height, -1, axis=-1)
        with np.errstate(divide="ignore", invalid="ignore"):
            share = np.where(height * following < 0, height / (height - following), np.nan)
        through = other + share * (np.roll(other, -1, axis=-1) - other)
        pierced = _inside(panel, normal, through).any(axis=-1)
        square = np.where(pierced, 0.0, square)
    between = np.where(square > 0, between, 0.0)
    return np.sqrt(square), between


def _between_edges(first: Array, second: Array) -> tuple[Array, Array]:
    """Smallest squared distance (P,) of two edges, and the vector (3, P) from first to second."""
    p, q = first[..., :, None], second[..., None, :]
    u = np.roll(p, -1, axis=-2) - p
    v = np.roll(q, -1, axis=-1) - q
    r = p - q
    uu, vv, uv = _dot(u, u), _dot(v, v), _dot(u, v)
    ur, vr = _dot(u, r), _dot(v, r)
    area = uu * vv - uv**2
    flat = area <= PARALLEL * uu * vv
    s = np.where(flat, 0.0, np.clip((uv * vr - ur * vv) / np.where(flat, 1.0, area), 0, 1))
    t = np.clip((uv * s + vr) / np.where(vv > 0, vv, 1.0), 0, 1)
    s = np.clip((uv * t - ur) / np.where(uu > 0, uu, 1.0), 0, 1)
    between = t * v - s * u - r
    square = _dot(between, between).reshape(first.shape[1], 16)
    which = square.argmin(axis=-1)
    rows = np.arange(len(which))
    return square[rows, which], between.reshape(3, -1, 16)[:, rows, which]


def _inside(panel: Array, normal: Array, points: Array) -> NDArray[np.bool_]:
    """Whether points (3, P, K) lie over the panel, seen along its normal."""
    edge = np.roll(panel, -1, axis=-1) - panel
    inward = _cross(normal[..., None], edge)
    level = _dot(inward, panel)
    inside = np.ones(points.shape[1:], np.bool_)
    for k in range(4):
        inside &= _dot(inward[..., k, None], points) >= level[:, k, None]
    return inside


def _dot(u: Array, v: Array) -> Array:
    return np.asarray(u[0] * v[0] + u[1] * v[1] + u[2] * v[2])


def _cross(u: Array, v: Array) -> Array:
    return np.stack(
        [
            u[1] * v[2] - u[2] * v[1],
            u[2] * v[0] - u[0] * v[2],
            u[0] * v[1] - u[1] * v[0],
        ]
    )
