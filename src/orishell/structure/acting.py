"""Which one-sided conditions act under a load: an active set, from all of them.

Conditions that pull where they can only push are let go, open ones that would be overrun act. While
nothing resists some motion that the loads drive, it is what must be stopped: the conditions that it
overruns act, and where there are none the shell moves.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from orishell.conventions.formatting import in_one_line
from orishell.errors import VerificationError
from orishell.numerics.arrays import Array, Booleans
from orishell.structure.held import Held

TOLERANCE = 1e-9
"""Forces below this share of all loads are none; motions are driven by more than DRIVEN of them."""
DRIVEN = 1e-6
TOGETHER, ROUNDS = 20, 400
"""All that is wrong is changed together so many times, then one at a time."""


@dataclass(frozen=True, slots=True, eq=False)
class Response:
    """What loads do to a structure.

    Parameters
    ----------
    moves
        The motion (n,) that they drive and nothing resists; None if it stands. Then:
    displacements
        Of free freedoms (n,).
    acting
        Which rows of :class:`~orishell.structure.held.Held` act (M,).
    forces
        Their forces (M,).
    motions
        What nothing resists, and the loads do not drive (n, k).
    """

    moves: Array | None
    displacements: Array
    acting: Booleans
    forces: Array
    motions: Array

    __repr__ = in_one_line


def respond(held: Held, loads: Array) -> Response:
    """What loads (n,) on free freedoms do to a structure.

    Raises
    ------
    VerificationError
        If no set of acting conditions is found: a fault of the program.
    """
    count, total = len(held.conditions), len(held.rows)
    sliding = held.sliding
    friction = count + np.arange(len(sliding))
    scale = float(np.abs(loads).sum())
    acting = np.zeros(total, dtype=bool)
    acting[: count + len(sliding)] = True
    slip = np.zeros((total, total))
    for round_ in range(ROUNDS):
        motions = held.motions(acting)
        drive = motions.T @ loads
        if np.linalg.norm(drive) > DRIVEN * np.linalg.norm(loads):
            moved = motions @ drive
            overrun = ~acting[:count] & (
                held.rows[:count] @ moved > TOLERANCE * np.abs(moved).max()
            )
            if not overrun.any():
                return Response(moved, np.full(len(loads), np.nan), acting, slip[0], motions)
            acting[:count] |= overrun
            acting[friction] = acting[sliding]
            continue
        found, gaps, forces = held.respond(loads, acting, slip)
        size = float(np.abs(found[: 3 * len(loads) // 6]).max(initial=0.0))
        one_sided = np.arange(total) < count
        wrong = one_sided & (
            (acting & (forces < -TOLERANCE * scale)) | (~acting & (gaps > TOLERANCE * size))
        )
        turned = _friction(held, acting, slip, gaps, forces)
        if not wrong.any() and not turned:
            found -= motions @ (motions.T @ found)
            return Response(None, found, acting, forces, motions)
        if round_ >= TOGETHER and wrong.any():
            wrong = np.arange(total) == np.flatnonzero(wrong)[0]
        acting ^= wrong
        lifted = ~acting[sliding]
        acting[friction[lifted]] = False
        slip[friction[lifted]] = 0.0
        back = wrong[sliding] & acting[sliding]
        acting[friction[back]] = True
        slip[friction[back]] = 0.0
    raise VerificationError(
        "no set of ties, flaps and feet that act was found: this is a fault of the program"
    )


def _friction(held: Held, acting: Booleans, slip: Array, gaps: Array, forces: Array) -> bool:
    """Let feet slip that friction does not hold, hold those that would slip back.

    Returns whether there was one.
    """
    count = len(held.conditions)
    least = TOLERANCE * float(np.abs(forces).max(initial=0.0))
    changed = False
    for foot in np.flatnonzero(held.conditions.grounded & acting[:count]):
        own = count + np.flatnonzero(held.sliding == foot)
        limit = held.conditions.friction[foot] * max(forces[foot], 0.0)
        push = forces[own]
        if acting[own].all():
            if np.linalg.norm(push) <= limit * (1 + TOLERANCE) + least:
                continue
            way = push / np.linalg.norm(push)
        else:
            before = slip[own, foot]
            if gaps[own] @ before < 0:  # it would be pushed the way that it slips
                acting[own], slip[own, foot] = True, 0.0
                changed = True
                continue
            length = np.linalg.norm(gaps[own])
            way = gaps[own] / length if length else before / np.linalg.norm(before)
            if way @ before > (1 - 1e-9) * np.linalg.norm(before):
                continue
        acting[own] = False
        slip[own, foot] = held.conditions.friction[foot] * way
        changed = True
    return changed
