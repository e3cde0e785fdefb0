"""First contact of boards along a path of folding, with a proof that there is none before.

Boards of panels that share a crease are on either side of the plane that bisects it. Those of
panels that are opposite each other at a vertex are near all the way, so they are looked at by
themselves, in every range, first along the direction that kept them apart before. A corner c of a
board is fixed on its panel: with the edges u along the row and w down the column from the common
vertex, c = alpha u + beta w + h n, and

    abs(c'') <= abs(alpha u'') + abs(beta w'') + abs(h n'')

bounds its chord error by itself. Corners near the vertex, where boards come near each other, hardly
have one. All other boards are looked at as panels are (:mod:`~orishell.clash.path`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache

import numpy as np

from orishell.clash.acceleration_bounds import NormalBounds, RangeBounds
from orishell.clash.bodies import Apartness, Bodies, BodyState, NearPairs, one_direction
from orishell.clash.broad_phase import Pairs, body_gaps, joined, selected
from orishell.clash.narrow_phase import Findings, examine_bodies, kept_near, near_slabs
from orishell.clash.path import PathRange, PathSearch
from orishell.clash.ranges import (
    TICKS,
    Found,
    Outcome,
    PathContact,
    PathResult,
    search_ranges,
)
from orishell.clash.separation import views_along
from orishell.conventions.progress import Progress, no_progress, stretch
from orishell.motion import Mechanism
from orishell.motion.convex import require_convex
from orishell.motion.layout import Layout, points_of
from orishell.numerics.arrays import Array, Booleans, Integers

OPPOSITE = 0.7
"""Share of the progress, as of the time, that opposite boards take."""
EARLY, SOONEST = 1.5, 2.0**-6
"""A pair that lacks a proof is looked at again at this multiple of the step that would do, or at
this share of the step at least."""

Rates = tuple[float, tuple[Array, Array], Array]
"""A step, and bounds of accelerations of edges along rows and down columns, and of normals (F,)."""


def find_first_body_contact(
    mechanism: Mechanism,
    end: float,
    tolerance: float,
    bodies: Bodies,
    *,
    settled: Booleans,
    only: Booleans | None = None,
    progress: Progress = no_progress,
) -> PathResult:
    """Return where two boards of panels without a common crease first come within a tolerance.

    Opposite boards are known to be apart about inner vertices (rows-2, columns-2) that are settled.
    Pairs with no panel of ``only`` (F,) are left out.
    """

    def search(until: float) -> BodySearch:
        return BodySearch(mechanism, until, tolerance, bodies, only)

    near = NearPairs.opposite(bodies, Layout.of(mechanism), settled, only)
    return first_contact(search, end, near, progress)


def first_contact(
    search: Callable[[float], BodySearch], end: float, near: NearPairs, progress: Progress
) -> PathResult:
    """The first contact of pairs that are near all the way, and of all others up to there.

    ``search`` makes the search of the others up to a drive.
    """
    others = search(end)
    opposite = NearBodies(others, near)
    everything = np.arange(len(opposite.pairs[0]))
    found, clear = search_ranges(opposite.examine, everything, stretch(progress, 0.0, OPPOSITE))
    contact = None
    if found is not None:
        ends = others.states.drive(found.tick), others.states.drive(clear)
        contact = others.contact(*ends, found)
        others = search(ends[0])
    result = others.run(stretch(progress, OPPOSITE, 1.0))
    ranges, tests = result.proof.ranges + opposite.ranges, result.proof.tests + opposite.tests
    proof = replace(result.proof, ranges=ranges, tests=tests)
    if result.contact is not None:
        first = result.contact
        until = min(each.clear_until for each in (first, contact) if each is not None)
        contact = replace(first, clear_until=until)
    return PathResult(contact, proof)


class BodySearch(PathSearch):
    """A search for the first contact of boards whose panels have no common vertex."""

    def __init__(
        self,
        mechanism: Mechanism,
        end: float,
        tolerance: float,
        bodies: Bodies,
        only: Booleans | None = None,
        *,
        start: float = 0.0,
    ) -> None:
        require_convex(mechanism)
        super().__init__(mechanism, end, tolerance, only=only, bodies=bodies, start=start)
        self.bodies = bodies
        self.normals = NormalBounds(self.layout, points_of(mechanism, 0.0))
        self._swings = lru_cache(1)(self._swings_within)  # a range asks for them again and again

    def contact(self, drive: float, clear: float, found: Found) -> PathContact:
        """Where two boards touch, or are not proved apart."""
        apart = None if found.touches else self._distance(found)
        return PathContact(drive, clear, self.bodies.carriers(found.pair), found.pair, apart)

    def _distance(self, found: Found) -> float:
        """How far two boards are apart in a state, at least (length)."""
        state = self.states.at(found.tick).bodies
        first, second = (np.array([body]) for body in found.pair)
        return max(0.0, float(Apartness.of((state, state), (first, second)).gaps[0, 0]))

    def _swung(self, part: PathRange, level: int, pairs: Pairs) -> Array | float:
        return 2 * float(self._swings(part.bounds).max())

    def _narrow_phase(self, part: PathRange, near: Pairs) -> Findings:
        tolerance = self.tolerance + self.rounding
        start, stop = (self.states.at(tick) for tick in (part.start, part.stop))
        states = start.bodies, stop.bodies
        needed = self._needed(part, part.open.pairs)
        left = kept_near(states, part.open, needed)
        fresh, more = self._not_seen_apart(part, near)
        pairs = joined([selected(part.open.pairs, left), fresh])
        needed = np.concatenate([needed[left], more])
        self.tests += len(part.open) + len(fresh[0])
        return examine_bodies(states, pairs, tolerance, needed)

    def _not_seen_apart(self, part: PathRange, near: Pairs) -> tuple[Pairs, Array]:
        """The pairs of bodies on pairs of panels that a short look leaves, and what they need."""
        tolerance = self.tolerance + self.rounding
        swings = self._swings(part.bounds)
        between = part.bounds.between_panels(*near) + swings[near[0]] + swings[near[1]]
        slabs = [self.states.at(tick).slabs for tick in (part.start, part.stop)]
        near = near_slabs((slabs[0], slabs[1]), near, tolerance + part.step**2 / 8 * between)
        pairs = self.bodies.pairs_of(near)[0]
        return pairs, self._needed(part, pairs)

    def _needed(self, part: PathRange, pairs: Pairs) -> Array:
        """Gaps that prove pairs of bodies (P,) apart."""
        swings = self._swings(part.bounds)
        first, second = (self.bodies.panels[each] for each in pairs)
        between = part.bounds.between_panels(first, second) + swings[first] + swings[second]
        return np.asarray(self.tolerance + self.rounding + part.step**2 / 8 * between)

    def _swings_within(self, bounds: RangeBounds) -> Array:
        """Bounds (F,) of the accelerations of corners of boards over their panels."""
        return self.bodies.height * self.normals.within(*bounds.steps)


class NearBodies:
    """All pairs of bodies that are near all the way, and not settled."""

    def __init__(self, search: BodySearch, near: NearPairs) -> None:
        self.bodies, self.states = search.bodies, search.states
        self.tolerance = search.tolerance + search.rounding
        self.edges, self.normals = search.bounds, search.normals
        self.pairs, self.places = near.bodies, search.layout.first
        self.parts = [
            self.bodies.components(numbers, near.vertices, base)
            for numbers, base in zip(self.pairs, near.bases, strict=True)
        ]
        self.largest = [each.max(axis=1, initial=0.0) for each in self.parts]
        self.between, self.steps = near.between, np.stack([near.steps, 0.0 * near.steps])
        self.kept_by = np.zeros(len(near.vertices), np.int64)
        # Pairs that lack a proof are left alone up to a tick, until steps are as short as that.
        self.sleep = np.full(len(near.vertices), np.inf)
        self.until = np.zeros(len(near.vertices), np.int64)
        self.tests = self.ranges = 0

    def examine(self, start: int, stop: int, pending: Integers) -> Outcome[Integers]:
        """Look at pairs (P,) in the range between two ticks."""
        self.ranges += 1
        self.tests += len(pending)
        step = abs(self.states.drive(stop) - self.states.drive(start))
        bounds = self.edges.within(start / TICKS, stop / TICKS)
        swing = self.normals.within(*bounds.steps)
        ends = [self.states.at(tick).bodies for tick in (start, stop)]

        def errors(which: Integers) -> list[Array]:
            found = []
            swung = swing[self.between[which]]
            for numbers, parts, step_h in zip(self.pairs, self.parts, self.steps, strict=True):
                panel = self.bodies.panels[numbers[which]]
                row, column = self.places[panel].T
                along, down, over = parts[..., which]
                total = along * bounds.steps[0][column] + down * bounds.steps[1][row]
                total = total + over * swing[panel] + step_h[which] * swung
                found.append(step**2 / 8 * total)
            return found

        asleep = (self.sleep[pending] < step) & (start < self.until[pending]) & (stop - start > 1)
        woken = pending[~asleep]
        if self.bodies.hinges.beside:
            woken = woken[self._may_be_near((start, stop), woken, (step, bounds.steps, swing))]
        left = woken[~(self._gaps(ends, woken, errors) > self.tolerance)]
        apart = Apartness.of(ends, selected(self.pairs, left))
        self.kept_by[left] = apart.number
        gap = self._gaps(ends, left, errors)
        open_ones = ~(gap > self.tolerance)
        left, apart, gap = left[open_ones], apart.chosen(open_ones), gap[open_ones]
        # The gap that a proof lacks shrinks with the square of the step.
        plain = apart.gaps.min(axis=0)
        share = np.maximum(plain, 0.0) / np.maximum(plain - gap, 1e-300)
        self.sleep[left] = step * np.clip(EARLY * np.sqrt(share), SOONEST, 0.5)
        self.until[left] = stop
        pairs = selected(self.pairs, left)
        touching = [apart.touching(end, pairs, self.tolerance) for end in (0, 1)]
        pending = np.concatenate([pending[asleep], left])
        if not len(pending):
            return Outcome(None, None, None, None)
        first, second = self.pairs[0][pending[-1]], self.pairs[1][pending[-1]]
        return Outcome(pending, (int(first), int(second)), *touching)

    def _may_be_near(self, ticks: tuple[int, int], which: Integers, rates: Rates) -> Booleans:
        """Which pairs (P,) are not seen apart between two ticks by the directions of the tree.

        By the largest chord error of a corner of each: most arms are far from all others.
        """
        step, (rows, columns), swing = rates
        ends = [self.states.at(tick).body_extents for tick in ticks]
        needed = np.full(len(which), self.tolerance)
        for numbers, largest, step_h in zip(self.pairs, self.largest, self.steps, strict=True):
            panel = self.bodies.panels[numbers[which]]
            row, column = self.places[panel].T
            along, down, over = largest[:, which]
            total = along * rows[column] + down * columns[row] + over * swing[panel]
            needed += step**2 / 8 * (total + step_h[which] * swing[self.between[which]])
        return np.asarray(~(body_gaps(ends, selected(self.pairs, which)) > needed))

    def _gaps(
        self,
        ends: list[BodyState],
        which: Integers,
        errors: Callable[[Integers], list[Array]],
    ) -> Array:
        """Gaps (P,) that stay between pairs along the directions (3, P) noted for them.

        As in :mod:`~orishell.clash.separation`, standing or turning, but every corner has a chord
        error (C, P) of its own.
        """
        pairs = selected(self.pairs, which)
        lines = [one_direction(state, pairs, self.kept_by[which]) for state in ends]
        corners = [(s.corners[:, :, pairs[0]], s.corners[:, :, pairs[1]]) for s in ends]
        first, last = (views_along(line, corners) for line in lines)
        middle = [0.5 * (after + now) for after, now in zip(first[1], last[0], strict=True)]
        above, below = np.empty((2, 5, len(pairs[0])))
        parts = errors(which)
        for k, view in enumerate((first[1], first[0], middle, last[1], last[0])):
            (low_a, high_a), (low_b, high_b) = (
                ((v - error).min(axis=0), (v + error).max(axis=0))
                for v, error in zip(view, parts, strict=True)
            )
            above[k], below[k] = low_b - high_a, low_a - high_b
        # What stands looks at both states along one direction, what turns from one to the other.
        ways = (slice(0, 2), slice(1, 4), slice(3, 5))
        kept = [side[way].min(axis=0) for side in (above, below) for way in ways]
        return np.asarray(np.max(kept, axis=0))
