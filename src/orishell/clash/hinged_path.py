"""First contact of whole boards and their arms, whose hinges stand beside the creases.

A body on panel p is where its panel has it, shifted by s_p (:mod:`~orishell.motion.hinges`). As
the shift changes by h (n_p - n_q) from a panel to the next,

    abs(s_p'' - s_q'') <= sum of abs(h) (abs(n_p'') + abs(n_q''))

over the creases between them, in any order of rows and columns: that is added to the bounds between
their vertices. Seen from a vertex that both panels have, with heights z counted from the hinge h
between them, two corners are

    x_p - x_q = (alpha u + beta w)_p - (alpha u + beta w)_q + (z_p - h) n_p - (z_q - h) n_q

apart; opposite each other, with a panel m between hinges at the heights h and k,

    ... + (z_p - h) n_p - (z_q - k) n_q + (h - k) n_m,

which takes no shifts and keeps what is near the vertex and the hinges near.

Bodies in the quarters of space beside one hinge, below a valley's on either side of its crease, or
above a mountain's, turn about it by less than half a turn, and the quarters never overlap: such
pairs are settled (docs/theory/thickness.md).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.clash.acceleration_bounds import EdgeBounds, NormalBounds, RangeBounds
from orishell.clash.bodies import Apartness, Bodies, BodyState, one_direction
from orishell.clash.body_path import BodySearch, NearPairs, first_contact
from orishell.clash.broad_phase import CHUNK, Extents, Pairs, PanelTree, body_gaps, joined, selected
from orishell.clash.narrow_phase import Findings, Group
from orishell.clash.path import PathRange
from orishell.clash.ranges import PathResult
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import record
from orishell.motion import Mechanism
from orishell.motion.hinges import Hinges
from orishell.motion.layout import Layout
from orishell.motion.quads import grid_corners
from orishell.numerics.arrays import Array, Booleans, Integers

TOUCHING = 1e-9
"""Bodies may reach beyond their hinge by so much of the thickness: rounding."""


def find_first_hinged_contact(
    mechanism: Mechanism,
    end: float,
    tolerance: float,
    bodies: Bodies,
    progress: Progress = no_progress,
) -> PathResult:
    """Return where two bodies of whole boards first come within a tolerance.

    Those on one panel, and those that are settled beside a hinge, are left out.
    """
    assert bodies.hinges is not None
    hinges = bodies.hinges

    def search(until: float) -> BodySearch:
        return HingedSearch(mechanism, until, tolerance, bodies)

    return first_contact(search, end, near_bodies(bodies, hinges), progress)


class HingedSearch(BodySearch):
    """A search for the first contact of bodies whose panels have no common vertex.

    Nodes of its tree hold panels with all that stands on them, shifted as they are.
    """

    def _tree(
        self, mechanism: Mechanism, end: float, layout: Layout, bodies: Bodies | None
    ) -> tuple[PanelTree, EdgeBounds]:
        assert bodies is not None
        tree = PanelTree.over(layout.faces, layout.first.astype(np.float64))
        return tree, ShiftedBounds(mechanism, end, tree, bodies)

    def _swung(self, part: PathRange, level: int, pairs: Pairs) -> Array:
        assert isinstance(part.bounds, ShiftedRange)
        swings = part.bounds.swings.high[level][:, 0]
        # Nodes of empty places have none; their gap is infinite anyway.
        return np.asarray(np.maximum(swings[pairs[0]], 0.0) + np.maximum(swings[pairs[1]], 0.0))

    def _narrow_phase(self, part: PathRange, near: Pairs) -> Findings:
        bounds, bodies = part.bounds, self.bodies
        assert isinstance(bounds, ShiftedRange)
        tolerance = self.tolerance + self.rounding
        start, stop = (self.states.at(tick) for tick in (part.start, part.stop))
        ends = start.body_extents, stop.body_extents
        pairs = joined([part.open, bodies.pairs_of(near)[0]])
        self.tests += len(pairs[0])
        needed = bounds.between_bodies(bodies, pairs) * part.step**2 / 8 + tolerance
        left = np.asarray(body_gaps(ends, pairs) <= needed)
        pairs, needed = selected(pairs, left), needed[left]
        states = start.bodies, stop.bodies
        # Most are seen apart along the normal of one of the boards, which needs no other looks.
        for body in (0, 1):
            lines = [state.normals[0][:, pairs[body]] for state in states]
            left = _near_along(lines, states, pairs, needed)
            pairs, needed = selected(pairs, left), needed[left]
        return _findings(states, pairs, tolerance, needed)


def _findings(
    states: tuple[BodyState, BodyState], pairs: Pairs, tolerance: float, needed: Array
) -> Findings:
    """The pairs (P,) that are not as far apart as is needed (P,), and those that touch at an end.

    Directions square to two edges are ten times as many as normals, and part hardly more: only
    where normals show no gap do they tell whether bodies touch. Others wait for shorter steps.
    """

    def near(apart: Apartness, pairs: Pairs, needed: Array) -> Booleans:
        lines = [one_direction(state, pairs, apart.number) for state in states]
        return _near_along(lines, states, pairs, needed)

    by_faces = Apartness.of(states, pairs, of_faces=True)
    left = near(by_faces, pairs, needed)
    deep = left & (by_faces.gaps <= tolerance).any(axis=0)
    touching = selected(pairs, deep)
    apart = Apartness.of(states, touching)
    left[deep] = near(apart, touching, needed[deep])
    ends = (apart.touching(end, touching, tolerance) for end in (0, 1))
    return Findings(selected(pairs, left), *ends)


def _near_along(
    lines: Sequence[Array], states: tuple[BodyState, BodyState], pairs: Pairs, needed: Array
) -> Booleans:
    """Pairs (P,) kept as far apart as is needed neither by one of two directions (3, P) nor by one
    that turns from the one to the other.
    """
    left = np.zeros(len(needed), np.bool_)
    for k in range(0, len(needed), CHUNK):
        part = slice(k, k + CHUNK)
        chunk = pairs[0][part], pairs[1][part]
        corners = [(s.corners[:, :, chunk[0]], s.corners[:, :, chunk[1]]) for s in states]
        number = np.arange(k, k + len(chunk[0]))
        group = Group((number, number), corners, needed[part], needed[part])
        group = group.not_separated_by(*(each[:, part] for each in lines))
        left[group.pairs[0]] = True
    return left


class ShiftedBounds(EdgeBounds):
    """Bounds of accelerations between points that are shifted with their panels."""

    def __init__(self, mechanism: Mechanism, end: float, tree: PanelTree, bodies: Bodies) -> None:
        super().__init__(mechanism, end, tree)
        assert bodies.hinges is not None
        self.tree, self.bodies, self.hinges = tree, bodies, bodies.hinges
        self.normals = NormalBounds(grid_corners(mechanism.positions(0.0)))
        self.reach = np.maximum(np.abs(bodies.low), np.abs(bodies.high))

    def within(self, start: float, stop: float) -> RangeBounds:
        """The bounds from one share of the path to another."""
        plain = super().within(start, stop)
        normals = self.normals.within(*plain.steps)
        n = normals.reshape(self.hinges.levels.shape)
        down = np.abs(self.hinges.heights.row) * (n[:-1] + n[1:])
        across = np.abs(self.hinges.heights.column) * (n[:, :-1] + n[:, 1:])
        swings = self.reach * normals[self.bodies.panels]
        largest = np.maximum.reduceat(swings, self.bodies.first)[:, None]
        return ShiftedRange(
            plain.steps,
            plain.along,
            plain.down,
            plain.hull,
            plain.layout,
            swings,
            self.tree.enclosing(0.0 * largest, largest),
            np.append(0.0, np.cumsum(across.max(axis=0))),
            np.append(0.0, np.cumsum(down.max(axis=1))),
        )


@record
class ShiftedRange(RangeBounds):
    """Bounds in one part of the path, of shifts as well."""

    of_bodies: Array  # bounds (B,) of accelerations of corners of bodies over their panels
    swings: Extents  # 0, and the largest of these, of the nodes of the tree
    # running sums of those of shifts from panel to panel, across (C-1,) and down (R-1,)
    across: Array
    below: Array

    def between_bodies(self, bodies: Bodies, pairs: Pairs) -> Array:
        """Bound (P,) of the acceleration of any vector between corners of two bodies."""
        first, second = (bodies.panels[each] for each in pairs)
        swings = self.of_bodies[pairs[0]] + self.of_bodies[pairs[1]]
        return np.asarray(self.between_panels(first, second) + swings)

    def _across(self, begin: Integers, end: Integers) -> Array:
        plain = RangeBounds._across(self, begin, end)
        last = np.maximum(end - 1, begin)
        shifts = self.below[last[0]] - self.below[begin[0]]
        return np.asarray(plain + shifts + self.across[last[1]] - self.across[begin[1]])


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
    height, sign, first, second, shared = (
        np.concatenate([each.ravel() for each in both])
        for both in (
            (hinges.heights.row, hinges.heights.column),
            (hinges.signs.row, hinges.signs.column),
            (number[:-1], number[:, :-1]),
            (number[1:], number[:, 1:]),
            (vertex[1:-1, :-1], vertex[:-1, 1:-1]),
        )
    )
    pairs, which = bodies.pairs_of((first, second))
    left = ~_settled(bodies, pairs, height[which], sign[which], hinges.thickness)
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
    pairs, vertices, bases, middles, steps = zip(*found, strict=True)
    return NearPairs(
        joined(pairs),
        np.concatenate(vertices),
        np.concatenate(bases, axis=1),
        np.concatenate(middles),
        np.concatenate(steps),
    )


def _settled(bodies: Bodies, pairs: Pairs, height: Array, sign: Array, thickness: float) -> Booleans:
    """Which pairs (P,) lie in the quarters of space beside a hinge (P,), or do not move at all."""
    rounding = TOUCHING * thickness
    below = np.maximum(bodies.high[pairs[0]], bodies.high[pairs[1]]) <= height + rounding
    above = np.minimum(bodies.low[pairs[0]], bodies.low[pairs[1]]) >= height - rounding
    return np.where(sign > 0, below, np.where(sign < 0, above, True)).astype(np.bool_)
