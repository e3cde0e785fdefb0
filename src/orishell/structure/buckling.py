"""How a loaded shell buckles."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from orishell.numerics.arrays import Array
from orishell.structure.mesh.elements import assemble
from orishell.structure.mesh.geometric import Turned, geometric_stiffness
from orishell.structure.mesh.sheet import CORNERS, SheetMesh
from orishell.structure.mesh.stresses import FacetForces
from orishell.structure.model import Model
from orishell.structure.plates import turned_plates
from orishell.structure.solve.factorised import Factorised
from orishell.structure.solve.stability import turning_stiffness

if TYPE_CHECKING:
    from scipy.sparse import csr_array


def turned_by_load(
    model: Model,
    structure: Factorised,
    forces: Array,
    borne: tuple[FacetForces, Sequence[FacetForces]],
    hung: tuple[Array, Array],
) -> Turned:
    """The geometric stiffness of free dofs.

    forces: Of all rows (M,) of the structure: ties pull, flaps push.
    borne: What triangles bear, and those of plates that stiffen the sheet.
    hung: Forces (T, 18) that move triangles, and loads (N, 3) on points.
    """
    mesh, ties = model.mesh, len(model.site.ties)
    straight = ties + len(model.flaps)
    pairs = structure.conditions.nodes
    pressed = pairs[forces[: len(pairs)] > 0].ravel()
    points = np.concatenate([model.supports.points, pressed])
    pulls = forces[:straight] * np.where(np.arange(straight) < ties, 1.0, -1.0)
    turning = turning_stiffness(mesh.facets.points, pairs[:straight], pulls, mesh.count)
    if mesh.offsets is not None:
        turning = turning + by_arms(mesh, *hung)
    panels, plates = borne
    for each, found in zip(model.plates, plates, strict=True):
        turning = turning + turned_plates(each, found, mesh.count)
    return geometric_stiffness(mesh, panels.forces, points, structure.free, turning)


def by_arms(mesh: SheetMesh, forces: Array, loads: Array) -> csr_array:
    """What turning arms r add (D, D), which pass forces g on from hinges to plates.

    Turned by t the end of an arm goes on by t x (t x r)/2, on which g works

        ((g t)(r t) - (g r)(t t))/2.

    forces: With which triangles are moved (T, 18).
    loads: On points (N, 3).
    """
    assert mesh.offsets is not None
    hung = mesh.offsets
    by_places = np.zeros((mesh.nodes.size, 3))
    np.add.at(by_places, mesh.places, forces.reshape(-1, 3, 6)[..., :3])
    pulls, arms = by_places[hung.places] - loads[mesh.node_count :], hung.arms
    outer = pulls[:, :, None] * arms[:, None]
    inner = np.einsum("ki,ki->k", pulls, arms)[:, None, None] * np.eye(3)
    turns = mesh.rotations().reshape(-1, 3)[hung.places]
    return assemble(0.5 * (outer + outer.swapaxes(1, 2)) - inner, turns, mesh.count)


def share_at_points(model: Model, structure: Factorised, modes: Array) -> Array:
    """Share (k,) of the strain energy of modes (n, k) in panels that are held at points.

    All of it is that of panels and of what stiffens them.
    """
    points = model.supports.points
    if not (len(points) and modes.size):
        return np.zeros(modes.shape[1])
    elements, plates = model.elements, model.plate_elements
    corners = model.mesh.nodes[:, *CORNERS]
    standing = np.asarray(np.isin(corners, points).any(axis=1))
    there = standing[model.mesh.panels]
    shares = []
    for mode in modes.T:
        moved = structure.moved(mode)
        energy, *others = (
            (each.forces(moved) * moved[each.dofs]).sum(axis=1) for each in (elements, *plates)
        )
        shares.append(energy[there].sum() / (energy.sum() + sum(each.sum() for each in others)))
    return np.array(shares)
