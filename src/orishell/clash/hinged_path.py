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
"""

from __future__ import annotations

import numpy as np

from orishell.clash.acceleration_bounds import EdgeBounds, NormalBounds, RangeBounds, Running
from orishell.clash.bodies import Bodies
from orishell.clash.body_path import BodySearch, first_contact
from orishell.clash.broad_phase import Extents, Pairs, PanelTree, body_gaps, selected
from orishell.clash.hinged_pairs import near_bodies
from orishell.clash.narrow_phase import near_along
from orishell.clash.path import PathRange
from orishell.clash.ranges import PathResult
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import record
from orishell.motion import Mechanism
from orishell.motion.hinges import Hinges
from orishell.motion.layout import points_of
from orishell.numerics.arrays import Array, Integers


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
    assert isinstance(bodies.hinges, Hinges)

    def search(until: float) -> BodySearch:
        return HingedSearch(mechanism, until, tolerance, bodies)

    return first_contact(search, end, near_bodies(bodies, bodies.hinges), progress)


class HingedSearch(BodySearch):
    """A search for the first contact of bodies whose panels have no common vertex.

    Nodes of its tree hold panels with all that stands on them, shifted as they are.
    """

    def _tree(
        self, mechanism: Mechanism, ends: tuple[float, float], bodies: Bodies | None
    ) -> tuple[PanelTree, EdgeBounds]:
        assert bodies is not None
        tree = PanelTree.over(self.layout.faces, self.layout.first.astype(np.float64))
        return tree, ShiftedBounds(mechanism, ends, tree, bodies)

    def _swung(self, part: PathRange, level: int, pairs: Pairs) -> Array:
        assert isinstance(part.bounds, ShiftedRange)
        swings = part.bounds.swings.high[level][:, 0]
        # Nodes of empty places have none; their gap is infinite anyway.
        return np.asarray(np.maximum(swings[pairs[0]], 0.0) + np.maximum(swings[pairs[1]], 0.0))

    def _not_seen_apart(self, part: PathRange, near: Pairs) -> tuple[Pairs, Array]:
        start, stop = (self.states.at(tick) for tick in (part.start, part.stop))
        states = start.bodies, stop.bodies
        pairs = self.bodies.pairs_of(near)[0]
        needed = self._needed(part, pairs)
        left = np.asarray(~(body_gaps((start.body_extents, stop.body_extents), pairs) > needed))
        pairs, needed = selected(pairs, left), needed[left]
        # Most are seen apart along the normal of one of the boards, which needs no other looks.
        for body in (0, 1):
            lines = [state.normals[0][:, pairs[body]] for state in states]
            left = near_along(lines, states, pairs, needed)
            pairs, needed = selected(pairs, left), needed[left]
        return pairs, needed

    def _needed(self, part: PathRange, pairs: Pairs) -> Array:
        assert isinstance(part.bounds, ShiftedRange)
        between = part.bounds.between_bodies(self.bodies, pairs)
        return np.asarray(self.tolerance + self.rounding + part.step**2 / 8 * between)


class ShiftedBounds(EdgeBounds):
    """Bounds of accelerations between points that are shifted with their panels."""

    def __init__(
        self, mechanism: Mechanism, ends: tuple[float, float], tree: PanelTree, bodies: Bodies
    ) -> None:
        super().__init__(mechanism, ends, tree)
        assert isinstance(bodies.hinges, Hinges)
        self.tree, self.bodies, self.hinges = tree, bodies, bodies.hinges
        self.normals = NormalBounds(self.layout, points_of(mechanism, 0.0))
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
            Running.of(across.max(axis=0)),
            Running.of(down.max(axis=1)),
        )


@record
class ShiftedRange(RangeBounds):
    """Bounds in one part of the path, of shifts as well."""

    of_bodies: Array  # bounds (B,) of accelerations of corners of bodies over their panels
    swings: Extents  # 0, and the largest of these, of the nodes of the tree
    # running sums of those of shifts from panel to panel, across (C-1,) and down (R-1,)
    across: Running
    below: Running

    def between_bodies(self, bodies: Bodies, pairs: Pairs) -> Array:
        """Bound (P,) of the acceleration of any vector between corners of two bodies."""
        first, second = (bodies.panels[each] for each in pairs)
        swings = self.of_bodies[pairs[0]] + self.of_bodies[pairs[1]]
        return np.asarray(self.between_panels(first, second) + swings)

    def _across(self, begin: Integers, end: Integers) -> Array:
        plain = RangeBounds._across(self, begin, end)
        last = np.maximum(end - 1, begin)
        shifts = self.below.between(begin[0], last[0]) + self.across.between(begin[1], last[1])
        return np.asarray(plain + shifts)
