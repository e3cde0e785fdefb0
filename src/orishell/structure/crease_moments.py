"""Moments that creases pass on, from what the triangles beside them bear."""

from __future__ import annotations

import numpy as np

from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array
from orishell.structure.hinges import beside_creases
from orishell.structure.sections import Section
from orishell.structure.sheet import SheetMesh


def crease_moments(mesh: SheetMesh, grid: Grid, section: Section, moved: Array) -> Array:
    """Largest moment per length (E,) about every edge, between its ends; 0 at the border.

    Parameters
    ----------
    moved
        Displacements and rotations (D,).
    """
    forces = mesh.elements(section).forces(moved)
    moments = np.zeros((mesh.nodes.size, 3))
    np.add.at(moments, mesh.places, forces.reshape(-1, 3, 6)[..., 3:])
    edge, first, _, nodes = beside_creases(mesh, grid)
    points = mesh.facets.points[nodes]
    along = points[:, -1] - points[:, 0]
    length = np.linalg.norm(along, axis=1, keepdims=True)
    about = np.einsum("cni,ci->cn", moments[first], along / length)
    cells = nodes.shape[1] - 1
    per_length = np.abs(about[:, 1:-1]) * cells / length
    largest = np.zeros(len(grid.edges_vertices()))
    largest[edge] = (
        per_length.max(axis=1) if cells > 1 else np.abs(about).sum(axis=1) / length[:, 0]
    )
    return largest
