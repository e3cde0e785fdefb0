"""Narrow phase: pairs of panels in a part of the path are apart throughout, touch, or stay open.

Along a direction d a vector e between corners is never less than the least of its views at the
ends of the part (:mod:`~orishell.clash.separation`), less its chord error,

    (b - a)^2 / 8 * max abs(e''),

by which it can leave the straight line between its values at drives a and b. So panels are proved
apart if one of these gaps exceeds the tolerance and the chord error together. Boards likewise: a
corner of one at the height h over its panel is a mean of the panel's vertices and h n, n being the
panel's normal.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from orishell.clash.bodies import ALIKE, Apartness, BodyState, one_direction
from orishell.clash.broad_phase import CHUNK, Pairs, joined, selected
from orishell.clash.open_pairs import OpenPairs
from orishell.clash.separation import (
    common_gap,
    corners_of,
    nearest,
    normals,
    turning_gap,
    views_along,
)
from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.equals import first_smallest

CROWDED = 3
"""Chunks of pairs from which the processor's cores share the work."""


@record
class Findings:
    """The pairs that no direction keeps apart, and the nearest that touch at an end of the part."""

    open: OpenPairs
    at_start: tuple[int, int] | None
    at_stop: tuple[int, int] | None


def examine_pairs(
    points: tuple[Array, Array], faces: Integers, pairs: Pairs, tolerance: Array, chord_error: Array
) -> Findings:
    """Return the pairs of panels that are not proved apart, and those that touch at an end.

    Vectors between the corners of a pair can be as far from the straight line between the two
    states (V, 3) as its chord error (P,). Separating axes are sought among the panels' normals and
    the lines between their nearest points. They stay as they are at one end, or turn from the one
    to the other: panels that turn together are seen apart by their own normals in steps far longer
    than any standing direction allows.
    """
    parts = [slice(k, k + CHUNK) for k in range(0, len(pairs[0]), CHUNK)]

    def examine(part: slice) -> tuple[OpenPairs, list[_Touch], list[_Touch]]:
        first, second = (panels[part] for panels in pairs)
        corners = [
            (corners_of(state, faces[first]), corners_of(state, faces[second])) for state in points
        ]
        needed = tolerance[part] + chord_error[part]
        return Group((first, second), corners, tolerance[part], needed).examined()

    if len(parts) < CROWDED:
        found = [examine(part) for part in parts]
    else:
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            found = list(pool.map(examine, parts))
    at_start = _nearest([touch for _, touching, _ in found for touch in touching], tolerance)
    at_stop = _nearest([touch for _, _, touching in found for touch in touching], tolerance)
    left = [OpenPairs.new(joined([])), *(each[0] for each in found)]
    return Findings(OpenPairs.joined(left), at_start, at_stop)


_Touch = tuple[float, tuple[int, int]]
"""A distance, and the two panels."""


def _nearest(touching: list[_Touch], tolerance: Array) -> tuple[int, int] | None:
    """The panels of the first of those that are nearest; None if none touch."""
    if not touching:
        return None
    distances = [distance for distance, _ in touching]
    return touching[first_smallest(distances, ALIKE, float(tolerance.max()))][1]


