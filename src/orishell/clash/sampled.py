"""Contact of panels in states of a motion that was followed, and how far parted panels reach."""

from __future__ import annotations

import numpy as np

from orishell.clash.state import find_contacts
from orishell.conventions.progress import Progress, followed, no_progress
from orishell.conventions.record import Angle, record
from orishell.motion.following import Followed
from orishell.motion.following.hinge_gaps import Parted
from orishell.motion.parts import Parts, find_parts
from orishell.motion.sizes import CONTACT_TOLERANCE
from orishell.numerics.arrays import Array, Integers

NARROW = 1e-4
"""A first contact is told to this angle (radians)."""


@record
class SampledContact:
    """What was seen in states of a motion; between these nothing is known."""

    states: int  # how many folded states were looked at, one after the other
    apart: Angle  # their largest fold angles lie so far apart at most
    clear: Angle  # the largest fold angle of the last state before the first contact
    met: Angle | None  # that of the first state with contact, next to it; None if there is none
    panels: tuple[int, int] | None  # two panels that touch there


def look_for_contact(motion: Followed, progress: Progress = no_progress) -> SampledContact:
    """Look for the first state of a motion in which panels touch, then halve the way before it.

    A last state in which creases are folded flat is left out: panels lie on each other there.

    Parameters
    ----------
    motion
        The motion. Its states are those that are looked at.
    """
    parts = find_parts(motion.pattern)
    last = len(motion.drives) - (motion.end == "closed")
    drives = motion.drives[1:last]
    apart = float(np.diff(motion.drives).max(initial=0.0))
    clear = 0.0
    for number, drive in enumerate(
        followed(drives.tolist(), len(drives), progress, "looking for contact"), start=1
    ):
        pairs = _touching(motion, parts, motion.folds[number])
        if len(pairs):
            return _narrowed(motion, parts, (clear, drive), pairs, (number, apart))
        clear = drive
    return SampledContact(len(drives), apart, clear, None, None)


def _narrowed(
    motion: Followed,
    parts: Parts,
    between: tuple[float, float],
    pairs: Integers,
    looked: tuple[int, float],
) -> SampledContact:
    clear, met = between
    while met - clear > NARROW:
        middle = 0.5 * (clear + met)
        found = _touching(motion, parts, motion.at(middle))
        if len(found):
            met, pairs = middle, found
        else:
            clear = middle
    first, second = (int(panel) for panel in pairs[0])
    return SampledContact(*looked, clear, met, (first, second))


def _touching(motion: Followed, parts: Parts, folds: Array) -> Integers:
    """Pairs (P, 2) of panels that touch in a state with fold angles (E,)."""
    points = parts.extended(motion.placing.placed(folds)[0])
    found = parts.panels[
        find_contacts(points, parts.faces, CONTACT_TOLERANCE * motion.pattern.diagonal)
    ]
    return np.unique(np.sort(found[found[:, 0] != found[:, 1]], axis=1), axis=0)


def find_near(state: Parted, parts: Parts, faces: Integers, gap: float) -> Integers:
    """Return all pairs (P, 2) of panels that are no farther apart than a gap.

    Panels that are hinged to each other count when they are folded flat to within the gap, those
    with one common joint when they cross there to within it.

    Parameters
    ----------
    state
        The panels, as rigid bodies.
    parts
        Convex quadrilaterals that make them up.
    faces
        Vertices (F, K) around every panel, -1 behind the last.
    gap
        How far hinges give way (length).
    """
    owners = parts.panels
    at = (faces[owners][:, None] == parts.faces[..., None]).argmax(axis=-1)
    held, joints = state.corners[owners[:, None], at], state.joints[owners[:, None], at]
    points = state.places[joints]
    # A triangle's fourth corner, in the middle of a side, is a joint of its own.
    middles = np.flatnonzero(parts.faces[:, 3] > faces.max())
    joints[middles, 3] = len(state.places) + np.arange(len(middles))
    held[middles, 3], points[middles, 3] = (_middles(each[middles]) for each in (held, points))
    places = np.concatenate([state.places, points[middles, 3]])
    found = owners[find_contacts(places, joints, gap, held)]
    return np.unique(np.sort(found[found[:, 0] != found[:, 1]], axis=1), axis=0)


def _middles(corners: Array) -> Array:
    """Halfway (T, 3) from the third corner (T, 4, 3) to the first."""
    return np.asarray(0.5 * (corners[:, 2] + corners[:, 0]))
