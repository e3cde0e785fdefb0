"""Pairs of panels looked at closely in a part of the path: apart throughout, touching, or open."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from orishell.clash.quads import common_gap, corners_of, nearest, normals
from orishell.clash.tree import CHUNK, Integers, Pairs, chosen, joined

Array = NDArray[np.float64]


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
    left: list[Pairs] = []
    touching: tuple[list[_Touch], list[_Touch]] = ([], [])
    for k in range(0, len(pairs[0]), CHUNK):
        part = slice(k, k + CHUNK)
        group = _Group.of(
            points, faces, (pairs[0][part], pairs[1][part]), tolerance[part], stray[part]
        )
        for end in (0, 1):
            for panel in (0, 1):
                group = group.without(normals(group.corners[end][panel]))
        for end in (0, 1):
            distance, between = nearest(*group.corners[end])
            touching[end].extend(group.touching(distance))
            group = group.without(between / np.where(distance > 0, distance, 1.0))
        left.append(group.pairs)
    at_start, at_stop = (min(found)[1] if found else None for found in touching)
    return Closely(joined(left), at_start, at_stop)


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

    def without(self, direction: Array) -> _Group:
        """Those that their directions (3, P) do not keep apart."""
        near = common_gap(direction, self.corners) <= self.need
        if near.all():
            return self
        corners = [(first[:, near], second[:, near]) for first, second in self.corners]
        return _Group(chosen(self.pairs, near), corners, self.tolerance[near], self.need[near])

    def touching(self, distance: Array) -> list[_Touch]:
        """The nearest pair within the tolerance, if there is one."""
        within = np.flatnonzero(distance <= self.tolerance)
        if not len(within):
            return []
        nearest_one = int(within[distance[within].argmin()])
        first, second = (int(panels[nearest_one]) for panels in self.pairs)
        return [(float(distance[nearest_one]), (first, second))]
