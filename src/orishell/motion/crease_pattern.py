"""A flat sheet parted by creases into panels of any number of corners: numbers only.

What is known of other people's patterns: where vertices lie, which letter an edge has. Readers
make it; verdicts, following and the family of drawn patterns work on it.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers

SENSE = {"V": 1.0, "M": -1.0, "F": 0.0, "J": 0.0}
"""Sign of the fold angle that a letter asks for; other letters ask for none."""


@record
class CreasePattern:
    """Vertices, edges and panels of a flat sheet; all panels go counter-clockwise seen from +z."""

    vertices: Array  # (V, 2)
    edges: Integers  # vertices (E, 2) of every edge
    # letter (E,) of every edge, as in FOLD: B border, M mountain, V valley, F flat, U unassigned,
    # C cut, J join
    letters: NDArray[np.str_]
    # vertices (F, K) around every panel, also those that lie on its sides; -1 behind the last
    faces: Integers
    # panels (E, 2) to the left and to the right of every edge, -1 where there is none
    edge_faces: Integers

    @property
    def crease(self) -> Booleans:
        """Which edges (E,) join two panels."""
        return np.asarray((self.edge_faces >= 0).all(axis=1) & (self.letters != "C"))

    @property
    def signs(self) -> Array:
        """Signs (E,) of fold angles: +1 valley, -1 mountain, 0 flat, NaN where nothing is said."""
        return np.array([SENSE.get(letter, np.nan) for letter in self.letters.tolist()])

    @cached_property
    def inner(self) -> Integers:
        """Numbers (I,) of the vertices that panels surround: all edges there are creases."""
        inside = np.zeros(len(self.vertices), dtype=np.bool_)
        inside[self.edges] = True
        inside[self.edges[~self.crease]] = False
        return np.flatnonzero(inside)

    @cached_property
    def fans(self) -> tuple[Integers, Integers]:
        """Creases (I, D) around every inner vertex counter-clockwise, and their other ends (I, D).

        D is the largest number there; -1 behind the last.
        """
        ends = np.concatenate([self.edges, self.edges[:, ::-1]])
        edge = np.tile(np.arange(len(self.edges)), 2)
        way = self.vertices[ends[:, 1]] - self.vertices[ends[:, 0]]
        place = np.full(len(self.vertices), -1)
        place[self.inner] = np.arange(len(self.inner))
        here = np.flatnonzero(place[ends[:, 0]] >= 0)
        row = place[ends[here, 0]]
        here = here[np.lexsort((np.arctan2(way[here, 1], way[here, 0]), row))]
        row = place[ends[here, 0]]
        count = np.bincount(row, minlength=len(self.inner))
        column = np.arange(len(row)) - np.repeat(np.cumsum(count) - count, count)
        around = np.full((2, len(self.inner), int(count.max(initial=0))), -1)
        around[0, row, column], around[1, row, column] = edge[here], ends[here, 1]
        return around[0], around[1]

    @cached_property
    def sectors(self) -> Array:
        """Angles (I, D) at inner vertices from each crease to the next; NaN behind the last.

        They add up to 2 pi (radians).
        """
        creases, ends = self.fans
        if not creases.size:
            return np.zeros(creases.shape)
        way = self.vertices[ends] - self.vertices[self.inner][:, None]
        angle = np.where(creases >= 0, np.arctan2(way[..., 1], way[..., 0]), np.nan)
        count = (creases >= 0).sum(axis=1)[:, None]
        after = np.take_along_axis(angle, (np.arange(angle.shape[1]) + 1) % count, axis=1)
        turn = np.mod(after - angle, 2 * np.pi)
        return np.where(creases >= 0, turn, np.nan)
