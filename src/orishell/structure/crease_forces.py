"""Forces that creases pass on from panel to panel: the largest of them, and what bears them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Panel
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.equals import SOLVED, first_largest, largest_along_first
from orishell.structure.mesh.arms import arm_stress
from orishell.structure.mesh.edge_forces import (
    EdgeForces,
    crease_sides,
    on_creases,
    spread_over,
)
from orishell.structure.mesh.strips import (
    board_stress,
    chamfered,
    film_stress,
    one_board,
    solid_stress,
)
from orishell.structure.model import Model
from orishell.structure.negligible import NEGLIGIBLE_FORCE

CreaseKind = Literal["row", "column"]
"""Row creases run from left to right in the flat sheet, column creases downwards."""
FORCES = ("pull", "push", "shear in the plane", "shear across")
"""Forces per length along a crease, as ``largest_forces`` has them."""


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
    return spread_over(values, stretch[:, None], model.thickness)


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
