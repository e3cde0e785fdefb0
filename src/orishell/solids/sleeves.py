"""Boards of sleeves: how far they stand off the panels that they hang on.

A strip hangs on a board that goes on beyond their common line, on both sides of it. About that line
the strip turns, from the one half of the board on which it lies in the flat sheet towards the other
half, by the fold angle phi of the crease between the panels that sleeve and sheet share. The edge
of its own board, square cut and d from the line, has corners d sin(phi) -+ h cos(phi) over the
plane of the panel, h being half the thickness of both. They are over the board of the panel if

    d >= h (1 + abs(cos(phi)))/sin(phi).

This is least at 90 degrees, so it is asked for at both ends of the fold angles that are used. The
line itself is in the middle of the board: the hinge lies in a groove on the side of the sleeve.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from orishell.design import Design, PanelSpec
from orishell.design.boxes import Box
from orishell.motion.boards import Boards, join_boards
from orishell.motion.complex import Complex
from orishell.motion.sleeves import Sleeve
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import bisect

FINE = 1e-6
"""Accuracy of the drive up to which boards may be used (relative)."""
STATES = 257
"""States among which the least and the largest fold angles are looked for."""
FIRST, LAST = 3, 1
"""Sides of the panels of a sleeve's strips that hang on the sheet: of the upper, of the lower."""


def sleeve_design(design: Design, sleeve: Sleeve, start: float, stop: float) -> Design:
    """A sleeve as a design of its own, of the panels of the sheet's, to be used between two drives.

    Parameters
    ----------
    start, stop
        Drives of the sheet (radians).
    """
    off = None
    if design.panel is not None:
        away = stand_off(sleeve, start, stop, design.panel.height)
        sides = np.zeros((2, len(away), 4))
        sides[0, :, FIRST] = sides[1, :, LAST] = away
        off = sides.reshape(-1, 4)
    return replace(design, mechanism=sleeve, clipped=None, attached=(), boxes=(), stand_off=off)


def moving_boards(sheet: Boards, whole: Complex, boxes: Sequence[Box]) -> Boards:
    """Boards of a sheet and of its box girders, as panels of both together."""
    every = [sheet]
    for first, box in zip(whole.firsts[0][1:], boxes, strict=True):
        assert box.boards is not None
        every.append(replace(box.boards, panels=box.boards.panels + first))
    return join_boards(every)


def closes_to(sleeve: Sleeve, start: float, stop: float, build: PanelSpec) -> float:
    """The drive up to which boards of strips may be used that are joined to the sheet at another.

    What they stand off the panels that they hang on, and back from their own crease, may take the
    share of a strip's width that set-backs may take of panels. Below ``start`` if that is too much
    there.

    Parameters
    ----------
    start
        The drive at which they are joined (radians).
    stop
        The drive up to which the sheet closes (radians).
    """
    points = sleeve.positions(0.0)[..., :2]
    along = np.diff(points[1], axis=0)
    across = np.diff(points, axis=0)[:, :-1]
    area = np.abs(across[..., 0] * along[:, 1] - across[..., 1] * along[:, 0])
    room = build.share * (area / np.linalg.norm(along, axis=1)).min(axis=0)

    def works(drive: float) -> bool:
        folds = np.abs(sleeve.fold_angles(np.linspace(start, drive, STATES)).row[:, 0])
        back = build.height * np.tan(0.5 * np.minimum(folds.max(axis=0), np.pi - 1e-9))
        return bool((stand_off(sleeve, start, drive, build.height) + back <= room).all())

    if works(stop):
        return stop
    return bisect(works, start, stop, relative=FINE) if works(start) else 0.0


def stand_off(sleeve: Sleeve, start: float, stop: float, half: float) -> Array:
    """How far (n-1,) boards of both strips stand off their lines while the drive is in a range.

    Infinite where a crease is flat there, or shut.

    Parameters
    ----------
    start, stop
        The range of the drive (radians).
    half
        Half the thickness of all boards (length).
    """
    folds = np.abs(sleeve.fold_angles(np.linspace(start, stop, STATES)).row[:, 0])
    # Where an angle turns around between two states it is beyond both by less than they differ.
    steps = np.diff(folds, axis=0)
    turning = (steps[1:] * steps[:-1] < 0).any(axis=0)
    spare = np.where(turning, np.abs(steps).max(axis=0), 0.0)
    ends = np.stack([folds.min(axis=0) - spare, folds.max(axis=0) + spare])
    sine = np.sin(np.clip(ends, 0.0, np.pi))
    with np.errstate(divide="ignore"):
        return np.asarray((half * (1 + np.abs(np.cos(ends))) / sine).max(axis=0))
