"""Boards: what is left of panels between their set-backs."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from orishell.conventions.formatting import in_one_line
from orishell.errors import DesignError
from orishell.numerics.arrays import Array
from orishell.sheet.grid import Grid
from orishell.solids.setbacks import SetBacks

INSIDE = 1e-12
"""A corner counts as inside an edge up to this share of the panel's size."""


@dataclass(frozen=True, slots=True, eq=False)
class Boards:
    """The boards on one face of the sheet.

    Parameters
    ----------
    corners
        Corners (F, 4, 2) of the board of every panel in the flat sheet, counter-clockwise seen from
        +z. A board with three corners has one of them twice (length).
    """

    corners: Array

    __repr__ = in_one_line

    def areas(self) -> Array:
        """Area (F,) of every board."""
        return _areas(self.corners)


def cut_boards(flat: Array, grid: Grid, set_backs: SetBacks) -> tuple[Boards, Boards]:
    """The boards on the upper and the lower face of a sheet.

    Parameters
    ----------
    flat
        Vertices (rows, columns, 3) of the flat sheet.
    grid
        Its grid.
    set_backs
        How far boards stand back from the edges.

    Raises
    ------
    DesignError
        If nothing is left of a panel.
    """
    panels = flat.reshape(-1, 3)[grid.faces_vertices(), :2]
    edges = grid.faces_edges()
    top, bottom = (
        Boards(_inset(panels, distance[edges], grid))
        for distance in (set_backs.top, set_backs.bottom)
    )
    return top, bottom


def _inset(panels: Array, distance: Array, grid: Grid) -> Array:
    """Corners (F, 4, 2) of what is left of convex panels (F, 4, 2) whose edges move inwards.

    Its corners are those of the six intersections of two edges that no other edge cuts off.
    """
    along = np.roll(panels, -1, axis=1) - panels
    inward = np.stack([-along[..., 1], along[..., 0]], axis=-1)
    inward /= np.hypot(inward[..., 0], inward[..., 1])[..., None]
    level = (inward * panels).sum(axis=-1) + distance
    size = np.abs(along).max(axis=(1, 2))

    crossings = []
    for first, second in combinations(range(4), 2):
        a, b = inward[:, first], inward[:, second]
        area = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
        area = np.where(np.abs(area) > INSIDE, area, np.nan)
        p, q = level[:, first], level[:, second]
        crossings.append(
            np.stack([p * b[:, 1] - q * a[:, 1], q * a[:, 0] - p * b[:, 0]], axis=-1)
            / area[:, None]
        )
    points = np.stack(crossings, axis=1)
    over = (points[:, :, None] * inward[:, None]).sum(axis=-1) - level[:, None]
    kept = (over > -INSIDE * size[:, None, None]).all(axis=-1)
    return _in_order(points, kept, grid)


def _in_order(points: Array, kept: Array, grid: Grid) -> Array:
    """Four corners (F, 4, 2), counter-clockwise, of those kept of points (F, 6, 2)."""
    few = kept.sum(axis=1) < 3
    if few.any():
        row, column = divmod(int(few.argmax()), grid.columns - 1)
        raise DesignError(
            "boards of this thickness leave nothing of a panel",
            place=f"of panel [{row}, {column}]",
        )
    middle = np.where(kept[..., None], points, 0.0).sum(axis=1) / kept.sum(axis=1)[:, None]
    turn = np.arctan2(*np.moveaxis(points - middle[:, None], -1, 0)[::-1])
    order = np.argsort(np.where(kept, turn, np.inf), axis=1)[:, :4]
    corners = np.take_along_axis(points, order[..., None], axis=1)
    there = np.take_along_axis(kept, order, axis=1)
    return np.where(there[..., None], corners, corners[:, :1])


def _areas(corners: Array) -> Array:
    p, q, r, s = (corners[:, k] for k in range(4))
    u, v = r - p, s - q
    return np.asarray(0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]))
