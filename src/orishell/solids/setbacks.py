"""How far boards stand back from creases, so that they never meet their neighbours.

The hinges stay in the creases, in the middle of the panels: a membrane between boards of the
thickness b on both its faces. A crease keeps its sign, so it has a closing side: the top of a
valley, the bottom of a mountain. Boards beside a crease that folds by phi are on either side of the
plane that bisects it; at a height b over the membrane they are clear of it if they stand back by

    s = b tan(phi/2)

on the closing side. On the opening side they move apart, and need no more than half the gap that
the tool cuts.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion import Mechanism
from orishell.motion.grid import CreaseValues
from orishell.numerics.arrays import Array

STATES = 257
"""States among which the largest fold angles of creases are looked for."""
AT_ONCE = 2**23
"""Fold angles that are looked at together: memory grows with it."""

SHUT = 1e-9
"""A crease whose fold angle is this near to pi folds flat (radians)."""


@record
class SetBacks:
    """How far boards stand back from every edge of the sheet.

    Parameters
    ----------
    top, bottom
        For the boards on the upper and the lower face of the flat sheet (E,), in the order of the
        grid's edges, 0 at the border (length).
    """

    top: Array
    bottom: Array


def largest_folds(mechanism: Mechanism, limit: float) -> CreaseValues:
    """The largest fold angles of all creases on the way from the flat sheet, with their signs.

    Most grow all the way. Of those that do not the largest is that of a parabola through the three
    states about it, or of these states if that is larger.

    Parameters
    ----------
    limit
        The drive up to which the motion is used (radians).
    """
    drives = np.linspace(0.0, limit, STATES)
    together = max(AT_ONCE // (2 * mechanism.grid.panel_count), 1)
    row = column = np.array(0.0)
    for start in range(0, STATES, together):
        # With the state before and the one after: parabolas go through both.
        around = slice(max(start - 1, 0), start + together + 1)
        own = slice(start - around.start, start - around.start + together)
        angles = mechanism.fold_angles(drives[around])
        row = _larger(row, _largest(angles.row, own))
        column = _larger(column, _largest(angles.column, own))
    return CreaseValues(row, column)


def find_set_backs(folds: CreaseValues, height: float, gap: float = 0.0) -> SetBacks:
    """Set-backs of boards from all edges.

    Parameters
    ----------
    folds
        The largest fold angles, in [-pi, pi], valley positive (radians). Beside a crease that folds
        flat there is no room for a board: its set-back is infinite.
    height
        How high boards stand over the membrane on one face (length).
    gap
        What the tool cuts away between two boards, half of it from each (length).
    """
    angle = folds.on_edges()
    crease = folds.on_edges(border=np.inf) < np.inf
    shut = np.abs(angle) >= np.pi - SHUT
    closing = height * np.tan(np.where(shut, 0.0, np.abs(angle)) / 2)
    closing = np.where(shut & (height > 0), np.inf, closing)
    least = np.where(crease, gap / 2, 0.0)
    return SetBacks(
        top=np.maximum(np.where(angle > 0, closing, 0.0), least),
        bottom=np.maximum(np.where(angle < 0, closing, 0.0), least),
    )


def _larger(first: Array, second: Array) -> Array:
    """The values (...) that are larger in size, the first of equals."""
    return np.where(np.abs(second) > np.abs(first), second, first)


def _largest(angles: Array, among: slice) -> Array:
    """The values (...) of the largest size among some of the states (S, ...)."""
    size = np.abs(angles)
    at = among.start + size[among].argmax(axis=0)[None]
    near = [
        np.take_along_axis(size, np.clip(at + step, 0, len(size) - 1), axis=0)[0]
        for step in (-1, 0, 1)
    ]
    bend = near[0] - 2 * near[1] + near[2]
    inside = (at[0] > 0) & (at[0] < len(size) - 1) & (bend < 0)
    inside &= (near[0] <= near[1]) & (near[2] <= near[1])
    rise = np.where(inside, (near[2] - near[0]) ** 2 / (8 * np.where(inside, -bend, 1.0)), 0.0)
    sign = np.sign(np.take_along_axis(angles, at, axis=0)[0])
    return np.asarray(sign * np.minimum(near[1] + rise, np.pi))
