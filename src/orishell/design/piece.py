"""A piece of surface that a shell is to cover: what fits know of their target."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from orishell.conventions.record import record
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
        """The same with its right side as the top."""
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
        _, index, feet = self._tree.squared_distance(
            self.vertices, self.triangles, np.ascontiguousarray(points)
        )
        corners = self.triangles[index]
        p, q, r = np.moveaxis(self.vertices[corners], 1, 0)
        whole = np.cross(q - p, r - p)
        # Shares of the corners by the areas opposite them.
        areas = [np.cross(r - q, feet - q), np.cross(p - r, feet - r), np.cross(q - p, feet - p)]
        shares = np.stack([dots(each, whole) for each in areas], axis=-1)
        shares /= dots(whole, whole)[:, None]
        normals = np.einsum("nk,nki->ni", shares, self.normals[corners])
        normals /= lengths(normals)[:, None]
        return dots(points - feet, normals), normals

    def beside(self, side: int, points: Array) -> tuple[Array, Array]:
        """Distances (N,) of points (N, 3) from a side, within the surface and positive outside.

        And the unit vectors (N, 3) along which they are measured: square to the rim, outwards.
        Beyond its corners a side goes on straight.
        """
        line, normals = self.vertices[self.sides[side]], self.normals[self.sides[side]]
        start, step = line[:-1], np.diff(line, axis=0)
        share = np.einsum("nki,ki->nk", points[:, None] - start, step) / dots(step, step)
        near = start + np.clip(share, 0, 1)[..., None] * step
        piece = ((points[:, None] - near) ** 2).sum(axis=-1).argmin(axis=1)
        found = np.arange(len(points))
        along = step[piece] / lengths(step[piece])[:, None]
        share = np.clip(share[found, piece], 0, 1)[:, None]
        normal = (1 - share) * normals[piece] + share * normals[piece + 1]
        outwards = np.cross(normal, along)
        outwards /= lengths(outwards)[:, None]
        return dots(points - near[found, piece], outwards), outwards

    @cached_property
    def _tree(self) -> Any:
        import igl

        tree = igl.AABB()
        tree.init(self.vertices, np.ascontiguousarray(self.triangles))
        return tree
