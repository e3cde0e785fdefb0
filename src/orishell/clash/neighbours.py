"""Panels that share vertices, in one state: folded onto each other, or crossing at a vertex.

For states by themselves; along a path the fold angles say it (docs/theory/locking-and-clash.md).
"""

from __future__ import annotations

import numpy as np

from orishell.clash.broad_phase import Pairs
from orishell.motion.quads import dots, lengths, unit_normals
from orishell.numerics.arrays import Array, Booleans, Integers


def touching_neighbours(points: Array, faces: Integers, pairs: Pairs, tolerance: float) -> Booleans:
    """Return which pairs (P,) of panels with common vertices touch beyond these.

    Panels with a common crease touch when it is folded flat. Panels with one common vertex touch
    when the arcs that they cut from a sphere about it meet.

    Parameters
    ----------
    points
        Vertices (V, 3).
    faces
        Corners (F, 4) of all panels.
    pairs
        The panels.
    tolerance
        Distance at which panels count as touching (length).
    """
    first, second = faces[pairs[0]], faces[pairs[1]]
    same = first[:, :, None] == second[:, None, :]
    count = same.sum(axis=(1, 2))
    touching: Booleans = count > 2
    crease, corner = count == 2, count == 1
    touching[crease] = _folded_flat(points, first[crease], second[crease], same[crease], tolerance)
    touching[corner] = _crossing(points, first[corner], second[corner], same[corner], tolerance)
    return touching


def _folded_flat(
    points: Array, first: Integers, second: Integers, same: Booleans, tolerance: float
) -> Booleans:
    """Whether the far corners of one panel lie on the plane of the other, on its side."""
    if not len(first):
        return np.zeros(0, np.bool_)
    a, b = points[first], points[second]
    on_a, on_b = same.any(axis=2), same.any(axis=1)
    shared = a[on_a].reshape(-1, 2, 3)
    along = _unit(shared[:, 1] - shared[:, 0])
    far_a, far_b = (
        corners[~on].reshape(-1, 2, 3) - shared[:, :1] for corners, on in ((a, on_a), (b, on_b))
    )
    height = np.abs(dots(unit_normals(a)[:, None], far_b)).max(axis=1)
    # Parts of the far corners square to the crease point the same way.
    sides = [far.sum(axis=1) for far in (far_a, far_b)]
    across = [side - along * dots(side, along)[:, None] for side in sides]
    result: Booleans = (height <= tolerance) & (dots(across[0], across[1]) > 0)
    return result


def _crossing(
    points: Array, first: Integers, second: Integers, same: Booleans, tolerance: float
) -> Booleans:
    """Whether the edges of one panel at the common vertex lie on both sides of the other."""
    if not len(first):
        return np.zeros(0, np.bool_)
    rows = np.arange(len(first))
    of_first, of_second = np.divmod(same.reshape(len(first), 16).argmax(axis=1), 4)
    vertex = points[first[rows, of_first]]

    def arms(faces: Integers, at: Integers) -> tuple[Array, Array]:
        return (
            points[faces[rows, (at + 1) % 4]] - vertex,
            points[faces[rows, (at - 1) % 4]] - vertex,
        )

    a, b = arms(first, of_first), arms(second, of_second)
    normal_a, normal_b = _unit(np.cross(*a)), _unit(np.cross(*b))
    over_a = [dots(normal_a, arm) for arm in b]
    over_b = [dots(normal_b, arm) for arm in a]
    line = np.cross(normal_a, normal_b)
    facing = dots(line, _unit(a[0]) + _unit(a[1])) * dots(line, _unit(b[0]) + _unit(b[1]))
    result = _straddle(over_a, tolerance) & _straddle(over_b, tolerance) & (facing > 0)
    for arm, height in zip(b, over_a, strict=True):
        result |= (np.abs(height) <= tolerance) & _between(a, normal_a, arm)
    for arm, height in zip(a, over_b, strict=True):
        result |= (np.abs(height) <= tolerance) & _between(b, normal_b, arm)
    return result


def _straddle(heights: list[Array], tolerance: float) -> Booleans:
    low, high = np.minimum(*heights), np.maximum(*heights)
    result: Booleans = (low < -tolerance) & (high > tolerance)
    return result


def _between(arms: tuple[Array, Array], normal: Array, vector: Array) -> Booleans:
    """Whether a vector near the plane of two arms lies in the sector between them."""
    small = 1e-12 * lengths(vector)
    result: Booleans = (dots(np.cross(_unit(arms[0]), vector), normal) > small) & (
        dots(np.cross(vector, _unit(arms[1])), normal) > small
    )
    return result


def _unit(vectors: Array) -> Array:
    length = lengths(vectors)[..., None]
    return np.asarray(vectors / np.where(length > 0, length, 1.0))
