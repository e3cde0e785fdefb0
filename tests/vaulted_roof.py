"""A vault of 8 by 4 flat panels over [-2, 2] x [-1.5, 1.5], for files of meshes.

Its area does not depend on how its panels are cut into triangles, and its coordinates are exact in
single precision.
"""

from __future__ import annotations

from typing import Any

import numpy as np

COLUMNS, ROWS = 8, 4
X, Y = np.meshgrid(np.linspace(-2, 2, COLUMNS + 1), np.linspace(-1.5, 1.5, ROWS + 1))
POINTS = np.stack([X, Y, 1.25 - 0.1875 * X**2], axis=-1).reshape(-1, 3)
NUMBERS = np.arange(len(POINTS)).reshape(ROWS + 1, COLUMNS + 1)
QUADS = np.stack(
    [NUMBERS[:-1, :-1], NUMBERS[:-1, 1:], NUMBERS[1:, 1:], NUMBERS[1:, :-1]], -1
).reshape(-1, 4)
TRIANGLES = np.concatenate([QUADS[:, :3], QUADS[:, [0, 2, 3]]])
MIXED = [q.tolist() for q in QUADS[:-1]] + [QUADS[-1, :3].tolist(), QUADS[-1, [0, 2, 3]].tolist()]
"""Mostly quadrilaterals, and two triangles."""
AREA = float(3 * np.hypot(np.diff(POINTS[:9, 0]), np.diff(POINTS[:9, 2])).sum())

Files = dict[str, bytes]


def _hexagons() -> list[list[int]]:
    """Panels above each other, which lie in one plane, two and two as polygons of six."""
    faces = [quad.tolist() for quad in QUADS]
    along = [faces[8 * k : 8 * k + 8] for k in range(ROWS)]
    return [
        [low[0], low[1], low[2], high[2], high[3], low[3]]
        for low, high in zip(along[0] + along[2], along[1] + along[3], strict=True)
    ]


HEXAGONS = _hexagons()


def np_lists(faces: Any) -> list[list[int]]:
    return [list(map(int, face)) for face in faces]
