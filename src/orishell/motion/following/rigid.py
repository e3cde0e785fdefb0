"""What cannot fold, proved vertex by vertex.

Round an inner vertex the panels cut a closed polygon of length 2 pi from a sphere; its corners are
the creases, its sides the sectors. So creases that do fold are at least two. Two are in line, and
fold alike. Three have a sector of pi between them: a triangle whose sides are less has a perimeter
below 2 pi. If a sector is above pi, the others join its ends on the shortest way, which is
straight. And from flat not all of three or more fold to one side: a convex polygon is shorter than
2 pi.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion.crease_pattern import CreasePattern
from orishell.numerics.arrays import Booleans, Integers

EXACT = 1e-9
"""Sectors nearer to pi prove nothing (radians)."""


@record
class Rigid:
    """Creases that do not fold in any state, and vertices whose letters cannot be."""

    flat: Booleans  # which edges (E,) are creases that are proved not to fold, letter F left out
    one_sided: Integers  # vertices at which all creases are asked to fold to one side


def find_rigid(pattern: CreasePattern) -> Rigid:
    """Find the creases that cannot fold, one after another, as those beside them cannot."""
    creases, _ = pattern.fans
    sectors = np.nan_to_num(pattern.sectors)
    angles = np.cumsum(sectors, axis=1) - sectors
    folds = np.append(pattern.crease & (pattern.signs != 0), False)
    while True:
        live = folds[creases]
        order = np.argsort(~live, axis=1, kind="stable")
        count = live.sum(axis=1)[:, None]
        here = np.take_along_axis(angles, order, axis=1)
        place = np.arange(live.shape[1])[None]
        after = np.take_along_axis(here, (place + 1) % np.maximum(count, 1), axis=1)
        between = np.where(place < count, np.mod(after - here, 2 * np.pi), 0.0)
        widest = between.max(axis=1, initial=0.0)
        stuck = (count[:, 0] == 1) | (widest > np.pi + EXACT)
        stuck |= (count[:, 0] <= 3) & (widest < np.pi - EXACT)
        caught = creases[stuck & live.any(axis=1)]
        if not caught.size:
            break
        folds[caught] = False
    signs = np.append(np.where(folds[:-1], pattern.signs, 0.0), 0.0)[creases]
    alike = (count[:, 0] >= 3) & (np.abs(np.nansum(signs, axis=1)) == count[:, 0])
    flat = pattern.crease & (pattern.signs != 0) & ~folds[:-1]
    return Rigid(flat, pattern.inner[alike])
