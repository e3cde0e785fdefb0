"""What cannot fold, proved vertex by vertex.

Round an inner vertex the panels cut a closed polygon of length 2 pi from a sphere; its corners are
the creases, its sides the sectors. So creases that do fold are at least two. Two are in line, and
fold alike. Three have a sector of pi between them: a triangle whose sides are less has a perimeter
below 2 pi. If a sector is above pi, the others join its ends on the shortest way, which is
straight. And from flat not all of three or more fold to one side: a convex polygon is shorter than
2 pi.

Two straight lines that cross do not fold together from flat, where their creases are A, B, C, D and
sectors a, pi - a, a, pi - a: let Q lie opposite to C. B and D are as far from A as from Q. So A is
Q, and the line of B and D does not fold; or both lie on the great circle between A and Q, where
either D lies opposite to B, so that the line of A and C does not fold, or B and D are mirror images
of opposite points, which comes of the former only where its line is folded flat.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion.crease_pattern import CreasePattern
from orishell.numerics.arrays import Array, Booleans, Integers

EXACT = 1e-9
"""Sectors nearer to pi prove nothing (radians)."""


@record
class Rigid:
    """Creases that do not fold in any state, and vertices whose letters cannot be."""

    flat: Booleans  # which edges (E,) are creases that are proved not to fold, letter F left out
    one_sided: Integers  # vertices at which all creases are asked to fold to one side
    crossing: Integers  # vertices at which two straight lines cross that are both asked to fold


def find_rigid(pattern: CreasePattern, exact: float = EXACT) -> Rigid:
    """Find the creases that cannot fold, one after another, as those beside them cannot.

    Parameters
    ----------
    exact
        Sectors nearer to pi than that prove nothing (radians).
    """
    creases, _ = pattern.fans
    folds = pattern.crease & (pattern.signs != 0)
    if not creases.size:
        none = np.zeros(0, np.int64)
        return Rigid(np.zeros(len(folds), np.bool_), none, none)
    while True:
        between, count = sectors_between(pattern, folds)
        widest = between.max(axis=1, initial=0.0)
        stuck = (count == 1) | (widest > np.pi + exact)
        stuck |= (count <= 3) & (widest < np.pi - exact)
        caught = creases[stuck & (count > 0)]
        if not caught.size:
            break
        folds[caught[caught >= 0]] = False
    signs = np.append(np.where(folds, pattern.signs, 0.0), 0.0)[creases]
    alike = (count >= 3) & (np.abs(np.nansum(signs, axis=1)) == count)
    flat = pattern.crease & (pattern.signs != 0) & ~folds
    straight = np.abs(between[:, :2].sum(axis=1) - np.pi) <= exact
    straight &= np.abs(between[:, 1:3].sum(axis=1) - np.pi) <= exact
    crossing = (count == 4) & straight & (np.abs(signs).sum(axis=1) == 4)
    return Rigid(flat, pattern.inner[alike], pattern.inner[crossing])


def why_still(pattern: CreasePattern, exact: float = EXACT) -> str:
    """Why single vertices do not let a sheet fold as its letters ask; empty if they may.

    Parameters
    ----------
    exact
        As of :func:`find_rigid`.
    """
    if not (pattern.crease & (pattern.signs != 0)).any():
        return "no crease is to fold"
    rigid = find_rigid(pattern, exact)
    flat = np.flatnonzero(rigid.flat & (np.abs(pattern.signs) == 1))
    if len(flat):
        first, second = pattern.edges[flat[0]].tolist()
        return (
            f"sectors beside crease {first}-{second} do not let it fold; so with {len(flat)} "
            "creases that have a letter"
        )
    if len(rigid.one_sided):
        return (
            f"all creases at vertex {rigid.one_sided[0]} have one letter, and one at least must "
            f"have another; so at {_vertices(rigid.one_sided)}"
        )
    if len(rigid.crossing):
        return (
            f"two straight lines cross at vertex {rigid.crossing[0]}, and only one of them folds, "
            f"until it is folded flat; so at {_vertices(rigid.crossing)}"
        )
    return ""


def _vertices(found: Integers) -> str:
    return "1 vertex" if len(found) == 1 else f"{len(found)} vertices"


def sectors_between(pattern: CreasePattern, folds: Booleans) -> tuple[Array, Integers]:
    """Angles (I, D) at inner vertices from each crease that folds to the next; how many (I,) do.

    Parameters
    ----------
    folds
        Which edges (E,) fold.

    Returns
    -------
    Angles, 0 behind the last (radians), and numbers of creases.
    """
    creases, _ = pattern.fans
    sectors = np.nan_to_num(pattern.sectors)
    angles = np.cumsum(sectors, axis=1) - sectors
    live = np.append(folds, False)[creases]
    count = live.sum(axis=1)
    order = np.argsort(~live, axis=1, kind="stable")
    here = np.take_along_axis(angles, order, axis=1)
    place = np.arange(live.shape[1])[None]
    after = np.take_along_axis(here, (place + 1) % np.maximum(count, 1)[:, None], axis=1)
    turn = np.where(place < count[:, None], np.mod(after - here, 2 * np.pi), 0.0)
    return turn, count