@record
class Group:
    """Pairs of convex panels or bodies, with their corners at both ends of the part."""

    pairs: Pairs
    corners: list[tuple[Array, Array]]  # (3, C, P) of the firsts and of the seconds
    tolerance: Array  # (P,), at which they touch
    needed: Array  # (P,), tolerance and chord error: gaps that prove them apart

    def examined(self) -> tuple[OpenPairs, list[_Touch], list[_Touch]]:
        """Pairs that stay open, and the nearest that touch at the start and at the stop.

        Lines between nearest points are sought only where normals show no gap: others do not touch,
        and wait for shorter steps.
        """
        group, gap = self, np.full(len(self.needed), -np.inf)
        for panel in (0, 1):
            lines = [normals(state[panel]) for state in group.corners]
            near, seen = group.near_along(*lines)
            group, gap = group.chosen(near), np.maximum(gap, seen)[near]
        if not len(gap):
            return OpenPairs.new(group.pairs), [], []
        left, deep = np.ones(len(gap), np.bool_), ~(gap > group.tolerance)
        doubtful = group.chosen(deep)
        distances, between = zip(*(nearest(*state) for state in doubtful.corners), strict=True)
        touching = [doubtful.touching(distance) for distance in distances]
        left[deep], _ = doubtful.near_along(
            *(b / np.where(d > 0, d, 1.0) for b, d in zip(between, distances, strict=True))
        )
        return OpenPairs.new(selected(group.pairs, left)), touching[0], touching[1]

    def chosen(self, which: Booleans) -> Group:
        """The pairs at which ``which`` (P,) is true."""
        if which.all():
            return self
        corners = [(first[..., which], second[..., which]) for first, second in self.corners]
        return Group(
            selected(self.pairs, which), corners, self.tolerance[which], self.needed[which]
        )

    def not_separated_by(self, start: Array, stop: Array) -> Group:
        """Pairs that two directions (3, P), and one turning between them, do not keep apart."""
        return self.chosen(self.near_along(start, stop)[0])

    def near_along(self, start: Array, stop: Array) -> tuple[Booleans, Array]:
        """Which pairs (P,) neither one of two directions (3, P) keeps apart nor one that turns.

        And how far they are apart along them at the ends, at least (P,), negative if they are not.
        """
        first, last = (views_along(direction, self.corners) for direction in (start, stop))
        standing = np.maximum(common_gap(first), common_gap(last))
        # A pair without a bound is not proved apart.
        near = ~(np.maximum(standing, turning_gap(first, last)) > self.needed)
        at_ends = np.minimum(common_gap(first[:1]), common_gap(last[1:]))
        return np.asarray(near), np.asarray(at_ends)

    def touching(self, distance: Array) -> list[_Touch]:
        """The nearest pair within the tolerance, if there is one."""
        within = np.flatnonzero(distance <= self.tolerance)
        if not len(within):
            return []
        nearest_one = int(
            within[first_smallest(distance[within], ALIKE, float(self.tolerance.max()))]
        )
        first, second = (int(panels[nearest_one]) for panels in self.pairs)
        return [(float(distance[nearest_one]), (first, second))]


States = tuple[BodyState, BodyState]
"""Of bodies at both ends of the part."""


def kept_near(states: States, open_ones: OpenPairs, needed: Array) -> Booleans:
    """Open pairs of bodies (P,) that what parted them most does not show apart by as much."""
    lines = [one_direction(state, open_ones.pairs, open_ones.kept_by) for state in states]
    return near_along(lines, states, open_ones.pairs, needed)


def examine_bodies(states: States, pairs: Pairs, tolerance: float, needed: Array) -> Findings:
    """The pairs of bodies (P,) not as far apart as is needed (P,), and those that touch at an end.

    Directions square to two edges are ten times as many as normals, and part hardly more: only
    where normals show no gap do they tell whether bodies touch. Others wait for shorter steps.
    """
    by_faces = Apartness.of(states, pairs, of_faces=True)
    number, gap = by_faces.number, by_faces.gaps.min(axis=0)
    left = kept_near(states, OpenPairs(pairs, number), needed)
    deep = left & (gap <= tolerance)
    touching = selected(pairs, deep)
    apart = Apartness.of(states, touching)
    number[deep] = apart.number
    left[deep] = kept_near(states, OpenPairs(touching, apart.number), needed[deep])
    ends = (apart.touching(end, touching, tolerance) for end in (0, 1))
    return Findings(OpenPairs(pairs, number).chosen(left), *ends)


def near_along(
    lines: Sequence[Array], states: tuple[BodyState, BodyState], pairs: Pairs, needed: Array
) -> Booleans:
    """Pairs (P,) that two directions (3, P), and one turning between them, show as too near."""
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


@record
class Slabs:
    """Panels as thick as their boards in one state: they enclose these."""

    corners: Array  # (3, 8, F)
    normals: Array  # (3, F), unit vectors

    @classmethod
    def of(cls, points: Array, faces: Integers, height: float) -> Slabs:
        """The slabs of panels (F, 4) in a state (V, 3), with faces at a height on both sides."""
        corners = corners_of(points, faces)
        normal = normals(corners)
        over = height * normal[:, None]
        return cls(np.concatenate([corners + over, corners - over], axis=1), normal)


def near_slabs(states: tuple[Slabs, Slabs], pairs: Pairs, needed: Array) -> Pairs:
    """The pairs of panels (P,) whose normals show no gap as wide as is needed (P,)."""
    left = []
    for k in range(0, len(pairs[0]), CHUNK):
        part = slice(k, k + CHUNK)
        chunk = (pairs[0][part], pairs[1][part])
        corners = [(s.corners[:, :, chunk[0]], s.corners[:, :, chunk[1]]) for s in states]
        group = Group(chunk, corners, needed[part], needed[part])
        for panel in (0, 1):
            group = group.not_separated_by(*(s.normals[:, group.pairs[panel]] for s in states))
        left.append(group.pairs)
    return joined(left)
