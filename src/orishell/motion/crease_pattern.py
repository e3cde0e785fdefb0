"""A flat sheet parted by creases into panels of any number of corners: numbers only.

What is known of other people's patterns: where vertices lie, which letter an edge has. Readers
make it; verdicts, following and the family of drawn patterns work on it.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.motion.panel_sides import join_loops
from orishell.numerics.arrays import Array, Booleans, Integers

SLIM = 1e-12
"""A panel whose area is below this share of its longest diagonal's square has none."""

SENSE = {"V": 1.0, "M": -1.0, "F": 0.0, "J": 0.0}
"""Sign of the fold angle that a letter asks for; other letters ask for none."""


@record
class Mark:
    """A place in a flat sheet, and what is wrong there."""

    x: float  # where
    y: float
    what: str  # in a few words


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

    @property
    def diagonal(self) -> float:
        """Diagonal of the flat sheet's bounding box."""
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))

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


@record
class FoldedPattern(CreasePattern):
    """Panels of a sheet that has no flat state; ``vertices`` only say which crease is next."""

    points: Array  # vertices (V, 3) in any state

    @cached_property
    def sectors(self) -> Array:
        """Angles (I, D) below pi at inner vertices from each crease to the next (radians).

        NaN behind the last; their sum is no matter.
        """
        creases, ends = self.fans
        if not creases.size:
            return np.zeros(creases.shape)
        way = self.points[ends] - self.points[self.inner][:, None]
        count = (creases >= 0).sum(axis=1)[:, None]
        next_one = (np.arange(creases.shape[1]) + 1) % count
        after = np.take_along_axis(way, next_one[..., None], axis=1)
        sine = np.linalg.norm(np.cross(way, after), axis=-1)
        turn = np.arctan2(sine, (way * after).sum(axis=-1))
        return np.where(creases >= 0, turn, np.nan)


def pattern_of_panels(
    vertices: Array,
    faces: Integers,
    edges: Integers | None = None,
    letters: NDArray[np.str_] | None = None,
) -> CreasePattern:
    """The pattern that panels make; those that go clockwise are turned.

    Parameters
    ----------
    vertices
        Vertices (V, 2).
    faces
        Vertices (F, K) around every panel, either way round, -1 behind the last.
    edges
        Vertices (E, 2) of every edge; None to number the panels' sides by their vertices.
    letters
        Letter (E,) of every edge; None for U. Edges with a panel on one side get B.

    Raises
    ------
    InputError
        If a panel has no area, a side of a panel is not among the edges, or panels lie on the
        same side of an edge.
    """
    areas = signed_areas(vertices, faces)
    reach = np.ptp(np.where((faces >= 0)[..., None], vertices[faces], vertices[faces[:, :1]]), 1)
    slim = ~(np.abs(areas) > SLIM * (reach**2).sum(axis=1))
    if slim.any():
        panel = int(np.argmax(slim))
        raise InputError(
            f"panel {panel} has no area",
            got="vertices " + ", ".join(map(str, faces[panel][faces[panel] >= 0])),
        )
    cut = None if letters is None else letters == "C"
    joined = join_loops(faces, len(vertices), edges, cut, turned=areas < 0)
    count = (joined.edge_faces >= 0).sum(axis=1)
    known = np.full(len(count), "U") if letters is None else letters
    return CreasePattern(
        vertices,
        joined.edges,
        np.where(count == 1, "B", known),
        joined.loops,
        joined.edge_faces,
    )


def signed_areas(vertices: Array, faces: Integers) -> Array:
    """Areas (F,) of panels (F, K) between vertices (V, 2), negative of those that go clockwise."""
    first = vertices[faces[:, 0]]
    around = np.where(faces < 0, faces[:, :1], faces)
    here = vertices[around] - first[:, None]
    after = np.roll(here, -1, axis=1)
    return np.asarray(
        0.5 * (here[..., 0] * after[..., 1] - here[..., 1] * after[..., 0]).sum(axis=1)
    )
