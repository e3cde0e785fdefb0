"""Feet that ballast holds: whether one lifts off, or slips, EN 1990, 6.4.1 (1) a).

They are held in place in the analysis. With the weight W of the ballast at a foot, times the factor
gamma of what is favourable in EQU, the vertical force R of the support on the shell (upwards) and
H aside, nothing moves if

    gamma W + R >= 0,        H <= mu (gamma W + R).

The second is asked where friction mu is given.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

import numpy as np

from orishell.conventions.quantities import GRAVITY, plain
from orishell.conventions.record import record
from orishell.motion.grid import Vertex
from orishell.numerics.arrays import Array
from orishell.numerics.equals import SOLVED, first_largest
from orishell.structure.combinations import LimitState
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.negligible import NEGLIGIBLE_FORCE
from orishell.structure.settings import Structure
from orishell.structure.verdict import Finding

JUDGED: tuple[LimitState | None, ...] = (None, "EQU")
"""Cases in which equilibrium is judged: those of no code, and EQU."""


@record
class BallastedFoot:
    """The foot that uses most of what ballast holds."""

    at: Vertex  # the vertex
    kind: Literal["lifts off", "slips"]  # how it would give way first
    force: float  # by which it is pulled up, or pushed aside (N)
    holds: float  # what holds against that (N)
    used: float  # the share of that which is used; infinite if nothing holds
    mass: float  # the ballast there (kg)
    needed: float  # the ballast with which it would be held (kg)
    factor: float  # gamma, in these


def favourable(asked: Structure, state: LimitState | None) -> float:
    """The factor of ballast in a limit state: it holds, so it is favourable."""
    return asked.factors.permanent_equ[1] if state == "EQU" else 1.0


def needed_weight(up: Array, aside: Array, friction: Array, factor: float | Array = 1.0) -> Array:
    """The least weight of ballast (...) that holds feet, by forces on the shell (...) (N).

    up, aside: Upwards, and along the ground.
    friction: Its coefficient; 0 where it is not asked.
    factor: By which ballast counts.
    """
    rough = friction > 0
    slides = np.where(rough, aside, 0.0) / np.where(rough, friction, 1.0)
    return np.asarray(np.maximum(slides - up, 0.0) / factor)


def worst_ballast(
    found: Equilibrium, loads: Array, state: LimitState | None
) -> BallastedFoot | None:
    """The foot that uses most of what its ballast holds; None if none has any, or it is not judged.

    loads: Forces (N, 3) on nodes, as they are in the limit state.
    """
    model, supports = found.model, found.model.supports
    having = np.flatnonzero(supports.ballast)
    if state not in JUDGED or not len(having):
        return None
    factor = favourable(model.structure, state)
    least = NEGLIGIBLE_FORCE * float(np.abs(loads).sum())
    forces = found.support_forces[having]
    up, aside = forces[:, 2], np.linalg.norm(forces[:, :2], axis=1)
    friction, mass = supports.rubs[having], supports.ballast[having]
    weight = factor * GRAVITY * mass
    pull = np.where(-up > least, -up, 0.0)
    aside = np.where((aside > least) & (friction > 0), aside, 0.0)
    rubs = friction * np.maximum(weight + up, 0.0)
    lifts, slips = pull / weight, np.zeros(len(having))
    slips[aside > 0] = np.inf
    np.divide(aside, rubs, out=slips, where=rubs > 0)
    used = np.maximum(lifts, slips)
    worst = first_largest(np.minimum(used, 1 / SOLVED), SOLVED)
    lifted = lifts[worst] > 1 or lifts[worst] >= slips[worst]
    needed = needed_weight(up, aside, friction, factor)[worst] / GRAVITY
    return BallastedFoot(
        at=model.supported[int(having[worst])],
        kind="lifts off" if lifted else "slips",
        force=float(pull[worst] if lifted else aside[worst]),
        holds=float(weight[worst] if lifted else rubs[worst]),
        used=float(lifts[worst] if lifted else slips[worst]),
        mass=float(mass[worst]),
        needed=float(needed),
        factor=factor,
    )


def against_ballast(worst: BallastedFoot | None) -> Iterator[Finding]:
    """What speaks against a shell whose feet ballast does not hold."""
    if worst is None or worst.used <= 1:
        return
    row, column = worst.at
    counts = "" if worst.factor == 1 else f", times {worst.factor:g},"
    ballast = f"ballast of {plain(worst.mass, 3)} kg{counts}"
    if worst.kind == "lifts off":
        text = (
            f"lifts its foot {row}, {column}, which is pulled up by {plain(worst.force)} N: "
            f"{ballast} holds {plain(worst.holds)} N"
        )
    else:
        text = (
            f"pushes its foot {row}, {column} aside by {plain(worst.force)} N: friction under "
            f"{ballast} holds {plain(worst.holds)} N"
        )
    text += f" ({plain(worst.needed, 3)} kg would)"
    excess = worst.used if np.isfinite(worst.used) else None
    yield Finding("fails", worst.kind, text, excess)
