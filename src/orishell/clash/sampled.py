"""Which panels meet in states of a motion that is followed: sampled, so no proof in between."""

from __future__ import annotations

import numpy as np

from orishell.clash.state import find_contacts
from orishell.conventions.progress import Progress, followed, no_progress
from orishell.conventions.record import Angle, record
from orishell.motion.following import Followed
from orishell.motion.parts import Parts, find_parts
from orishell.numerics.arrays import Array, Integers

CONTACT_TOLERANCE = 1e-9
"""Panels closer than this share of the sheet's diagonal touch."""
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
