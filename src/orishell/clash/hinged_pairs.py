"""Bodies of whole boards whose panels have a vertex in common, and which of them cannot meet.

Bodies in the quarters of space beside one hinge, below a valley's on either side of its crease, or
above a mountain's, turn about it by half a turn at most, and the quarters never overlap: such pairs
are settled (docs/theory/thickness.md). So are the knuckle of a hinge and its two boards with the
arms that carry it: they end at its radius from the axis, and turn about it.
"""

from __future__ import annotations

import numpy as np

from orishell.clash.bodies import Bodies, NearPairs
from orishell.clash.broad_phase import Pairs, joined, selected
from orishell.motion.boards import ARM, KNUCKLE
from orishell.motion.hinges import Hinges
from orishell.numerics.arrays import Array, Booleans, Integers

TOUCHING = 1e-9
"""Bodies may reach beyond their hinge by so much of the thickness: rounding."""


def near_bodies(bodies: Bodies, hinges: Hinges) -> NearPairs:
    """Pairs of bodies whose panels have a vertex in common, but those settled beside a hinge."""
    parts = [_beside_hinges(bodies, hinges), _about_vertices(bodies, hinges)]
    return NearPairs(
        joined([each.bodies for each in parts]),
        np.concatenate([each.vertices for each in parts]),
        np.concatenate([each.bases for each in parts], axis=1),
        np.concatenate([each.between for each in parts]),
        np.concatenate([each.steps for each in parts]),
    )


def _beside_hinges(bodies: Bodies, hinges: Hinges) -> NearPairs:
    """Pairs of bodies beside a hinge one of which reaches beyond it."""
    number = np.arange(hinges.levels.size).reshape(hinges.levels.shape)
    vertex = hinges.grid.vertices()
    row, column = np.full(hinges.heights.row.shape, 1), np.full(hinges.heights.column.shape, 2)
    height, sign, first, second, shared, of_first, of_second = (
        np.concatenate([each.ravel() for each in both])
        for both in (
            (hinges.heights.row, hinges.heights.column),
            (hinges.signs.row, hinges.signs.column),
            (number[:-1], number[:, :-1]),
            (number[1:], number[:, 1:]),
            (vertex[1:-1, :-1], vertex[:-1, 1:-1]),
            # Numbers of the hinge's edge in EDGES, of the first and the second panel.
            (row, column),
            (row + 2, column - 2),
        )
    )
    pairs, which = bodies.pairs_of((first, second))
    left = ~_settled(bodies, pairs, height[which], sign[which], hinges.thickness)
    left &= ~_about_knuckle(bodies, pairs, of_first[which], of_second[which])
    pairs, which = selected(pairs, left), which[left]
    base = height[which]
    return NearPairs(
        pairs, shared[which], np.stack([base, base]), bodies.panels[pairs[0]], 0.0 * base
    )


def _about_vertices(bodies: Bodies, hinges: Hinges) -> NearPairs:
    """Pairs of bodies opposite each other at a vertex."""
    number = np.arange(hinges.levels.size).reshape(hinges.levels.shape)
    vertex = hinges.grid.vertices()[1:-1, 1:-1]
    row, column = hinges.heights.row, hinges.heights.column
    left, right, up, down = row[:, :-1], row[:, 1:], column[:-1], column[1:]
    upper, lower = (number[:-1, :-1], number[:-1, 1:]), (number[1:, :-1], number[1:, 1:])
    # Left above to right below, over either of the two others, and right above to left below.
    ways = [
        (upper[0], lower[1], [(upper[1], up, right), (lower[0], left, down)]),
        (upper[1], lower[0], [(upper[0], up, left), (lower[1], right, down)]),
    ]
    signs = hinges.signs
    found = []
    for first, second, between in ways:
        pairs, which = bodies.pairs_of((first.ravel(), second.ravel()))
        by_row, by_column = (
            _settled(bodies, pairs, each.ravel()[which], sign.ravel()[which], hinges.thickness)
            & (still.ravel()[which] == 0)
            for each, sign, still in (
                (left, signs.row[:, :-1], signs.column[:-1]),
                (up, signs.column[:-1], signs.row[:, :-1]),
            )
        )
        open_ones = ~(by_row | by_column)
        pairs, which = selected(pairs, open_ones), which[open_ones]
        (m, h, k), (other, g, f) = ([each.ravel()[which] for each in way] for way in between)
        nearer = np.abs(h - k) <= np.abs(g - f)
        h, k, m = (np.where(nearer, *both) for both in ((h, g), (k, f), (m, other)))
        found.append((pairs, vertex.ravel()[which], np.stack([h, k]), m, np.abs(h - k)))
    return NearPairs(
        joined([each[0] for each in found]),
        np.concatenate([each[1] for each in found]),
        np.concatenate([each[2] for each in found], axis=1),
        np.concatenate([each[3] for each in found]),
        np.concatenate([each[4] for each in found]),
    )


def _about_knuckle(bodies: Bodies, pairs: Pairs, first: Integers, second: Integers) -> Booleans:
    """Which pairs (P,) are a knuckle and what turns about it: a board, or an arm of its hinge.

    The hinge is at edges ``first`` (P,) and ``second`` (P,) of their panels.
    """
    edges = bodies.edges_of
    if edges is None:
        return np.zeros(len(first), np.bool_)
    knuckle = (bodies.sides[pairs[0]] == KNUCKLE) & (edges[pairs[0]] == first)
    arm = (bodies.sides[pairs[1]] == ARM) & (edges[pairs[1]] == second)
    return np.asarray(knuckle & ((edges[pairs[1]] < 0) | arm))


def _settled(
    bodies: Bodies, pairs: Pairs, height: Array, sign: Array, thickness: float
) -> Booleans:
    """Which pairs (P,) lie in the quarters of space beside a hinge (P,), or do not move at all."""
    rounding = TOUCHING * thickness
    below = np.maximum(bodies.high[pairs[0]], bodies.high[pairs[1]]) <= height + rounding
    above = np.minimum(bodies.low[pairs[0]], bodies.low[pairs[1]]) >= height - rounding
    return np.where(sign > 0, below, np.where(sign < 0, above, True)).astype(np.bool_)
