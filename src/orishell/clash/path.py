"""First contact along a path of folding, with a proof that there is none before.

Between two states at drives a and b every vector e between two vertices stays near the straight
line l between its values there, by its chord error,

    abs(e - l) <= (b - a)^2 / 8 * max abs(e'').

So a direction along which two panels are apart by more than that in both states keeps them apart
in between, and so does one that turns evenly from one state to the other (see ``turning_gap``).
Where no direction does, the range of the drive is halved. Ranges are worked through in the order of
the drive, so what is found is the first contact, and everything before it is proved.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from orishell.clash.acceleration_bounds import EdgeBounds, RangeBounds
from orishell.clash.broad_phase import (
    Extents,
    Pairs,
    PanelTree,
    child_pairs,
    gaps,
    joined,
    selected,
)
from orishell.clash.narrow_phase import Findings, examine_pairs
from orishell.clash.result import PathContact, PathResult, ProofRecord
from orishell.conventions.progress import Progress, unwatched
from orishell.motion import Mechanism
from orishell.numerics.arrays import Array, Booleans

LOOKING = "looking for contact"
TICKS = 1 << 36
"""Smallest steps along a path: a contact is found to this part of it."""
BASE = 8
"""Number of ranges into which the path is divided at first."""
ROUNDING = 1e-14
"""Rounding of coordinates, relative to the largest."""
STATES_KEPT = 16
LENIENCE = 1e-4
"""Share of the tolerance that is used for panels that are meant to clash at the end."""
CROWD = 64
"""Pairs per node from which it is better to halve the range than to look at each: where a sheet
runs through itself all over at the end of a range, its first contact is far from there."""
CROWDED_ABOVE = TICKS >> 20
"""Ranges no longer than this are looked at, whatever the crowd (ticks)."""
WORTH_HALVING = 4.0
"""A pair of nodes waits for half the step if a quarter of the bound would do."""
WORTH_SPLITTING = 3.0
"""A pair waits, too, if its bound is this many times the room and the bound of the motions within
its nodes, because smaller nodes would then be no nearer to a proof."""


def find_first_contact(
    mechanism: Mechanism,
    end: float,
    tolerance: float,
    *,
    lenient: Callable[[Pairs], Booleans] | None = None,
    only: Booleans | None = None,
    progress: Progress = unwatched,
) -> PathResult:
    """Return where two panels without a common vertex first come within a tolerance.

    Panels that share a crease meet where it is folded flat; panels that share a vertex only,
    opposite each other, cannot touch before one of its four creases is: where the arcs that they
    cut from a sphere about the vertex first meet, an end of one lies on the other, and the arc
    between them covers it. Both are seen from the fold angles, which the families keep
    below 180 degrees until the end (docs/theory/locking-and-clash.md), not here.

    Parameters
    ----------
    end
        The path goes from the flat sheet to this drive (radians).
    tolerance
        Distance at which panels count as touching (length).
    lenient
        Says which pairs of panels (P,) touch only within a ten-thousandth of the tolerance: those
        that are to clash at the end.
    only
        Panels (F,): pairs with none of them are left out. All panels if None.
    """
    return _Search(mechanism, end, tolerance, lenient, only).run(progress)


@dataclass(slots=True, eq=False)
class _State:
    points: Array
    extents: Extents | None = None


@dataclass(slots=True, eq=False)
class _Range:
    """Part of the path with the pairs that are not proved apart in it."""

    start: int
    stop: int
    """Its ends, in :data:`TICKS` of the path."""
    nodes: list[Pairs]
    """By level of the tree."""
    panels: Pairs


class _Search:
    def __init__(
        self,
        mechanism: Mechanism,
        end: float,
        tolerance: float,
        lenient: Callable[[Pairs], Booleans] | None,
        only: Booleans | None,
    ) -> None:
        grid = mechanism.grid
        faces = grid.faces_vertices()
        place = np.indices((grid.rows - 1, grid.columns - 1)).reshape(2, -1).T
        self.mechanism, self.end, self.tolerance, self.lenient = mechanism, end, tolerance, lenient
        self.tree = PanelTree.over(faces, place.astype(np.float64))
        self.bounds = EdgeBounds(mechanism, end, self.tree)
        self.wanted = _held(self.tree, only)
        self.kept: OrderedDict[int, _State] = OrderedDict()
        self.states = self.ranges = self.tests = 0
        self.steps = (np.inf, 0.0)
        self.rounding = ROUNDING * float(np.abs(self.state(0).points).max())

    def run(self, progress: Progress) -> PathResult:
        """Work through the ranges in the order of the drive."""
        root = (np.zeros(1, np.int64), np.zeros(1, np.int64))
        step = TICKS // BASE
        stack = [
            _Range(k * step, (k + 1) * step, [root], joined([])) for k in reversed(range(BASE))
        ]
        found: tuple[int, tuple[int, int]] | None = None
        clear = 0
        while stack:
            part = stack.pop()
            if found is not None and part.start >= found[0]:
                break
            waiting, panels = self._examine(part)
            if panels.at_start is not None:
                found = (part.start, panels.at_start)
                break
            if panels.at_stop is not None:
                found = (part.stop, panels.at_stop)
            if not any(len(pairs[0]) for pairs in (panels.open, *waiting)):
                clear = part.stop
                progress(clear / TICKS, LOOKING)
            elif part.stop - part.start == 1:
                found = (part.stop, (int(panels.open[0][0]), int(panels.open[1][0])))
                break
            else:
                middle = (part.start + part.stop) // 2
                stack.append(_Range(middle, part.stop, waiting, panels.open))
                stack.append(_Range(part.start, middle, waiting, panels.open))
        progress(1.0, LOOKING)
        contact = None
        if found is not None:
            contact = PathContact(self._drive(found[0]), self._drive(clear), found[1])
        proof = ProofRecord(self.states, self.ranges, self.tests, *self.steps[::-1], self.tolerance)
        return PathResult(contact, proof)

    def state(self, tick: int) -> _State:
        """The state at a tick of the path; the last few are kept."""
        state = self.kept.get(tick)
        if state is None:
            self.states += 1
            state = _State(self.mechanism.positions(self._drive(tick)).reshape(-1, 3))
            self.kept[tick] = state
            if len(self.kept) > STATES_KEPT:
                self.kept.popitem(last=False)
        self.kept.move_to_end(tick)
        return state

    def _extents(self, tick: int) -> Extents:
        state = self.state(tick)
        if state.extents is None:
            state.extents = self.tree.extents(state.points)
        return state.extents

    def _drive(self, tick: int) -> float:
        return self.end * (tick / TICKS)

    def _examine(self, part: _Range) -> tuple[list[Pairs], Findings]:
        """Pairs of nodes, by level, and of panels that are not proved apart in a range."""
        step = self._drive(part.stop) - self._drive(part.start)
        self.ranges += 1
        self.steps = (min(self.steps[0], step), max(self.steps[1], step))
        bounds = self.bounds.within(part.start / TICKS, part.stop / TICKS)
        waiting, near = self._broad_phase(part, bounds, step)
        pairs = joined([part.panels, near])
        self.tests += len(pairs[0])
        tolerance = np.full(len(pairs[0]), self.tolerance)
        if self.lenient is not None:
            tolerance[self.lenient(pairs)] *= LENIENCE
        tolerance += self.rounding
        chord_error = step**2 / 8 * bounds.between_panels(*pairs)
        points = (self.state(part.start).points, self.state(part.stop).points)
        return waiting, examine_pairs(points, self.tree.faces, pairs, tolerance, chord_error)

    def _broad_phase(
        self, part: _Range, bounds: RangeBounds, step: float
    ) -> tuple[list[Pairs], Pairs]:
        """Pairs of nodes that wait for half the range, by level, and pairs of panels to look at."""
        waiting: list[Pairs] = []
        children: Pairs = joined([])
        for level in range(self.tree.depth + 1):
            pairs = joined([*part.nodes[level : level + 1], children])
            waiting.append(joined([]))
            children = joined([])
            if not len(pairs[0]):
                continue
            self.tests += len(pairs[0])
            gap = gaps((self._extents(part.start), self._extents(part.stop)), level, pairs)
            room = gap - self.tolerance - self.rounding
            chord_error = step**2 / 8 * bounds.between_nodes(level, *pairs)
            near = room <= chord_error
            pairs, room, chord_error = selected(pairs, near), room[near], chord_error[near]
            if len(room) > CROWD << level and part.stop - part.start > CROWDED_ABOVE:
                waiting[level] = pairs
                continue
            halving = np.zeros(len(room), np.bool_)
            if part.stop - part.start > 1:
                # What motions within the two nodes contribute: splitting them saves no more.
                inner = [bounds.between_nodes(level, nodes, nodes) for nodes in pairs]
                own = step**2 / 8 * (inner[0] + inner[1])
                soon = (chord_error <= WORTH_HALVING * room) & (level < self.tree.depth)
                no_better = chord_error > WORTH_SPLITTING * np.maximum(own, room)
                halving = (room > 0) & (soon | no_better)
            waiting[level] = selected(pairs, halving)
            pairs = selected(pairs, ~halving)
            if level == self.tree.depth:
                return waiting, self._panels(pairs)
            children = self._wanted(level + 1, child_pairs(pairs))
        return waiting, joined([])

    def _panels(self, pairs: Pairs) -> Pairs:
        """Pairs of panels from pairs of lowest nodes, those that share a vertex left out."""
        first, second = (self.tree.panels[nodes] for nodes in pairs)
        pairs = selected((first, second), (first >= 0) & (second >= 0) & (first != second))
        return selected(pairs, ~self.tree.share_corner(*pairs))

    def _wanted(self, level: int, pairs: Pairs) -> Pairs:
        """Pairs with a panel that is asked for."""
        if self.wanted is None:
            return pairs
        flags = self.wanted[level]
        return selected(pairs, flags[pairs[0]] | flags[pairs[1]])


def _held(tree: PanelTree, only: Booleans | None) -> list[Booleans] | None:
    """Which nodes of every level hold panels that are asked for."""
    if only is None:
        return None
    held = tree.enclosing(np.zeros((len(only), 1)), only[:, None].astype(np.float64))
    return [level[:, 0] > 0 for level in held.high]
