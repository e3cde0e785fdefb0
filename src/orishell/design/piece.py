"""The piece of a surface that a shell is to cover: triangles with normals, and four sides.

Distances are of third order in the size of the triangles: over the foot q in a triangle with
corners v_i, shares b_i and unit normals n_i, a surface with these normals is the height

    h = 1/2 sum_i b_i ((v_i - q) . n_i) (n_i . n),     n = sum_i b_i n_i, of unit length,

exactly so for a quadratic one: half of the tangent planes' mean (Boubekeur and Alexa, Phong
tessellation, ACM TOG 27 (2008) 141). So the distance (p - q) . n - h changes with p as n says.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers

Sides = tuple[Integers, Integers, Integers, Integers]
SIDES = ("top", "right", "bottom", "left")
AT_ONCE = 2**21
"""Pairs of a point and a step of the rim that are looked at together."""


@record
class Piece:
    """An open piece of surface with a rim of four sides.

    Seen from the side of its normals the sides run clockwise: the top from left to right, the
    right side down, the bottom from right to left, the left side up.
    """

    vertices: Array  # (V, 3)
    normals: Array  # (V, 3), of unit length
    triangles: Integers  # (T, 3), counter-clockwise seen from the side of the normals
    # numbers of the vertices along the top, right, bottom and left, from corner to corner: the
    # last of each is the first of the next
    rim: Sides

    @classmethod
    def of_grid(cls, points: Array, normals: Array) -> Piece:
        """The piece of a grid of points (A, B, 3) and unit normals: rows down, columns right."""
        number = np.arange(points[..., 0].size).reshape(points.shape[:2])
        a, b = number[:-1, :-1], number[:-1, 1:]
        c, d = number[1:, 1:], number[1:, :-1]
        triangles = np.stack([a, d, c, a, c, b], axis=-1).reshape(-1, 3)
        rim = number[0], number[:, -1], number[-1, ::-1], number[::-1, 0]
        return cls(points.reshape(-1, 3), normals.reshape(-1, 3), triangles, rim)

    @property
    def sides(self) -> tuple[Array, Array, Array, Array]:
        """Points (K, 3) along the top, right, bottom and left."""
        top, right, bottom, left = (self.vertices[each] for each in self.rim)
        return top, right, bottom, left

    @property
    def diagonal(self) -> float:
        """The diagonal of its box."""
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))

    @property
    def along(self) -> float:
        """How long it is from left to right: the mean of top and bottom (length)."""
        return 0.5 * (_length(self.sides[0]) + _length(self.sides[2]))

    @property
    def across(self) -> float:
        """How long it is from the top down: the mean of left and right (length)."""
        return 0.5 * (_length(self.sides[1]) + _length(self.sides[3]))

    @property
    def area(self) -> float:
        """Area of its triangles."""
        return float(0.5 * np.linalg.norm(self._double_areas(), axis=-1).sum())

    def mean_plane(self) -> tuple[Array, Array]:
        """A point and the unit normal (3,) of the plane in which its rim encloses the most."""
        weights = np.linalg.norm(self._double_areas(), axis=-1)
        middle = self.vertices[self.triangles].mean(axis=1)
        normal = self._double_areas().sum(axis=0)
        return weights @ middle / weights.sum(), normal / np.linalg.norm(normal)

    def flattened(self, share: float) -> Piece:
        """The piece with its departure from its mean plane times a share, normals to match."""
        middle, axis = self.mean_plane()
        height = (self.vertices - middle) @ axis
        # A plane's normal changes by the inverse of what its points change by.
        rise = self.normals @ axis
        normals = share * self.normals + (1 - share) * rise[:, None] * axis
        size = np.linalg.norm(normals, axis=-1, keepdims=True)
        return Piece(
            self.vertices - (1 - share) * height[:, None] * axis,
            np.where(size > 1e-12, normals / np.maximum(size, 1e-12), axis),
            self.triangles,
            self.rim,
        )

    def nearest(self, points: Array) -> tuple[Array, Array]:
        """Distances (N,) of points (N, 3), positive on the side of the normals, and normals (N, 3).

        The normals are those of the piece, of unit length, where it is nearest. Beyond the rim the
        piece goes on in its tangent planes.
        """
        points = np.ascontiguousarray(points)
        _, index, foot = self._tree.squared_distance(self.vertices, self.triangles, points)
        corners = self.triangles[index]
        normals = self.normals[corners]  # (N, 3 corners, 3)
        steps = self.vertices[corners] - foot[:, None]
        shares = _shares(steps)
        normal = _unit(np.einsum("ni,nij->nj", shares, normals))
        rise = np.einsum("nij,nij->ni", steps, normals) * np.einsum("nij,nj->ni", normals, normal)
        height = 0.5 * np.einsum("ni,ni->n", shares, rise)
        return np.einsum("nj,nj->n", points - foot, normal) - height, normal

    def beside(self, side: int, points: Array) -> tuple[Array, Array]:
        """Distances (N,) of points (N, 3) from a side, within the surface; directions (N, 3).

        The sides are numbered top, right, bottom, left. Distances are positive outside, directions
        of unit length: they lie in the surface, square to the side, and point outwards.
        """
        line, outward = self._beside[side]
        points = np.asarray(points)
        step = max(AT_ONCE // len(line), 1)
        parts = [
            _from_line(points[k : k + step], line, outward) for k in range(0, len(points), step)
        ]
        if not parts:
            return np.zeros(0), np.zeros((0, 3))
        distances, directions = (np.concatenate(each) for each in zip(*parts, strict=True))
        return distances, directions

    @cached_property
    def _tree(self) -> Any:
        import igl

        tree = igl.AABB()
        tree.init(self.vertices, self.triangles)
        return tree

    @cached_property
    def _beside(self) -> tuple[tuple[Array, Array], ...]:
        """Points (K, 3) along each side, and directions out of the piece there."""
        found = []
        for numbers in self.rim:
            line = self.vertices[numbers]
            edges = _unit(np.diff(line, axis=0))
            tangents = np.concatenate([edges[:1], edges[:-1] + edges[1:], edges[-1:]])
            if len(line) > 3:  # at the ends as a parabola through the last three points
                tangents[0] = edges[0] + 0.5 * (edges[0] - edges[1])
                tangents[-1] = edges[-1] + 0.5 * (edges[-1] - edges[-2])
            found.append((line, _unit(np.cross(self.normals[numbers], tangents))))
        return tuple(found)

    def _double_areas(self) -> Array:
        """Normals (T, 3) of the triangles, twice as long as their areas."""
        p, q, r = (self.vertices[self.triangles[:, k]] for k in range(3))
        return np.cross(q - p, r - p)


def _from_line(points: Array, line: Array, outward: Array) -> tuple[Array, Array]:
    """Distances (N,) of points (N, 3) from a line (K, 3) along directions (K, 3) of its points."""
    edges = np.diff(line, axis=0)
    squares = np.maximum((edges**2).sum(axis=-1), 1e-300)
    away = points[:, None] - line[:-1]  # (N, K-1, 3)
    at = np.clip(np.einsum("nki,ki->nk", away, edges) / squares, 0.0, 1.0)
    away -= at[..., None] * edges
    nearest = (away**2).sum(axis=-1).argmin(axis=1)
    row = np.arange(len(points))
    share, away = at[row, nearest], away[row, nearest]
    shares = np.stack([1 - share, share], axis=-1)
    ends = np.stack([nearest, nearest + 1], axis=-1)
    directions = outward[ends]
    direction = _unit(np.einsum("ni,nij->nj", shares, directions))
    steps = line[ends] - (points - away)[:, None]
    rise = np.einsum("nij,nij->ni", steps, directions)
    rise *= np.einsum("nij,nj->ni", directions, direction)
    height = 0.5 * np.einsum("ni,ni->n", shares, rise)
    return np.einsum("nj,nj->n", away, direction) - height, direction


def _shares(steps: Array) -> Array:
    """Barycentric coordinates (N, 3) of points, given the steps (N, 3, 3) to the corners."""
    p, q, r = np.moveaxis(steps, 1, 0)
    whole = np.cross(q - p, r - p)
    size = np.maximum((whole**2).sum(axis=-1), 1e-300)
    first = (np.cross(q, r) * whole).sum(axis=-1) / size
    second = (np.cross(r, p) * whole).sum(axis=-1) / size
    return np.stack([first, second, 1 - first - second], axis=-1)


def _length(line: Array) -> float:
    return float(np.linalg.norm(np.diff(line, axis=0), axis=-1).sum())


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))
