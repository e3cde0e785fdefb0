"""Boards of strips on a sheet: how far they stand off the panels that they hang on.

A strip hangs on a board that goes on beyond their common line, on both sides of it. About that line
the strip turns, from the one half of the board on which it lies in the flat sheet towards the other
half, by the fold angle phi of the crease between the panels that both are parallel to. The edge
of its own board, square cut and d from the line, has corners d sin(phi) -+ h cos(phi) over the
plane of the panel, h being half the thickness of both. They are over the board of the panel if

    d >= h (1 + abs(cos(phi)))/sin(phi).

This is least at 90 degrees, so it is asked for at both ends of the fold angles that are used. The
line itself is in the middle of the board: the hinge lies in a groove on the side of the strip.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from orishell.design import Design, PanelSpec
from orishell.design.carried import CarriedPart
from orishell.motion.boards import Boards, join_boards
from orishell.motion.carried import Carried, Hanging
from orishell.motion.complex import Complex
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import bisect

FINE = 1e-6
"""Accuracy of the drive up to which boards may be used (relative)."""
STATES = 257
"""States among which the least and the largest fold angles are looked for."""
FIRST, LAST = 3, 1
"""Sides of panels at the first and the last line of their strip."""


def carried_design(design: Design, strips: Carried, start: float, stop: float) -> Design:
    """Strips as a design of their own, of the panels of the sheet's, to be used between two drives.

    Parameters
    ----------
    start, stop
        Drives of the sheet (radians).
    """
    off = None
    if design.panel is not None:
        away = np.zeros((strips.grid.rows - 1, strips.grid.columns - 1, 4))
        for hanging in strips.hung:
            for strip, side in sides_at(strips, hanging.line):
                away[strip, :, side] = stand_off(strips, hanging, start, stop, design.panel.height)
        off = away.reshape(-1, 4)
    return replace(design, mechanism=strips, clipped=None, attached=(), carried=(), stand_off=off)


def sides_at(strips: Carried, line: int) -> Iterator[tuple[int, int]]:
    """Strips on both sides of a line, each with the side of its panels that is there."""
    if line < len(strips.parallel):
        yield line, FIRST
    if line:
        yield line - 1, LAST


def moving_boards(sheet: Boards, whole: Complex, carried: Sequence[CarriedPart]) -> Boards:
    """Boards of a sheet and of what it carries, as panels of all together."""
    every = [sheet]
    for first, part in zip(whole.firsts[0][1:], carried, strict=True):
        assert part.boards is not None
        every.append(replace(part.boards, panels=part.boards.panels + first))
    return join_boards(every)


def closes_to(strips: Carried, start: float, stop: float, build: PanelSpec) -> float:
    """The drive up to which boards of strips may be used that are joined to the sheet at another.

    What they stand off the panels that they hang on, and back from their own creases, may take the
    share of a strip's width that set-backs may take of panels. Below ``start`` if that is too much
    there.

    Parameters
    ----------
    start
        The drive at which they are joined (radians).
    stop
        The drive up to which the sheet closes (radians).
    """
    points = strips.positions(0.0)[..., :2]
    along = np.diff(points, axis=1)[:-1]
    across = np.diff(points, axis=0)[:, :-1]
    area = np.abs(across[..., 0] * along[..., 1] - across[..., 1] * along[..., 0])
    room = build.share * area / np.linalg.norm(along, axis=-1)

    def works(drive: float) -> bool:
        taken = np.zeros_like(room)
        folds = np.abs(strips.fold_angles(np.linspace(start, drive, STATES)).row)
        back = build.height * np.tan(0.5 * np.minimum(folds.max(axis=0), np.pi - 1e-9))
        taken[:-1] += back
        taken[1:] += back
        for hanging in strips.hung:
            for strip, _ in sides_at(strips, hanging.line):
                taken[strip] += stand_off(strips, hanging, start, drive, build.height)
        return bool((taken <= room).all())

    if works(stop):
        return stop
    return bisect(works, start, stop, relative=FINE) if works(start) else 0.0


def stand_off(strips: Carried, hanging: Hanging, start: float, stop: float, half: float) -> Array:
    """How far (n-1,) boards stand off a line that they hang in while the drive is in a range.

    Infinite where panels are parallel there to those that they hang on.

    Parameters
    ----------
    start, stop
        The range of the drive (radians).
    half
        Half the thickness of all boards (length).
    """
    folds = np.abs(strips.hung_folds(hanging, np.linspace(start, stop, STATES)))
    # Where an angle turns around between two states it is beyond both by less than they differ.
    steps = np.diff(folds, axis=0)
    turning = (steps[1:] * steps[:-1] < 0).any(axis=0)
    spare = np.where(turning, np.abs(steps).max(axis=0), 0.0)
    ends = np.stack([folds.min(axis=0) - spare, folds.max(axis=0) + spare])
    sine = np.sin(np.clip(ends, 0.0, np.pi))
    with np.errstate(divide="ignore"):
        return np.asarray((half * (1 + np.abs(np.cos(ends))) / sine).max(axis=0))
