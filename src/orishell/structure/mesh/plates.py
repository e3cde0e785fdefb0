"""Plates that stiffen a sheet: triangles between edges of its columns, hinged there.

A plate goes from a vertex along the edges of the column above and below. Along both its nodes are
those of the sheet, whose translations it shares; its rotations are its own, so that it is hinged
there, as panels are at creases. Inside it has nodes of its own. It is meshed as a quadrilateral is,
with the middle of its outer side as its fourth corner.
"""

from __future__ import annotations

import numpy as np

from orishell.motion.grid import Grid
from orishell.numerics.arrays import Integers
from orishell.structure.mesh.lines import triangle_corners
from orishell.structure.mesh.parts import MeshedPart, number_nodes
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.mesh.triangle import Facets

LEAST_STANDING = 3
"""Fewer cells along edges of panels have no line of nodes on either side of their middle."""


def mesh_plates(sheet: SheetMesh, grid: Grid, at: Integers, line: int) -> MeshedPart:
    """Mesh plates that go from vertices.

    sheet: The mesh of the sheet, with a line of nodes where they end.
    at: Rows and columns (G, 2) of the vertices, none of them in the first or the last row.
    line: Which line of nodes that is, counted from the vertex.
    """
    up, down = _along_edges(sheet, grid, at)
    sides = up[:, : line + 1], down[:, : line + 1]
    points = sheet.facets.points
    x, q, r = points[up[:, 0]], points[up[:, line]], points[down[:, line]]
    first, second = (
        np.linalg.norm(points[side] - x[:, None], axis=-1)
        / np.linalg.norm(end - x, axis=-1)[:, None]
        for side, end in zip(sides, (q, r), strict=True)
    )
    d, e = first[:, :, None, None], second[:, None, :, None]
    x, q, r = (each[:, None, None] for each in (x, q, r))
    places = (
        x * (1 - d) * (1 - e) + q * d * (1 - e) + 0.5 * (q + r) * d * e + r * (1 - d) * e
    )  # (G, line+1, line+1, 3)

    count, size = len(at), (line + 1) ** 2
    own = np.arange(count * size).reshape(count, line + 1, line + 1)
    triangles = own.reshape(count, -1)[:, triangle_corners(line)].reshape(-1, 3)
    mesh = SheetMesh(Facets(places.reshape(-1, 3), triangles), own, triangles)

    nodes = np.full(own.shape, -1)
    nodes[:, :, 0], nodes[:, 0] = sides
    flat = nodes.ravel()
    number_nodes(flat, sheet.node_count)
    beside = np.repeat(_triangles_beside(sheet, grid, at), len(triangles) // count)
    return MeshedPart(mesh, flat, beside, straight=own[:, -1, -1])


def _along_edges(sheet: SheetMesh, grid: Grid, at: Integers) -> tuple[Integers, Integers]:
    """Nodes (G, cells+1) of the edges of columns from vertices upwards, and downwards."""
    row, column = at.T
    last = column == grid.columns - 1
    below = row * (grid.columns - 1) + column - last
    above = below - (grid.columns - 1)
    left, right = sheet.nodes[:, :, 0], sheet.nodes[:, :, -1]
    up, down = (np.where(last[:, None], right[panel], left[panel]) for panel in (above, below))
    return up[:, ::-1], down


def _triangles_beside(sheet: SheetMesh, grid: Grid, at: Integers) -> Integers:
    """Triangles (G,) of panels at vertices."""
    row, column = at.T
    last = column == grid.columns - 1
    panel, cells = row * (grid.columns - 1) + column - last, sheet.nodes.shape[1] - 1
    return np.asarray(2 * (panel * cells**2 + np.where(last, cells - 1, 0)))
