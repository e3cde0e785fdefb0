"""From a design and what loads it to displacements, forces, stresses and modes.

Limit: the analysis of a structure is for early design and does not replace an engineer's check. It
begins with the shell as designed, without imperfections, and is linear, but where a case buckles
below three times its loads, or ``nonlinear`` asks for large displacements. Stresses at the corners
of panels grow with finer cells. What single screws, bolts and clips do to boards is not
judged, but the forces per length that they hold.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from orishell.conventions.errors import InputError, VerificationError
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import record
from orishell.deployment import Site
from orishell.design import Design
from orishell.numerics.arrays import Array
from orishell.solids import BuiltPanels
from orishell.structure.buckling import share_at_points, turned_by_load
from orishell.structure.case import CaseResult
from orishell.structure.changes import Figures
from orishell.structure.combinations import STRENGTH, Combination, LimitState
from orishell.structure.crease_forces import moments
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.feet import find_feet
from orishell.structure.footings import to_nearest
from orishell.structure.free_motion import describe_motion
from orishell.structure.held_panels import PanelLoads, hold_panels
from orishell.structure.kept_modes import KeptModes
from orishell.structure.loads import CaseLoads, Load, vector
from orishell.structure.mesh.stresses import facet_stresses, panel_stresses
from orishell.structure.model import Model
from orishell.structure.negligible import borne_by
from orishell.structure.nonlinear import follow
from orishell.structure.plates import plate_forces, stresses_in_plates
from orishell.structure.refine import Run, figures, refined
from orishell.structure.results import Analysis
from orishell.structure.settings import LoadCase, Structure, not_combined
from orishell.structure.soft_cases import Loaded, assumed_imperfection, follow_soft, is_soft
from orishell.structure.solve.active_set import Response, respond, stands
from orishell.structure.solve.factorised import Factorised
from orishell.structure.solve.stability import Inverse
from orishell.structure.whole_boards import check_whole_boards
from orishell.structure.worst_place import placed

BUCKLING = 3
"""How many buckling factors are found."""
SLIDES = 0.5
"""A shell slides away if a foot slips by this share of its largest displacement."""
UNBALANCED = 1e-6
"""Loads and reactions that balance no better than this mean that the program is wrong."""


def analyse(
    design: Design,
    structure: Structure,
    site: Site,
    progress: Progress = no_progress,
    *,
    built: BuiltPanels | None = None,
    remedies: bool = True,
    briefly: bool = False,
) -> Analysis:
    """Analyse a shell at its target.

    structure: What holds and loads it.
    built: Its panels, if they have a thickness.
    remedies: Whether it is tried what would hold it where it moves.
    briefly: Whether only that is found which tells if it carries: no figures of a coarser mesh, no
    frequencies, and the first way to buckle alone.
    Raises InputError: If supports or loads do not fit the sheet, or its own weight is asked for and
    not known.
    Raises VerificationError: If loads and reactions do not balance: a fault of the program.
    """
    if design.has_whole_boards:
        check_whole_boards(structure)
    if site.areal_mass == 0 and any(case.self_weight for case in structure.cases):
        panel = design.panel
        lacking = "density"
        if panel is not None and panel.density and panel.membrane and not panel.membrane_density:
            lacking = "membrane_density"
        raise InputError(
            "own weight is a load, and what panels weigh is not known",
            where="[[load_case]] self_weight",
            keys=("load_case",),
            remedy=f"give {lacking} in [panel], or areal_density in [workshop]",
        )
    model = Model(design, structure, site, structure.cells, built)

    def run(cells: int, told: Progress, *, last: bool) -> Run:
        finer = replace(model, cells=cells)
        return _run(finer, told, last=last, modes=last and not briefly, remedies=remedies)

    if briefly:
        model, cases, _ = run(structure.cells, progress, last=True)
    else:
        found, cases, change, stopped = refined(model, run, progress)
        model = found.with_refinement(change, stopped)
    followed = follow_soft(
        model, [case.of(model) for case, _ in cases], [how for _, how in cases], progress
    )
    return Analysis(model, followed)


def _run(model: Model, progress: Progress, *, last: bool, modes: bool, remedies: bool) -> Run:
    """All load cases, with the least stiffness of creases first; figures only if not ``last``.

    modes: Whether frequencies are found, and more than the first way to buckle.
    """
    found: list[tuple[CaseResult, Loaded | None]] = []
    compared: list[Figures] = []
    asked = model.structure
    stiffnesses = tuple(dict.fromkeys(asked.crease_stiffness))
    total = len(stiffnesses) * len(asked.analysed)
    for stiffness in stiffnesses:
        kept = KeptModes()
        for solved in _solve(model, stiffness):
            progress(len(compared) / total, f"loading {solved.case.name}")
            linear = _equilibrium(model, solved, kept, modes=modes) if solved.stands else None
            compared.append(figures(linear))
            if last:
                case = _result(model, solved, linear, remedies=remedies)
                how = Loaded(solved.case, solved.known, solved.response)
                found.append((case, how if is_soft(case) else None))
    return model, found, compared


@record
class _Solved:
    """How the structure responds to a load case with one stiffness of creases."""

    case: LoadCase
    known: Sequence[LoadCase]
    limit_state: LimitState | None
    stiffness: float
    structure: Factorised
    loads: tuple[Load, ...]
    forces: Array
    on_panels: Array
    response: Response
    stands: bool


def _solve(model: Model, stiffness: float) -> Iterator[_Solved]:
    """All load cases with one stiffness of creases."""
    asked = model.structure
    structure = model.factorised(stiffness)
    known = placed(model, structure, asked.arranged)
    on_nodes, on_panels = CaseLoads(model.exposure, known), PanelLoads(model, known)
    for case in not_combined(known):
        loads, forces = on_nodes.of(case), on_nodes.forces(case)
        response = respond(structure, structure.free_loads(forces))
        held = stands(structure, response, model.size)
        if asked.nonlinear:  # far too soft by linear theory is not so by itself
            held = response.moves is None
        state = case.limit_state if isinstance(case, Combination) else None
        borne = on_panels.of(case)
        yield _Solved(
            case, known, state, stiffness, structure, loads, forces, borne, response, held
        )


def _result(
    model: Model, solved: _Solved, linear: Equilibrium | None, *, remedies: bool
) -> CaseResult:
    forces, response = solved.forces, solved.response
    motion = None
    if not solved.stands:
        moves = response.displacements if response.moves is None else response.moves
        shape, soft = _unit(solved.structure, moves), response.moves is None
        slipped = solved.structure.slipped(response.parted) if soft else 0.0
        slides = response.slides or slipped > SLIDES * solved.structure.furthest(moves)
        motion = describe_motion(
            model,
            solved.stiffness,
            shape,
            forces,
            soft=soft and not slides,
            slides=slides,
            unknown=response.unknown,
            remedies=remedies,
        )
    return CaseResult(
        name=solved.case.name,
        stiffness=solved.stiffness,
        loads=solved.loads,
        forces=forces,
        motion=motion,
        equilibrium=_balanced(model, solved, linear),
        limit_state=solved.limit_state,
    )


def _balanced(model: Model, solved: _Solved, linear: Equilibrium | None) -> Equilibrium | None:
    if linear is None or not model.structure.nonlinear:
        return linear
    asked = model.structure.imperfection
    off = assumed_imperfection(linear) if asked is None else asked
    return follow(linear, solved.forces, solved.on_panels, solved.response, imperfection=off)


def _equilibrium(model: Model, solved: _Solved, kept: KeptModes, *, modes: bool) -> Equilibrium:
    mesh, structure, response = model.mesh, solved.structure, solved.response
    moved = structure.moved(response.displacements)
    support_forces, reaction, residual = _reactions(model, solved)
    ties = len(model.site.ties)
    straight = ties + len(model.flaps)
    borne = facet_stresses(mesh.facets, model.section, mesh.corners_moved(moved))
    stresses = panel_stresses(mesh, model.section, borne)
    on_plates = plate_forces(model, [each.corners_moved(moved) for each in model.plates])
    total = float(np.linalg.norm(solved.forces, axis=1).sum())
    steps = [structure.moved(each) for each in response.steps]
    held = hold_panels(model, steps, solved.on_panels, solved.stiffness, total)
    factors, shapes = np.zeros(0), np.zeros((len(structure.free), 0))
    frequencies, swinging = factors, shapes
    if solved.limit_state in STRENGTH:
        inverse = Inverse.of(structure, response.active, response.motions)
        hung = model.elements.forces(moved), solved.forces
        turned = turned_by_load(model, structure, response.forces, (borne, on_plates), hung)
        if turned.loaded:
            count = BUCKLING if modes else 1
            factors, shapes = kept.buckling(solved.forces, inverse, turned, count)
        if modes and model.site.areal_mass:
            frequencies, swinging = kept.swinging(model, inverse)
    return Equilibrium(
        model=model,
        duration=solved.case.lasts(solved.known),
        stiffness=solved.stiffness,
        displacements=structure.shape(response.displacements),
        support_forces=support_forces,
        reaction=vector(reaction),
        residual=residual,
        panel_residual=held.residual,
        feet=find_feet(structure, response, tuple(model.grounded)),
        tie_forces=borne_by(response.forces[:ties], total),
        flap_forces=borne_by(response.forces[ties:straight], total),
        edges=held.edges,
        held_plates=held.plates,
        crease_moments=moments(model, held.edges),
        stresses=stresses.von_mises(),
        principal=stresses.principal(),
        in_patches=stresses,
        buckling_factors=tuple(factors.tolist()),
        buckling_modes=_units(structure, shapes),
        buckling_at_points=tuple(share_at_points(model, structure, shapes).tolist()),
        frequencies=tuple(frequencies.tolist()),
        modes=_units(structure, swinging),
        in_plates=stresses_in_plates(model, on_plates),
    )


def _unit(structure: Factorised, mode: Array) -> Array:
    """Displacements (N, 3) of a mode (n,), the largest is 1."""
    return structure.shape(mode) / structure.furthest(mode)


def _units(structure: Factorised, modes: Array) -> Array:
    """Displacements (k, N, 3) of modes (n, k), the largest of each is 1."""
    shapes = [_unit(structure, mode) for mode in modes.T]
    return np.stack(shapes) if shapes else np.zeros((0, structure.nodes, 3))


def _reactions(model: Model, solved: _Solved) -> tuple[Array, Array, float]:
    """Forces (S, 3) at supported vertices, their sum, and the share of the loads that they miss."""
    mesh, structure, points = model.mesh, solved.structure, model.mesh.facets.points
    forces, response = solved.forces, solved.response
    missing = response.taken + structure.pulls(response.forces)
    missing -= mesh.loads(forces)
    supported = model.supports.dofs(mesh)
    bearing = np.zeros(mesh.count)
    bearing[supported] = missing[supported]
    at_nodes = structure.ground_forces(response.forces)
    at_nodes[: mesh.node_count] += bearing[mesh.translations()]
    turning = bearing[mesh.rotations().reshape(-1, 3)]
    middle = points.mean(axis=0)
    both = forces + at_nodes
    force = float(np.linalg.norm(both.sum(axis=0)))
    moment = np.cross(points - middle, both).sum(axis=0) + turning.sum(axis=0)
    worst = max(force, float(np.linalg.norm(moment)) / model.size)
    scale = float(np.linalg.norm(forces, axis=1).sum())
    residual = worst / scale if scale else 0.0
    if residual > UNBALANCED:
        raise VerificationError(
            f"loads and reactions do not balance, {residual:.2g} of the loads are missing: "
            "this is a fault of the program"
        )
    at_vertices = to_nearest(points, model.supports.at, at_nodes)
    return at_vertices, at_nodes.sum(axis=0), residual
