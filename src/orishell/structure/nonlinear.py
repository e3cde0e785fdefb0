"""Large displacements: what a case does to the shell as it is moved, step by step.

Loads keep their directions and their sizes, those of wind and pressure, too: they are those on the
shell as designed. Where the shell would move on by itself from a point of the path though the load
goes on growing, the path has branched: it is followed again from before with a nudge along the
softest motion, so small that it moves the shell by :data:`IMPERFECT` of the thickness of panels
there; it is left out again under the full load. Where ``imperfection`` says how far a shell is off
its shape as built, it begins so.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from orishell.numerics.arrays import Array
from orishell.structure.crease_forces import hold_moved_panels, moments
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.feet import Foot, moved_feet
from orishell.structure.footings import to_nearest
from orishell.structure.load_path import Ending, LoadPath
from orishell.structure.loads import vector
from orishell.structure.mesh.corotational import Corotational
from orishell.structure.mesh.hinges import Folds, crease_springs, rigid_stiffness
from orishell.structure.mesh.rotations import logarithms
from orishell.structure.mesh.stresses import facet_stresses, panel_stresses
from orishell.structure.model import Model
from orishell.structure.negligible import borne_by
from orishell.structure.solve.active_set import Response
from orishell.structure.solve.contacts import Feet, Links
from orishell.structure.solve.moving import Moving
from orishell.structure.solve.path import TOUCHING, Point, climb, settle, trace

FIRST, LONGEST = 0.2, 0.5
"""The share of the loads, or of those at which it buckles by linear theory, that the first step is
aimed at; steps are no longer than by the other factor."""
MOST_POINTS, PAST = 60, 3
"""Points of a path at most, and those that are kept behind a limit."""
IMPERFECT, BRANCHES = 0.1, 3
"""What a nudge moves by the thickness of panels, and how many branches are taken at most."""
PENALTY, STEADY = 100.0, 1e-9
"""What does not give has this stiffness by that of nodes, until it is taken over; motions that
nothing drives have the other."""


def follow(linear: Equilibrium, loads: Array, on_panels: Array, response: Response) -> Equilibrium:
    """A case with large displacements.

    linear: How it stands by linear theory.
    loads: Forces (N, 3) on nodes.
    on_panels: Forces (F (cells+1)^2, 3) on panels by nodes of their own.
    response: What loads do by linear theory.
    """
    perfect = linear.model
    linear = replace(linear, model=_imperfect(linear))
    model = linear.model
    moving = movable(model, linear.stiffness, response)
    every = np.zeros(moving.count)
    every[: loads.size] = loads.ravel()
    first = FIRST * min(1.0, linear.buckling or 1.0)
    path, ending = _path(moving, every, model.thickness, first, response.displacements)
    last = _highest(path, every)
    # Where feet rub, nothing is free: they have slipped as far as they had to.
    motions = response.motions[:, : 0 if model.supports.friction.any() else None]
    told = _told(model, linear, path, motions, ending)
    still = _still(last, motions)[model.mesh.translations()]
    found = _deformed(linear, last, (loads, on_panels), told)
    return replace(found, model=perfect, displacements=still)


def _imperfect(linear: Equilibrium) -> Model:
    """The model as it is built: off its shape as it first buckles, the way that the loads move it.

    Without stress: it was cut and joined so.
    """
    model, most = linear.model, linear.model.structure.imperfection
    if not most or not len(linear.buckling_modes):
        return model
    mode = linear.buckling_modes[0]
    way = -1.0 if (mode * linear.displacements).sum() < 0 else 1.0
    facets, built = model.mesh.facets, replace(model)
    points = facets.points + way * most * mode
    vars(built)["mesh"] = replace(model.mesh, facets=replace(facets, points=points))
    return built


def _still(point: Point, motions: Array) -> Array:
    """Displacements (D,) at a point, less those along motions (n, k) that nothing resists.

    Linear theory leaves them out in the same way.
    """
    moving, moved = point.moving, point.moved
    every = moved.displacements.copy()
    every[moving.spins] = logarithms(moved.rotations)
    every[moving.free] -= motions @ (motions.T @ every[moving.free])
    return every


def movable(model: Model, stiffness: float, response: Response) -> Moving:
    """The model, with creases of a stiffness (force per radian), as it may be moved far.

    response: What loads do by linear theory: who touches at the start.
    """
    mesh, points = model.mesh, model.mesh.facets.points
    translations, lever = mesh.translations(), float(np.sqrt(mesh.facets.areas().mean()))
    panels = Corotational.of(mesh.facets, model.section, mesh.dofs(), mesh.places)
    parts: list[Corotational | Folds | Links | Feet] = [panels]
    if stiffness:
        least = min(stiffness, rigid_stiffness(mesh, model.section))
        parts.append(Folds(*crease_springs(mesh, model.grid, least)))
    diagonal = np.einsum("tii->ti", panels.stiffness).reshape(-1, 3, 6)[..., :3]
    typical = float(diagonal.sum() / (3 * len(points)))
    ties, flaps = model.nodes_of(model.site.ties), model.nodes_of(model.flaps)
    pairs, ground = np.concatenate([ties, flaps]), model.supports.ground
    bears = TOUCHING * np.maximum(response.forces, 0.0)
    if len(pairs):
        tie = np.arange(len(pairs)) < len(ties)
        length = np.linalg.norm(points[pairs[:, 1]] - points[pairs[:, 0]], axis=1)
        own = model.structure.tie_stiffness / length
        hard = ~tie | ~np.isfinite(own)
        parts.append(
            Links(
                points=points[pairs],
                dofs=translations[pairs].reshape(-1, 6),
                sign=np.where(tie, 1.0, -1.0),
                stiffness=np.where(hard, PENALTY * typical, own),
                hard=hard,
                borne=bears[: len(pairs)],
            )
        )
    if len(ground):
        stood, rubbed = np.zeros((2, len(ground), 2))
        normal, rubs = np.split(response.forces[len(pairs) :], [len(ground)])
        friction = model.supports.friction
        rough = np.flatnonzero(friction)
        rubbed[rough] = TOUCHING * rubs[: 2 * len(rough)].reshape(-1, 2)
        parts.append(
            Feet(
                dofs=translations[ground],
                stiffness=PENALTY * typical,
                friction=friction,
                borne=TOUCHING * np.maximum(normal, 0.0),
                rubbed=rubbed,
                stood=stood,
            )
        )
    loose = len(pairs) or len(ground) or not stiffness or response.motions.shape[1]
    return Moving.of(
        parts,
        model.supports.dofs(mesh),
        mesh.rotations().reshape(-1, 3),
        lever,
        steady=STEADY * typical if loose else 0.0,
    )


def _path(
    moving: Moving, loads: Array, thickness: float, first: float, along: Array
) -> tuple[list[Point], Ending]:
    """The path, and how it ends."""
    if any(isinstance(part, Feet) for part in moving.parts):
        path = climb(moving, loads, along, first=first, longest=LONGEST)
        return path, "carries" if path[-1].factor == 1 else "lost"
    path = trace(moving, loads, first=first, longest=LONGEST, done=_enough)
    nudge = np.zeros(moving.count)
    for _ in range(BRANCHES):
        branch = _branch(path)
        if branch is None:
            break
        nudge += _nudge(path, branch, thickness)
        start = path[branch - 1]
        step = min(first, 0.5 * (path[branch].factor - start.factor))
        path = path[: branch - 1] + trace(
            moving, loads, first=step, start=start, nudge=nudge, longest=LONGEST, done=_enough
        )
    branch, top = _branch(path), max(point.factor for point in path)
    if branch is not None:
        return path[:branch], "branches"
    if path[-1].factor == 1:
        return path, "carries"
    return path, "snaps" if path[-1].factor < top else "lost"


def _highest(path: Sequence[Point], loads: Array) -> Point:
    """The point of a path under the largest load, in balance with that alone, without a nudge."""
    ranked = sorted(path, key=lambda point: -point.factor)
    for point in ranked:
        if not point.nudged:
            return point
        settled = settle(point.moving, point.moved, loads, point.factor)
        if settled is not None:
            return settled
    return path[0]


def _enough(points: Sequence[Point]) -> bool:
    """Whether the load has fallen for some points, the path has branched, or it is too long."""
    factors = [point.factor for point in points]
    fallen = len(factors) - 1 - int(np.argmax(factors))
    return fallen >= PAST or len(points) >= MOST_POINTS or _branch(points) is not None


def _branch(points: Sequence[Point]) -> int | None:
    """The first point with a motion that goes on by itself, where the load grows on beyond it."""
    for number, (one, other) in enumerate(pairwise(points)):
        if number > 1 and one.negative and other.negative and other.factor > one.factor:
            return number
    if len(points) > 1 and points[-1].negative and points[-1].factor == 1:
        return len(points) - 1
    return None


def _nudge(path: Sequence[Point], branch: int, thickness: float) -> Array:
    """Loads (D,) along the softest motion at a branch, by what they do at the point before."""
    here, before = path[branch], path[branch - 1]
    moving = before.moving
    shape = np.where(moving.straight, here.moving.tangent(here.moved)[1].softest(), 0.0)
    way = (here.moved.displacements - before.moved.displacements)[moving.free]
    if way @ shape < 0:
        shape = -shape
    does = moving.tangent(before.moved)[1].solve(shape)
    most = float(np.abs(does[moving.straight]).max())
    return moving.every(IMPERFECT * thickness / most / before.factor * shape)


def _told(
    model: Model, linear: Equilibrium, path: Sequence[Point], motions: Array, ending: Ending
) -> LoadPath:
    translations = model.mesh.translations()
    moved = [_still(point, motions)[translations] for point in path]
    return LoadPath(
        ending=ending,
        reached=float(max(point.factor for point in path)),
        factors=tuple(float(point.factor) for point in path),
        displacements=tuple(float(np.linalg.norm(each, axis=1).max()) for each in moved),
        linear_displacement=linear.displacement.size,
        linear_buckling=linear.buckling,
    )


def _deformed(
    linear: Equilibrium, point: Point, loads: tuple[Array, Array], path: LoadPath
) -> Equilibrium:
    """What there is in the shell at a point of its path.

    loads: On nodes, and on panels.
    """
    model, moved, moving = linear.model, point.moved, point.moving
    mesh, (on_nodes, on_panels) = model.mesh, loads
    panels, *others = moving.parts
    assert isinstance(panels, Corotational)
    places = mesh.facets.points + moved.displacements[mesh.translations()]
    strained = panels.seen(moved)[2].reshape(-1, 6, 3)
    in_place = np.einsum("tji,tkj->tki", panels.axes, strained).reshape(-1, 18)
    stresses = panel_stresses(
        mesh, model.section, facet_stresses(mesh.facets, model.section, in_place)
    )
    at_nodes, reaction, residual = _reactions(model, point, on_nodes, places)
    total = point.factor * float(np.linalg.norm(on_nodes, axis=1).sum())
    turning = next((each.forces(moved) for each in others if isinstance(each, Folds)), None)
    edges, panel_residual = hold_moved_panels(
        model, (panels.forces(moved), turning, places), point.factor * on_panels, total
    )
    borne = np.zeros(len(model.site.ties) + len(model.flaps))
    feet: tuple[Foot, ...] = ()
    for part in others:
        if isinstance(part, Links):
            borne = part.bears(moved)
        if isinstance(part, Feet):
            feet = moved_feet(part, moved, tuple(model.grounded))
    ties = len(model.site.ties)
    factors = () if path.carries or not path.reached else (path.reached,)
    return replace(
        linear,
        support_forces=to_nearest(mesh.facets.points, model.supports.at, at_nodes),
        reaction=vector(reaction),
        residual=residual,
        feet=feet,
        tie_forces=borne_by(borne[:ties], total),
        flap_forces=borne_by(borne[ties:], total),
        edges=edges,
        panel_residual=panel_residual,
        crease_moments=moments(model, edges),
        stresses=stresses.von_mises(),
        principal=stresses.principal(),
        buckling_factors=factors,
        buckling_modes=np.zeros((0, *places.shape)),
        buckling_at_points=len(factors) * (0.0,),
        path=path,
    )


def _reactions(
    model: Model, point: Point, loads: Array, places: Array
) -> tuple[Array, Array, float]:
    """Forces (N, 3) of supports, their sum, and the share of the loads that they miss."""
    mesh, moved = model.mesh, point.moved
    taken = point.moving.forces(moved)
    taken[: loads.size] -= point.factor * loads.ravel()
    supported = model.supports.dofs(mesh)
    bearing = np.zeros(mesh.count)
    bearing[supported] = taken[supported]
    at_nodes = bearing[mesh.translations()]
    for part in point.moving.parts:
        if isinstance(part, Feet):
            at_nodes[model.supports.ground] += part.pushes(moved)
    turning = bearing[mesh.rotations().reshape(-1, 3)].sum(axis=0)
    both = point.factor * loads + at_nodes
    moment = np.cross(places - places.mean(axis=0), both).sum(axis=0) + turning
    worst = max(float(np.linalg.norm(both.sum(axis=0))), float(np.linalg.norm(moment)) / model.size)
    scale = point.factor * float(np.linalg.norm(loads, axis=1).sum())
    return at_nodes, at_nodes.sum(axis=0), worst / scale if scale else 0.0
