"""How far hinges close: the largest fold angle of a state, and the state that has it."""

from __future__ import annotations

import numpy as np

from orishell.motion.mechanism import Mechanism
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import bisect

STATES = 257
"""States among which the first one beyond a fold angle is looked for."""
FINE = 1e-14
"""Accuracy of the drive at which a fold angle is reached (relative)."""


def largest_fold(mechanism: Mechanism, drive: Array) -> Array:
    """Return the largest fold angle (S,) of any crease, without its sign (radians).

    Parameters
    ----------
    drive
        Drive angles (S,) of the states (radians).
    """
    angles = mechanism.fold_angles(drive)
    row, column = (
        np.abs(each).reshape(len(drive), -1).max(axis=1, initial=0.0)
        for each in (angles.row, angles.column)
    )
    return np.asarray(np.maximum(row, column))


def drive_at_fold(mechanism: Mechanism, fold: float) -> float:
    """The drive at which a crease is first folded as far as this, or the end of the motion.

    Parameters
    ----------
    fold
        A fold angle, in (0, pi] (radians).
    """
    end = mechanism.end_drive
    if fold >= np.pi:
        return end
    drives = np.linspace(0.0, end, STATES)
    beyond = np.flatnonzero(largest_fold(mechanism, drives) > fold)
    if not len(beyond):
        return end

    def open_enough(drive: float) -> bool:
        return bool(largest_fold(mechanism, np.array([drive]))[0] <= fold)

    first = int(beyond[0])
    return bisect(open_enough, float(drives[first - 1]), float(drives[first]), relative=FINE)
