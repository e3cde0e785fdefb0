"""The largest distance of one surface from another, by branch and bound.

How far a point p of a cell may be, if q_k are the points of the other surface nearest to the
cell's corners p_k, at distances D_k:

- No farther than a corner and the way to it (the distance is 1-Lipschitz).
- p is a mean of the corners but for the cell's own sagitta, so it is at most max D_k from the same
  mean of the q_k. That lies on chords of the other surface, which leaves a chord of length c by no
  more than (c/2) tan(T/2) if it turns by T over it.
- No farther than the foot of any corner; and the corner of the cell that is farthest from that foot
  is as far from it as any p, since the distance from a point is convex.
- Or one after the other: first to the nearer of two opposite sides, then along it.

The second is far better where the other surface is smooth, the fourth along its ridges. The third
needs nothing but feet, and exceeds the largest distance D of a cell of radius r by about r^2 / 2D:
it is used where the other surface is scattered triangles.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.record import record
from orishell.deviation.triangles import At, Nearest, Triangles
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array, Booleans, Integers

Number = TypeVar("Number", np.float64, np.int64)

PRECISION = 1e-3
"""Accuracy sought for the largest distance, relative to it."""
URGENT = 0.5
"""Cells whose bound is in this upper part of what is still possible are divided first."""
AT_ONCE = 200_000
"""Cells looked at at once: bounds the memory."""
NARROWEST = 1 / 16
"""Cells are cut no nearer to their sides than this share."""
MOST_TURN = 0.5 * np.pi
"""Where a surface turns by more than this between two points, their chord says nothing."""

ANY = 1e30
"""Stands for an infinite slope, but times a chord of no length it is 0."""


@record
class Cells:
    """Cells of a surface, each between two values of u and two values of v.

    Corners are those at (u0, v0), (u1, v0), (u1, v1), (u0, v1); feet are the nearest points of the
    other surface, places the cells of it that they are in.
    """

    sides: Array  # (4, C): u0, u1, v0, v1
    points: Array  # corners (4, C, 3)
    distances: Array  # (4, C) from the other surface
    feet: Array  # (4, C, 3)
    places: Integers  # (4, C, 2)
    ceiling: Array  # (1, C): no point of a cell is farther

    @classmethod
    def of_lattice(cls, u: Array, v: Array, points: Array, found: Nearest) -> Iterator[Cells]:
        """The cells of a lattice (A, B), as many at once as fit into memory."""
        rows = max(AT_ONCE // (len(v) - 1), 1)
        for k in range(0, len(u) - 1, rows):
            part = slice(k, k + rows + 1)
            at = u[part]
            sides = np.broadcast_arrays(at[:-1, None], at[1:, None], v[None, :-1], v[None, 1:])
            yield cls(
                np.stack(sides).reshape(4, -1),
                _corners(points[part]),
                _corners(found.distances[part]),
                _corners(found.feet[part]),
                _corners(found.cells[part]),
                np.full((1, sides[0].size), np.inf),
            )

    def __len__(self) -> int:
        return int(self.sides.shape[1])

    def __getitem__(self, which: Booleans) -> Cells:
        return Cells(*(array[:, which] for array in self._arrays))

    @staticmethod
    def joined(parts: list[Cells]) -> Cells:
        """The cells of several sets in one."""
        every = zip(*(part._arrays for part in parts), strict=True)
        return Cells(*(np.concatenate(arrays, axis=1) for arrays in every))

    @property
    def _arrays(self) -> tuple[Any, ...]:
        return self.sides, self.points, self.distances, self.feet, self.places, self.ceiling

    def bounded(self, at: At, other: Triangles) -> tuple[Cells, Booleans]:
        """The cells with the lowest ceilings that can be proved, and which to cut across u."""
        u0, u1, v0, v1 = self.sides
        middle = at(0.5 * (u0 + u1), 0.5 * (v0 + v1))
        sag = lengths(middle - self.points.mean(axis=0))
        to_corners = lengths(self.points - middle).max(axis=0)
        wide, high = _spans(self.points)
        chord_u, chord_v = _spans(self.feet)
        along_u = 0.5 * chord_u * self._steepness(((0, 1), (3, 2)), other) + sag
        along_v = 0.5 * chord_v * self._steepness(((0, 3), (1, 2)), other) + sag
        apart = [
            np.maximum(to_corners, 0.5 * np.maximum(wide, high)),
            0.5 * (chord_u + chord_v) * self._steepness(((0, 1, 2, 3),), other) + sag,
            0.5 * high + along_u,
            0.5 * wide + along_v,
        ]
        if not other.columns:
            from_feet = [lengths(self.points - foot).max(axis=0) for foot in self.feet]
            apart.append(np.min(from_feet, axis=0) - self.distances.max(axis=0) + sag)
        ways = np.stack(apart)
        best = ways.argmin(axis=0)
        # Across what contributes most to the bound.
        either = np.where(best == 2, 2 * along_u > high, wide > 2 * along_v)
        cut_u = np.where((best < 2) | (best == 4), wide >= high, either)
        ceiling = np.minimum(self.ceiling, self.distances.max(axis=0) + ways.min(axis=0))
        return replace(self, ceiling=ceiling), cut_u

    def divided(self, cut_u: Booleans, at: At, other: Triangles) -> tuple[Cells, float]:
        """Both parts of every cell, cut across u or v, and the largest distance on the cuts."""
        parts, largest = [], 0.0
        for cells, by_u in ((self[cut_u], True), (self[~cut_u], False)):
            if not len(cells):
                continue
            u0, u1, v0, v1 = cells.sides
            # Corners of the parts: numbers of old corners, or of those on the cuts beyond 4.
            if by_u:
                u = u0 + cells._beside_ridge(((0, 1), (3, 2))) * (u1 - u0)
                cuts = at(np.stack([u, u]), np.stack([v0, v1]))
                both = ((0, 4, 5, 3), (u0, u, v0, v1)), ((4, 1, 2, 5), (u, u1, v0, v1))
            else:
                v = v0 + cells._beside_ridge(((0, 3), (1, 2))) * (v1 - v0)
                cuts = at(np.stack([u0, u1]), np.stack([v, v]))
                both = ((0, 1, 5, 4), (u0, u1, v0, v)), ((4, 5, 2, 3), (u0, u1, v, v1))
            found = other.nearest(cuts)
            largest = max(largest, float(found.distances.max()))
            for numbers, sides in both:
                chosen = list(numbers)
                parts.append(
                    Cells(
                        np.stack(sides),
                        np.concatenate([cells.points, cuts])[chosen],
                        np.concatenate([cells.distances, found.distances])[chosen],
                        np.concatenate([cells.feet, found.feet])[chosen],
                        np.concatenate([cells.places, found.cells])[chosen],
                        cells.ceiling,
                    )
                )
        return Cells.joined(parts), largest

    def _beside_ridge(self, pairs: tuple[tuple[int, int], ...]) -> Array:
        """Where to cut (C,), as a share: beside the ridge of the distance, if there is one.

        Along an edge from corner a to corner b the distances to what is nearest to a, and to b,
        change as the directions to the feet say. Where they meet is a ridge.
        """
        total = np.zeros(len(self))
        for a, b in pairs:
            edge = self.points[b] - self.points[a]
            slope_a, slope_b = (
                np.einsum("ij,ij->i", self.points[k] - self.feet[k], edge)
                / np.where(self.distances[k] > 0, self.distances[k], np.inf)
                for k in (a, b)
            )
            meet = (self.places[a] != self.places[b]).any(axis=-1) & (slope_a > slope_b)
            rise = self.distances[b] - self.distances[a] - slope_b
            total += np.where(meet, rise / np.where(meet, slope_a - slope_b, 1.0), 0.5)
        share = total / len(pairs)
        # On the ridge itself the feet would be on either side of it.
        share += NARROWEST * np.sign(0.5 - share)
        return np.asarray(np.clip(share, NARROWEST, 1 - NARROWEST))

    def _steepness(self, groups: tuple[tuple[int, ...], ...], other: Triangles) -> Array:
        """How steeply the other surface may leave chords (C,) between feet of given corners."""
        turns = [other.turns(self.places[list(group)]) for group in groups]
        turn = np.max(turns, axis=0)
        return np.where(turn < MOST_TURN, np.tan(0.5 * np.minimum(turn, MOST_TURN)), ANY)


def find_largest(
    parts: Iterator[Cells],
    at: At,
    other: Triangles,
    attained: float,
    samples: int,
    *,
    limit: float | None = None,
) -> tuple[float, float]:
    """The largest distance of cells from another surface, and by how much it may be exceeded.

    Cells in which it may be exceeded by more than :data:`PRECISION` are cut in two again and again,
    for as many further points as ``samples`` says. With a limit it is enough to know whether the
    largest distance exceeds that. ``attained`` is one that does occur.
    """
    largest, left_out = attained, attained
    waiting: list[tuple[Cells, Booleans]] = []

    def wait(cells: Cells) -> float:
        """Put off what may exceed the largest, at most as much as is affordable."""
        cells, cut_u = cells.bounded(at, other)
        known = largest if limit is None else max(largest, limit)
        chosen = _highest(cells.ceiling[0], (1 + PRECISION) * known, samples)
        waiting.append((cells[chosen], cut_u[chosen]))
        return float(cells.ceiling[0, ~chosen].max(initial=0.0))

    for part in parts:
        left_out = max(left_out, wait(part))
    while True:
        cells = Cells.joined([each for each, _ in waiting])
        cut_u = np.concatenate([each for _, each in waiting])
        ceiling = cells.ceiling[0]
        highest = float(ceiling.max(initial=0.0))
        enough = (1 + PRECISION) * largest if limit is None else limit
        if highest <= enough or largest > enough or samples < 2:
            return largest, max(left_out, highest) - largest
        # The most promising first, so that the bound falls evenly.
        now = _highest(ceiling, largest + URGENT * (highest - largest), samples // 2)
        samples -= 2 * int(np.count_nonzero(now))
        divided, found = cells[now].divided(cut_u[now], at, other)
        largest = max(largest, found)
        waiting = [(cells[~now], cut_u[~now])]
        left_out = max(left_out, wait(divided))


def _corners(lattice: NDArray[Number]) -> NDArray[Number]:
    """Values at the four corners of all cells (4, C, ...) of a lattice (A, B, ...)."""
    four = (lattice[:-1, :-1], lattice[1:, :-1], lattice[1:, 1:], lattice[:-1, 1:])
    return np.stack(four).reshape(4, -1, *lattice.shape[2:])


def _spans(points: Array) -> tuple[Array, Array]:
    """Longer sides (C,) of quads (4, C, 3) along u and along v."""
    sides = lengths(points - np.roll(points, -1, axis=0))
    return np.maximum(sides[0], sides[2]), np.maximum(sides[1], sides[3])


def _highest(values: Array, above: float, most: int) -> Booleans:
    """Which values (C,) exceed ``above``; only the highest if more than ``most`` do."""
    chosen = values > above
    if np.count_nonzero(chosen) > most:
        chosen = np.zeros(len(values), np.bool_)
        chosen[np.argsort(-values, kind="stable")[:most]] = True
    return np.asarray(chosen)
