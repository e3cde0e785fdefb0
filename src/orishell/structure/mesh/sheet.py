"""The shell as triangles: every panel meshed, panels tied along their creases.

Panels that share a crease have its translations in common; rotations are every panel's own, so that
creases are free hinges until springs are put on them.

Where hinges are beside the creases, what is common are the translations u of the hinge. A point of
a plate that is r away from it hangs on it rigidly, and turns with the rotation t of its panel:

    u + t x r.

So dofs are those of a sheet that is hinged in its creases, and a corner's share of an element's
matrix is changed by one matrix on either side: exactly, without a penalty.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.structure.mesh.elements import Elements
from orishell.structure.mesh.lines import GRADING, by_panel, cells_of, lines_of, triangle_corners
from orishell.structure.mesh.rotations import cross_matrices
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.stops import Stops
from orishell.structure.mesh.triangle import Facets

if TYPE_CHECKING:
    from scipy.sparse import csr_array

CELLS = 6
"""Cells along every side of a panel, of two triangles each."""
CORNERS = [0, -1, -1, 0], [0, 0, -1, -1]
"""Where in the nodes of a panel its corners are, counter-clockwise from the top left one."""


@record
class Offsets:
    """Hinges beside creases, and points of plates that hang on them: the last points of a mesh."""

    nodes: Integers  # the node (k,) that each of those points hangs on
    places: Integers  # the place (k,) whose rotation it turns with
    arms: Array  # from the node to it (k, 3) (length)
    # length of hinge (C, cells+1) that nodes along creases stand for, 0 where there is none, in
    # the order of ``crease_places`` (length)
    lengths: Array
    axes: Array  # points (C, cells+1, 3) on the axes of hinges beside these nodes
    # how high arms are (C, 2), on the board of the first side and on that of the second (length)
    heights: Array
    feet: Array  # from axes to the feet of arms (C, 2, 3), upright on boards (length)
    on_fins: Booleans  # hinges (C,) whose arms are fins that give
    fins: Section | None  # the section of these; None if no arm gives


@record
class SheetMesh:
    """A meshed shell."""

    facets: Facets  # its points (N), nodes first, and triangles
    # nodes (F, cells+1, cells+1) of every panel, downwards and to the right; what is joined to a
    # sheet may have another number of cells in the one direction than in the other
    nodes: Integers
    # corners (T, 3) of every triangle, as places among all nodes of all panels one after the other
    places: Integers
    offsets: Offsets | None = None  # points that are no nodes; None if all are
    turns: int = 0  # rotations of what stiffens it, three dofs each, which are the last

    @property
    def node_count(self) -> int:
        """Number M of nodes, the first points."""
        return len(self.facets.points) - (0 if self.offsets is None else len(self.offsets.nodes))

    @property
    def count(self) -> int:
        """Number of dofs: translations of all nodes, then rotations, those of panels first."""
        return 3 * (self.node_count + self.nodes.size + self.turns)

    @property
    def seats(self) -> Integers:
        """Points (F, cells+1, cells+1) of the panels' plates: the nodes, or what hangs on them."""
        if self.offsets is None:
            return self.nodes
        found = self.nodes.copy()
        hung = self.node_count + np.arange(len(self.offsets.nodes))
        found.reshape(-1)[self.offsets.places] = hung
        return found

    @property
    def panels(self) -> Integers:
        """The panel (T,) of every triangle."""
        return np.repeat(np.arange(len(self.nodes)), len(self.places) // len(self.nodes))

    def cells(self) -> Integers:
        """Nodes (T/2, 4) around every cell; its triangles are numbers 2 k and 2 k + 1."""
        _, down, right = self.nodes.shape
        around = cells_of(down - 1, right - 1)
        return np.asarray(self.seats.reshape(len(self.nodes), -1)[:, around].reshape(-1, 4))

    def translations(self) -> Integers:
        """Dofs (M, 3) of the displacements of nodes."""
        return np.arange(3 * self.node_count).reshape(-1, 3)

    def rotations(self) -> Integers:
        """Dofs (F, cells+1, cells+1, 3) of the panels' rotations at their nodes."""
        first = 3 * self.node_count
        return np.asarray(first + np.arange(3 * self.nodes.size).reshape(*self.nodes.shape, 3))

    def elements(self, section: Section) -> Elements:
        """Its triangles as elements."""
        if self.offsets is None:
            return self.facets.elements(section, self.dofs(), self.count)
        matrices, arms = self.facets.element_stiffness(section), self.arms()
        apart = np.flatnonzero(arms.any(axis=(1, 2)))
        hung = hanging(arms[apart])
        matrices[apart] = hung.swapaxes(1, 2) @ matrices[apart] @ hung
        corners = self.facets.points[self.nodes.ravel()[self.places]]
        return Elements(matrices, self.dofs(), corners[:, 1:] - corners[:, :1], self.count)

    def dofs(self) -> Integers:
        """Dofs (T, 18) of the corners of every triangle: translations, then rotations."""
        translations = self.translations()[self.nodes.ravel()[self.places]]
        rotations = self.rotations().reshape(-1, 3)[self.places]
        return np.concatenate([translations, rotations], axis=-1).reshape(-1, 18)

    def arms_at_places(self) -> Array:
        """From the node at every place to the plate (F (cells+1)^2, 3) (length)."""
        arms = np.zeros((self.nodes.size, 3))
        if self.offsets is not None:
            arms[self.offsets.places] = self.offsets.arms
        return arms

    def arms(self) -> Array:
        """From nodes to the plate (T, 3, 3) at the corners of triangles (length)."""
        return self.arms_at_places()[self.places]

    def corners_moved(self, moved: Array) -> Array:
        """Displacements and rotations (T, 18) of triangles' corners, by those of dofs (D,)."""
        own = moved[self.dofs()].reshape(-1, 3, 6)
        if self.offsets is not None:
            own[..., :3] += np.cross(own[..., 3:], self.arms())
        return own.reshape(-1, 18)

    def loads(self, forces: Array) -> Array:
        """Loads (D,) on dofs by forces (N, 3) on points."""
        return np.asarray(points_by_dofs(self).T @ forces.ravel())


def hanging(arms: Array) -> Array:
    """Dofs (T, 18) of corners of triangles by those of the nodes that they hang on: (T, 18, 18).

    arms: From the nodes to the corners (T, 3, 3) (length).
    """
    found = np.tile(np.eye(18), (len(arms), 1, 1))
    by_turns = -cross_matrices(arms)
    for corner in range(3):
        own = 6 * corner
        found[:, own : own + 3, own + 3 : own + 6] = by_turns[:, corner]
    return found


@lru_cache(maxsize=4)
def points_by_dofs(mesh: SheetMesh) -> csr_array:
    """Displacements (3 N, D) of the points of a mesh by its dofs."""
    from scipy.sparse import coo_array, csr_array, eye_array, vstack

    nodes = eye_array(3 * mesh.node_count, mesh.count, format="csr")
    if mesh.offsets is None:
        return csr_array(nodes)
    hung = mesh.offsets
    rows = np.arange(3 * len(hung.nodes)).reshape(-1, 3)
    turns = mesh.rotations().reshape(-1, 3)[hung.places]
    places = (
        np.concatenate([rows.ravel(), np.repeat(rows, 3, axis=1).ravel()]),
        np.concatenate([mesh.translations()[hung.nodes].ravel(), np.tile(turns, (1, 3)).ravel()]),
    )
    values = np.concatenate([np.ones(rows.size), -cross_matrices(hung.arms).ravel()])
    more = coo_array((values, places), shape=(rows.size, mesh.count))
    return csr_array(vstack([nodes, more], format="csr"))


def crease_places(grid: Grid, cells: int) -> tuple[Integers, Integers, Integers]:
    """Edges (C,) that are creases, and places (C, cells+1) beside them on both sides."""
    places = np.arange(grid.panel_count * (cells + 1) ** 2).reshape(-1, cells + 1, cells + 1)
    # In the order of Grid.faces_edges.
    sides = [places[:, :, 0], places[:, -1], places[:, :, -1], places[:, 0]]
    edge, beside = grid.faces_edges().T.ravel(), np.concatenate(sides)
    order = np.argsort(edge, kind="stable")
    edge, beside = edge[order], beside[order]
    pair = np.flatnonzero(edge[1:] == edge[:-1])
    return edge[pair], beside[pair], beside[pair + 1]


def mesh_sheet(
    positions: Array,
    grid: Grid,
    cells: int = CELLS,
    grading: float = GRADING,
    stops: Stops | None = None,
) -> SheetMesh:
    """Mesh the panels of a folded state.

    positions: Vertices (rows, columns, 3).
    cells: Cells along every side of a panel, at least 1.
    grading: How much narrower cells at creases are; 0 for cells of one width.
    stops: Where lines of nodes across columns have to be; None for nowhere.
    """
    return mesh_panels(positions, grid, *lines_of(positions, cells, grading, stops))


def mesh_panels(positions: Array, grid: Grid, down: Array, right: Array) -> SheetMesh:
    """Mesh panels by lines of nodes, each straight in a panel.

    positions: Vertices (rows, columns, 3).
    down: Shares (rows - 1, columns, m+1) of the way down edges of columns.
    right: Shares (columns - 1, n+1) of the way along edges of rows.
    """
    faces, tall, wide = grid.faces_vertices(), down.shape[2], right.shape[1]
    nodes = _nodes(grid, tall - 1, wide - 1)
    corners = positions.reshape(-1, 3)[faces][:, :, None]
    first, last, across = by_panel(down, right)
    left = corners[:, 0] * (1 - first) + corners[:, 1] * first  # (F, m+1, 3)
    end = corners[:, 3] * (1 - last) + corners[:, 2] * last
    points = np.empty((int(nodes.max()) + 1, 3))
    points[nodes] = left[:, :, None] * (1 - across) + end[:, :, None] * across

    pattern = triangle_corners(tall - 1, wide - 1)
    flat = nodes.reshape(len(faces), -1)
    triangles = flat[:, pattern].reshape(-1, 3)
    places = np.arange(flat.size).reshape(flat.shape)[:, pattern].reshape(-1, 3)
    return SheetMesh(Facets(points, triangles), nodes, places)


def count_freedoms(grid: Grid, cells: int) -> int:
    """Number of dofs of a mesh with so many cells along a panel's sides."""
    inside, panels = cells - 1, len(grid.faces_vertices())
    nodes = grid.vertex_count + inside * len(grid.edges_vertices()) + panels * inside**2
    return int(3 * nodes + 3 * panels * (cells + 1) ** 2)


def _nodes(grid: Grid, down: int, right: int) -> Integers:
    """Nodes (F, down+1, right+1): vertices first, then those inside edges, then inside panels."""
    faces, edges = grid.faces_vertices(), grid.faces_edges()
    inner = np.empty(len(grid.edges_vertices()), np.int64)
    inner[edges[:, [0, 2]]], inner[edges[:, [1, 3]]] = down - 1, right - 1
    begin = grid.vertex_count + np.cumsum(inner) - inner
    left, bottom, end, top = begin[edges].T[..., None]
    first, size = grid.vertex_count + int(inner.sum()), (down - 1) * (right - 1)
    inside = first + np.arange(len(faces) * size)
    nodes = np.empty((len(faces), down + 1, right + 1), np.int64)
    nodes[:, *CORNERS] = faces
    tall, wide = np.arange(down - 1), np.arange(right - 1)
    nodes[:, 1:-1, 0], nodes[:, -1, 1:-1] = left + tall, bottom + wide
    nodes[:, 1:-1, -1], nodes[:, 0, 1:-1] = end + tall, top + wide
    nodes[:, 1:-1, 1:-1] = inside.reshape(len(faces), down - 1, right - 1)
    return nodes
