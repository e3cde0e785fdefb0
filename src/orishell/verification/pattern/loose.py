"""How a sheet folds whose panels stay rigid only if its hinges give way: looked at in states."""

from __future__ import annotations

import numpy as np

from orishell.clash.sampled import find_near
from orishell.conventions.progress import Progress, followed, no_progress
from orishell.conventions.record import Angle, record
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following.correcting import corrected
from orishell.motion.following.dofs import Freedom, find_freedom
from orishell.motion.following.hinge_gaps import Parted, RigidPanels
from orishell.motion.following.system import Closure
from orishell.motion.parts import find_parts
from orishell.motion.quads import dots, units
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_largest, first_smallest

WIDEST = 0.02
"""Hinges that give way by more than this share of the shortest crease are none."""
WORK = 15_000
"""Panels of all states together: of larger sheets fewer states are looked at, at least three."""
LEAST_FOLDED = 0.1
"""A state is one of the motion if all creases fold by this share of what they fold in it."""
NEARLY_FLAT = 0.1
"""Creases that lack less to 180 degrees are folded flat, to either side (radians)."""
MOST_PANELS = 20_000
"""Panels of the largest sheets that are looked at: work grows faster than they do."""
EVERY = (1, 2, 3, 4, 6)
"""Of the states of a motion these are looked at: all, every second, ..."""


@record
class LooseMotion:
    """States of rigid panels that are placed so that they part least at hinges."""

    drives: Array  # the driving fold angle (S,) of every state that was found (radians)
    gaps: Array  # by how much hinges give way in each (S,), at most (length)
    apart: Angle  # between two states that are looked at
    complete: bool  # whether all states that were to be looked at were found
    freedom: tuple[Freedom, ...]  # degrees of freedom in some of them, to within that
    # up to this state no panels are nearer to each other than the largest gap; 0 for none
    clear: int
    near: tuple[int, int] | None  # two panels that are in the next one, or meet; None if none

    @property
    def gap(self) -> float:
        """By how much hinges give way in any of these states (length)."""
        return float(self.gaps.max())

    @property
    def widest(self) -> float:
        """The drive at which they do (radians)."""
        return float(self.drives[first_largest(self.gaps)])

    @property
    def clear_until(self) -> float:
        """The drive up to which no panels are nearer to each other than the largest gap."""
        return float(self.drives[self.clear - 1]) if self.clear else 0.0

    @property
    def until(self) -> float:
        """The drive of the last state (radians)."""
        return float(self.drives[-1])


def find_loose(
    pattern: CreasePattern, drives: Array, folds: Array, progress: Progress = no_progress
) -> LooseMotion | None:
    """Place the panels of a sheet that nearly folds in states of its motion; None if it does not.

    Nearly: with hinges that give way by no more than a fiftieth of the shortest crease. One crease
    near the middle of the sheet has the fold angle that it has in the motion.

    Parameters
    ----------
    drives
        The driving fold angle (S,) of states, the flat one first and the end last (radians).
    folds
        Fold angles (S, E) of all edges there, which do not close (radians).
    """
    count = len(pattern.faces)
    if count > MOST_PANELS:
        return None
    every = next((each for each in EVERY if count * (len(drives) / each - 1) <= WORK), EVERY[-1])
    asked = np.arange(every, len(drives) - 1, every)
    asked = asked[np.isfinite(folds[asked]).all(axis=1)]
    if not len(asked):
        return None
    closure, panels = Closure.of(pattern), RigidPanels(pattern)
    held = _driving(pattern, drives[asked], folds[asked])
    fixed = closure.edges == held
    ends = pattern.vertices[pattern.edges[pattern.crease]]
    most = WIDEST * float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=-1).min())
    found: list[tuple[Parted, Array]] = []
    for number in followed(asked.tolist(), len(asked), progress, "placing panels"):
        start = folds[number][closure.edges]
        closed, _ = corrected(closure, start, np.zeros_like(start), fixed)
        state = panels.placed(closure.on_edges(closed), held)
        if state is None or state.gap > most:
            break
        if not _alike(_fold_angles(state, pattern)[closure.edges], start):
            break
        found.append((state, closed))
    if not found:
        return None
    gaps = np.array([state.gap for state, _ in found])
    some = sorted({len(found) // 4, len(found) // 2, 3 * len(found) // 4})
    clear, near = _clear([state for state, _ in found], pattern, float(gaps.max()))
    return LooseMotion(
        drives=drives[asked[: len(found)]],
        gaps=gaps,
        apart=float(drives[every]),
        complete=len(found) == len(asked),
        freedom=tuple(find_freedom(closure, found[each][1], nearly=True) for each in some),
        clear=clear,
        near=near,
    )


def _fold_angles(state: Parted, pattern: CreasePattern) -> Array:
    """Fold angles (E,) of all creases between panels as they are placed, 0 at the border."""
    there = (pattern.faces >= 0)[..., None]
    around = np.where(there, state.corners, state.corners[:, :1]) - state.corners[:, :1]
    normals = units(np.cross(around, np.roll(around, -1, axis=1)).sum(axis=1))
    creases = np.flatnonzero(pattern.crease)
    left, right = pattern.edge_faces[creases].T
    ends = [
        state.corners[left, (pattern.faces[left] == pattern.edges[creases, k, None]).argmax(axis=1)]
        for k in (0, 1)
    ]
    sine = dots(np.cross(normals[right], normals[left]), units(ends[1] - ends[0]))
    found = np.zeros(len(pattern.edges))
    found[creases] = np.arctan2(sine, dots(normals[left], normals[right]))
    return found


def _alike(folds: Array, meant: Array) -> bool:
    """Whether all creases fold as they are meant to: not to the other side, nor hardly.

    Near 180 degrees the sides are not told apart.
    """
    flat = np.abs(folds) > np.pi - NEARLY_FLAT
    return bool((flat | (folds * np.sign(meant) >= LEAST_FOLDED * np.abs(meant))).all())


def _driving(pattern: CreasePattern, drives: Array, folds: Array) -> int:
    """The crease that folds as the drive does, that nearest to the middle of the sheet."""
    off = np.abs(np.abs(folds) - drives[:, None]).max(axis=0)
    off[~pattern.crease] = np.inf
    alike = np.flatnonzero(off <= off.min() + 1e-9)
    middles = pattern.vertices[pattern.edges[alike]].mean(axis=1)
    away = np.linalg.norm(middles - pattern.vertices.mean(axis=0), axis=1)
    return int(alike[first_smallest(away)])


def _clear(
    states: list[Parted], pattern: CreasePattern, gap: float
) -> tuple[int, tuple[int, int] | None]:
    """How many states, from the first on, have no panels nearer than a gap; two in the next."""
    parts = find_parts(pattern)
    for number, state in enumerate(states):
        pairs = find_near(state, parts, pattern.faces, gap)
        if len(pairs):
            first, second = pairs[0].tolist()
            return number, (first, second)
    return len(states), None
