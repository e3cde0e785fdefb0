"""What supports ask of the ground: the worst push, pull and sideways force on each, and ballast.

Ballast at a foot, of the weight W, holds it without an anchor if it is pulled up by no more than W
and pushed aside by no more than friction on what presses then: with the vertical force R on the
shell (upwards) and H aside,

    W + R >= 0,        H <= mu (W + R).

In EQU it counts with the factor of what is favourable there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from operator import attrgetter

import numpy as np

from orishell.conventions.quantities import GRAVITY, plain
from orishell.conventions.record import record
from orishell.conventions.row import Note
from orishell.deployment.report import DeploymentReport
from orishell.motion.grid import Vertex
from orishell.numerics.equals import SOLVED, first_largest, largest_of
from orishell.structure.ballast import favourable, needed_weight
from orishell.structure.case import CaseResult
from orishell.structure.model import Model
from orishell.structure.negligible import NEGLIGIBLE_FORCE

ASSUMED = 0.3
"""Coefficient of friction under ballast where a support has none of its own."""
NAMED = 4
"""So many feet are named in a sentence."""


@record
class Worst:
    """The largest of a force, and the load case that has it."""

    force: float  # how large (N)
    case: str | None  # the load case; None where the force is 0 in all


@record
class Anchor:
    """What a supported vertex asks of the ground, of all cases in equilibrium."""

    REPORTED = (
        "at", "push", "pull", "sideways", "ballast", "ballast_mass", "friction", "assumed", "given",
    )  # fmt: skip

    at: Vertex  # the vertex
    push: Worst  # down on the ground
    pull: Worst  # up: what a peg has to hold
    sideways: Worst  # along the ground: what a peg has to hold
    ballast: Worst  # weight at the foot that holds it without a peg
    # coefficient of friction under the ballast: that of the ground there, or else one that is
    # assumed
    friction: float
    assumed: bool
    given: float = 0.0  # the ballast that holds it; 0 where none is given (kg)

    @property
    def ballast_mass(self) -> float:
        """The mass of the ballast (kg)."""
        return self.ballast.force / GRAVITY


def find_anchors(model: Model, balanced: Sequence[tuple[str, CaseResult]]) -> tuple[Anchor, ...]:
    """What every support asks of the ground.

    balanced: Cases in equilibrium, each with what it is called.
    """
    held = [case.equilibrium for _, case in balanced if case.equilibrium is not None]
    if not held:
        return ()
    names = [name for name, _ in balanced]
    forces = np.stack([found.support_forces for found in held])
    loads = np.array([np.abs(case.forces).sum() for _, case in balanced])
    least = NEGLIGIBLE_FORCE * loads[:, None]
    up, aside = forces[..., 2], np.linalg.norm(forces[..., :2], axis=-1)
    up, aside = (np.where(np.abs(each) > least, each, 0.0) for each in (up, aside))
    ground, supports = model.grounded, model.supports
    rubs, given = (
        dict(zip(model.supported, each.tolist(), strict=True))
        for each in (supports.rubs, supports.ballast)
    )
    factors = [favourable(model.structure, case.limit_state) for _, case in balanced]
    found = []
    for number, at in enumerate(model.supported):
        own = ground.get(at, 0.0) or rubs[at]
        friction = own or ASSUMED
        rises, slides = up[:, number], aside[:, number]
        rough = np.full(len(rises), friction)
        ballast = needed_weight(rises, slides, rough, np.array(factors))
        ballast = np.where(ballast > least[:, 0], ballast, 0.0)
        kinds = (np.maximum(rises, 0.0), np.maximum(-rises, 0.0), slides, ballast)
        push, pull, sideways, weight = (_worst(each, names) for each in kinds)
        found.append(Anchor(at, push, pull, sideways, weight, friction, not own, given[at]))
    return tuple(found)


def with_anchors(report: DeploymentReport, anchors: tuple[Anchor, ...]) -> DeploymentReport:
    """The report whose feet in plan know what the structure asks of the ground there."""
    plan, asked = report.ground, {each.at: each for each in anchors}
    if plan is None:
        return report
    feet = tuple(
        replace(
            foot,
            push=found.push.force,
            pull=found.pull.force,
            sideways=found.sideways.force,
            ballast=found.ballast_mass,
        )
        if (found := asked.get(foot.at)) is not None
        else foot
        for foot in plan.feet
    )
    return replace(report, ground=replace(plan, feet=feet))


def _worst(forces: np.ndarray, names: list[str]) -> Worst:
    most = first_largest(forces, SOLVED)
    force = float(forces[most])
    return Worst(force, names[most] if force else None)


def anchors_in_words(anchors: tuple[Anchor, ...]) -> str:
    """The worst pull, the worst sideways force, and the heaviest ballast: for one line."""
    if not anchors:
        return "not known: nothing is in equilibrium"
    pull, aside, heavy = (
        largest_of(anchors, attrgetter(f"{name}.force"), SOLVED)
        for name in ("pull", "sideways", "ballast")
    )
    words = ["no foot is pulled up"]
    if pull.pull.force:
        words = [f"pulled up by {plain(pull.pull.force)} N at most at {_at(pull)} "]
        words[0] += f"({pull.pull.case})"
    if aside.sideways.force:
        words.append(
            f"pushed aside by {plain(aside.sideways.force)} N at most at {_at(aside)} "
            f"({aside.sideways.case})"
        )
    if heavy.ballast.force:
        assumed = "assumed " if heavy.assumed else ""
        words.append(
            f"without pegs ballast of {plain(heavy.ballast_mass, 3)} kg at most a foot, with "
            f"{assumed}friction of {heavy.friction:g}"
        )
    return "; ".join(words)


def ground_warnings(
    model: Model, anchors: tuple[Anchor, ...], balanced: Sequence[tuple[str, CaseResult]]
) -> Iterator[str]:
    """Which feet lift off the ground, which slip, and which supports have to hold down."""
    lifted: dict[Vertex, list[str]] = {}
    for name, case in balanced:
        for foot in () if case.equilibrium is None else case.equilibrium.feet:
            if foot.state == "lifted":
                lifted.setdefault(foot.at, []).append(name)
    if lifted:
        cases = list(dict.fromkeys(name for names in lifted.values() for name in names))
        yield (
            f"{_number(len(lifted), 'foot lifts', 'feet lift')} off the ground "
            f"({_several(map(_vertex, lifted))}), under {_several(cases)}: others bear their share"
        )
    restrained = set(model.supported) - set(model.grounded)
    restrained -= {each.at for each in anchors if each.given}  # of those it is judged
    pulled = [each for each in anchors if each.pull.force and each.at in restrained]
    if pulled:
        most = largest_of(pulled, lambda each: each.pull.force, SOLVED)
        yield Note(
            f"{_number(len(pulled), 'support is', 'supports are')} pulled up, by "
            f"{plain(most.pull.force)} N at most at {_at(most)} under {most.pull.case}: anchors or "
            "ballast must hold them down",
            "pulled",
        )


def _several(names: Iterator[str] | list[str]) -> str:
    every = list(names)
    more = f" and {len(every) - NAMED} more" if len(every) > NAMED else ""
    return ", ".join(every[:NAMED]) + more


def _at(anchor: Anchor) -> str:
    return _vertex(anchor.at)


def _vertex(at: Vertex) -> str:
    return str(list(at))


def _number(count: int, one: str, more: str) -> str:
    return f"{count} {one if count == 1 else more}"
