"""Whole boards as triangles: plates up to their creases, on hinges beside these.

Every board has nodes of its own, but along its hinges: there the nodes are on the axis, shared by
both boards, and the edges of their plates hang on them. Hinges take the middle of creases. So
nothing joins the corners of boards at a vertex.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.design.fittings import TRIMMED
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.structure.mesh.edge_forces import crease_sides
from orishell.structure.mesh.lines import triangle_corners
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import Offsets, SheetMesh, crease_places
from orishell.structure.mesh.triangle import Facets

ON_LINE = 1e-9
"""Lines are where hinges end to this share of a crease."""
LEAST_CELLS = 3
"""Fewer cells have no two nodes along the middle of a crease: no hinge, but a ball joint."""


@record
class HingedPlates:
    """Plates and the axes of the hinges between them."""

    corners: Array  # corners (F, 4, 3) of plates, half way up, in the order of a grid's panels
    # axes of hinges from end to end (E, 2, 3), edge by edge; those of the border are not used
    axes: Array
    # how high arms are (E, 2): on the first and the second board beside a hinge, those of a row
    # above and below it, of a column left and right; 0 where it lies on the face (length)
    arms: Array
    fins: Section | None = None  # the section of arms that give, None if arms are rigid
    trimmed: float = TRIMMED  # share of a crease that hinges leave out at either end


def mesh_boards(plates: HingedPlates, grid: Grid, cells: int) -> SheetMesh:
    """Mesh boards on hinges.

    Of the points the first are corners of boards, one at each vertex of the grid: that on which a
    shell stands there, and where ties are fixed (:class:`~orishell.deployment.fixings.Fixings`).
    Then come the other nodes of boards, those of hinges, and the points of plates on hinges.

    cells: Cells along every side of a board, at least :data:`LEAST_CELLS`.
    """
    lines = places_of_lines(cells)
    down, right = lines[:, None, None], lines[:, None]
    a, b, c, d = (each[:, None, None] for each in plates.corners.swapaxes(0, 1))
    at = (a * (1 - right) + d * right) * (1 - down) + (b * (1 - right) + c * right) * down
    at = at.reshape(-1, 3)

    edge, *sides = crease_places(grid, cells)
    hinged = np.minimum(lines, 1 - lines) >= max(plates.trimmed, lines[1]) - ON_LINE
    start, end = (each[:, None] for each in plates.axes[edge].swapaxes(0, 1))
    axes = start * (1 - lines[:, None]) + end * lines[:, None]
    gives = plates.fins is not None
    on_fins: Booleans = np.asarray(plates.arms[edge].any(axis=1)) & gives
    joined = hinged & ~on_fins[:, None]
    on_axes = axes[joined]

    fixed = _fixed_corners(grid, cells)
    nodes = np.full(len(at), -1)
    nodes[fixed] = np.arange(grid.vertex_count)
    numbers = np.arange(len(on_axes))
    both = np.stack([each[joined] for each in sides])
    nodes[both] = len(at)
    others = np.flatnonzero(nodes < 0)
    nodes[others] = grid.vertex_count + np.arange(len(others))
    nodes[both] = grid.vertex_count + len(others) + numbers
    arms = at[both] - on_axes
    points = np.concatenate([at[fixed], at[others], on_axes, *at[both]])

    count = grid.panel_count
    pattern = triangle_corners(cells)
    places = np.arange(len(at)).reshape(count, -1)[:, pattern].reshape(-1, 3)
    offsets = Offsets(
        nodes=nodes[both].ravel(),
        places=both.ravel(),
        arms=arms.reshape(-1, 3),
        lengths=_lengths(plates, edge, lines, hinged),
        axes=axes,
        heights=plates.arms[edge],
        feet=_feet(plates, grid, edge),
        on_fins=on_fins,
        fins=plates.fins,
    )
    mesh = SheetMesh(
        Facets(points, places), nodes.reshape(count, cells + 1, cells + 1), places, offsets
    )
    facets = Facets(points, mesh.seats.ravel()[places])
    return SheetMesh(facets, mesh.nodes, places, offsets)


def places_of_lines(cells: int) -> Array:
    """Lines (cells+1,) of nodes along a side, as shares of it, two of them where hinges end."""
    outer = max(1, cells // 4)
    ends = np.linspace(0, TRIMMED, outer + 1)
    middle = np.linspace(TRIMMED, 1 - TRIMMED, cells - 2 * outer + 1)
    return np.concatenate([ends, middle[1:], 1 - ends[-2::-1]])


def _fixed_corners(grid: Grid, cells: int) -> Integers:
    """Places (V,) of the corners at vertices where boards stand, and ties are fixed.

    They are those of the board below a vertex in the upper half, above one in the lower half; to
    the right of its column, to the left of the last one.
    """
    row, column = np.divmod(np.arange(grid.vertex_count), grid.columns)
    below, left = 2 * row >= grid.rows, column == grid.columns - 1
    panel = (row - below) * (grid.columns - 1) + column - left
    return np.asarray((panel * (cells + 1) + below * cells) * (cells + 1) + left * cells)


def _feet(plates: HingedPlates, grid: Grid, edge: Integers) -> Array:
    """From axes of hinges to the feet of arms (C, 2, 3), upright on both boards."""
    corners = plates.corners
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    _, sides = crease_sides(grid)
    beside = sides[..., 0]  # panels (C, 2)
    away = corners.mean(axis=1)[beside] - plates.axes[edge].mean(axis=1)[:, None]
    upright = normal[beside]
    sign = np.sign((away * upright).sum(axis=-1))
    return np.asarray((sign * plates.arms[edge])[..., None] * upright)


def _lengths(plates: HingedPlates, edge: Integers, lines: Array, hinged: Booleans) -> Array:
    """Length of hinge (C, cells+1) that every node stands for."""
    step = np.diff(lines) * (hinged[1:] & hinged[:-1])
    share = 0.5 * (np.append(0.0, step) + np.append(step, 0.0))
    first = int(hinged.argmax())
    share[[first, len(lines) - 1 - first]] += lines[first] - plates.trimmed
    axis = np.linalg.norm(plates.axes[edge, 1] - plates.axes[edge, 0], axis=1)
    return np.asarray(axis[:, None] * share)
