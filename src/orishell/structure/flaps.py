"""Flaps, which are no part of the mesh: what they weigh on it, what they keep apart."""

from __future__ import annotations

import numpy as np

from orishell.motion import Mechanism
from orishell.motion.grid import Grid, VertexPair
from orishell.motion.quads import area_vectors
from orishell.numerics.arrays import Array


def hung_area(flapped: Mechanism, grid: Grid, count: int) -> Array:
    """Area (count,) of flaps at nodes, half of every panel at each of the two that it hangs on.

    flapped: The sheet with its flaps.
    grid: That of the sheet without them, whose vertices are the first nodes.
    """
    hung = np.zeros(count)
    vertices, flat = grid.vertices(), flapped.positions(0.0)
    for panel, column in _columns(flapped, grid):
        sides = flat[:, panel], flat[:, panel + 1]
        corners = [sides[0][:-1], sides[0][1:], sides[1][1:], sides[1][:-1]]
        area = np.linalg.norm(area_vectors(np.stack(corners, axis=1)), axis=1)
        hung[vertices[:-1, column]] += 0.5 * area
        hung[vertices[1:, column]] += 0.5 * area
    return hung


def kept_apart(flapped: Mechanism, grid: Grid, before: int) -> tuple[VertexPair, ...]:
    """Vertices of the folding sheet that two neighbouring panels of a flap keep apart.

    before: Number of columns of folded flaps before the first column of the grid.
    """
    return tuple(
        ((row - 1, column + before), (row + 1, column + before))
        for _, column in _columns(flapped, grid)
        for row in range(1, grid.rows - 1)
    )


def _columns(flapped: Mechanism, grid: Grid) -> list[tuple[int, int]]:
    """Columns of panels that are flaps, and the column of the grid that each hangs on."""
    return [(panel, 0 if panel == 0 else grid.columns - 1) for panel in flapped.flap_columns]
