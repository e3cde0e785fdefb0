"""Brute force: do the edges of any panel pierce another panel that shares no vertex with it?"""

from __future__ import annotations

import numpy as np

from orishell.pattern import Grid


def pierced(positions: np.ndarray) -> bool:
    """Whether some edge of a sheet (rows, columns, 3) passes through a panel it does not touch.

    Every pair of an edge and a triangle is tried (Moller and Trumbore's intersection of a segment
    and a triangle); pairs that share a vertex are left out, for those fold about it. Coplanar
    contact is not seen.
    """
    grid = Grid(*positions.shape[:2])
    points = positions.reshape(-1, 3)
    faces = grid.faces_vertices()
    triangles = np.concatenate([faces[:, [0, 1, 2]], faces[:, [0, 2, 3]]])
    quads = np.concatenate([faces, faces])
    edges = grid.edges_vertices()
    start, way = points[edges[:, 0]], points[edges[:, 1]] - points[edges[:, 0]]
    a, b, c = (points[triangles[:, k]] for k in range(3))
    first, second = b - a, c - a
    for k in range(len(triangles)):
        apart = ~(edges[:, :, None] == quads[k]).any(axis=(1, 2))
        h = np.cross(way, second[k])
        det = h @ first[k]
        with np.errstate(divide="ignore", invalid="ignore"):
            s = start - a[k]
            u = (s * h).sum(axis=1) / det
            q = np.cross(s, first[k])
            v = (way * q).sum(axis=1) / det
            t = q @ second[k] / det
            inside = (u > 1e-9) & (v > 1e-9) & (u + v < 1 - 1e-9) & (t > 1e-9) & (t < 1 - 1e-9)
        if (apart & inside).any():
            return True
    return False
