"""Which panels are nearer to each other than their hinges give way, in one state."""

from __future__ import annotations

import numpy as np

from orishell.clash.state import find_contacts
from orishell.motion.following.hinge_gaps import Parted
from orishell.motion.parts import Parts
from orishell.numerics.arrays import Array, Integers


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
