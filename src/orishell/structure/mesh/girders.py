"""Box girders: strips of panels that hang on panels above and below a row, and plates across them.

A strip's nodes along the line that it hangs on are those of the panel there, whose translations it
shares; its rotations are its own, so that it is hinged there, and the panel bends on through the
line. Both strips of a sleeve share the nodes of their common crease, and panels of a strip those of
the edges between them: there, too, they are hinged.

The upper strip is parallel to the panels below and has the cells across that these have between
their crease and their line, the lower one those of the panels above. So a plate across the box is
a grid of nodes: those on its four sides are the sheet's and the strips', likewise.
"""

from __future__ import annotations

import numpy as np

from orishell.motion.grid import Grid
from orishell.motion.sleeves import Q, R, Sleeve, W
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.lines import centres_of, triangle_corners
from orishell.structure.mesh.parts import MeshedPart, number_nodes
from orishell.structure.mesh.sheet import SheetMesh, mesh_panels
from orishell.structure.mesh.stops import Stops
from orishell.structure.mesh.triangle import Facets


def stops_of_sleeves(grid: Grid, sleeves: tuple[Sleeve, ...]) -> Stops:
    """Where strips of sleeves hang, by columns of this grid."""
    found = Stops.none(grid)
    for each in sleeves:
        found.up[each.row - 1, each.columns] = each.above
        found.down[each.row, each.columns] = each.below
    return found


def mesh_strips(
    sheet: SheetMesh, grid: Grid, sleeve: Sleeve, places: Array, first: int
) -> tuple[MeshedPart, MeshedPart]:
    """Mesh the upper and the lower strip of a sleeve.

    sheet: The mesh of the sheet, with lines of nodes where they hang.
    sleeve: Whose columns are those of this grid.
    places: Vertices (3, n, 3) of the sleeve.
    first: The number of the first node that only they have.
    """
    cells, points = sheet.nodes.shape[1] - 1, sheet.facets.points
    columns = np.arange(sleeve.columns.start, sleeve.columns.stop - 1)
    above = sheet.nodes[(sleeve.row - 1) * (grid.columns - 1) + columns]
    below = sheet.nodes[sleeve.row * (grid.columns - 1) + columns]
    upper_line = line_at(points[above[:, :, 0]], places[Q, :-1])
    lower_line = line_at(points[below[:, :, 0]], places[R, :-1])
    hung, hung_below = above[:, upper_line], below[:, lower_line]
    right = shares_along(points[hung])

    # Down a strip there are the shares of the edges that it is parallel to.
    down = [
        shares_along(np.concatenate([points[each[:, part, 0]], points[each[-1:, part, -1]]]))
        for each, part in ((below, np.s_[: lower_line + 1]), (above, np.s_[upper_line:]))
    ]
    strips = [
        mesh_panels(places[rows], Grid(2, len(columns) + 1), each[None], right)
        for rows, each in (([Q, W], down[0]), ([W, R], down[1]))
    ]
    upper, lower = (np.full(each.node_count, -1) for each in strips)
    upper[strips[0].nodes[:, 0]] = hung
    first = number_nodes(upper, first)
    lower[strips[1].nodes[:, -1]] = hung_below
    lower[strips[1].nodes[:, 0]] = upper[strips[0].nodes[:, -1]]
    number_nodes(lower, first)
    # Where their cells are beside those of the sheet: from the line to the crease, or back.
    beside = [
        _triangles_beside(cells, panels, rows)
        for panels, rows in (
            (
                (sleeve.row - 1) * (grid.columns - 1) + columns,
                upper_line + np.arange(lower_line) * (cells - upper_line) // lower_line,
            ),
            (
                sleeve.row * (grid.columns - 1) + columns,
                np.arange(cells - upper_line) * lower_line // (cells - upper_line),
            ),
        )
    ]
    one, other = (
        MeshedPart(own, nodes, near, centres_of(each[None], right))
        for own, nodes, near, each in zip(strips, (upper, lower), beside, down, strict=True)
    )
    return one, other


def mesh_across(
    sheet: SheetMesh,
    grid: Grid,
    sleeve: Sleeve,
    columns: Integers,
    strips: tuple[MeshedPart, MeshedPart],
) -> MeshedPart:
    """Mesh plates across a sleeve; nodes that only they have are not numbered yet, but -1.

    columns: The columns (G,) of vertices that they go from.
    strips: The upper and the lower strip of the sleeve.
    """
    count, across, row = len(columns), grid.columns - 1, sleeve.row
    left = np.where(columns == across, columns - 1, columns)
    side = np.where(columns == across, -1, 0)
    above, below = (sheet.nodes[r * across + left, :, side] for r in (row - 1, row))
    upper, lower = (_column(each, columns - sleeve.columns.start) for each in strips)
    tall, wide = lower.shape[1], upper.shape[1]  # nodes from x to q, and from x to r
    nodes = np.full((count, tall, wide), -1)
    nodes[:, :, 0], nodes[:, 0] = above[:, ::-1][:, :tall], below[:, :wide]
    nodes[:, -1], nodes[:, :, -1] = upper, lower[:, ::-1]
    points = sheet.facets.points
    x, q, r = (points[each] for each in (nodes[:, :1, :1], nodes[:, :, :1], nodes[:, :1]))
    places = q + r - x
    own = np.arange(nodes.size).reshape(nodes.shape)
    triangles = own.reshape(count, -1)[:, triangle_corners(tall - 1, wide - 1)].reshape(-1, 3)
    cells = sheet.nodes.shape[1] - 1
    near = 2 * ((row * across + left) * cells**2 + np.where(side < 0, cells - 1, 0))
    return MeshedPart(
        SheetMesh(Facets(places.reshape(-1, 3), triangles), own, triangles),
        nodes.ravel(),
        np.repeat(near, len(triangles) // count),
    )


def _column(strip: MeshedPart, columns: Integers) -> Integers:
    """Nodes (G, m+1) of the whole down the edges of columns of a strip."""
    nodes = strip.nodes[strip.own.nodes]
    last = columns == len(nodes)
    return np.asarray(nodes[columns - last, :, np.where(last, -1, 0)])


def line_at(edges: Array, ends: Array) -> int:
    """The line of nodes of edges (n, cells+1, 3) that is where points (n, 3) of these are."""
    away = np.linalg.norm(edges - ends[:, None], axis=-1).max(axis=0)
    return int(np.argmin(away))


def shares_along(lines: Array) -> Array:
    """Where points (k, n, 3) of straight lines are, as shares of these (k, n)."""
    away = np.linalg.norm(lines - lines[:, :1], axis=-1)
    return np.asarray(away / away[:, -1:])


def _triangles_beside(cells: int, panels: Integers, rows: Integers) -> Integers:
    """A triangle of a panel (T',) for each one of a strip, by rows (m,) of cells of the panels."""
    cell = (panels[:, None, None] * cells + rows[:, None]) * cells + np.arange(cells)
    return np.repeat(2 * cell.ravel(), 2)
