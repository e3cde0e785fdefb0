"""A motion followed from its first state: predicted along its tangent, corrected, step by step."""

from __future__ import annotations

from typing import Literal

import numpy as np

from orishell.conventions.progress import Progress, followed, no_progress
from orishell.conventions.record import Angle, record
from orishell.motion.following.correcting import CLOSED, Linearised, corrected
from orishell.motion.following.start import SIZE
from orishell.motion.following.system import Closure
from orishell.numerics.arrays import Array
from orishell.numerics.equals import descending, first_largest

End = Literal["asked", "closed", "turns back", "lost"]
"""Why a motion ends: the fold angle asked for is reached; a crease is folded flat; the largest fold
angle grows no further; no closed state is found beyond, as at a branch of the motion."""

FOLLOWING = "following the motion"

LONGEST = 0.15
"""A step changes no fold angle by more (radians)."""
SHORTEST = 1e-5
"""Below this length of a step (radians) nothing is found any more."""
ASTRAY = 0.1
"""A step is taken again, shorter, if it is corrected by more than this share of it."""
OTHERS = 4
"""So many of the largest fold angles are tried as the one that is the largest at the end."""
NEARLY_FLAT = 0.02
"""At the end creases that lack so much to 180 degrees are folded flat, if that closes (radians)."""


@record
class Path:
    """Closed states along a motion, and why it ends."""

    folds: Array  # fold angles (S, N) of the unknowns: the flat state first (radians)
    residuals: Array  # by how much each state misses closure (S,) (radians)
    end: End  # why it ends
    reached: Angle  # the largest fold angle there

    @property
    def drives(self) -> Array:
        """The largest fold angle (S,) of every state, growing (radians)."""
        return np.asarray(np.abs(self.folds).max(axis=1, initial=0.0))


def follow_path(
    closure: Closure,
    start: Array,
    largest: float = np.pi,
    tolerance: float = CLOSED,
    progress: Progress = no_progress,
) -> Path:
    """Follow the motion on which a state lies away from the flat one.

    Where a sheet has several degrees of freedom it goes on as straight as it can: each step is the
    part of the last one that keeps the sheet closed, and least corrections. That is one of many
    motions.

    Parameters
    ----------
    start
        Fold angles (N,) of a nearly flat closed state.
    largest
        The largest fold angle at which to stop, above that of ``start``, up to pi (radians).
    tolerance
        A state is closed if no vertex misses by more (radians).
    """
    states = [np.zeros_like(start), start]
    residuals = [0.0, Linearised(closure, start).residual]
    way, length = start / np.abs(start).max(), SIZE
    before, travelled = way, np.inf
    while True:
        here = states[-1]
        tangent = Linearised(closure, here).motion(way)
        bend = (tangent - before) / travelled
        while True:
            step = min(length, _until(here, tangent, largest))
            last = step < length
            found = here + step * tangent + step**2 / 2 * bend
            allowed = ASTRAY * step + step**2
            if last:
                found, residual = _at_largest(closure, found, largest, (allowed, tolerance))
            else:
                found, residual = corrected(closure, found, tangent)
            off = np.abs(found - here - step * tangent).max()
            if residual <= tolerance and off <= allowed:
                break
            length = step / 2
            if length < SHORTEST:
                return _path(states, residuals, "lost")
        if np.abs(found).max() < np.abs(here).max():
            return _path(states, residuals, "turns back")
        states.append(found)
        residuals.append(residual)
        before, travelled, way = tangent, step, tangent
        length = min(LONGEST, 1.5 * step)
        progress(min(1.0, float(np.abs(found).max()) / largest), FOLLOWING)
        if last:
            return _path(states, residuals, "closed" if largest >= np.pi else "asked")


def _path(states: list[Array], residuals: list[float], end: End) -> Path:
    folds = np.stack(states)
    return Path(folds, np.array(residuals), end, float(np.abs(folds[-1]).max(initial=0.0)))


def _until(folds: Array, way: Array, largest: float) -> float:
    """How far along a way (N,) the first fold angle becomes so large."""
    with np.errstate(divide="ignore", invalid="ignore"):
        left = np.where(way != 0, (largest - np.sign(way) * folds) / np.abs(way), np.inf)
    return float(left.min(initial=np.inf))


def _at_largest(
    closure: Closure, folds: Array, largest: float, limits: tuple[float, float]
) -> tuple[Array, float]:
    """The closed state near fold angles (N,) whose largest is as asked, and how far it misses.

    Creases that are nearly folded flat are folded flat together if that closes and changes none by
    more than allowed: equations about such a state determine it to half the digits only.

    Limits are of the change and of what is missed.
    """
    allowed, tolerance = limits
    near = np.abs(folds) >= np.pi - NEARLY_FLAT
    largest_of = [np.arange(len(folds)) == each for each in descending(np.abs(folds))[:OTHERS]]
    for fixed in [near, *largest_of] if largest >= np.pi and near.any() else largest_of:
        size = np.where(fixed, largest * np.sign(folds), folds)
        found, residual = corrected(closure, size, np.zeros(len(folds)), fixed)
        beyond = np.abs(found).max() - largest
        if residual <= tolerance and np.abs(found - folds).max() <= allowed and beyond < CLOSED:
            break
    return found, residual


def states_at(
    closure: Closure, path: Path, drives: Array, progress: Progress = no_progress
) -> tuple[Array, Array]:
    """Closed states (S, N) of a path by their largest fold angle (S,), and their residuals (S,).

    Parameters
    ----------
    drives
        Largest fold angles, from 0 to the one that the path reaches (radians).
    """
    known = path.drives
    found, residuals = [], []
    for drive in followed(drives.tolist(), len(drives), progress, FOLLOWING):
        place = int(np.clip(np.searchsorted(known, drive), 1, len(known) - 1))
        share = (drive - known[place - 1]) / (known[place] - known[place - 1])
        folds = (1 - share) * path.folds[place - 1] + share * path.folds[place]
        if 0 < share < 1:
            first = first_largest(np.abs(folds))
            fixed = np.arange(len(folds)) == first
            folds[first] = np.copysign(drive, folds[first])
            folds, residual = corrected(closure, folds, np.zeros(len(folds)), fixed)
        else:
            residual = float(path.residuals[place if share >= 1 else place - 1])
        found.append(folds)
        residuals.append(residual)
    return np.array(found), np.array(residuals)
