"""What boards have in common, as manifold3d finds it: proofs of contact are held against it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from orishell.motion import Mechanism
from orishell.motion.as_made import as_cut
from orishell.motion.boards import Boards
from orishell.motion.layout import points_of
from orishell.numerics.arrays import Array, Booleans, Integers

NOTHING = 1e-12
"""Overlap below this share of all boards' volume is none."""


def solids(corners: Array, boards: Boards) -> list[Any]:
    manifold3d = pytest.importorskip("manifold3d")
    triangles, there = boards.triangles()
    made = []
    for own, all_sides, kept in zip(corners, triangles, there, strict=True):
        used, sides = np.unique(all_sides[kept], return_inverse=True)
        points = own.reshape(-1, 3)[used]
        mesh = manifold3d.Mesh64(points, sides.reshape(-1, 3).astype(np.uint64))
        made.append(manifold3d.Manifold(mesh))
        assert made[-1].status() == manifold3d.Error.NoError
    return made


def beyond_a_face(corners: Array, pairs: Integers) -> Booleans:
    """Whether all of the second board lies beyond an upright side, top or bottom of the first."""
    first, second = (
        corners[each].reshape(len(pairs), corners.shape[1] * corners.shape[2], 3)
        for each in pairs.T
    )
    outline = corners[pairs[:, 0]][:, 0]
    up = np.cross(outline[:, 2] - outline[:, 0], outline[:, 3] - outline[:, 1])
    sides = np.cross(np.roll(outline, -1, axis=1) - outline, up[:, None])
    normals = np.concatenate([sides, up[:, None], -up[:, None]], axis=1)
    own = np.einsum("pnx,pcx->pnc", normals, first).max(axis=-1)
    other = np.einsum("pnx,pcx->pnc", normals, second).min(axis=-1)
    return np.asarray((other > own).any(axis=1))


def overlap(mechanism: Mechanism, boards: Boards, drive: float) -> float:
    """The largest common volume of two boards of different panels, relative to that of all."""
    cut = as_cut(mechanism)
    points = points_of(mechanism, drive)[cut.vertices]
    corners = boards.carried(cut.mesh.faces, cut.flat, points)
    made = solids(corners, boards)
    low, high = corners.min(axis=(1, 2)), corners.max(axis=(1, 2))
    near = ((low[:, None] < high) & (low < high[:, None])).all(axis=-1)
    near &= boards.panels[:, None] < boards.panels
    pairs = np.argwhere(near)
    pairs = pairs[~beyond_a_face(corners, pairs) & ~beyond_a_face(corners, pairs[:, ::-1])]
    common = [(made[a] ^ made[b]).volume() for a, b in pairs]
    return max(common, default=0.0) / float(boards.volumes().sum())
