"""Samples of triangles in any order, and the areas that samples stand for."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.record import record
from orishell.deviation.branch_and_bound import AT_ONCE, Cells
from orishell.deviation.triangles import Nearest
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array, Integers

MOST_PARTS = 128
"""Parts of an edge of a triangle, at most."""


@record
class Scattered:
    """Samples of triangles: the corners of the parts that each is cut into.

    A cell of the search is a part as a quad whose last two corners are one, with parameters of its
    own: part k has u from 2k to 2k + 1 and v from 0 to 1.
    """

    points: Array  # (P, 3)
    parts: Integers  # (Q, 3) numbers of the points at the corners of parts
    left_out: float = 0.0  # nothing is

    @classmethod
    def of(cls, vertices: Array, triangles: Integers, samples: int) -> Scattered:
        """About so many samples, or all vertices if there are more, evenly spaced."""
        corners = vertices[triangles]
        p, q, r = np.moveaxis(corners, 1, 0)
        area = 0.5 * lengths(np.cross(q - p, r - p)).sum()
        step = np.sqrt(2 * area / samples)
        longest = lengths(corners - np.roll(corners, 1, axis=1)).max(axis=1)
        counts = np.clip(np.ceil(longest / step - 1e-9), 1, MOST_PARTS).astype(np.intp)
        points, parts = [vertices], [triangles[counts == 1]]
        total = len(vertices)
        for count in np.unique(counts[counts > 1]):
            shares, pieces = _cut(int(count))
            found = np.einsum("sk,tki->tsi", shares, corners[counts == count])
            start = total + len(shares) * np.arange(len(found))
            points.append(found.reshape(-1, 3))
            parts.append((start[:, None, None] + pieces).reshape(-1, 3))
            total += found.shape[0] * found.shape[1]
        used, inverse = np.unique(np.concatenate(parts), return_inverse=True)
        return cls(np.concatenate(points)[used], inverse.reshape(-1, 3))

    def at(self, u: Array, v: Array) -> Array:
        """Points (..., 3) at parameters u, v (...) of cells."""
        part = np.clip(np.floor(0.5 * u), 0, len(self.parts) - 1).astype(np.intp)
        share, v = (u - 2 * part)[..., None], v[..., None]
        p, q, r = np.moveaxis(self.points[self.parts[part]], -2, 0)
        return np.asarray((1 - v) * ((1 - share) * p + share * q) + v * r)

    def cells(self, found: Nearest) -> Iterator[Cells]:
        """The parts as cells, as many at once as fit into memory."""
        for k in range(0, len(self.parts), AT_ONCE):
            corners = self.parts[k : k + AT_ONCE][:, [0, 1, 2, 2]].T
            u = 2.0 * np.arange(k, k + corners.shape[1])
            yield Cells(
                np.stack([u, u + 1, np.zeros_like(u), np.ones_like(u)]),
                self.points[corners],
                found.distances[corners],
                found.feet[corners],
                found.cells[corners],
                np.full((1, len(u)), np.inf),
            )

    def spread(self, distances: Array) -> tuple[Array, Array]:
        """Distances (3 Q,) inside the parts, linear between samples, and shares of the area.

        At the three points of a triangle that integrate squares exactly.
        """
        p, q, r = np.moveaxis(self.points[self.parts], 1, 0)
        areas = lengths(np.cross(q - p, r - p))
        weights = np.full((3, 3), 1 / 6) + 0.5 * np.eye(3)
        inside = distances[self.parts] @ weights
        return inside.ravel(), np.repeat(areas / (3 * areas.sum()), 3)

    def radius(self) -> float:
        """A length within which every point of a part has a corner of it, in all parts."""
        corners = self.points[self.parts]
        return float(lengths(corners - np.roll(corners, 1, axis=1)).max() / np.sqrt(3))


def _cut(count: int) -> tuple[Array, Integers]:
    """Barycentric coordinates (S, 3) of a triangle cut ``count`` times, and its parts (Q, 3)."""
    i, j = np.meshgrid(np.arange(count + 1), np.arange(count + 1), indexing="ij")
    within = i + j <= count
    number = np.full(i.shape, -1)
    number[within] = np.arange(np.count_nonzero(within))
    shares = np.stack([count - i - j, i, j], axis=-1)[within] / count
    low = i[:-1, :-1] + j[:-1, :-1]
    a, b, c, d = number[:-1, :-1], number[1:, :-1], number[:-1, 1:], number[1:, 1:]
    upright = np.stack([a, b, c], axis=-1)[low < count]
    turned = np.stack([b, d, c], axis=-1)[low < count - 1]
    return shares, np.concatenate([upright, turned])
