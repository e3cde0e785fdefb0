"""Pairs of panels looked at closely in a part of the path: apart throughout, touching, or open."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from orishell.clash.quads import (
    common_gap,
    corners_of,
    nearest,
    normals,
    turning_gap,
    views_along,
)
from orishell.clash.tree import CHUNK, Integers, Pairs, chosen, joined

Array = NDArray[np.float64]

CROWDED = 3
"""Chunks of pairs from which the processor's cores share the work."""


@dataclass(frozen=True, slots=True, eq=False)
class Closely:
    """What a close look leaves.

    Parameters
    ----------
    open
        Pairs that no direction keeps apart.
    at_start, at_stop
        Panels that touch at an end of the part, if there are any: the nearest of them.
    """

    open: Pairs
    at_start: tuple[int, int] | None
    at_stop: tuple[int, int] | None


def look_closely(
    points: tuple[Array, Array], faces: Integers, pairs: Pairs, tolerance: Array, stray: Array
) -> Closely:
    """Try the panels' normals and the lines between their nearest points as directions.

    They stay as they are at one end, or turn from the one to the other: panels that turn together
    are seen apart by their own normals in steps far longer than any standing direction allows.

    Parameters
    ----------
    points
        Vertices (V, 3) in the states at both ends of the part.
    faces
        Corners (F, 4) of all panels.
    pairs
        Panels (P,).
    tolerance
        Distances (P,) at which they count as touching.
    stray
        How far (P,) vectors between their corners can be from the straight line in between.
    """
    parts = [slice(k, k + CHUNK) for k in range(0, len(pairs[0]), CHUNK)]

    def look(part: slice) -> tuple[Pairs, list[_Touch], list[_Touch]]:
        some = pairs[0][part], pairs[1][part]
        return _Group.of(points, faces, some, tolerance[part], stray[part]).looked_at()

    if len(parts) < CROWDED:
        looks = [look(part) for part in parts]
    else:
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            looks = list(pool.map(look, parts))
    at_start, at_stop = (
        min((touch for found in looks for touch in found[end]), default=None) for end in (1, 2)
    )
    return Closely(
        joined([found[0] for found in looks]),
        None if at_start is None else at_start[1],
        None if at_stop is None else at_stop[1],
    )


_Touch = tuple[float, tuple[int, int]]


@dataclass(frozen=True, slots=True, eq=False)
class _Group:
    """Pairs with their corners at both ends."""

    pairs: Pairs
    corners: list[tuple[Array, Array]]
    tolerance: Array
    need: Array

    @classmethod
    def of(
        cls,
        points: tuple[Array, Array],
        faces: Integers,
        pairs: Pairs,
        tolerance: Array,
        stray: Array,
    ) -> _Group:
        first, second = faces[pairs[0]], faces[pairs[1]]
        corners = [(corners_of(state, first), corners_of(state, second)) for state in points]
        return cls(pairs, corners, tolerance, tolerance + stray)

    def looked_at(self) -> tuple[Pairs, list[_Touch], list[_Touch]]:
        """Pairs that stay open, and the nearest that touch at the start and at the stop."""
        group = self
        for panel in (0, 1):
            group = group.without(*(normals(state[panel]) for state in group.corners))
        if not len(group.pairs[0]):
            return group.pairs, [], []
        touching, lines = [], []
        for state in group.corners:
            distance, between = nearest(*state)
            touching.append(group.touching(distance))
            lines.append(between / np.where(distance > 0, distance, 1.0))
        return group.without(*lines).pairs, touching[0], touching[1]

    def without(self, start: Array, stop: Array) -> _Group:
        """Those that neither one of two directions (3, P) nor their turn keeps apart."""
        first, last = (views_along(direction, self.corners) for direction in (start, stop))
        standing = np.maximum(common_gap(first), common_gap(last))
        near = np.maximum(standing, turning_gap(first, last)) <= self.need
        if near.all():
            return self
        corners = [(first[..., near], second[..., near]) for first, second in self.corners]
        return _Group(chosen(self.pairs, near), corners, self.tolerance[near], self.need[near])

    def touching(self, distance: Array) -> list[_Touch]:
        """The nearest pair within the tolerance, if there is one."""
        within = np.flatnonzero(distance <= self.tolerance)
        if not len(within):
            return []
        nearest_one = int(within[distance[within].argmin()])
        first, second = (int(panels[nearest_one]) for panels in self.pairs)
        return [(float(distance[nearest_one]), (first, second))]
