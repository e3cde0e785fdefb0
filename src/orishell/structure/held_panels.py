"""What holds panels of a loaded sheet, and of what stiffens it, at their edges."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from orishell.conventions.errors import VerificationError
from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.structure.loads import CaseLoads
from orishell.structure.mesh.edge_forces import EdgeForces, find_edge_forces
from orishell.structure.mesh.elements import Elements
from orishell.structure.mesh.hinges import hinge_elements, rigid_stiffness
from orishell.structure.mesh.plate_edges import PlateEdges, find_plate_edges
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.mesh.triangle import Facets
from orishell.structure.model import Model
from orishell.structure.settings import LoadCase

UNBALANCED = 1e-6
"""Panels that miss more than this share of the loads for their balance mean a fault."""


class PanelLoads:
    """Loads of cases on panels by nodes of their own, those at vertices left out.

    Those of the sheet's panels are first, then, mesh by mesh, those of what stiffens it.
    """

    def __init__(self, model: Model, cases: Sequence[LoadCase]) -> None:
        """Loads of ``cases``, all that may be combined."""
        mesh, exposure = model.mesh, model.exposure
        # Beside all nodes, so that loads at vertices stay there.
        points, own = mesh.facets.points, [each.own for each in model.plates]
        beside = [points[mesh.seats.ravel()], *(e.facets.points[e.nodes.ravel()] for e in own)]
        hung = [exposure.hung, np.zeros(mesh.nodes.size), *model.plate_masses]
        apart = replace(
            exposure,
            mesh=Facets(np.concatenate([points, *beside]), len(points) + mesh.places),
            hung=np.concatenate(hung),
        )
        self._loads, self._first = CaseLoads(apart, cases), len(points)

    def of(self, case: LoadCase) -> Array:
        """Loads (places, 3) of a case (N)."""
        return self._loads.forces(case)[self._first :]


def panel_loads(model: Model, case: LoadCase, cases: Sequence[LoadCase]) -> Array:
    """Loads (places, 3) on panels, as :class:`PanelLoads` has them (N).

    cases: All cases, which this one may combine.
    """
    return PanelLoads(model, cases).of(case)


def by_mesh(model: Model, loads: Array) -> list[Array]:
    """Loads of the sheet's panels, and of each mesh of what stiffens it."""
    sizes = [model.mesh.nodes.size, *(each.own.nodes.size for each in model.plates)]
    return np.split(loads, np.cumsum(sizes)[:-1])


@record
class Held:
    """What holds panels of the sheet, and of what stiffens it, at their edges."""

    edges: EdgeForces  # of the sheet's panels
    plates: tuple[PlateEdges, ...]  # of what stiffens it, as ``Model.plates`` has it
    residual: float  # what is missing for the balance of a panel, relative to all loads


def hold_panels(
    model: Model, steps: Sequence[Array], loads: Array, stiffness: float, scale: float
) -> Held:
    """What holds panels at their edges.

    steps: Displacements and rotations (D,), as they were found one after the other: forces of each
    are added, as those of all together are rounded.
    loads: On panels, as :func:`panel_loads` has them (N).
    stiffness: Of creases (force per radian).
    scale: Sum of the sizes of all loads (N).
    Raises VerificationError: If a panel is not in balance: a fault of the program.
    """
    mesh, grid = model.mesh, model.grid
    springs = min(stiffness, rigid_stiffness(mesh, model.section))
    hinges = hinge_elements(mesh, grid, springs) if stiffness else None
    turning = None if hinges is None else _summed(hinges, steps)
    forces = [_summed(each, steps) for each in (model.elements, *model.plate_elements)]
    places = [each.own.facets.points for each in model.plates]
    return _held(model, mesh, (forces, turning, places), loads, (scale, 0.0))


def _summed(elements: Elements, steps: Sequence[Array]) -> Array:
    """Forces (T, k) of elements, step by step."""
    return np.asarray(np.sum([elements.forces(each) for each in steps], axis=0))


def hold_moved_panels(
    model: Model,
    borne: tuple[Sequence[Array], Array | None, Array, Sequence[Array]],
    loads: Array,
    scale: float,
    rounded: float,
) -> Held:
    """What holds panels at their edges where large displacements are followed.

    borne: Forces (T, 18) of triangles, of the sheet and of each mesh of what stiffens it, moments
    (m, 6) of springs, and where nodes (N, 3), and those of each of these meshes, are.
    rounded: Forces that are but rounding errors of displacements (N).
    """
    forces, turning, points, places = borne
    mesh = replace(model.mesh, facets=Facets(points, model.mesh.facets.triangles))
    return _held(model, mesh, (forces, turning, places), loads, (scale, rounded))


def _held(
    model: Model,
    mesh: SheetMesh,
    borne: tuple[Sequence[Array], Array | None, Sequence[Array]],
    loads: Array,
    sizes: tuple[float, float],
) -> Held:
    (own, *others), turning, places = borne
    scale, rounded = sizes
    on_panels, *on_plates = by_mesh(model, loads)
    grid, restrained = model.grid, _restrained(model)
    edges = find_edge_forces(mesh, grid, own, turning, on_panels, supported=restrained)
    every = zip(model.plates, places, others, on_plates, strict=True)
    plates = tuple(
        find_plate_edges(each.own, place, forces, weights, each.shared)
        for each, place, forces, weights in every
    )
    missing = max(edges.missing, *(each.missing for each in plates), 0.0)
    residual = missing / scale if scale else 0.0
    if missing > UNBALANCED * scale + rounded:
        raise VerificationError(
            f"a panel is not in balance, {residual:.2g} of the loads are missing: "
            "this is a fault of the program"
        )
    return Held(edges, plates, residual)


def _restrained(model: Model) -> Integers:
    """Nodes that supports, base rails and what stiffens panels hold, the ground included."""
    rails = (rail.nodes for rail in model.rails)
    plates = (each.nodes for each in model.plates)
    return np.concatenate([model.supports.restrained[:, 0], model.supports.ground, *rails, *plates])
