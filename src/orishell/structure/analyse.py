"""From a design and what loads it to displacements, forces, stresses and modes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.errors import InputError, VerificationError
from orishell.conventions.progress import Progress, no_progress, stretch
from orishell.design import Design
from orishell.numerics.arrays import Array
from orishell.structure.active_set import Response, describe_motion, respond
from orishell.structure.hinges import crease_moments
from orishell.structure.loads import case_forces
from orishell.structure.model import Frame, Model, models
from orishell.structure.results import Analysis, Balance, CaseResult
from orishell.structure.settings import LoadCase, Structure
from orishell.structure.stability import (
    Inverse,
    find_buckling,
    find_frequencies,
    geometric_stiffness,
    turning_stiffness,
)
from orishell.structure.stresses import facet_stresses

FREQUENCIES = 3
"""How many frequencies are found."""
FINEST = 32
"""Cells are not halved beyond so many along a side."""
UNBALANCED = 1e-6
"""Loads and reactions that balance no better than this mean that the program is wrong."""


def analyse(
    design: Design, structure: Structure, frame: Frame, progress: Progress = no_progress
) -> Analysis:
    """Analyse a shell at its target.

    Parameters
    ----------
    structure
        What holds and loads it.
    frame
        What else belongs to it.

    Raises
    ------
    InputError
        If supports or loads do not fit the sheet, or its own weight is asked for and not known.
    VerificationError
        If loads and reactions do not balance: a fault of the program.
    """
    _require_mass(structure, frame)
    cells = structure.cells
    coarse = _displaced(design, structure, frame, cells // 2 or 2)  # 1 cannot be halved
    while True:
        halves = [stretch(progress, 0.0, 0.5), stretch(progress, 0.5, 1.0)]
        if structure.refine and 2 * cells <= FINEST:
            halves[0](0.0, f"with {cells} x {cells} cells to a panel")
            fine = _displaced(design, structure, frame, cells)
            if _change(coarse, fine) > structure.refine:
                coarse, cells = fine, 2 * cells
                continue
        found = _analysed(design, structure, frame, cells, halves[1])
        fine = np.array([_largest(case.displacements) for case in found.cases])
        return replace(found, change=_change(coarse, fine))


def _displaced(design: Design, structure: Structure, frame: Frame, cells: int) -> Array:
    """The largest displacement of every case, not a number where it moves."""
    found = []
    for model in models(design, structure, frame, cells):
        for case in structure.analysed:
            forces = case_forces(model.exposure, case, structure.cases)
            response = respond(model.held, model.free_loads(forces))
            found.append(model.furthest(response.displacements))
    return np.array(found)


def _largest(displacements: Array) -> float:
    return float(np.linalg.norm(displacements, axis=1).max())


def _change(coarse: Array, fine: Array) -> float:
    """The largest relative change of the cases that stand."""
    change = np.abs(fine - coarse) / np.where(fine, fine, 1.0)
    return float(np.max(change, where=np.isfinite(change), initial=0.0))


def _require_mass(structure: Structure, frame: Frame) -> None:
    if frame.areal_mass == 0 and any(case.self_weight for case in structure.cases):
        raise InputError(
            "own weight is a load, and what panels weigh is not known",
            where="[[load_case]] self_weight",
            keys=("load_case",),
            remedy="give density in [panel], or areal_density in [workshop]",
        )


def _analysed(
    design: Design, structure: Structure, frame: Frame, cells: int, progress: Progress
) -> Analysis:
    every = models(design, structure, frame, cells)
    cases = [(model, case) for model in every for case in structure.analysed]
    results = []
    for number, (model, case) in enumerate(cases):
        share = stretch(progress, number / len(cases), (number + 1) / len(cases))
        share(0.0, f"loading {case.name}")
        results.append(_loaded(model, case))
    model = every[0]
    return Analysis(
        grid=model.grid,
        before=model.before,
        mesh=model.mesh,
        section=model.section,
        supported=tuple(_vertex(model, node) for node in model.supports.vertices()),
        ties=frame.ties,
        flaps=tuple(
            ((a, b + model.before), (c, d + model.before)) for (a, b), (c, d) in model.flaps()
        ),
        mass=float(model.mass().sum()),
        cases=tuple(results),
        exposure=model.exposure,
        held=model.supports.as_if_pinned(),
        change=0.0,
    )


def _vertex(model: Model, node: int) -> tuple[int, int]:
    row, column = divmod(int(node), model.grid.columns)
    return row, column + model.before


def _loaded(model: Model, case: LoadCase) -> CaseResult:
    """One case with one stiffness of creases."""
    mesh, held = model.mesh, model.held
    forces = case_forces(model.exposure, case, model.structure.cases)
    response = respond(held, model.free_loads(forces))
    if response.moves is not None:
        return _moving(model, case, forces, response.moves)
    if model.furthest(response.displacements) > model.size:
        return _moving(model, case, forces, response.displacements, soft=True)
    moved = model.moved(response.displacements)
    residual = response.taken + held.pulls(response.forces)
    residual[: forces.size] -= forces.ravel()
    reactions, balance = _reactions(model, forces, residual, response)
    ties, flaps = len(model.ties()), len(model.flaps())
    stresses = facet_stresses(mesh.facets, model.section, moved[mesh.freedoms()])
    inverse = Inverse.of(held, response.acting, response.motions)
    straight = ties + flaps
    directed = response.forces[:straight] * np.where(np.arange(straight) < ties, 1.0, -1.0)
    geometric = geometric_stiffness(mesh.facets, stresses.forces, mesh.count) + turning_stiffness(
        mesh.facets.points, held.conditions.nodes[:straight], directed, mesh.count
    )
    buckling = find_buckling(inverse, geometric[held.free][:, held.free])
    frequencies, modes = np.zeros(0), np.zeros((0, *forces.shape))
    if model.frame.areal_mass:
        frequencies, found = find_frequencies(inverse, model.inertia()[held.free], FREQUENCIES)
        modes = np.stack([_unit(model, mode) for mode in found.T])
    return CaseResult(
        name=case.name,
        stiffness=model.stiffness,
        loads=forces,
        motion=None,
        balance=balance,
        displacements=model.shape(response.displacements),
        reactions=reactions,
        friction=held.friction_used(response.forces),
        tie_forces=response.forces[:ties],
        flap_forces=response.forces[ties:straight],
        crease_moments=crease_moments(mesh, model.grid, model.section, moved),
        stresses=stresses.von_mises(),
        principal=stresses.principal(),
        buckling=None if buckling is None else (buckling[0], _unit(model, buckling[1])),
        frequencies=frequencies,
        modes=modes,
    )


def _moving(
    model: Model, case: LoadCase, forces: Array, moves: Array, *, soft: bool = False
) -> CaseResult:
    """A case that nothing balances."""
    nodes, triangles = len(forces), len(model.mesh.facets.triangles)
    unknown = np.full(3, np.nan)
    edges = len(model.grid.edges_vertices())
    return CaseResult(
        name=case.name,
        stiffness=model.stiffness,
        loads=forces,
        motion=describe_motion(model, _unit(model, moves), forces, soft=soft),
        balance=Balance(forces.sum(axis=0), unknown, float("nan")),
        displacements=np.full((nodes, 3), np.nan),
        reactions=np.full((len(model.supports.vertices()), 3), np.nan),
        friction=None,
        tie_forces=np.full(len(model.ties()), np.nan),
        flap_forces=np.full(len(model.flaps()), np.nan),
        crease_moments=np.full(edges, np.nan),
        stresses=np.full((triangles, 2), np.nan),
        principal=np.full((triangles, 2), np.nan),
        buckling=None,
        frequencies=np.zeros(0),
        modes=np.zeros((0, nodes, 3)),
    )


def _unit(model: Model, mode: Array) -> Array:
    """Displacements (N, 3) of a mode (n,), the largest is 1."""
    return model.shape(mode) / model.furthest(mode)


def _reactions(
    model: Model, forces: Array, residual: Array, response: Response
) -> tuple[Array, Balance]:
    """Forces (S, 3) on supported vertices, and how loads and reactions balance.

    residual: What is missing (D,) at supported freedoms.
    """
    mesh, held, points = model.mesh, model.held, model.mesh.facets.points
    supported = model.supports.freedoms(mesh)
    bearing = np.zeros(mesh.count)
    bearing[supported] = residual[supported]
    at_nodes = bearing[mesh.translations()] + held.ground_forces(response.forces)
    turning = bearing[mesh.rotations().reshape(-1, 3)]
    middle = points.mean(axis=0)
    both = forces + at_nodes
    missing = both.sum(axis=0)
    moment = np.cross(points - middle, both).sum(axis=0) + turning.sum(axis=0)
    scale = float(np.linalg.norm(forces, axis=1).sum())
    worst = max(float(np.linalg.norm(missing)), float(np.linalg.norm(moment)) / model.size)
    balance = Balance(forces.sum(axis=0), at_nodes.sum(axis=0), worst / scale if scale else 0.0)
    if balance.residual > UNBALANCED:
        raise VerificationError(
            f"loads and reactions do not balance, {balance.residual:.2g} of the loads are missing: "
            "this is a fault of the program"
        )
    return at_nodes[model.supports.vertices()], balance
