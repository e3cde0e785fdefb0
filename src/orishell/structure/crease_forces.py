"""Forces that creases pass on from panel to panel: the largest of them, and what bears them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from orishell.conventions.errors import VerificationError
from orishell.conventions.record import record
from orishell.motion.grid import Panel
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.equals import SOLVED, first_largest, largest_along_first
from orishell.structure.loads import CaseLoads
from orishell.structure.mesh.arms import arm_stress
from orishell.structure.mesh.edge_forces import (
    EdgeForces,
    crease_sides,
    find_edge_forces,
    on_creases,
)
from orishell.structure.mesh.hinges import hinge_elements, rigid_stiffness
from orishell.structure.mesh.strips import (
    board_stress,
    chamfered,
    film_stress,
    one_board,
    solid_stress,
)
from orishell.structure.mesh.triangle import Facets
from orishell.structure.model import Model
from orishell.structure.negligible import NEGLIGIBLE_FORCE
from orishell.structure.settings import LoadCase

CreaseKind = Literal["row", "column"]
"""Row creases run from left to right in the flat sheet, column creases downwards."""
FORCES = ("pull", "push", "shear in the plane", "shear across")
"""Forces per length along a crease, as ``largest_forces`` has them."""
UNBALANCED = 1e-6
"""Panels that miss more than this share of the loads for their balance mean a fault."""


@record
class AtCrease:
    """Something that is largest at a crease."""

    size: float  # how large it is
    panels: tuple[Panel, Panel]  # the two panels beside the crease


@record
class CreaseForces:
    """The largest forces per length along all creases of a kind, on either side of them."""

    kind: CreaseKind  # which creases
    pull: AtCrease  # square to the crease in the plane of a panel, out of it; 0 if all are pressed
    push: AtCrease  # the same into the panel
    in_plane: AtCrease  # shear along the crease
    across: AtCrease  # shear square to the plane of a panel
    moment: AtCrease  # moment about the crease


class PanelLoads:
    """Loads of cases on panels by nodes of their own, those at vertices left out."""

    def __init__(self, model: Model, cases: Sequence[LoadCase]) -> None:
        """Loads of ``cases``, all that may be combined."""
        mesh, exposure = model.mesh, model.exposure
        # Beside all nodes, so that loads at vertices stay there.
        points = mesh.facets.points
        apart = replace(
            exposure,
            mesh=Facets(
                np.concatenate([points, points[mesh.seats.ravel()]]), len(points) + mesh.places
            ),
            hung=np.concatenate([exposure.hung, np.zeros(mesh.nodes.size)]),
        )
        self._loads, self._first = CaseLoads(apart, cases), len(points)

    def of(self, case: LoadCase) -> Array:
        """Loads (F (cells+1)^2, 3) of a case (N)."""
        return self._loads.forces(case)[self._first :]


def panel_loads(model: Model, case: LoadCase, cases: Sequence[LoadCase]) -> Array:
    """Loads (F (cells+1)^2, 3) on panels, as :class:`PanelLoads` has them (N).

    cases: All cases, which this one may combine.
    """
    return PanelLoads(model, cases).of(case)


def hold_panels(
    model: Model, moved: Array, loads: Array, stiffness: float, scale: float
) -> tuple[EdgeForces, float]:
    """What holds panels at their edges, and the share of the loads that their balance misses.

    moved: Displacements and rotations (D,).
    loads: On panels, as :func:`panel_loads` has them (N).
    stiffness: Of creases (force per radian).
    scale: Sum of the sizes of all loads (N).
    Raises VerificationError: If a panel is not in balance: a fault of the program.
    """
    mesh, grid = model.mesh, model.grid
    springs = min(stiffness, rigid_stiffness(mesh, model.section))
    turning = hinge_elements(mesh, grid, springs).forces(moved) if stiffness else None
    forces = model.elements.forces(moved)
    found = find_edge_forces(mesh, grid, forces, turning, loads, supported=_restrained(model))
    return _balanced(found, scale)


def hold_moved_panels(
    model: Model, borne: tuple[Array, Array | None, Array], loads: Array, scale: float
) -> tuple[EdgeForces, float]:
    """What holds panels where large displacements are followed, and the share of loads missed.

    borne: Forces (T, 18) of triangles, moments (m, 6) of springs, and where nodes (N, 3) are.
    """
    forces, turning, places = borne
    mesh = replace(model.mesh, facets=Facets(places, model.mesh.facets.triangles))
    found = find_edge_forces(mesh, model.grid, forces, turning, loads, supported=_restrained(model))
    return _balanced(found, scale)


def _restrained(model: Model) -> Integers:
    """Nodes that supports, base rails and what stiffens panels hold, the ground included."""
    rails = (rail.nodes for rail in model.rails)
    plates = (each.nodes for each in model.plates)
    return np.concatenate([model.supports.restrained[:, 0], model.supports.ground, *rails, *plates])


def _balanced(found: EdgeForces, scale: float) -> tuple[EdgeForces, float]:
    residual = found.missing / scale if scale else 0.0
    if residual > UNBALANCED:
        raise VerificationError(
            f"a panel is not in balance, {residual:.2g} of the loads are missing: "
            "this is a fault of the program"
        )
    return found, residual


def largest_forces(model: Model, found: EdgeForces) -> Array:
    """Pull, push, shear in the plane and across it, and moment (C, 5) of every crease."""
    values = on_creases(found.per_length, model.grid)
    normal, sizes = values[..., :1], np.abs(values[..., 1:])
    every = np.concatenate([np.maximum(normal, 0), np.maximum(-normal, 0), sizes], axis=-1)
    return np.asarray(every.max(axis=(1, 2)))


def worst_forces(model: Model, cases: Sequence[EdgeForces]) -> tuple[Array, Integers]:
    """The largest forces (C, 5) of all cases, and the case of each, 0 where they are rounding."""
    creases = len(crease_sides(model.grid)[0])
    if not cases:
        return np.zeros((creases, 5)), np.zeros((creases, 5), np.int64)
    every = np.stack([largest_forces(model, found) for found in cases])
    least = NEGLIGIBLE_FORCE * every[..., :2].max() * np.array([1, 1, 1, 1, 0])
    every = np.where(every > least, every, 0.0)
    return every.max(axis=0), largest_along_first(every, SOLVED)


def by_kind(model: Model, found: EdgeForces) -> tuple[CreaseForces, ...]:
    """The largest forces along creases of each kind."""
    sizes = largest_forces(model, found)
    edges, _ = crease_sides(model.grid)
    rows = edges < model.grid.rows * (model.grid.columns - 1)
    kinds: tuple[tuple[CreaseKind, Booleans], ...] = (("row", rows), ("column", ~rows))
    return tuple(
        CreaseForces(kind, *(largest_at(model, np.where(own, each, -1.0)) for each in sizes.T))
        for kind, own in kinds
        if own.any()
    )


def moments(model: Model, found: EdgeForces) -> Array:
    """Largest moment per length (E,) about every edge; 0 at the border."""
    edges, _ = crease_sides(model.grid)
    largest = np.zeros(len(model.grid.edges_vertices()))
    largest[edges] = largest_forces(model, found)[:, -1]
    return largest


def film(model: Model, found: EdgeForces) -> AtCrease | None:
    """The largest stress of the membrane between boards; None if there is none."""
    build = model.design.panel
    if build is None or not build.membrane:
        return None
    values = on_creases(found.per_length, model.grid)
    return largest_at(model, film_stress(values, build).max(axis=(1, 2)))


def lone_board(model: Model, found: EdgeForces) -> AtCrease | None:
    """The largest stress where one board is left beside a crease; None if it is nowhere."""
    build, boards = model.design.panel, model.boards
    if build is None or boards is None or not build.membrane:
        return None
    alone = one_board(boards, model.flat)
    stress = np.where(
        alone[..., None], board_stress(found.per_length, build, model.structure.layup), -1.0
    )
    largest = on_creases(stress[..., None], model.grid).max(axis=(1, 2, 3))
    return largest_at(model, largest) if largest.max() >= 0 else None


def beside_one_board(model: Model) -> Array:
    """1 beside creases (C, 2, 1) where one of two boards is left alone, else 0."""
    assert model.boards is not None
    alone = one_board(model.boards, model.flat).astype(np.float64)
    return on_creases(alone[..., None, None], model.grid)[..., 0]


def beside_creases(model: Model, found: EdgeForces) -> AtCrease | None:
    """The largest structural stress of solid panels at creases; None if panels are not solid.

    It is that of the forces and moments per length with which nodes hold a panel at its edge, over
    the thickness as a film and a beam have it, and so depends little on the mesh (Dong, A
    structural stress definition and numerical implementation for fatigue analysis of welded joints,
    International Journal of Fatigue 23, 2001). Where a board is chamfered only the half of it on
    the other side of the hinge plane is left.
    """
    build, boards, values = model.design.panel, model.boards, spread_forces(model, found)
    if build is None:
        stress = solid_stress(values, model.thickness, model.structure.layup)
    elif build.construction == "bevel" and boards is not None:
        thin = chamfered(boards, model.flat).astype(np.float64)
        alone = on_creases(thin[..., None, None], model.grid)[..., 0] > 0
        layup = model.structure.layup
        half = board_stress(values, build, layup)
        whole = solid_stress(values, build.thickness, layup)
        stress = np.where(alone, half, whole)
    else:
        return None
    return largest_at(model, stress.max(axis=(1, 2)))


def spread_forces(model: Model, found: EdgeForces) -> Array:
    """Forces per length (C, 2, S, 4) on stretches of creases, over a thickness of panels at least.

    What acts on a shorter piece of a crease spreads over about as much of its panels: a crease of a
    few millimetres has large forces per length, and hardly any force.
    """
    values = on_creases(found.per_length, model.grid)
    edges, _ = crease_sides(model.grid)
    ends = model.mesh.facets.points[model.grid.edges_vertices()[edges]]
    stretch = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) / values.shape[2]
    count = np.clip(np.ceil(model.thickness / stretch), 1, values.shape[2])
    spread = values.copy()
    for many in range(2, values.shape[2] + 1):
        windows = np.lib.stride_tricks.sliding_window_view(values, many, axis=2).mean(axis=-1)
        more = np.pad(windows, ((0, 0), (0, 0), (0, many - 1), (0, 0)))
        spread = np.where((count == many)[:, None, None, None], more, spread)
    share = np.minimum(1.0, count * stretch / model.thickness)
    return np.asarray(share[:, None, None, None] * spread)


def arms(model: Model, found: EdgeForces) -> AtCrease | None:
    """The largest stress of the arms that hinges stand on; None if there are none."""
    hinges, build = model.mesh.offsets, model.design.panel
    if hinges is None or found.hinged is None or build is None or not hinges.heights.any():
        return None
    return largest_at(model, arm_stress(hinges, found.hinged, build.fin).max(axis=1))


def largest_at(model: Model, sizes: Array) -> AtCrease:
    """The largest of sizes (C,) of creases."""
    crease = first_largest(sizes, SOLVED)
    _, sides = crease_sides(model.grid)
    first, second = (model.panel_at(int(panel)) for panel in sides[crease, :, 0])
    return AtCrease(float(sizes[crease]), (first, second))
