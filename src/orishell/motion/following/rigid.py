"""What cannot fold, proved vertex by vertex.

Round an inner vertex the panels cut a closed polygon of length 2 pi from a sphere; its corners are
the creases, its sides the sectors. So creases that do fold are at least two. Two are in line, and
fold alike. Three have a sector of pi between them: a triangle whose sides are less has a perimeter
below 2 pi. If a sector is above pi, the others join its ends on the shortest way, which is
straight. And from flat not all of three or more fold to one side: a convex polygon is shorter than
2 pi.

Nor does it fold from flat if some direction w has s u . w at least 0 for all of its creases, of
signs s along u, and more for some. Rates of fold angles at a vertex, each along its crease as it
lies then, add up to 0, and so do their parts along w: sizes times s u . w, of which near the flat
state all that are not 0 are positive. So these creases stand still, but for those that lie across
w: one such crease has a rate that is bounded by theirs, and stands still, too. Two are in line, and
what is on either side of them is a chain as long as a half circle that turns one way, so that its
ends leave the way between them at a right angle: to the same hand, the line folded flat.

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
UNSURE = 100.0
"""Nor do rates that are less than so many times as large."""


@record
class Rigid:
    """Creases that do not fold in any state, and vertices whose letters cannot be."""

    flat: Booleans  # which edges (E,) are creases that are proved not to fold, letter F left out
    one_sided: Integers  # vertices at which all creases are asked to fold to one side
    crossing: Integers  # vertices at which two straight lines cross that are both asked to fold
    # vertices whose creases, by their letters, all pull to one side, or are four of other letters
    # than those with which four fold
    against: Integers


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
        return Rigid(np.zeros(len(folds), np.bool_), none, none, none)
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
    # Lines that bend by little fold together a little: what is said rests on straight ones.
    straight = np.abs(between[:, :2].sum(axis=1) - np.pi) <= EXACT
    straight &= np.abs(between[:, 1:3].sum(axis=1) - np.pi) <= EXACT
    crossing = (count == 4) & straight & (np.abs(signs).sum(axis=1) == 4)
    _, ends = pattern.fans
    way = pattern.vertices[ends] - pattern.vertices[pattern.inner][:, None]
    along = np.arctan2(way[..., 1], way[..., 0])
    against = _pulled(along, signs, exact)
    four = np.flatnonzero((count == 4) & (np.abs(signs).sum(axis=1) == 4))
    if len(four):
        chosen = np.argsort(signs[four] == 0, axis=1, kind="stable")[:, :4]
        ways, asked = (np.take_along_axis(each[four], chosen, axis=1) for each in (along, signs))
        against[four] |= _not_of_four(ways, asked, exact)
    return Rigid(flat, pattern.inner[alike], pattern.inner[crossing], pattern.inner[against])


def _pulled(along: Array, signs: Array, exact: float) -> Booleans:
    """At which inner vertices (I,) all creases, by signs (I, D), pull to one side of a line.

    Signs are 0 for what does not fold, and NaN where none is asked for; directions in radians.
    """
    angles = np.mod(along + np.where(signs < 0, np.pi, 0), 2 * np.pi)
    angles = np.sort(np.where(signs == 0, np.nan, angles), axis=1)  # NaN last
    count = (np.nan_to_num(signs, nan=1.0) != 0).sum(axis=1)
    last = np.take_along_axis(angles, np.maximum(count - 1, 0)[:, None], axis=1)
    gaps = np.diff(angles, axis=1, append=np.nan)
    wrapped = angles[:, :1] + 2 * np.pi - last
    widest = np.fmax(np.nanmax(np.nan_to_num(gaps), axis=1), wrapped[:, 0])
    # All along one line, to either side: that folds.
    lines = np.abs(np.mod(angles - angles[:, :1] + np.pi / 2, np.pi) - np.pi / 2)
    straight = np.nanmax(np.nan_to_num(lines), axis=1) <= exact
    straight &= widest <= np.pi + exact
    known = ~np.isnan(signs).any(axis=1)
    one_side = (np.abs(widest - np.pi) <= EXACT) | (widest > np.pi + exact)
    return np.asarray(known & (count > 0) & one_side & ~straight)


def _not_of_four(along: Array, signs: Array, exact: float) -> Booleans:
    """At which vertices (N,) four creases do not fold with signs (N, 4) from flat.

    Near the flat state rates c fulfil sum c_i u_i = 0 and sum of c_i c_k (u_i x u_k), i < k, = 0:
    two lines in a plane, of which each is a motion. A crease has rate 0 in one of them only if two
    others are in line, and fold alone.
    """
    axes = np.stack([np.cos(along), np.sin(along)], axis=1)
    basis = np.linalg.svd(axes)[2][:, 2:]
    cross = np.sin(along[:, None] - along[:, :, None])
    form = basis @ (np.triu(cross, 1) / 2) @ basis.transpose(0, 2, 1)
    values, vectors = np.linalg.eigh(form + form.transpose(0, 2, 1))
    low, high = values[:, 0], values[:, 1]
    size = np.sqrt(np.stack([np.maximum(high, 0), np.maximum(-low, 0)], axis=-1))
    fits = np.zeros(len(along), np.bool_)
    for side in (1.0, -1.0):
        rates = (size * [1.0, side])[:, None] @ vectors.transpose(0, 2, 1) @ basis
        rates = rates[:, 0] / np.maximum(np.abs(rates).max(axis=2), np.finfo(float).tiny)
        unsure = (np.abs(rates) > EXACT) & (np.abs(rates) < UNSURE * exact)
        moves = np.where(np.abs(rates) > EXACT, np.sign(rates), 0.0)
        for turned in (moves, -moves):
            fits |= ((turned == signs) | unsure).all(axis=1)
    return ~fits & (low <= -exact) & (high >= exact)


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
            f"two straight lines cross at vertex {rigid.crossing[0]}, and only one of them folds; "
            f"so at {_vertices(rigid.crossing)}"
        )
    if len(rigid.against):
        return (
            f"the letters at vertex {rigid.against[0]} do not let its creases fold together from "
            f"flat; so at {_vertices(rigid.against)}"
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
