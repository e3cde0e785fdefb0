"""Hinges: springs about creases.

A rigid crease is a spring much stiffer than a cell beside it. It joins rotations about the crease
only: those across it follow from the displacements that both panels have in common, and sharing
them as well would couple the bending of one panel to the plane of the other, which coarse cells
answer far too stiffly.
"""

from __future__ import annotations

import numpy as np

from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.elements import Elements
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import SheetMesh, crease_places

RIGID = 1e3
"""Stiffness of a rigid crease by that of a cell in bending."""


def rigid_stiffness(mesh: SheetMesh, section: Section) -> float:
    """Moment per length and angle of creases that are rigid (force per radian)."""
    corners = mesh.facets.points[mesh.facets.triangles]
    shortest = np.linalg.norm(np.roll(corners, 1, axis=1) - corners, axis=-1).min()
    return float(RIGID * np.max(section.bending) / shortest)


def hinge_elements(mesh: SheetMesh, grid: Grid, stiffness: Array | float) -> Elements:
    """Springs about all creases.

    grid: The grid of the sheet.
    stiffness: Moment per length of crease and per angle, of every edge (E,) or of all; border edges
    have no spring (force per radian).
    """
    springs, along, dofs, _ = crease_springs(mesh, grid, stiffness)
    turn = np.concatenate([along, -along], axis=1)
    elements = springs[:, None, None] * (turn[:, :, None] * turn[:, None])
    return Elements(elements, dofs, None, mesh.count)


def crease_springs(
    mesh: SheetMesh, grid: Grid, stiffness: Array | float
) -> tuple[Array, Array, Integers, Integers]:
    """Springs (m,) at nodes along creases, directions (m, 3), dofs (m, 6) and places (m, 2) there.

    stiffness: As of :func:`hinge_elements`.
    """
    edge, *beside, nodes = beside_creases(mesh, grid)
    points = mesh.facets.points[nodes]  # (C, cells+1, 3)
    if mesh.offsets is None:
        step = np.linalg.norm(np.diff(points, axis=1), axis=-1)
        share = 0.5 * (np.pad(step, ((0, 0), (1, 0))) + np.pad(step, ((0, 0), (0, 1))))
    else:
        share = np.where(mesh.offsets.on_fins[:, None], 0.0, mesh.offsets.lengths)
    along = points[:, -1] - points[:, 0]
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    k = np.broadcast_to(np.asarray(stiffness, np.float64), len(grid.edges_vertices()))[edge]
    places = np.stack(beside, axis=-1).reshape(-1, 2)
    dofs = mesh.rotations().reshape(-1, 3)[places].reshape(-1, 6)
    return (k[:, None] * share).ravel(), np.repeat(along, nodes.shape[1], axis=0), dofs, places


def beside_creases(mesh: SheetMesh, grid: Grid) -> tuple[Integers, Integers, Integers, Integers]:
    """Edges (C,) that are creases, places (C, cells+1) beside them on both sides, and nodes there.

    Nodes are those of the first side. Places are those of
    :class:`~orishell.structure.mesh.sheet.SheetMesh`.
    """
    edge, first, second = crease_places(grid, mesh.nodes.shape[1] - 1)
    return edge, first, second, mesh.nodes.ravel()[first]
