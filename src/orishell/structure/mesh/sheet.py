"""The shell as triangles: every panel meshed, panels tied along their creases.

Panels that share a crease have its translations in common; rotations are every panel's own, so that
creases are free hinges until springs are put on them.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.elements import Elements
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.triangle import Facets

CELLS = 4
"""Cells along every side of a panel, of two triangles each."""


@record
class SheetMesh:
    """A meshed shell."""

    facets: Facets  # its nodes (N) and triangles
    nodes: Integers  # nodes (F, cells+1, cells+1) of every panel, downwards and to the right
    # corners (T, 3) of every triangle, as places among all nodes of all panels one after the other
    places: Integers

    @property
    def count(self) -> int:
        """Number of dofs: translations of all nodes, then rotations."""
        return 3 * len(self.facets.points) + 3 * self.nodes.size

    @property
    def panels(self) -> Integers:
        """The panel (T,) of every triangle."""
        return np.repeat(np.arange(len(self.nodes)), len(self.places) // len(self.nodes))

    def cells(self) -> Integers:
        """Nodes (T/2, 4) around every cell; its triangles are numbers 2 k and 2 k + 1."""
        size = self.nodes.shape[1] - 1
        return np.asarray(self.nodes.reshape(len(self.nodes), -1)[:, _cells(size)].reshape(-1, 4))

    def translations(self) -> Integers:
        """Dofs (N, 3) of the displacements of nodes."""
        return np.arange(3 * len(self.facets.points)).reshape(-1, 3)

    def rotations(self) -> Integers:
        """Dofs (F, cells+1, cells+1, 3) of the panels' rotations at their nodes."""
        first = 3 * len(self.facets.points)
        return np.asarray(first + np.arange(3 * self.nodes.size).reshape(*self.nodes.shape, 3))

    def elements(self, section: Section) -> Elements:
        """Its triangles as elements."""
        return self.facets.elements(section, self.dofs(), self.count)

    def dofs(self) -> Integers:
        """Dofs (T, 18) of the corners of every triangle: translations, then rotations."""
        translations = self.translations()[self.facets.triangles]
        rotations = self.rotations().reshape(-1, 3)[self.places]
        return np.concatenate([translations, rotations], axis=-1).reshape(-1, 18)


def mesh_sheet(positions: Array, grid: Grid, cells: int = CELLS) -> SheetMesh:
    """Mesh the panels of a folded state.

    positions: Vertices (rows, columns, 3).
    cells: Cells along every side of a panel, at least 1.
    """
    faces, edges = grid.faces_vertices(), grid.faces_edges()
    nodes = _nodes(grid, faces, edges, cells)
    corners = positions.reshape(-1, 3)[faces]
    down, right = (
        each.ravel()[None, :, None]
        for each in np.meshgrid(*[np.linspace(0, 1, cells + 1)] * 2, indexing="ij")
    )
    top = corners[:, None, 0] * (1 - right) + corners[:, None, 3] * right
    bottom = corners[:, None, 1] * (1 - right) + corners[:, None, 2] * right
    points = np.empty((int(nodes.max()) + 1, 3))
    points[nodes.reshape(len(faces), -1)] = top * (1 - down) + bottom * down

    pattern = _triangles(cells)
    flat = nodes.reshape(len(faces), -1)
    triangles = flat[:, pattern].reshape(-1, 3)
    places = np.arange(flat.size).reshape(flat.shape)[:, pattern].reshape(-1, 3)
    return SheetMesh(Facets(points, triangles), nodes, places)


def _cells(cells: int) -> Integers:
    """Corners (cells^2, 4) of the cells of a panel, downwards and to the right."""
    node = np.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    around = (node[:-1, :-1], node[1:, :-1], node[1:, 1:], node[:-1, 1:])
    return np.stack([each.ravel() for each in around], axis=1)


def _triangles(cells: int) -> Integers:
    """Corners (2 cells^2, 3) of the triangles of a panel: two of each cell, one after the other.

    Cells are cut from the side of the panel's corners towards its middle, so that an even number of
    them is as symmetric as the panel.
    """
    a, b, c, d = _cells(cells).T
    late = np.arange(cells) >= cells / 2
    outwards = (late[:, None] == late).ravel()[:, None]
    first = np.where(outwards, np.stack([a, b, c], axis=1), np.stack([a, b, d], axis=1))
    second = np.where(outwards, np.stack([a, c, d], axis=1), np.stack([b, c, d], axis=1))
    return np.stack([first, second], axis=1).reshape(-1, 3)


def _nodes(grid: Grid, faces: Integers, edges: Integers, cells: int) -> Integers:
    """Nodes (F, cells+1, cells+1): vertices first, then those inside edges, then inside panels."""
    between = np.arange(cells - 1)
    on_edges = grid.vertex_count + (cells - 1) * edges[..., None] + between
    first = grid.vertex_count + (cells - 1) * len(grid.edges_vertices())
    inside = first + np.arange(len(faces) * (cells - 1) ** 2)
    nodes = np.empty((len(faces), cells + 1, cells + 1), np.int64)
    nodes[:, [0, -1, -1, 0], [0, 0, -1, -1]] = faces
    nodes[:, 1:-1, 0], nodes[:, -1, 1:-1] = on_edges[:, 0], on_edges[:, 1]
    nodes[:, 1:-1, -1], nodes[:, 0, 1:-1] = on_edges[:, 2], on_edges[:, 3]
    nodes[:, 1:-1, 1:-1] = inside.reshape(len(faces), cells - 1, cells - 1)
    return nodes
