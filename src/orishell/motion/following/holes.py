"""Closure round holes and cuts: a way round one comes back to the panel where it began.

From panel to panel across creases the sheet turns about lines, which lie where they are in the flat
sheet: the product of these screws is the identity. That is six equations for each hole, three of
turns and three of places, where a vertex, through which all lines pass, has the first three.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.panel_sides import pair_keys
from orishell.motion.quads import units
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.components import find_components

Way = list[tuple[int, float]]
"""Creases that a way crosses, in order: 1 where it comes to the panel to their left, else -1."""


@record
class Holes:
    """Ways round the holes of a sheet, and what they ask of fold angles."""

    unknowns: Integers  # of creases (H, D) that each crosses; -1 for what does not fold, or none
    senses: Array  # signs (H, D) with which their fold angles count
    axes: Array  # unit vectors (H, D, 3) along the creases in the flat sheet
    places: Array  # points (H, D, 3) of the creases, as seen from the middle of the hole
    sizes: Array  # of the holes (H,), by which what places miss is divided (length)

    def __len__(self) -> int:
        return len(self.unknowns)

    @classmethod
    def of(cls, pattern: CreasePattern, unknown: Integers) -> Holes:
        """Those of a pattern.

        unknown: The number (E+1,) of every edge's unknown, -1 where it has none.
        """
        ways = [way for way in _ways(pattern) if any(unknown[edge] >= 0 for edge, _ in way)]
        longest = max(map(len, ways), default=0)
        edges = np.full((len(ways), longest), -1)
        senses = np.zeros((len(ways), longest))
        for number, way in enumerate(ways):
            edges[number, : len(way)], senses[number, : len(way)] = zip(*way, strict=True)
        flat = np.column_stack([pattern.vertices, np.zeros(len(pattern.vertices))])
        ends = flat[pattern.edges[edges]]
        there = (edges >= 0)[..., None]
        count = np.maximum(there.sum(axis=1), 1)
        middles = np.where(there, ends.mean(axis=2), 0.0).sum(axis=1) / count
        places = np.where(there, ends[..., 0, :] - middles[:, None], 0.0)
        sizes = np.linalg.norm(places, axis=-1).max(axis=1, initial=0.0)
        return cls(unknown[edges], senses, units(ends[..., 1, :] - ends[..., 0, :]), places, sizes)

    def turns(self, sines: Array, cosines: Array) -> tuple[Array, Array]:
        """By how much every way misses its beginning (2 H, 3), and derivatives of that (H, 6, D).

        For each hole the axis by which what is left turns, as long as its sine (radians), then by
        how much its middle is off, over its size.

        Parameters
        ----------
        sines, cosines
            Of the fold angles (N+1,) of the unknowns, the last one that of what does not fold.
        """
        count, longest = self.unknowns.shape
        if not count:
            return np.zeros((0, 3)), np.zeros((0, 6, 0))
        turn, place = np.tile(np.eye(3), (count, 1, 1)), np.zeros((count, 3))
        axes, points = np.zeros((2, count, longest, 3))
        for k in range(longest):
            axes[:, k] = np.einsum("hij,hj->hi", turn, self.axes[:, k])
            points[:, k] = np.einsum("hij,hj->hi", turn, self.places[:, k]) + place
            step = _turns(
                self.axes[:, k],
                self.senses[:, k] * sines[self.unknowns[:, k]],
                1 - cosines[self.unknowns[:, k]],
            )
            turn = turn @ step
            place = points[:, k] - np.einsum("hij,hj->hi", turn, self.places[:, k])
        left = np.stack(
            [turn[:, i, j] - turn[:, j, i] for i, j in ((2, 1), (0, 2), (1, 0))], axis=-1
        )
        size = np.maximum(self.sizes, np.finfo(np.float64).tiny)[:, None]
        missed = np.stack([left / 2, place / size], axis=1)
        moved = np.cross(axes, place[:, None] - points) / size[:, None]
        derivatives = self.senses[:, :, None] * np.concatenate([axes, moved], axis=2)
        return missed.reshape(-1, 3), derivatives.transpose(0, 2, 1)


def _ways(pattern: CreasePattern) -> list[Way]:
    """The ways along all of a sheet's borders that are round holes: all but the longest of a piece.

    A piece with b borders has Euler's characteristic 2 - b: panels less creases, with inner
    vertices.
    """
    creases, panels = pattern.crease, len(pattern.faces)
    pieces = find_components(pattern.edge_faces[creases], panels)
    if panels - int(creases.sum()) + len(pattern.inner) == len(np.unique(pieces)):
        return []
    after, panel = _sides(pattern)
    rest = dict.fromkeys(np.flatnonzero((after >= 0) & np.repeat(~creases, 2)).tolist())
    ways: dict[int, list[Way]] = {}
    while rest:
        first = side = next(iter(rest))
        way: Way = []
        while True:
            del rest[side]
            side = int(after[side])
            while creases[side // 2]:
                way.append((side // 2, 1.0 if side % 2 else -1.0))
                side = int(after[side ^ 1])
            if side == first:
                break
        ways.setdefault(int(pieces[panel[first]]), []).append(way)
    return [way for found in ways.values() for way in sorted(found, key=len)[:-1]]


def _sides(pattern: CreasePattern) -> tuple[Integers, Integers]:
    """For every side of a panel the next one round it (2 E,), and its panel (2 E,); -1 for none.

    Side 2 e is that of the panel to the left of edge e, 2 e + 1 of that to the right.
    """
    there = pattern.faces >= 0
    place = np.arange(there.shape[1])[None]
    wrapped = np.where(place + 1 < there.sum(axis=1)[:, None], place + 1, 0)
    onwards = np.take_along_axis(pattern.faces, wrapped, axis=1)
    pairs = np.stack([pattern.faces[there], onwards[there]], axis=-1)
    known, keys = (pair_keys(each, len(pattern.vertices)) for each in (pattern.edges, pairs))
    order = np.argsort(known, kind="stable")
    edge = order[np.searchsorted(known, keys, sorter=order)]
    side = 2 * edge + (pattern.edges[edge, 0] != pairs[:, 0])
    numbers = np.full(there.shape, -1)
    numbers[there] = side
    after, panel = np.full((2, 2 * len(pattern.edges)), -1)
    after[side] = np.take_along_axis(numbers, wrapped, axis=1)[there]
    panel[side] = np.nonzero(there)[0]
    return after, panel


def _turns(axes: Array, sines: Array, versines: Array) -> Array:
    """Rotations (H, 3, 3) about axes (H, 3)."""
    x, y, z = axes.T
    zero = np.zeros_like(x)
    cross = np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]).transpose(2, 0, 1)
    return np.asarray(
        np.eye(3) + sines[:, None, None] * cross + versines[:, None, None] * (cross @ cross)
    )
