"""Which panels touch in one state."""

from __future__ import annotations

import numpy as np

from orishell.clash.broad_phase import (
    CHUNK,
    Pairs,
    PanelTree,
    child_pairs,
    common_corners,
    gaps,
    in_chunks,
)
from orishell.clash.neighbours import touching_neighbours
from orishell.clash.separation import corners_of, nearest, overlaps
from orishell.numerics.arrays import Array, Integers


def near_panels(
    positions: Array, faces: Integers, tolerance: float, over: Array | None = None
) -> Pairs:
    """Return all pairs of panels (P,) that bounds do not keep apart, the smaller number first.

    Parameters
    ----------
    positions
        Vertices (V, 3).
    faces
        Corners (F, 4) of panels.
    tolerance
        Distance at which they are near (length).
    over
        What panels have on both sides (F, 3), if they have a thickness: normals as long as it.
    """
    tree = PanelTree.over(faces, positions[faces].mean(axis=1))
    extents = tree.extents(positions, over)
    pairs = (np.zeros(1, np.int64), np.zeros(1, np.int64))
    for level in range(tree.depth + 1):
        near = gaps((extents, extents), level, pairs) <= tolerance
        pairs = (pairs[0][near], pairs[1][near])
        if level < tree.depth:
            pairs = child_pairs(pairs)
    first, second = np.sort([tree.panels[nodes] for nodes in pairs], axis=0)
    real = (first >= 0) & (first != second)
    return first[real], second[real]


def find_contacts(positions: Array, faces: Integers, tolerance: float) -> Integers:
    """Return all pairs of panels that touch, cross or overlap.

    Panels that share a crease count when it is folded flat, panels that share one vertex when
    they cross there.

    Parameters
    ----------
    positions
        Vertices (V, 3).
    faces
        Corners (F, 4) of planar, convex panels, in order around each.
    tolerance
        Distance at which panels count as touching (length).

    Returns
    -------
    Integers
        Numbers (P, 2) of the panels, the smaller one first, in ascending order.
    """
    first, second = near_panels(positions, faces, tolerance)
    found = []
    for k in range(0, len(first), CHUNK):
        chunk = (first[k : k + CHUNK], second[k : k + CHUNK])
        shared = np.asarray(common_corners(faces, *chunk).any(axis=(1, 2)))
        touching = np.zeros(len(shared), np.bool_)
        beside = (chunk[0][shared], chunk[1][shared])
        touching[shared] = touching_neighbours(positions, faces, beside, tolerance)
        apart = [corners_of(positions, faces[panels[~shared]]) for panels in chunk]
        touching[~shared] = nearest(apart[0], apart[1])[0] <= tolerance
        found.append(np.stack(chunk, axis=-1)[touching])
    contacts = np.concatenate([np.empty((0, 2), np.int64), *found])
    return contacts[np.lexsort((contacts[:, 1], contacts[:, 0]))]


def overlap_depths(positions: Array, faces: Integers, pairs: Integers) -> Array:
    """How far panels reach into each other, for pairs (P, 2) of them (length).

    Parameters
    ----------
    positions, faces
        Vertices (V, 3), and corners (F, 4) of planar, convex panels, in order around each.
    pairs
        Numbers (P, 2) of panels.

    Returns
    -------
    Array
        By how much (P,) one of the two would have to be moved, at least, for them only to touch:
        0 where they touch or lie on each other.
    """

    def of(first: Integers, second: Integers) -> Array:
        return overlaps(corners_of(positions, faces[first]), corners_of(positions, faces[second]))

    return in_chunks(of, pairs[:, 0], pairs[:, 1])
