"""Quadrilateral panels joined along shared edges, in any order: not only grids.

Numbers only: which panels lie beside which edges, which vertices are inside the sheet. A panel has
four corners. Further vertices may lie on its sides, where hinges of other panels end: they part a
side into edges, and bend nothing.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.motion.panel_sides import find_edges, join_loops, pair_keys, sides_of
from orishell.motion.quads import sector_angles, unit_normals
from orishell.numerics.arrays import Array, Booleans, Integers

REVERSED = [0, 3, 2, 1]
"""Corners of a panel the other way round, the same one first."""


@record
class QuadMesh:
    """Panels, edges and what lies beside them; made by :func:`build_mesh`."""

    vertex_count: int  # number of vertices; some may belong to no panel
    # Vertices (F, 4) of every panel in order around it. Neighbours go round the same way.
    faces: Integers
    # All vertices (F, K) around every panel, its first corner first, also those that lie on its
    # sides; -1 behind the last. Alike ``faces`` where none do.
    loops: Integers
    edges: Integers  # vertices (E, 2) of every edge
    # panels (E, 2) to the left and to the right of every edge seen from the side from which the
    # panels go counter-clockwise; -1 where there is none
    edge_faces: Integers
    crease: Booleans  # which edges (E,) join two panels
    pieces: Integers  # number (F,) of the connected piece that a panel belongs to
    reversed_faces: Booleans  # which panels (F,) were listed the other way round

    def loops_edges(self) -> Integers:
        """Numbers (F, K) of every panel's edges: each from one of ``loops`` on; -1 beyond."""
        found = np.full(self.loops.shape, -1)
        sides, owners = sides_of(self.loops)
        keys = pair_keys(sides, self.vertex_count)
        found[self.loops >= 0] = find_edges(keys, owners, self.edges, self.vertex_count)
        return found

    def faces_edges(self) -> Integers:
        """Numbers (F, 4) of every panel's edges, that from its first to its second corner first.

        -1 for a side of several edges.
        """
        edges, after = self.loops_edges(), np.where(self.loops < 0, self.loops[:, :1], self.loops)
        after = np.roll(after, -1, axis=1)
        begins = self.loops[:, None] == self.faces[..., None]  # (F, 4, K)
        ends = np.roll(self.faces, -1, axis=1)
        at = begins.argmax(axis=-1)
        whole = np.take_along_axis(after, at, axis=1) == ends
        return np.where(whole, np.take_along_axis(edges, at, axis=1), -1)

    def around(self) -> Integers | list[list[int]]:
        """Vertices (F, ...) of every panel in order around it, those on its sides included."""
        return _ragged(self.loops)

    def around_edges(self) -> Integers | list[list[int]]:
        """Edges (F, ...) of every panel in order around it: each from one of :meth:`around` on."""
        return _ragged(self.loops_edges())

    def inner_vertices(self) -> Integers:
        """Vertices (I,) that panels surround: all edges that end there are creases."""
        inner = np.zeros(self.vertex_count, dtype=np.bool_)
        inner[self.faces] = True
        border = (self.edge_faces >= 0).any(axis=1) & ~self.crease
        inner[self.edges[border]] = False
        return np.flatnonzero(inner)


def build_mesh(
    faces: Integers,
    vertex_count: int,
    edges: Integers | None = None,
    cut: Booleans | None = None,
    loops: Integers | None = None,
) -> QuadMesh:
    """Find which panels share which edges; turn panels so that all go round the same way.

    Parameters
    ----------
    faces
        Vertices (F, 4) of every panel in order around it, either way round. Most panels of a
        connected piece keep their way.
    vertex_count
        Number of vertices.
    edges
        Vertices (E, 2) of every edge, in the order in which they are to be numbered; None to
        number the panels' sides by their vertices.
    cut
        Which edges (E,) do not join the panels beside them.
    loops
        All vertices (F, K) around every panel, where some lie on sides, its first corner first;
        -1 behind the last. ``faces`` if None.

    Raises
    ------
    InputError
        If a panel repeats a corner, an edge is listed twice or not at all or has more than two
        panels, or if the sheet has only one side (a Moebius strip).
    """
    _require_corners(faces)
    joined = join_loops(faces if loops is None else loops, vertex_count, edges, cut)
    turned, oriented = joined.turned, joined.loops
    if loops is not None:
        oriented = np.where(turned[:, None], faces[:, REVERSED], faces)
        oriented.flags.writeable = False
    return QuadMesh(
        vertex_count,
        oriented,
        joined.loops,
        joined.edges,
        joined.edge_faces,
        joined.crease,
        joined.pieces,
        turned,
    )


def measure_mesh_folds(mesh: QuadMesh, positions: Array) -> Array:
    """Fold angles (E,) measured from positions (V, 3), zero at edges that are no creases.

    Signed angles between the normals of the two panels at each crease, positive where they turn
    towards each other (a valley seen from where the panels go counter-clockwise), in (-pi, pi]
    (radians). At pi the sign is undetermined.

    Parameters
    ----------
    positions
        Vertices (V, 3) in one state.
    """
    normals = unit_normals(positions[mesh.faces])
    return folds_between(normals, mesh.edges, mesh.edge_faces, mesh.crease, positions)


def folds_between(
    normals: Array, edges: Integers, edge_faces: Integers, crease: Booleans, positions: Array
) -> Array:
    """Fold angles (E,) between panels of any number of corners, zero but at creases (radians).

    Parameters
    ----------
    normals
        Unit normals (F, 3) of the panels.
    edges, edge_faces
        Vertices (E, 2) of every edge, and panels (E, 2) to the left and to the right of it.
    crease
        Which edges (E,) join two panels.
    positions
        Vertices (V, 3) in one state.
    """
    ends, (left, right) = positions[edges[crease]], edge_faces[crease].T
    axis = ends[:, 1] - ends[:, 0]
    length = np.linalg.norm(axis, axis=1)
    sine = (np.cross(normals[right], normals[left]) * axis).sum(axis=1)
    cosine = (normals[left] * normals[right]).sum(axis=1)
    angles = np.zeros(len(edges))
    angles[crease] = np.arctan2(sine / np.where(length > 0, length, 1.0), cosine)
    return angles


def measure_sector_sums(mesh: QuadMesh, positions: Array, reflex: Booleans) -> Array:
    """Sum (V,) of the sector angles of all panels at every vertex (radians).

    Parameters
    ----------
    positions
        Vertices (V, 3).
    reflex
        Corners (F, 4) whose sector is above pi.
    """
    angles = sector_angles(positions[mesh.faces])
    angles = np.where(reflex, 2 * np.pi - angles, angles)
    sums = np.bincount(mesh.faces.ravel(), angles.ravel(), minlength=mesh.vertex_count)
    # Those that lie on sides.
    around, corners = (
        np.bincount(each[each >= 0], minlength=mesh.vertex_count)
        for each in (mesh.loops, mesh.faces)
    )
    return np.asarray(sums + np.pi * (around - corners), dtype=np.float64)


def _ragged(loops: Integers) -> Integers | list[list[int]]:
    """Rows (F, K) without what is -1 at their ends."""
    if (loops >= 0).all():
        return loops
    return [row[row >= 0].tolist() for row in loops]


def _require_corners(faces: Integers) -> None:
    corners = np.sort(faces, axis=1)
    repeated = (corners[:, 1:] == corners[:, :-1]).any(axis=1)
    if repeated.any():
        face = int(np.argmax(repeated))
        raise InputError(
            f"panel {face} repeats a corner",
            got=str(faces[face].tolist()),
            expected="four different vertices",
        )
