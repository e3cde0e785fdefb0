"""Whether ties, flaps and feet can bear loads at all, with friction as it is.

Along the motions m that panels and hinges allow, forces have to balance loads. Those nearest to it
are sought in the cones of what conditions bear, by non-negative least squares of rays: of each foot
n + mu d, with those directions d that the motion asks for which is missing still, until no ray
would help (Wolfe's method, in which rays stand for their cone). What is missing then is a motion
that overruns no condition, and that loads drive (Farkas' lemma).
"""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np

from orishell.numerics.arrays import Array
from orishell.structure.solve.factorised import Factorised

DRIVEN = 1e-6
"""Loads drive a motion if more than this share of them works on it."""
HUGE = 1e-8
"""Forces of conditions are not huge up to about the loads over this."""
ROUNDS, HELPS = 100, 1e-10
"""Directions of friction are added so often, if their ray works by more than this share."""
GREATEST = 10.0
"""Coefficients of friction beyond this are not asked for."""
CLOSE = 1e-4
"""To this share the least coefficient of friction is found."""

Ground = Literal["rough", "sticks", "anchored"]
"""Feet with friction as it is; with as much as they need; and held down, too."""


def driven_motion(structure: Factorised, loads: Array, ground: Ground = "rough") -> Array | None:
    """The motion (n,) that loads drive whatever the conditions bear; None if there is none.

    loads: Loads (n,) on free dofs.
    ground: What feet on rough ground are taken to do.
    """
    motions = structure.motions(np.zeros(len(structure.rows), dtype=bool))
    if not motions.shape[1]:
        return None
    missing = _missing(structure, motions, motions.T @ loads, ground)
    if np.linalg.norm(missing) <= DRIVEN * np.linalg.norm(loads):
        return None
    return np.asarray(motions @ missing)


def needed_friction(structure: Factorised, loads: Array) -> float | None:
    """The least coefficient of friction with which all rough feet can bear loads (n,); or None."""
    low, high = 0.0, GREATEST
    if not len(structure.conditions.rough) or _moves(structure, loads, high):
        return None
    while high - low > CLOSE * high:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _moves(structure, loads, middle) else (low, middle)
    return high


def with_friction(structure: Factorised, friction: float) -> Factorised:
    """The same on ground of another coefficient of friction, where it is rough."""
    conditions = structure.conditions
    rough = np.where(conditions.friction > 0, friction, 0.0)
    return replace(structure, conditions=replace(conditions, friction=rough))


def _moves(structure: Factorised, loads: Array, friction: float) -> bool:
    return driven_motion(with_friction(structure, friction), loads) is not None


def _missing(structure: Factorised, motions: Array, drive: Array, ground: Ground) -> Array:
    """What no forces balance (k,) of a drive (k,) along motions (n, k)."""
    from scipy.optimize import nnls

    count, rough = len(structure.conditions), structure.conditions.rough
    by_row = structure.rows @ motions
    slides = by_row[count : count + 2 * len(rough)].reshape(len(rough), 2, motions.shape[1])
    friction = structure.conditions.friction[rough]
    rays = by_row[:count]
    if ground != "rough":
        rays = np.concatenate([rays, *slides.swapaxes(0, 1), *-slides.swapaxes(0, 1)])
    if ground == "anchored":
        rays = np.concatenate([rays, -by_row[rough]])
    # Rounding of the motions lets forces balance what they cannot, if they are huge.
    largest = np.linalg.norm(motions[structure.free < 3 * structure.nodes], axis=1).max()
    for _ in range(ROUNDS):
        bound = HUGE * largest * np.eye(len(rays))
        aim = np.concatenate([drive, np.zeros(len(rays))])
        borne = nnls(np.concatenate([rays.T, bound]), aim)[0] if len(rays) else np.zeros(0)
        missing = drive - rays.T @ borne
        if ground != "rough" or not len(rough):
            break
        along = slides @ missing
        way = along / np.maximum(np.linalg.norm(along, axis=1), 1e-300)[:, None]
        found = by_row[rough] + friction[:, None] * np.einsum("gi,gik->gk", way, slides)
        enough = HELPS * np.linalg.norm(found, axis=1) * np.linalg.norm(drive)
        helps = found @ missing > enough
        if not helps.any():
            break
        rays = np.concatenate([rays, found[helps]])
    return np.asarray(missing)
