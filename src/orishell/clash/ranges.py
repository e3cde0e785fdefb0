"""A path of folding: its states, its ranges, and what is found on it."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Generic, TypeVar

import numpy as np

from orishell.clash.bodies import Bodies, BodyState
from orishell.clash.broad_phase import DIRECTIONS, Extents, PanelTree
from orishell.clash.narrow_phase import Slabs
from orishell.conventions.progress import Progress
from orishell.conventions.record import Angle, record
from orishell.motion import Mechanism
from orishell.motion.layout import points_of
from orishell.numerics.arrays import Array
from orishell.numerics.equals import smallest_of

BOUND = (
    "between two states a vector between two vertices stays within step**2/8 times a bound of its "
    "acceleration of the straight line"
)


@record
class ProofRecord:
    """How contact was excluded along the whole path."""

    # numbers of states computed, ranges of the drive proved clear, and pairs of panels, or of
    # groups of panels, compared
    states: int
    ranges: int
    tests: int
    # the longest and the shortest of these ranges
    largest_step: Angle
    smallest_step: Angle
    contact_tolerance: float  # distance at which panels touch (length)
    bound: str = BOUND  # what the proof rests on, in words


@dataclass(frozen=True, slots=True)
class PathContact:
    """The first contact on a path, or where the proof that there is none ends."""

    drive: float  # where two panels touch, or are not proved apart (radians)
    clear_until: float  # up to here no two panels touch, proved (radians)
    panels: tuple[int, int]  # numbers of the two panels
    # numbers of the two bodies on them, if these were looked at
    bodies: tuple[int, int] | None = None
    # how far they are apart there, if they are not seen to touch and are merely not proved apart in
    # the smallest step beside it; None if they touch (length)
    apart: float | None = None


@dataclass(frozen=True, slots=True)
class PathResult:
    """What was found on a path: the first contact, or where the proof ends, or None; and how."""

    contact: PathContact | None  # None if it is proved all the way that there is none
    proof: ProofRecord

    @classmethod
    def of_all(cls, results: Sequence[PathResult]) -> PathResult:
        """What was found on the same path in several searches, of other panels each.

        Parameters
        ----------
        results
            At least one.
        """
        met = [each.contact for each in results if each.contact is not None]
        proofs = [each.proof for each in results]
        proof = replace(
            proofs[0],
            states=sum(each.states for each in proofs),
            ranges=sum(each.ranges for each in proofs),
            tests=sum(each.tests for each in proofs),
            largest_step=max(each.largest_step for each in proofs),
            smallest_step=min(each.smallest_step for each in proofs),
        )
        if not met:
            return cls(None, proof)
        first = smallest_of(met, lambda each: each.drive)
        clear = min(each.clear_until for each in met)
        return cls(replace(first, clear_until=clear), proof)


Left = TypeVar("Left")

TICKS = 1 << 36
"""Smallest steps along a path: a contact is found to this part of it."""
BASE = 8
"""Number of ranges into which the path is divided at first."""
LOOKING = "looking for contact"

Numbers = tuple[int, int]
"""Two panels, or two bodies."""


@record
class Outcome(Generic[Left]):
    """What is found in a range."""

    left: Left | None  # for both halves of it; None if all is proved apart
    pair: Numbers | None  # one of those that are left
    at_start: Numbers | None  # the nearest that touch there
    at_stop: Numbers | None  # the nearest that touch there


@record
class Found:
    """Where a search through ranges ends."""

    tick: int
    pair: Numbers
    touches: bool  # whether the two touch there, or are merely not proved apart beside it


def search_ranges(
    examine: Callable[[int, int, Left], Outcome[Left]], everything: Left, progress: Progress
) -> tuple[Found | None, int]:
    """Work through the ranges of a path in their order, up to the first contact.

    ``examine`` looks at a range between two ticks, first at ``everything``. Returned are the first
    contact, or the first of the smallest ranges in which a pair is not proved apart that touches at
    neither end, or None; and the tick up to which everything is apart.
    """
    step = TICKS // BASE
    stack = [(k * step, (k + 1) * step, everything) for k in reversed(range(BASE))]
    found: Found | None = None
    clear = 0
    while stack:
        start, stop, pending = stack.pop()
        if found is not None and start >= found.tick:
            break
        # Many ranges may bring no progress: it is told, and can be ended, at each.
        progress(clear / TICKS, LOOKING)
        outcome = examine(start, stop, pending)
        if outcome.at_start is not None:
            found = Found(start, outcome.at_start, touches=True)
            break
        if outcome.at_stop is not None:
            found = Found(stop, outcome.at_stop, touches=True)
        if outcome.left is None:
            clear = stop
        elif stop - start == 1 and outcome.pair is not None:
            if outcome.at_stop is None:
                found = Found(stop, outcome.pair, touches=False)
            break
        else:
            middle = (start + stop) // 2
            stack.append((middle, stop, outcome.left))
            stack.append((start, middle, outcome.left))
    progress(1.0, LOOKING)
    return found, clear


KEPT = 16


@record
class State:
    """One state of a path: vertices (V, 3), and what encloses panels and bodies there."""

    points: Array
    tree: PanelTree
    carriers: Bodies | None

    @cached_property
    def slabs(self) -> Slabs:
        """Panels as thick as their bodies."""
        height = 0.0 if self.carriers is None else self.carriers.height
        return Slabs.of(self.points, self.tree.faces, height)

    @cached_property
    def extents(self) -> Extents:
        """What the nodes of the tree span, with the height of bodies."""
        bodies = self.carriers
        if bodies is not None and bodies.hinges.beside:
            low, high = self.body_extents
            return self.tree.enclosing(
                np.minimum.reduceat(low, bodies.first), np.maximum.reduceat(high, bodies.first)
            )
        over = None if bodies is None else bodies.height * self.slabs.normals.T
        return self.tree.extents(self.points, over)

    @cached_property
    def body_extents(self) -> tuple[Array, Array]:
        """Lower and upper ends (B, 13) of the bodies along the directions of the tree."""
        corners = self.bodies.corners
        views = np.tensordot(DIRECTIONS, corners, axes=(1, 0))
        return views.min(axis=1).T, views.max(axis=1).T

    @cached_property
    def bodies(self) -> BodyState:
        """The bodies as they are carried along."""
        assert self.carriers is not None
        return self.carriers.carried(self.points)


class States:
    """The states at ticks of the path between two drives; the last few are kept."""

    def __init__(
        self,
        mechanism: Mechanism,
        ends: tuple[float, float],
        tree: PanelTree,
        bodies: Bodies | None,
    ) -> None:
        self.mechanism, self.ends, self.tree, self.bodies = mechanism, ends, tree, bodies
        self.kept: OrderedDict[int, State] = OrderedDict()
        self.made = 0

    def drive(self, tick: int) -> float:
        """The drive at a tick (radians)."""
        start, end = self.ends
        return start + (end - start) * (tick / TICKS)

    def at(self, tick: int) -> State:
        """The state at a tick."""
        state = self.kept.get(tick)
        if state is None:
            self.made += 1
            points = points_of(self.mechanism, self.drive(tick))
            state = State(points, self.tree, self.bodies)
            self.kept[tick] = state
            if len(self.kept) > KEPT:
                self.kept.popitem(last=False)
        self.kept.move_to_end(tick)
        return state
