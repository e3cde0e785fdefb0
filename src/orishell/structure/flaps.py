"""Flaps, which are no part of the mesh: what they weigh on it, what they keep apart."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.motion import Mechanism
from orishell.motion.boards import Boards
from orishell.motion.grid import Grid, VertexPair
from orishell.motion.layout import SlitFlaps
from orishell.motion.quads import area_vectors
from orishell.numerics.arrays import Array


def hung_area(flapped: Mechanism, grid: Grid, count: int) -> Array:
    """Area (count,) of flaps at nodes, half of every panel at each of the two that it hangs on.

    Slit flaps hang on a part of an edge: on its two ends by the lever rule.

    flapped: The sheet with its flaps.
    grid: That of the sheet without them, whose vertices are the first nodes.
    """
    hung = np.zeros(count)
    if isinstance(flapped, SlitFlaps):
        _hang_slit(hung, flapped)
        return hung
    vertices, flat = grid.vertices(), flapped.positions(0.0)
    for panel, column in _columns(flapped, grid):
        sides = flat[:, panel], flat[:, panel + 1]
        corners = [sides[0][:-1], sides[0][1:], sides[1][1:], sides[1][:-1]]
        area = np.linalg.norm(area_vectors(np.stack(corners, axis=1)), axis=1)
        hung[vertices[:-1, column]] += 0.5 * area
        hung[vertices[1:, column]] += 0.5 * area
    return hung


def between_flaps(boards: Boards, folding: Grid, grid: Grid, before: int) -> Boards:
    """Those of the boards of a folding sheet that are between its flaps, by panels of that grid.

    before: Number of columns of folded flaps before the first column of the grid.
    """
    # Boards of folded flaps are numbered with the sheet, or behind it.
    row, column = np.divmod(boards.panels, folding.columns - 1)
    column = column - before
    own = (row < folding.rows - 1) & (column >= 0) & (column < grid.columns - 1)
    chosen = boards.chosen(own)
    return replace(chosen, panels=row[own] * (grid.columns - 1) + column[own])


def kept_apart(flapped: Mechanism, grid: Grid, before: int) -> tuple[VertexPair, ...]:
    """Vertices of the folding sheet that two neighbouring panels of a flap keep apart.

    Flaps that are folded flat upon each other close no further. So the row crease that ends between
    them does not, which is folded by as much as the vertices above and below it are near.

    before: Number of columns of folded flaps before the first column of the grid.
    """
    if isinstance(flapped, SlitFlaps):
        layout = flapped.layout
        at = layout.names[layout.pairs[:, 0]].tolist()
        ends = [(upper // 2, before + (0 if column < 0 else column)) for upper, column in at]
        return tuple(((row, column), (row + 2, column)) for row, column in ends)
    return tuple(
        ((row - 1, column + before), (row + 1, column + before))
        for _, column in _columns(flapped, grid)
        for row in range(1, grid.rows - 1)
    )


def _hang_slit(hung: Array, flapped: SlitFlaps) -> None:
    """Hang slit flaps on the ends of the edges of the border that they are hinged to."""
    layout, flat = flapped.layout, flapped.points(0.0)
    ends = np.array([layout.between(*pair) for pair in layout.hinges.tolist()])
    middle = flat[ends].mean(axis=1)
    areas = np.linalg.norm(area_vectors(flat[layout.faces[layout.hinges[:, 0]]]), axis=1)
    for flap, (_, panel) in enumerate(layout.hinges.tolist()):
        corners = layout.faces[panel]
        sides = np.stack([corners, np.roll(corners, -1)], axis=-1)
        start, way = flat[sides[:, 0]], flat[sides[:, 1]] - flat[sides[:, 0]]
        share = ((middle[flap] - start) * way).sum(axis=1) / (way**2).sum(axis=1)
        off = np.linalg.norm(start + share[:, None] * way - middle[flap], axis=1)
        side = int(off.argmin())
        hung[sides[side]] += areas[flap] * np.array([1 - share[side], share[side]])


def _columns(flapped: Mechanism, grid: Grid) -> list[tuple[int, int]]:
    """Columns of panels that are flaps, and the column of the grid that each hangs on."""
    return [(panel, 0 if panel == 0 else grid.columns - 1) for panel in flapped.flap_columns]
