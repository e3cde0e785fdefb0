"""First contact along a path of folding, with a proof that there is none before.

Between two states at drives a and b every vector between two vertices stays within
(b-a)^2/8 times a bound of its acceleration of the straight line. So a direction along which two
panels are apart by more than that in both states keeps them apart in between, and so does one
that turns evenly from one state to the other (see ``turning_gap``). Where no direction does, the
range of the drive is halved. Ranges are worked through in the order of the drive, so what is
found is the first contact, and everything before it is proved.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from orishell.clash.closely import Closely, look_closely
from orishell.clash.swing import Swing
from orishell.clash.tree import Extents, Pairs, PanelTree, chosen, gaps, joined, split
from orishell.motion import Mechanism

Array = NDArray[np.float64]
Booleans = NDArray[np.bool_]

TICKS = 1 << 36
"""Smallest steps along a path: a contact is found to this part of it."""
BASE = 8
"""Ranges to begin with."""
ROUNDING = 1e-14
"""Rounding of coordinates, relative to the largest."""
STATES_KEPT = 16
LENIENCE = 1e-4
"""Share of the tolerance that holds for panels that are to clash at the end."""
CROWD = 64
"""Pairs per node from which it is better to halve the range than to look at each: where a sheet
runs through itself all over at the end of a range, its first contact is far from there."""
CROWDED_ABOVE = TICKS >> 20
"""Ranges no longer than this are looked at, whatever the crowd (ticks)."""
WORTH_HALVING = 4.0
"""A pair of nodes waits for half the step if a quarter of the bound would do."""
WORTH_SPLITTING = 3.0
"""It also does if the bound is so many times the room and that of motions within the nodes: then
their parts are no better off."""


@dataclass(frozen=True, slots=True)
class Proof:
    """How the path was examined.

    Parameters
    ----------
    states
        Number of states whose positions were computed.
    ranges
        Number of ranges of the drive between two of them.
    tests
        Number of pairs, of panels or of groups of panels, that were tested in a range.
    largest_step, smallest_step
        Widest and narrowest range (radians).
    tolerance
        Distance below which panels touch (length).
    """

    states: int
    ranges: int
    tests: int
    largest_step: float
    smallest_step: float
    tolerance: float


@dataclass(frozen=True, slots=True)
class PathContact:
    """The first contact on a path.

    Parameters
    ----------
    drive
        Where two panels touch (radians).
    clear_until
        Up to here no two panels touch, proved (radians).
    panels
        Numbers of the two panels.
    """

    drive: float
    clear_until: float
    panels: tuple[int, int]


@dataclass(frozen=True, slots=True)
class PathResult:
    """What was found on a path: the first contact, or None, and how.

    Parameters
    ----------
    contact
        The first contact, or None.
    proof
        How the path was examined.
    """

    contact: PathContact | None
    proof: Proof


def find_first_contact(
    mechanism: Mechanism,
    end: float,
    tolerance: float,
    *,
    lenient: Callable[[Pairs], Booleans] | None = None,
    only: Booleans | None = None,
    advanced: Callable[[float], None] | None = None,
) -> PathResult:
    """Find where two panels without a common vertex first come within a tolerance.

    Panels that share a crease meet where it is folded flat; panels that share a vertex only,
    opposite each other, cannot touch before one of its four creases is: where the arcs that they
    cut from a sphere about the vertex first meet, an end of one lies on the other, and the arc
    between them covers it. Both are seen from the fold angles, not here.

    Parameters
    ----------
    mechanism
        The folding sheet.
    end
        The path goes from the flat sheet to this drive (radians).
    tolerance
        Distance at which panels count as touching (length).
    lenient
        Says which pairs of panels (P,) touch only within a ten-thousandth of the tolerance: those
        that are to clash at the end.
    only
        Panels (F,): pairs with none of them are left out. All panels if None.
    advanced
        Called with the share of the path that is done.

    Returns
    -------
    PathResult
        The first contact if there is one, and how it was looked for.
    """
    search = _Search(mechanism, end, tolerance, lenient, only)
    return search.run(advanced or (lambda share: None))


@dataclass(slots=True, eq=False)
class _State:
    points: Array
    extents: Extents | None = None


@dataclass(slots=True, eq=False)
class _Range:
    """Part of the path with the pairs that are not proved apart in it, by level of the tree."""

    start: int
    stop: int
    nodes: list[list[Pairs]]
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
        self.swing = Swing(mechanism, end, self.tree)
        self.wanted = _flags(self.tree, only)
        self.kept: OrderedDict[int, _State] = OrderedDict()
        self.states = self.ranges = self.tests = 0
        self.steps = (np.inf, 0.0)
        self.rounding = ROUNDING * float(np.abs(self.state(0).points).max())

    def run(self, advanced: Callable[[float], None]) -> PathResult:
        """Work through the ranges in the order of the drive."""
        root = (np.zeros(1, np.int64), np.zeros(1, np.int64))
        step = TICKS // BASE
        stack = [
            _Range(k * step, (k + 1) * step, [[root]], joined([])) for k in reversed(range(BASE))
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
            if not len(panels.open[0]) and not any(waiting):
                clear = part.stop
                advanced(clear / TICKS)
            elif part.stop - part.start == 1:
                found = (part.stop, (int(panels.open[0][0]), int(panels.open[1][0])))
                break
            else:
                middle = (part.start + part.stop) // 2
                stack.append(_Range(middle, part.stop, waiting, panels.open))
                stack.append(_Range(part.start, middle, waiting, panels.open))
        advanced(1.0)
        contact = None
        if found is not None:
            contact = PathContact(self._drive(found[0]), self._drive(clear), found[1])
        proof = Proof(self.states, self.ranges, self.tests, *self.steps[::-1], self.tolerance)
        return PathResult(contact, proof)

    def state(self, tick: int) -> _State:
        """A state, kept for a while."""
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

    def _examine(self, part: _Range) -> tuple[list[list[Pairs]], Closely]:
        """Pairs of nodes, and of panels, that are not proved apart in a range."""
        step = self._drive(part.stop) - self._drive(part.start)
        self.ranges += 1
        self.steps = (min(self.steps[0], step), max(self.steps[1], step))
        bound = self.swing.between(part.start / TICKS, part.stop / TICKS)
        stray = step**2 / 8
        near: Pairs = joined([])
        waiting: list[list[Pairs]] = []
        fresh: Pairs = joined([])
        for level in range(self.tree.depth + 1):
            given = part.nodes[level] if level < len(part.nodes) else []
            pairs = joined([*given, fresh])
            waiting.append([])
            fresh = joined([])
            if not len(pairs[0]):
                continue
            self.tests += len(pairs[0])
            gap = gaps((self._extents(part.start), self._extents(part.stop)), level, pairs)
            room = gap - self.tolerance - self.rounding
            need = stray * bound.accelerations(level, *pairs)
            near_by = room <= need
            pairs, room, need = chosen(pairs, near_by), room[near_by], need[near_by]
            if len(room) > CROWD << level and part.stop - part.start > CROWDED_ABOVE:
                waiting[level] = [pairs]
                continue
            halving = np.zeros(len(room), np.bool_)
            if part.stop - part.start > 1:
                own = stray * (bound.within(level, pairs[0]) + bound.within(level, pairs[1]))
                soon = (need <= WORTH_HALVING * room) & (level < self.tree.depth)
                halving = (room > 0) & (soon | (need > WORTH_SPLITTING * np.maximum(own, room)))
            waiting[level] = [chosen(pairs, halving)] if halving.any() else []
            if level == self.tree.depth:
                near = self._panels(chosen(pairs, ~halving))
                break
            fresh = self._wanted(level + 1, split(chosen(pairs, ~halving)))
        pairs = joined([part.panels, near])
        self.tests += len(pairs[0])
        tolerance = np.full(len(pairs[0]), self.tolerance)
        if self.lenient is not None:
            tolerance[self.lenient(pairs)] *= LENIENCE
        tolerance += self.rounding
        needed = stray * bound.of_panels(*pairs)
        points = (self.state(part.start).points, self.state(part.stop).points)
        return waiting, look_closely(points, self.tree.faces, pairs, tolerance, needed)

    def _panels(self, pairs: Pairs) -> Pairs:
        """Panels at places of the lowest level, those that share a vertex left out."""
        first, second = (self.tree.panels[nodes] for nodes in pairs)
        pairs = chosen((first, second), (first >= 0) & (second >= 0) & (first != second))
        return chosen(pairs, ~self.tree.share_corner(*pairs))

    def _wanted(self, level: int, pairs: Pairs) -> Pairs:
        """Pairs with a panel that is asked for."""
        if self.wanted is None:
            return pairs
        flags = self.wanted[level]
        return chosen(pairs, flags[pairs[0]] | flags[pairs[1]])


def _flags(tree: PanelTree, only: Booleans | None) -> list[Booleans] | None:
    """Which nodes of every level hold panels that are asked for."""
    if only is None:
        return None
    held = tree.gathered(np.zeros((len(only), 1)), only[:, None].astype(np.float64))
    return [level[:, 0] > 0 for level in held.high]
