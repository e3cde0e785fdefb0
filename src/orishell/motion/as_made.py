"""How a sheet is made: as one flat sheet, or as flat strips that are joined on site.

A mechanism that is flat at drive 0 is cut from one sheet, and so is one row of panels: a strip of
quadrilaterals, each beside the next, can always be laid flat. Any other is made of its columns of
panels. Strips are joined along hinges, where each has vertices of its own: first those of the grid,
by their numbers, then the right sides of all strips that have another beside them.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.motion.layout import Layout, mesh_of, points_of
from orishell.motion.mechanism import Mechanism
from orishell.motion.mesh import QuadMesh, build_mesh
from orishell.motion.quads import is_level, lengths, unit_normals
from orishell.numerics.arrays import Array, Integers

APART = 0.25
"""Room between two strips, as a share of the mean width of strips."""


@record
class AsMade:
    """Panels of a mechanism as they are cut."""

    mesh: QuadMesh
    flat: Array  # vertices (V, 2)
    vertices: Integers  # their numbers (V,) in the mechanism
    edges: Integers  # numbers (E,) of edges in the mechanism
    is_one_sheet: bool = False  # whether all panels are joined as they fold


def as_cut(mechanism: Mechanism) -> AsMade:
    """The sheet of a mechanism, or its strips where it is none."""
    flat, mesh = laid_flat(mechanism), mesh_of(mechanism)
    if flat is None:
        return in_strips(mechanism)
    return AsMade(mesh, flat, np.arange(len(flat)), np.arange(len(mesh.edges)), is_one_sheet=True)


def laid_flat(mechanism: Mechanism) -> Array | None:
    """Vertices (V, 2) of a mechanism that is cut from one sheet; None if it is made in strips."""
    points = points_of(mechanism, 0.0)
    if is_level(points):
        return points[:, :2]
    if mechanism.grid.rows > 2:
        return None
    # As a column it goes down with its first row at the left.
    column = mechanism.positions(0.0).swapaxes(0, 1)
    sides = np.concatenate(_laid_side_by_side(column, slice(0, 1)), axis=1).swapaxes(0, 1)
    return -sides[..., ::-1].reshape(-1, 2)


def in_strips(mechanism: Mechanism) -> AsMade:
    """The columns of panels of a mechanism, each a strip by itself, side by side."""
    grid = mechanism.grid
    left, right = sides_of_strips(mechanism)
    vertices = grid.vertices()
    # The left sides of strips are the grid's columns but the last, whose right side that is.
    of_right = grid.vertex_count + np.arange(grid.rows * (grid.columns - 2)).reshape(grid.rows, -1)
    sides = vertices[:, :-1], np.concatenate([of_right, vertices[:, -1:]], axis=1)
    corners = [sides[0][:-1], sides[0][1:], sides[1][1:], sides[1][:-1]]
    own = np.concatenate([vertices.ravel(), vertices[:, 1:-1].ravel()])
    flat = np.empty((len(own), 2))
    for numbers, places in zip(sides, (left, right), strict=True):
        flat[numbers] = places
    mesh = build_mesh(np.stack(corners, axis=-1).reshape(-1, 4), len(own))
    return AsMade(mesh, flat, own, _edges_of(grid, own[mesh.edges]))


def sheet_sides(mechanism: Mechanism) -> tuple[float, float, int]:
    """Sides of the sheet that a mechanism is cut from, and the number of strips.

    That is 0 where it is one flat sheet; else width and height are those of the largest strip.
    """
    points = points_of(mechanism, 0.0)
    if is_level(points):
        width, height = np.ptp(points[:, :2], axis=0).tolist()
        return width, height, 0
    sides = np.stack(sides_of_strips(mechanism), axis=1)
    width, height = np.ptp(sides, axis=(0, 1)).max(axis=0).tolist()
    return width, height, mechanism.grid.columns - 1


def panels_laid_flat(mechanism: Mechanism) -> Array:
    """Corners (F, 4, 2) of all panels of a mechanism as they are cut, counter-clockwise.

    Where flaps are left out the others lie where they lay. What strips carry lies panel by panel.
    """
    flat, faces = laid_flat(mechanism), Layout.of(mechanism).faces
    if flat is not None:
        return flat[faces]
    left, right = sides_of_strips(mechanism)
    corners = np.stack([left[:-1], left[1:], right[1:], right[:-1]], axis=2).reshape(-1, 4, 2)
    return np.concatenate([corners, _each_alone(points_of(mechanism, 0.0)[faces[len(corners) :]])])


def sides_of_strips(mechanism: Mechanism) -> tuple[Array, Array]:
    """Left and right vertices (rows, columns-1, 2) of all columns of panels as they are cut."""
    positions = mechanism.positions(0.0)
    if is_level(positions):
        return positions[:, :-1, :2], positions[:, 1:, :2]
    inner = mechanism.inner_columns
    return _laid_side_by_side(positions, slice(inner.start, inner.stop - 1))


def _each_alone(corners: Array) -> Array:
    """Corners (F, 4, 2) of panels (F, 4, 3) in their planes, each from its first corner on."""
    local = corners - corners[:, :1]
    x = local[:, 1] / lengths(local[:, 1])[:, None]
    axes = np.stack([x, np.cross(unit_normals(corners), x)], axis=-1)
    return np.asarray(local @ axes)


def _edges_of(grid: Grid, ends: Integers) -> Integers:
    """Numbers (E,) of a grid's edges by their vertices (E, 2), in any order."""
    count = grid.vertex_count
    known, asked = (np.sort(each, axis=1) @ [count, 1] for each in (grid.edges_vertices(), ends))
    order = np.argsort(known)
    return np.asarray(order[np.searchsorted(known, asked, sorter=order)])


def _laid_side_by_side(positions: Array, inner: slice) -> tuple[Array, Array]:
    """Left and right vertices (rows, columns-1, 2) of all strips, laid flat beside one another.

    Places are told from the ``inner`` strips, those that are no flaps.

    In the panel at (i, j), with x along its upper side, the next upper side begins at d and lies
    along r; so from strip to strip all is a running product of turns, and a running sum.
    """
    first, second = positions[:, :-1], positions[:, 1:]
    upper = second - first
    width = lengths(upper)
    along = upper / width[..., None]
    down = first[1:] - first[:-1]
    x = (down * along[:-1]).sum(axis=-1)
    across = down - x[..., None] * along[:-1]
    y = lengths(across)
    across /= y[..., None]
    turn = (along[1:] * along[:-1]).sum(axis=-1) - 1j * (along[1:] * across).sum(axis=-1)
    turn /= np.abs(turn)
    ones = np.ones((1, turn.shape[1]))
    turned = np.concatenate([ones, np.cumprod(turn, axis=0)])
    steps = turned[:-1] * (x - 1j * y)
    left = np.concatenate([0 * ones, np.cumsum(steps, axis=0)])
    right = left + turned * width
    # Strips hang down from their upper ends, the first at the left.
    ends = 0.5 * (left[-1] + right[-1] - left[0] - right[0])
    upright = -1j * np.abs(ends) / ends
    left, right = left * upright, right * upright
    both = np.stack([left, right])
    low, high = both.real.min(axis=(0, 1)), both.real.max(axis=(0, 1))
    room = APART * float(np.mean((high - low)[inner]))
    stops = np.cumsum(high - low + room)
    place = stops - stops[: inner.start][-1:].sum() - high - both.imag.max(axis=(0, 1)) * 1j
    left, right = left + place, right + place
    return np.stack([left.real, left.imag], axis=-1), np.stack([right.real, right.imag], axis=-1)
