"""Whether ties, flaps and feet can bear loads at all, with friction as it is.

Along the motions that panels and hinges allow, forces have to balance a drive d. Those nearest to
it are sought in the cones of what conditions bear, by non-negative least squares of rays: of each
foot n + mu t, with those directions t that the motion asks for which is missing still, until no ray
would help (Wolfe's method, in which rays stand for their cone). That ends with a proof of either:
forces that balance; or a motion v on which d works, and no ray by more than its share of

    d v > LIMIT max(ray v),

so that forces, of which those of the rays add up to F, work on it by F max(ray v) at most, and
balance needs more than LIMIT times the loads (Farkas' lemma, with room for rounding). Forces so
large are none: motions are rounded, ties and flaps that hold one folding motion are parallel, and
what rounding leaves of the two could bear anything. Where least squares prove neither, a linear
program takes their place, in which forces add up to LIMIT at most.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.structure.solve.factorised import Factorised

DRIVEN = 1e-6
"""Loads drive a motion if more than this share of them works on it."""
LIMIT = 1e4
"""Forces of conditions are not more than so many times the loads."""
HUGE = 1e-7
"""Least squares keep forces below about the loads over this."""
ROUNDS, HELPS = 100, 1e-12
"""Directions of friction are added so often, if their ray works by more than this share."""
EXACT = 1e-10
"""To this the linear program is solved."""
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
    motions = structure.free_motions
    size = float(np.linalg.norm(loads))
    drive = motions.T @ loads
    if np.linalg.norm(drive) <= DRIVEN * size:
        return None
    shape = _driven(_Cones.of(structure, motions, ground), drive / size)
    return None if shape is None else np.asarray(motions @ shape)


def needed_friction(structure: Factorised, loads: Array) -> float | None:
    """The least coefficient of friction with which all rough feet can bear loads (n,); or None."""
    low, high = 0.0, GREATEST
    if not len(structure.conditions.rough) or _moves(structure, loads, high):
        return None
    while high - low > CLOSE * max(high, CLOSE):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _moves(structure, loads, middle) else (low, middle)
    return high


def with_friction(structure: Factorised, friction: float) -> Factorised:
    """The structure on ground of another coefficient of friction, where it is rough."""
    conditions = structure.conditions
    rough = np.where(conditions.friction > 0, friction, 0.0)
    return replace(structure, conditions=replace(conditions, friction=rough))


def _moves(structure: Factorised, loads: Array, friction: float) -> bool:
    return driven_motion(with_friction(structure, friction), loads) is not None


@record
class _Cones:
    """What conditions bear, along k motions: rays, by their size alike, and cones."""

    rays: Array  # (R, k)
    normals: Array  # of feet that may slip (G, k)
    slides: Array  # mu times those of their friction along x and along y (G, 2, k)

    @classmethod
    def of(cls, structure: Factorised, motions: Array, ground: Ground) -> _Cones:
        """Those along motions (n, k) of a structure."""
        count, rough = len(structure.conditions), structure.conditions.rough
        # A row moves by as much as nodes do at most: so forces are counted in those of the loads.
        largest = np.linalg.norm(motions[structure.free < 3 * structure.nodes], axis=1).max()
        bearing = structure.rows[: count + 2 * len(rough)]
        by_row = _without_rounding(bearing @ motions / largest)
        slides = by_row[count : count + 2 * len(rough)].reshape(len(rough), 2, motions.shape[1])
        friction = structure.conditions.friction[rough]
        if ground == "rough":
            return cls(by_row[:count], by_row[rough], friction[:, None, None] * slides)
        stuck = [by_row[:count], *slides.swapaxes(0, 1), *-slides.swapaxes(0, 1)]
        if ground == "anchored":
            stuck.append(-by_row[rough])
        return cls(np.concatenate(stuck), by_row[:0], slides[:0])

    def along(self, shape: Array) -> Array:
        """The rays (G, k) of cones that work most on a motion (k,)."""
        by = self.slides @ shape
        way = by / np.maximum(np.linalg.norm(by, axis=1), 1e-300)[:, None]
        return np.asarray(self.normals + np.einsum("gi,gik->gk", way, self.slides))


def _without_rounding(rows: Array) -> Array:
    """Rows (M, k) without what they do to motions that only forces beyond LIMIT could hold.

    Those of the shell as a whole on smooth ground, for example, are none of any row's but for
    rounding: 4e-6 of a row was seen, of which huge forces would make a hold.
    """
    _, sizes, ways = np.linalg.svd(rows, full_matrices=False)
    kept = ways[sizes > 1 / LIMIT]
    return np.asarray(rows @ kept.T @ kept)


def _driven(cones: _Cones, drive: Array) -> Array | None:
    """The motion (k,) that a drive (k,) moves whatever the cones bear; None if there is none."""
    for nearest in (_least_squares, _linear_program):
        rays = cones.rays
        for _ in range(ROUNDS):
            found = nearest(rays, drive)
            if found is None:
                break
            missing, shape = found
            if np.linalg.norm(missing) <= DRIVEN:
                return None
            more = cones.along(shape)
            most = max(float(np.max(each @ shape, initial=0.0)) for each in (rays, more))
            if drive @ shape > LIMIT * most:
                return shape
            helps = more @ shape > HELPS * np.linalg.norm(shape)
            if not helps.any():
                break
            rays = np.concatenate([rays, more[helps]])
    return None


def _least_squares(rays: Array, drive: Array) -> tuple[Array, Array] | None:
    """What rays (R, k) miss of a drive (k,), and a motion (k,) it moves: the same; or None."""
    from scipy.optimize import nnls

    if not len(rays):
        return drive, drive
    matrix = np.concatenate([rays.T, HUGE * np.eye(len(rays))])
    try:
        borne = nnls(matrix, np.concatenate([drive, np.zeros(len(rays))]))[0]
    except RuntimeError:  # it goes round in circles
        return None
    if borne.sum() > LIMIT:  # by rounding, as likely as not
        return None
    missing = drive - rays.T @ borne
    return missing, missing


def _linear_program(rays: Array, drive: Array) -> tuple[Array, Array] | None:
    """What rays miss of a drive, least by its sum, and a motion, with forces up to LIMIT in all."""
    from scipy.optimize import linprog

    count, one = len(rays), np.eye(len(drive))
    found = linprog(
        np.append(np.zeros(count), np.ones(2 * len(drive))),
        A_ub=np.append(np.full(count, 1 / LIMIT), np.zeros(2 * len(drive)))[None],
        b_ub=[1.0],
        A_eq=np.concatenate([rays.T, one, -one], axis=1),
        b_eq=drive,
        method="highs",
        options={"primal_feasibility_tolerance": EXACT, "dual_feasibility_tolerance": EXACT},
    )
    if found.x is None:
        return None
    return drive - rays.T @ found.x[:count], np.asarray(found.eqlin.marginals)
