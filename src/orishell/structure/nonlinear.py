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
from orishell.structure.built_shape import built_off
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.load_path import Ending, LoadPath
from orishell.structure.movable import movable
from orishell.structure.moved_shell import deformed, still
from orishell.structure.solve.active_set import Response
from orishell.structure.solve.contacts import Feet
from orishell.structure.solve.moving import Moving, Work
from orishell.structure.solve.path import Point, climb, settle, trace

FIRST, LONGEST = 0.2, 0.5
"""The share of the loads, or of those at which it buckles by linear theory, that the first step is
aimed at; steps are no longer than by the other factor."""
MOST_POINTS, PAST = 60, 3
"""Points of a path at most, and those that are kept behind a limit."""
IMPERFECT, BRANCHES = 0.1, 3
"""What a nudge moves by the thickness of panels, and how many branches are taken at most."""


def follow(
    linear: Equilibrium,
    loads: Array,
    on_panels: Array,
    response: Response,
    *,
    imperfection: float,
    work: Work | None = None,
) -> Equilibrium:
    """A case with large displacements.

    linear: How it stands by linear theory.
    loads: Forces (N, 3) on nodes.
    on_panels: Forces (F (cells+1)^2, 3) on panels by nodes of their own.
    response: What loads do by linear theory.
    imperfection: How far it is off its shape as built, at most (length).
    work: How much may be done; None for as much as it takes.
    Raises OutOfWorkError: If it would take more.
    """
    perfect = linear.model
    linear = replace(linear, model=built_off(linear, imperfection))
    model = linear.model
    moving = movable(model, linear.stiffness, response)
    if work is not None:
        moving = replace(moving, work=work)
    every = np.zeros(moving.count)
    every[: loads.size] = loads.ravel()
    first = FIRST * min(1.0, linear.buckling or 1.0)
    path, ending = _path(moving, every, model.thickness, first, response.displacements)
    last = _highest(path, every)
    # Where feet rub, nothing is free: they have slipped as far as they had to.
    motions = response.motions[:, : 0 if model.supports.friction.any() else None]
    told = _told(linear, path, motions, ending, imperfection)
    places = still(last, motions)[model.mesh.translations()]
    found = deformed(linear, last, (loads, on_panels), told)
    return replace(found, model=perfect, displacements=places)


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
    linear: Equilibrium,
    path: Sequence[Point],
    motions: Array,
    ending: Ending,
    imperfection: float,
) -> LoadPath:
    translations = linear.model.mesh.translations()
    moved = [still(point, motions)[translations] for point in path]
    return LoadPath(
        ending=ending,
        reached=float(max(point.factor for point in path)),
        factors=tuple(float(point.factor) for point in path),
        displacements=tuple(float(np.linalg.norm(each, axis=1).max()) for each in moved),
        linear_displacement=linear.displacement.size,
        linear_buckling=linear.buckling,
        imperfection=imperfection if len(linear.buckling_modes) else 0.0,
    )
