"""How a loaded shell buckles."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.numerics.arrays import Array
from orishell.structure.mesh.geometric import geometric_stiffness
from orishell.structure.model import Model
from orishell.structure.solve.factorised import Factorised
from orishell.structure.solve.stability import turning_stiffness

if TYPE_CHECKING:
    from scipy.sparse import csr_array


def turned_by_load(
    model: Model, structure: Factorised, forces: Array, membrane: Array
) -> csr_array:
    """The geometric stiffness (n, n) of free dofs.

    forces: Of all rows (M,) of the structure: ties pull, flaps push.
    membrane: Membrane forces xx, yy, xy (T, 3) of triangles, in their own axes.
    """
    from scipy.sparse import csr_array

    mesh, ties = model.mesh, len(model.site.ties)
    straight = ties + len(model.flaps)
    pairs = structure.conditions.nodes
    pressed = pairs[forces[: len(pairs)] > 0].ravel()
    points = np.concatenate([model.supports.points, pressed])
    pulls = forces[:straight] * np.where(np.arange(straight) < ties, 1.0, -1.0)
    geometric = geometric_stiffness(mesh, membrane, points)
    turning = turning_stiffness(mesh.facets.points, pairs[:straight], pulls, mesh.count)
    free = structure.free
    return csr_array((geometric + turning)[free][:, free])


def share_at_points(model: Model, structure: Factorised, modes: Array) -> Array:
    """Share (k,) of the strain energy of modes (n, k) in panels that are held at points."""
    points = model.supports.points
    if not (len(points) and modes.size):
        return np.zeros(modes.shape[1])
    elements = model.elements
    standing = np.asarray(np.isin(model.grid.faces_vertices(), points).any(axis=1))
    there = standing[model.mesh.panels]
    energies = []
    for mode in modes.T:
        moved = structure.moved(mode)
        energies.append((elements.forces(moved) * moved[elements.dofs]).sum(axis=1))
    energy = np.stack(energies)
    return np.asarray(energy[:, there].sum(axis=1) / energy.sum(axis=1))
