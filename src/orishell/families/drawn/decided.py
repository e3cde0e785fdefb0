"""How a drawn sheet folds in closed form: decided once, for all that ask (not in the paper)."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.conventions.record import record
from orishell.families.drawn.mechanism import DrawnSheet
from orishell.families.drawn.nearest import DRIVES, FOLDS, Nearby, disagreement, find_nearby
from orishell.families.drawn.sheet import drawn_sheet
from orishell.families.drawn.signs import find_signs
from orishell.motion import largest_fold
from orishell.motion.grid import CreaseValues, crease_signs
from orishell.numerics.arrays import Array

SHORT_OF_FLAT = 0.99 * np.pi
"""The drive at which a motion ends whose last state has no digits (radians)."""


@record
class Decided:
    """How it folds: with which mountains and valleys, and whether exactly."""

    sheet: DrawnSheet  # with those of the way that is taken
    # signs of all creases with which it folds, the best first; those of the sheet alone where none
    # was missing
    ways: tuple[CreaseValues, ...]
    exact: bool  # whether vertices agree but for rounding; else it folds nearly, or not at all
    # the drive at the end of its motion (radians): pi, or a little less where rounding leaves no
    # digits of the state that is folded flat
    end: float


def decide(flat: Array, signs: CreaseValues, choice: int = 1) -> Decided | None:
    """Decide how a flat sheet folds; None where no signs were found for the creases without.

    Parameters
    ----------
    flat
        Vertices (rows, columns, 2) as in :class:`~orishell.motion.grid.Grid`, with at least one
        inner vertex.
    signs
        Of the creases: 1 valley, -1 mountain, 0 never folded, NaN where nothing is said.
    choice
        Which of the ways is taken, from 1; the last one if there are fewer.

    Raises
    ------
    DesignError
        If mountains and valleys at a vertex cannot fold: it has a place; or if parts of the sheet
        fold by themselves.
    """
    ways = [signs]
    if np.isnan(signs.row).any() or np.isnan(signs.column).any():
        ways = find_signs(flat, signs)
    if not ways:
        return None
    sheet = drawn_sheet(flat, ways[min(choice, len(ways)) - 1], np.pi)
    exact = disagreement(sheet.drive, np.append(DRIVES, SHORT_OF_FLAT)) < FOLDS
    return Decided(sheet, tuple(ways), exact, end_of(sheet) if exact else np.pi)


def end_of(sheet: DrawnSheet) -> float:
    """The drive at which the motion of a sheet ends that folds exactly (radians).

    Short of 180 degrees where the folds there disagree, or one is beyond, as by rounding.
    """
    flat = np.array([np.pi])
    agrees = disagreement(sheet.drive, flat) < FOLDS
    return np.pi if agrees and largest_fold(sheet, flat)[0] <= np.pi + FOLDS else SHORT_OF_FLAT


def nearby_as_drawn(flat: Array, signs: CreaseValues, sheet: DrawnSheet) -> Nearby | None:
    """A sheet near a flat one that folds exactly, all creases as its signs ask; None if none is.

    Parameters
    ----------
    flat, signs
        As of :func:`decide`, all signs known.
    sheet
        The sheet as drawn, which does not fold exactly.
    """
    found = find_nearby(flat, sheet.drive)
    if found is None:
        return None
    try:
        moved = drawn_sheet(found.vertices, signs, np.pi)
    except DesignError:
        return None
    folds = crease_signs(moved.fold_angles(DRIVES))
    kept = (folds.row == signs.row).all() and (folds.column == signs.column).all()
    return found if kept else None
