"""First contact along a path of folding, with a proof that there is none before.

Between two states at drives a and b every vector e between two vertices stays near the straight
line l between its values there, by its chord error,

    abs(e - l) <= (b - a)^2 / 8 * max abs(e'').

So a direction along which two panels are apart by more than that in both states keeps them apart
in between, and so does one that turns evenly from one state to the other (see ``turning_gap``).
Where no direction does, the range of the drive is halved. Ranges are worked through in the order of
the drive, so what is found is the first contact, and everything before it is proved.

Limit: the proof that nothing touches takes minutes for a million panels. ``--no-clash-test`` leaves
it out, and ``report.json`` then says so.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from orishell.clash.acceleration_bounds import EdgeBounds, RangeBounds
from orishell.clash.bodies import Bodies
from orishell.clash.broad_phase import (
    Pairs,
    PanelTree,
    child_pairs,
    gaps,
    joined,
    selected,
)
from orishell.clash.narrow_phase import Findings, examine_pairs
from orishell.clash.open_pairs import OpenPairs
from orishell.clash.ranges import (
    TICKS,
    Found,
    Outcome,
    PathContact,
    PathResult,
    ProofRecord,
    States,
    search_ranges,
)
from orishell.clash.separation import corners_of, nearest
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import record
from orishell.motion import Mechanism
from orishell.motion.convex import ConvexParts
from orishell.motion.layout import Layout
from orishell.numerics.arrays import Array, Booleans

COORDINATE_ROUNDING = 1e-14
"""Rounding of coordinates, relative to the largest: 45 units in the last place."""
LENIENCE = 1e-4
"""Share of the tolerance that is used for panels that are meant to clash at the end."""
CROWD = 8
"""Pairs per node from which a sample tells whether to halve the range rather than to look at each:
where a sheet runs through itself all over at the end of a range, its first contact is far from
there, and where all is near in so long a range each pair would be looked at again in its halves."""
SAMPLE = 512
"""Pairs of panels in such a sample, at most; the range is halved if half of them stay open."""
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
    start: float = 0.0,
    progress: Progress = no_progress,
) -> PathResult:
    """Return where two panels without a common vertex first come within a tolerance.

    Panels that share a crease meet where it is folded flat; panels that share a vertex only,
    opposite each other, cannot touch within their sectors there before one of its four creases is:
    where the arcs that they cut from a sphere about the vertex first meet, an end of one lies on
    the other, and the arc between them covers it. Both are seen from the fold angles, which the
    families keep below 180 degrees until the end (docs/theory/locking-and-clash.md), not here. What
    a panel with a reflex corner has outside of its sector is compared as all others are.

    Parameters
    ----------
    end
        The path goes to this drive (radians).
    tolerance
        Distance at which panels count as touching (length).
    lenient
        Says which pairs of panels (P,) touch only within a ten-thousandth of the tolerance: those
        that are to clash at the end.
    only
        Panels (F,): pairs with none of them are left out. All panels if None.
    start
        The drive that the path begins at, from the flat sheet if it is 0 (radians).

    Raises
    ------
    DesignError
        If panels lie on each other in the flat sheet about a reflex corner.
    """
    search = PathSearch(mechanism, end, tolerance, lenient=lenient, only=only, start=start)
    return search.run(progress)


@record
class PathRange:
    """A range of the path with the pairs that are not proved apart in it."""

    start: int  # TICKS of the path
    stop: int  # TICKS of the path
    step: float  # its width (radians)
    bounds: RangeBounds
    nodes: list[Pairs]  # by level of the tree
    open: OpenPairs  # of panels, or of bodies in their place


NONE = OpenPairs.new(joined([]))
"""No pairs."""
Pending = tuple[list[Pairs], OpenPairs]
"""Pairs of nodes by level, and of panels, that are not proved apart in a range."""


class PathSearch:
    """A search for the first contact of panels without a common vertex, or of bodies on them."""

    def __init__(
        self,
        mechanism: Mechanism,
        end: float,
        tolerance: float,
        *,
        lenient: Callable[[Pairs], Booleans] | None = None,
        only: Booleans | None = None,
        bodies: Bodies | None = None,
        start: float = 0.0,
    ) -> None:
        self.layout = Layout.of(mechanism)
        self.parts = ConvexParts.of(mechanism)
        self.tolerance, self.lenient = tolerance, lenient
        self.tree, self.bounds = self._tree(mechanism, (start, end), bodies)
        self.wanted = _held(self.tree, None if only is None else only[self.parts.panels])
        self.states = States(mechanism, (start, end), self.tree, bodies)
        self.ranges = self.tests = 0
        self.steps = (np.inf, 0.0)
        self.rounding = COORDINATE_ROUNDING * float(np.abs(self.states.at(0).points).max())

    def _tree(
        self, mechanism: Mechanism, ends: tuple[float, float], bodies: Bodies | None
    ) -> tuple[PanelTree, EdgeBounds]:
        """The tree of convex parts of panels, and bounds between its nodes."""
        panels = self.parts.panels
        tree = PanelTree.over(self.parts.faces, self.layout.first[panels].astype(np.float64))
        return tree, EdgeBounds(mechanism, ends, tree, panels)

    def run(self, progress: Progress) -> PathResult:
        """Work through the ranges in the order of the drive."""
        root = (np.zeros(1, np.int64), np.zeros(1, np.int64))
        found, clear = search_ranges(self._examine, ([root], NONE), progress)
        contact = None
        if found is not None:
            contact = self.contact(self.states.drive(found.tick), self.states.drive(clear), found)
        proof = ProofRecord(
            self.states.made, self.ranges, self.tests, *self.steps[::-1], self.tolerance
        )
        return PathResult(contact, proof)

    def contact(self, drive: float, clear: float, found: Found) -> PathContact:
        """Where two panels touch, or are not proved apart."""
        first, second = self.parts.panels[list(found.pair)].tolist()
        apart = None if found.touches else self._distance(found)
        return PathContact(drive, clear, (first, second), apart=apart)

    def _distance(self, found: Found) -> float:
        """How far two parts are apart in a state (length)."""
        points = self.states.at(found.tick).points
        faces = self.parts.faces[list(found.pair)]
        first, second = (corners_of(points, each[None]) for each in faces)
        return float(nearest(first, second)[0][0])

    def _examine(self, start: int, stop: int, pending: Pending) -> Outcome[Pending]:
        """Look at a range for pairs of nodes and of panels that are not proved apart."""
        step = abs(self.states.drive(stop) - self.states.drive(start))
        self.ranges += 1
        self.steps = (min(self.steps[0], step), max(self.steps[1], step))
        bounds = self.bounds.within(start / TICKS, stop / TICKS)
        part = PathRange(start, stop, step, bounds, *pending)
        waiting, near = self._broad_phase(part)
        found = self._narrow_phase(part, near)
        left = found.open
        pair = (int(left.pairs[0][0]), int(left.pairs[1][0])) if len(left) else None
        clear = pair is None and not any(len(each[0]) for each in waiting)
        return Outcome(None if clear else (waiting, left), pair, found.at_start, found.at_stop)

    def _swung(self, part: PathRange, level: int, pairs: Pairs) -> Array | float:
        """Acceleration to add to the bounds between vertices of panels of two nodes (P,)."""
        return 0.0

    def _narrow_phase(self, part: PathRange, near: Pairs) -> Findings:
        """Look at panels that stayed open, and at pairs (P,) that the tree found near."""
        pairs = joined([part.open.pairs, near])
        self.tests += len(pairs[0])
        tolerance = np.full(len(pairs[0]), self.tolerance)
        if self.lenient is not None:
            tolerance[self.lenient(self._owners(pairs))] *= LENIENCE
        tolerance += self.rounding
        chord_error = part.step**2 / 8 * part.bounds.between_panels(*self._owners(pairs))
        points = (self.states.at(part.start).points, self.states.at(part.stop).points)
        return examine_pairs(points, self.tree.faces, pairs, tolerance, chord_error)

    def _broad_phase(self, part: PathRange) -> tuple[list[Pairs], Pairs]:
        """Pairs of nodes that wait for half the range, by level, and pairs of panels to look at."""
        bounds = part.bounds
        start, stop = (self.states.at(tick) for tick in (part.start, part.stop))
        waiting: list[Pairs] = []
        children: Pairs = joined([])
        for level in range(self.tree.depth + 1):
            pairs = joined([*part.nodes[level : level + 1], children])
            waiting.append(joined([]))
            children = joined([])
            if not len(pairs[0]):
                continue
            self.tests += len(pairs[0])
            gap = gaps((start.extents, stop.extents), level, pairs)
            room = gap - self.tolerance - self.rounding
            swung = np.broadcast_to(self._swung(part, level, pairs), gap.shape)
            chord_error = part.step**2 / 8 * (bounds.between_nodes(level, *pairs) + swung)
            near = ~(room > chord_error)
            pairs, room, chord_error = selected(pairs, near), room[near], chord_error[near]
            swung = swung[near]
            crowded = len(room) > CROWD << level and part.stop - part.start > CROWDED_ABOVE
            if crowded and self._mostly_open(part, level, pairs):
                waiting[level] = pairs
                continue
            halving = np.zeros(len(room), np.bool_)
            if part.stop - part.start > 1:
                # The share of motions within the two nodes: splitting them saves no more.
                inner = [bounds.between_nodes(level, nodes, nodes) for nodes in pairs]
                own = part.step**2 / 8 * (inner[0] + inner[1] + swung)
                soon = (chord_error <= WORTH_HALVING * room) & (level < self.tree.depth)
                no_better = chord_error > WORTH_SPLITTING * np.maximum(own, room)
                halving = (room > 0) & (soon | no_better)
            waiting[level] = selected(pairs, halving)
            pairs = selected(pairs, ~halving)
            if level == self.tree.depth:
                return waiting, self._panels(pairs)
            children = self._wanted(level + 1, child_pairs(pairs))
        return waiting, joined([])

    def _mostly_open(self, part: PathRange, level: int, pairs: Pairs) -> bool:
        """Whether most panels of pairs of nodes (P,) of a level stay open, by a sample of them."""
        few = selected(pairs, np.arange(0, len(pairs[0]), -(-len(pairs[0]) // SAMPLE)))
        below = self.tree.depth - level
        sample = self._panels((few[0] << below, few[1] << below))
        found = self._narrow_phase(replace(part, open=NONE), sample)
        return 2 * len(found.open) > len(sample[0])

    def _panels(self, pairs: Pairs) -> Pairs:
        """Pairs of panels from pairs of lowest nodes, those that share a vertex left out.

        Of parts of panels they are those that have none in common, nor a crease of their panels.
        """
        first, second = (self.tree.panels[nodes] for nodes in pairs)
        pairs = selected((first, second), (first >= 0) & (second >= 0) & (first != second))
        return selected(pairs, self.parts.compared(*pairs))

    def _owners(self, pairs: Pairs) -> Pairs:
        """The panels of pairs of parts (P,)."""
        return self.parts.panels[pairs[0]], self.parts.panels[pairs[1]]

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
