"""Which way triangles face: normals of vertices, and surfaces that fold over."""

from __future__ import annotations

import numpy as np

from orishell.design.mesh_errors import ELSE_PART, place_in_words, refused_mesh
from orishell.motion.quads import dots, lengths
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import first_smallest

FOLDED = np.deg2rad(120)
"""Neighbouring triangles whose normals turn by more are folded onto each other."""
ASIDE = np.deg2rad(110)
"""Triangles that are turned by more from the mean normal fold over."""
NARROW = 1e-3
"""Triangles that are narrower than this share of their longest edge face nowhere."""
UPRIGHT = 1e-6
"""A triangle whose plan has less than this share of its area stands upright."""


def vertex_normals(vertices: Array, triangles: Integers) -> Array:
    """Unit normals (V, 3) of vertices: those of their triangles, weighted by angles.

    After G. Thuermer and C. A. Wuethrich, J. Graphics Tools 3 (1998) 43.
    """
    corners = vertices[triangles]  # (T, 3, 3)
    forth = np.roll(corners, -1, axis=1) - corners
    back = np.roll(corners, 1, axis=1) - corners
    across = np.cross(forth, back)
    angles = np.arctan2(lengths(across), dots(forth, back))
    across = np.cross(forth[:, 0], back[:, 0])
    across /= np.maximum(lengths(across), 1e-300)[:, None]
    normals = np.zeros_like(vertices)
    for k in range(3):
        np.add.at(normals, triangles[:, k], angles[:, k, None] * across)
    return np.asarray(normals / np.maximum(lengths(normals), 1e-300)[:, None])


def require_no_folds(vertices: Array, triangles: Integers) -> None:
    """Refuse triangles that are folded onto their neighbours, or turned away from the rest."""
    p, q, r = np.moveaxis(vertices[triangles], 1, 0)
    normals = np.cross(q - p, r - p)
    sizes = lengths(normals)
    mean = normals.sum(axis=0)
    longest = np.max([lengths(q - p), lengths(r - q), lengths(p - r)], axis=0)
    clear = sizes > NARROW * longest**2
    normals = normals / np.maximum(sizes, 1e-300)[:, None]
    remedy = "remove what is folded" + ELSE_PART
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    order = np.lexsort(edges.T)
    edges, face = edges[order], np.repeat(np.arange(len(triangles)), 3)[order]
    twice = np.flatnonzero((edges[1:] == edges[:-1]).all(axis=1))
    one, other = face[twice], face[twice + 1]
    bent = np.where(clear[one] & clear[other], (normals[one] * normals[other]).sum(axis=1), 1.0)
    if len(bent) and bent.min() < np.cos(FOLDED):
        worst = first_smallest(bent, size=1.0)
        raise refused_mesh(
            "the mesh folds over",
            f"an edge that is folded by {_degrees(bent[worst])} degrees near "
            f"{place_in_words(vertices[edges[twice[worst]]].mean(axis=0))}",
            f"at most {np.rad2deg(FOLDED):.0f} degrees",
            remedy,
        )
    size = float(lengths(mean))
    facing = np.where(clear, normals @ mean / max(size, 1e-300), 1.0)
    if facing.min() < np.cos(ASIDE):
        worst = first_smallest(facing, size=1.0)
        raise refused_mesh(
            "the mesh folds over",
            f"a part turned by {_degrees(facing[worst])} degrees from its mean normal near "
            f"{place_in_words(vertices[triangles[worst]].mean(axis=0))}",
            f"at most {np.rad2deg(ASIDE):.0f} degrees",
            remedy,
        )


def _degrees(cosine: float) -> str:
    return f"{np.rad2deg(np.arccos(np.clip(cosine, -1, 1))):.0f}"


def require_graph(vertices: Array, triangles: Integers, narrow: float) -> None:
    """Refuse triangles that stand upright or hang over."""
    p, q, r = np.moveaxis(vertices[triangles], 1, 0)
    normal = np.cross(q - p, r - p)
    size = lengths(normal)
    longest = np.max([lengths(q - p), lengths(r - q), lengths(p - r)], axis=0)
    upward = np.where(size > narrow * longest, normal[:, 2] / np.maximum(size, 1e-300), 1.0)
    if upward.min() < UPRIGHT:
        worst = first_smallest(upward, size=1.0)
        at = vertices[triangles[worst]].mean(axis=0)
        what = "hangs over" if upward[worst] < -UPRIGHT else "stands upright"
        raise refused_mesh(
            "the mesh folds over in plan",
            f"it {what} near {place_in_words(at)}",
            "one height over every point of the rectangle",
            "choose a rectangle beside that place",
        )
