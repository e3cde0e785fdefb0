"""What loads do: who bears them, how feet slip or lift, and what moves where nothing holds a shell.

Whether the shell moves is asked first (:mod:`~orishell.structure.solve.bearing`), then who bears
its loads (:mod:`~orishell.structure.solve.contact_path`), by Coulomb's law
(:mod:`~orishell.structure.solve.friction`). What that leaves of the loads is solved for again.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans
from orishell.structure.solve.bearing import driven_motion
from orishell.structure.solve.contact_path import Found, find_contact
from orishell.structure.solve.factorised import STEPS, Factorised

NEGLIGIBLE = 1e-7
"""Forces below this share of the largest are none, and gaps below it of the displacements."""

SINGULAR = 1e-15
"""Where a foot is about to slip or lift, the slope may be singular: to this share of it."""

UNBALANCED = 1e-5
"""Loads that miss more than this share drive a motion."""

WITHIN = 1e-9
"""Friction beyond what there is by less than this share has not slipped."""


@record
class Response:
    """What loads do to a structure."""

    moves: Array | None  # the motion (n,) that they drive and nothing resists; None if it stands
    # whether feet slip away, though forces within their friction could bear the loads
    slides: bool
    displacements: Array  # of free dofs (n,); not numbers where it moves
    # which rows of :class:`~orishell.structure.solve.factorised.Factorised` act and hold (M,):
    # friction does where a foot sticks
    active: Booleans
    forces: Array  # forces of the rows (M,)
    # how far rows part, less than 0, and how far feet slip (M,); without what they give
    parted: Array
    taken: Array  # what panels and hinges take (D,) of all dofs; not numbers where it moves
    motions: Array  # what nothing resists, and the loads do not drive (n, k)
    # the displacements (s, n) as they were found: each step of the loads that those before left.
    # What elements bear is the sum of what these make them bear; of their sum it is rounded
    steps: Array
    # whether forces could bear the loads, and no state of sticking and slipping feet was found;
    # then it is said to move, as it would if nothing slipped or parted
    unknown: bool = False


def respond(structure: Factorised, loads: Array) -> Response:
    """What loads do to a structure.

    loads: Loads (n,) on its free dofs.
    """
    moves = driven_motion(structure, loads)
    if moves is not None:
        return _moving(structure, moves)
    direct = structure.spring_solve(loads)
    found = find_contact(structure, direct)
    if found is None:
        held = structure.respond(loads, np.ones(len(structure.springs), dtype=bool))[0]
        return replace(_moving(structure, held / np.linalg.norm(held)), unknown=True)
    settled = _settled(structure, loads, direct, found)
    if found.away:
        far = settled.displacements
        return _moving(structure, far / np.linalg.norm(far), slides=True)
    rest = loads - (settled.taken + structure.pulls(settled.forces))[structure.free]
    if np.linalg.norm(rest) > UNBALANCED * np.linalg.norm(loads):
        motions = structure.free_motions
        shape = motions @ (motions.T @ rest)
        return replace(_moving(structure, shape / np.linalg.norm(shape)), unknown=True)
    return settled


def _moving(structure: Factorised, moves: Array, *, slides: bool = False) -> Response:
    """The response of a structure that moves (n,)."""
    count, dofs = structure.every_row.shape
    still, nothing, taken = (np.full(each, np.nan) for each in (len(moves), count, dofs))
    none = np.zeros(count, dtype=bool)
    return Response(
        moves,
        slides,
        still,
        none,
        nothing,
        nothing,
        taken,
        moves[:, None],
        np.zeros((0, len(moves))),
    )


def _settled(structure: Factorised, loads: Array, direct: Array, found: Found) -> Response:
    """The response by rows in balance, in which small rests of the loads are solved for again.

    direct: How the loads (n,) would move free dofs (n,) on springs alone.
    """
    contact, y = found.contact, found.y
    root = np.sqrt(structure.springs)
    point = contact.at(y, 1.0)
    law = np.linalg.pinv(point.slope, rcond=SINGULAR)
    p = root * (point.parted - point.forces)
    by_p = root[:, None] * (point.by_parted - point.by_force) @ law
    taken, rest, steps = np.zeros(structure.every_row.shape[1]), loads, []
    for number in range(STEPS):
        if number:  # rests are small, so few digits of what they do are enough
            direct = structure.quick_solve(rest)
            opened = root * (structure.rows @ direct)
            p, y = by_p @ opened, y + law @ opened
        step = direct + structure.spread @ p
        steps.append(step)
        taken = taken + structure.resisting(step)
        point = contact.at(y, 1.0)
        forces = root * point.forces
        rest = loads - (taken + structure.pulls(forces))[structure.free]
    parted = (point.parted - contact.give * point.forces) / root
    count, rough = len(structure.conditions), structure.conditions.rough
    acts = np.zeros(len(y), dtype=bool)
    acts[:count] = forces[:count] > NEGLIGIBLE * np.max(forces[:count], initial=0.0)
    pressing = acts.copy()
    pressing[contact.rubs] = acts[rough][:, None]
    sizes = np.linalg.norm(y[contact.rubs], axis=1)
    inside = sizes <= y[rough] * (1 + WITHIN)
    parted[contact.rubs[inside]] = 0.0
    acts[contact.rubs] = (acts[rough] & inside)[:, None]
    still = structure.motions(pressing)
    moved = np.sum(steps, axis=0)
    settled = moved - still @ (still.T @ moved)
    gaps = structure.rows @ settled
    open_ = NEGLIGIBLE * float(np.abs(gaps).max())
    if not (~acts[:count] & (gaps[:count] > open_)).any():
        moved = settled
    motions = still if (acts == pressing).all() else structure.motions(acts)
    return Response(None, False, moved, acts, forces, parted, taken, motions, np.array(steps))


def stands(structure: Factorised, response: Response, size: float) -> bool:
    """Whether no motion is free, and no displacement beyond the shell's size (length)."""
    return response.moves is None and structure.furthest(response.displacements) <= size
