"""A piece of surface that a shell is to cover: what fits know of their target."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from orishell.conventions.record import record
from orishell.design.foot import Foot, shares_of
from orishell.motion.quads import dots, lengths
from orishell.numerics.arrays import Array, Integers

Side = Integers
"""Numbers of vertices (K,) along a side of the rim, from corner to corner."""


@record
class Piece:
    """Triangles with smooth normals, and a rim of four sides."""

    vertices: Array  # (V, 3)
    normals: Array  # (V, 3), unit vectors
    triangles: Integers  # (T, 3), counter-clockwise seen from the side of the normals
    # The top from left to right, the right side downwards, the bottom from right to left and the
    # left side upwards, seen from there.
    sides: tuple[Side, Side, Side, Side]

    @classmethod
    def of_lattice(cls, points: Array, normals: Array) -> Piece:
        """The piece of a lattice of points (A, B, 3), its first row the top, with their normals."""
        rows, columns = points.shape[:2]
        number = np.arange(rows * columns).reshape(rows, columns)
        a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
        triangles = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
        sides = number[0], number[:, -1], number[-1, ::-1], number[::-1, 0]
        return cls(points.reshape(-1, 3), normals.reshape(-1, 3), triangles, sides)

    @cached_property
    def centre(self) -> Array:
        """A point (3,) in its middle: the mean of its corners' means along the rim."""
        return np.asarray(
            np.mean([self.vertices[side].mean(axis=0) for side in self.sides], axis=0)
        )

    @cached_property
    def axes(self) -> Array:
        """Unit vectors (3, 3): from left to right, from bottom to top, and its mean normal."""
        p, q, r = np.moveaxis(self.vertices[self.triangles], 1, 0)
        normal = np.cross(q - p, r - p).sum(axis=0)
        normal /= np.linalg.norm(normal)
        _, right, _, left = (self.vertices[side].mean(axis=0) for side in self.sides)
        across = right - left - ((right - left) @ normal) * normal
        across /= np.linalg.norm(across)
        return np.stack([across, np.cross(normal, across), normal])

    @cached_property
    def diagonal(self) -> float:
        """Diagonal of its box."""
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))

    @property
    def extents(self) -> tuple[float, float]:
        """Mean lengths from left to right and from bottom to top, along the surface."""
        top, right, bottom, left = (
            float(lengths(np.diff(self.vertices[side], axis=0)).sum()) for side in self.sides
        )
        return 0.5 * (top + bottom), 0.5 * (left + right)

    def turned(self) -> Piece:
        """The piece with its right side as the top."""
        top, right, bottom, left = self.sides
        return replace(self, sides=(right, bottom, left, top))

    def flattened(self, share: float) -> Piece:
        """The piece whose departures from its mean plane are a share, above 0, of what they are."""
        normal = self.axes[2]
        heights = (self.vertices - self.centre) @ normal
        vertices = self.vertices - ((1 - share) * heights)[:, None] * normal
        normals = self.normals + (1 / share - 1) * (self.normals @ normal)[:, None] * normal
        normals = normals / lengths(normals)[:, None]
        return replace(self, vertices=vertices, normals=normals)

    def nearest(self, points: Array) -> tuple[Array, Array]:
        """Signed distances (N,) of points (N, 3), and unit normals (N, 3) where they are nearest.

        Beyond the rim it is the distance from the plane that touches there.
        """
        foot = self._foot(points)
        return foot.distances, foot.direction

    def over(self, points: Array) -> tuple[Array, Array]:
        """Signed distances (N,) of points (N, 3), and their derivatives (N, 3) by the points."""
        foot = self._foot(points)
        return foot.distances, foot.slopes

    def _foot(self, points: Array) -> Foot:
        _, index, feet = self._tree.squared_distance(
            self.vertices, self.triangles, np.ascontiguousarray(points)
        )
        corners = self.triangles[index]
        steps = self.vertices[corners] - feet[:, None]
        return Foot(points - feet, steps, shares_of(steps), self.normals[corners])

    def beside(self, side: int, points: Array) -> tuple[Array, Array]:
        """Distances (N,) of points (N, 3) from a side, and their derivatives (N, 3) by the points.

        Distances lie within the surface, square to the rim, and are positive outside. Beyond its
        corners a side goes on straight.
        """
        line, directions = self._outwards[side]
        points = np.asarray(points)
        start, step = line[:-1], np.diff(line, axis=0)
        away = points[:, None] - start
        share = np.clip(np.einsum("nki,ki->nk", away, step) / dots(step, step), 0, 1)
        away -= share[..., None] * step
        piece = dots(away, away).argmin(axis=1)
        found = np.arange(len(points))
        away, share = away[found, piece], share[found, piece]
        shares, ends = np.stack([1 - share, share], axis=-1), np.stack([piece, piece + 1], axis=-1)
        foot = Foot(away, line[ends] - (points - away)[:, None], shares, directions[ends])
        return foot.distances, foot.slopes

    @cached_property
    def _outwards(self) -> tuple[tuple[Array, Array], ...]:
        """Points (K, 3) along each side, and unit vectors out of the piece there."""
        found = []
        for side in self.sides:
            line = self.vertices[side]
            edges = np.diff(line, axis=0)
            edges /= lengths(edges)[:, None]
            along = np.concatenate([edges[:1], edges[:-1] + edges[1:], edges[-1:]])
            if len(line) > 3:  # at its ends as a parabola through three points
                along[0] += 0.5 * (edges[0] - edges[1])
                along[-1] += 0.5 * (edges[-1] - edges[-2])
            outwards = np.cross(self.normals[side], along)
            found.append((line, outwards / lengths(outwards)[:, None]))
        return tuple(found)

    @cached_property
    def _tree(self) -> Any:
        import igl

        tree = igl.AABB()
        tree.init(self.vertices, np.ascontiguousarray(self.triangles))
        return tree
