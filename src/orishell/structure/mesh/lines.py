"""Lines of nodes in meshed panels, and the cells and triangles between them.

Each line is straight in a panel. Where lines are is said as shares of the way down both edges of
columns, and across.
"""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.stops import Stops

GRADING = 0.6
"""Cells at creases are narrower than those of a uniform mesh by this share, in the limit of many;
those in the middle are wider by it, of panels that are as long as wide."""


def lines_of(
    positions: Array, cells: int, grading: float, stops: Stops | None
) -> tuple[Array, Array]:
    """Lines of nodes, as shares down every edge of a column, and across every column of panels.

    (rows - 1, columns, cells+1) and (columns - 1, cells+1). Panels that share a crease have the
    same there. Along the longer sides of panels cells differ less: those in the middle would be as
    long as waves of buckling.
    """
    tall = np.linalg.norm(np.diff(positions, axis=0), axis=-1).mean(axis=1)
    wide = np.linalg.norm(np.diff(positions, axis=1), axis=-1).mean(axis=0)
    even = np.linspace(0, 1, cells + 1)
    wave = np.sin(2 * np.pi * even) / (2 * np.pi)
    down, right = (
        even - grading * np.minimum(1.0, other.mean() / own)[:, None] * wave
        for own, other in ((tall, wide), (wide, tall))
    )
    if stops is None:
        return np.repeat(down[:, None], len(wide) + 1, axis=1), right
    return stops.moved(down), right


def lines_down(positions: Array, cells: int, stops: Stops | None = None) -> Array:
    """Lines of nodes (rows - 1, columns, cells+1) of a sheet, as shares down edges of columns."""
    return lines_of(positions, cells, GRADING, stops)[0]


def centres(positions: Array, cells: int, stops: Stops | None = None) -> Array:
    """Middles (F, 2 cells^2, 2) of the panels' triangles, as shares of the way down and across."""
    return centres_of(*lines_of(positions, cells, GRADING, stops))


def centres_of(down: Array, right: Array) -> Array:
    """Middles (F, 2 m n, 2) of panels' triangles, likewise, by lines of nodes.

    down, right: As of :func:`mesh_panels`.
    """
    first, last, across = (each[..., 0] for each in by_panel(down, right))
    along = first[:, :, None] * (1 - across) + last[:, :, None] * across
    places = np.stack(np.broadcast_arrays(along, across), axis=-1)
    pattern = triangle_corners(down.shape[2] - 1, right.shape[1] - 1)
    corners = places.reshape(len(places), -1, 2)[:, pattern]
    return np.asarray(corners.mean(axis=2))


def by_panel(down: Array, right: Array) -> tuple[Array, Array, Array]:
    """Shares of panels' left and right edges (F, m+1, 1), and across (F, 1, n+1, 1)."""
    tall, wide = down.shape[2], right.shape[1]
    first, last = (each.reshape(-1, tall, 1) for each in (down[:, :-1], down[:, 1:]))
    across = np.broadcast_to(right, (len(down), *right.shape)).reshape(-1, 1, wide, 1)
    return first, last, across


def cells_of(down: int, right: int) -> Integers:
    """Corners (down * right, 4) of the cells of a panel, downwards and to the right."""
    node = np.arange((down + 1) * (right + 1)).reshape(down + 1, right + 1)
    around = (node[:-1, :-1], node[1:, :-1], node[1:, 1:], node[:-1, 1:])
    return np.stack([each.ravel() for each in around], axis=1)


def triangle_corners(down: int, right: int | None = None) -> Integers:
    """Corners (2 down * right, 3) of the triangles of a panel: two of each cell, one by one.

    Cells are cut from the side of the panel's corners towards its middle, so that an even number of
    them is as symmetric as the panel. There are as many cells across as ``down`` without ``right``.
    """
    across = down if right is None else right
    a, b, c, d = cells_of(down, across).T
    low, late = np.arange(down) >= down / 2, np.arange(across) >= across / 2
    outwards = (low[:, None] == late).ravel()[:, None]
    first = np.where(outwards, np.stack([a, b, c], axis=1), np.stack([a, b, d], axis=1))
    second = np.where(outwards, np.stack([a, c, d], axis=1), np.stack([b, c, d], axis=1))
    return np.stack([first, second], axis=1).reshape(-1, 3)
