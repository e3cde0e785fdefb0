"""A piece of surface that a shell is to cover: what fits know of their target.

Distances from the triangles that stand for the smooth surface, and from polylines for its rim, are
of third order in the size of the triangles: over the foot q of a point p in a triangle with corners
v_i, shares b_i and unit normals n_i, a surface with these normals is the height

    h = 1/2 sum_i b_i ((v_i - q) . n_i) (n_i . n),     n = sum_i b_i n_i, of unit length,

exactly so for a quadratic one: half of the tangent planes' mean (Boubekeur and Alexa, Phong
tessellation, ACM TOG 27 (2008) 141). The distance is (p - q) . n - h.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from orishell.conventions.record import record
from orishell.motion.quads import dots, lengths
from orishell.numerics.arrays import Array, Integers

AT_CORNER = 1e-9
"""A share below this is none."""


@record
class Foot:
    """Where points are nearest to a triangle (K = 3) or to an edge (K = 2)."""

    away: Array  # (N, 3), from there to the points
    steps: Array  # (N, K, 3), from there to the corners
    shares: Array  # (N, K), of the corners
    directions: Array  # (N, K, 3), unit vectors along which distances from the corners are

    @cached_property
    def _mean(self) -> Array:
        return np.asarray(np.einsum("nk,nki->ni", self.shares, self.directions))

    @cached_property
    def direction(self) -> Array:
        """Unit vectors (N, 3) along which distances are: n."""
        return np.asarray(self._mean / lengths(self._mean)[:, None])

    @cached_property
    def _rises(self) -> Array:
        """(v_i - q) . n_i (N, K)."""
        return dots(self.steps, self.directions)

    @cached_property
    def _leans(self) -> Array:
        """n_i . n (N, K)."""
        return np.asarray(np.einsum("nki,ni->nk", self.directions, self.direction))

    @property
    def distances(self) -> Array:
        """Distances (N,) of the points, signed."""
        height = 0.5 * (self.shares * self._rises * self._leans).sum(axis=-1)
        return np.asarray(dots(self.away, self.direction) - height)

    @property
    def slopes(self) -> Array:
        """Derivatives (N, 3) of the distances by the points.

        With a foot that stays it is n. As the foot moves and shares change, the distance changes by

            dq . (1/2 sum_i b_i (n_i . n) n_i - n)
            + sum_i db_i (m . n_i / size - 1/2 (v_i - q) . n_i (n_i . n)).

        Here size is the length of sum_i b_i n_i, by which n was divided, and m is the part square
        to n of p - q - 1/2 sum_i b_i ((v_i - q) . n_i) n_i.
        """
        directions, n = self.directions, self.direction
        shifts = 0.5 * np.einsum("nk,nki->ni", self.shares * self._leans, directions) - n
        turns = self.away - 0.5 * np.einsum("nk,nki->ni", self.shares * self._rises, directions)
        turns -= dots(turns, n)[:, None] * n
        turns /= lengths(self._mean)[:, None]
        by_share = np.einsum("nki,ni->nk", directions, turns) - 0.5 * self._rises * self._leans
        # Along an edge, from corner to corner, one share falls from 1 to 0 and the next one rises.
        corners = np.array([0, 1] if self.shares.shape[1] == 2 else [0, 1, 2, 0])
        edges = np.diff(self.steps[:, corners], axis=1)
        changes = np.einsum("nki,ni->nk", edges, shifts) + np.diff(by_share[:, corners], axis=1)
        return np.asarray(n + self._moved(edges, changes, corners))

    def _moved(self, edges: Array, changes: Array, corners: Integers) -> Array:
        """Derivatives (N, 3) by the points of what changes so much along edges (N, E, 3).

        The foot moves with the point in the plane of its triangle, along the edge if it is on one,
        and not at all at a corner.
        """
        there = self.shares[:, corners] > AT_CORNER
        both = there[:, 1:] & there[:, :-1]
        found = np.einsum("nk,nki->ni", np.where(both, changes / dots(edges, edges), 0.0), edges)
        if edges.shape[1] == 3:
            # Of the plane's vectors the one whose products with the edges are the changes.
            within = both.all(axis=1)
            (p, q, _), (by_p, by_q, _) = np.moveaxis(edges[within], 1, 0), changes[within].T
            normal = np.cross(p, q)
            found[within] = (
                by_p[:, None] * np.cross(q, normal) - by_q[:, None] * np.cross(p, normal)
            ) / dots(normal, normal)[:, None]
        return np.asarray(found)


def shares_of(steps: Array) -> Array:
    """Barycentric coordinates (N, 3) of points in triangles, steps (N, 3, 3) to corners given."""
    p, q, r = np.moveaxis(steps, 1, 0)
    whole = np.cross(q - p, r - p)
    areas = [np.cross(q, r), np.cross(r, p), np.cross(p, q)]
    return np.stack([dots(each, whole) for each in areas], axis=-1) / dots(whole, whole)[:, None]


Side = Integers
"""Numbers of vertices (K,) along a side of the rim, from corner to corner."""


@record
class Facets:
    """Triangles with smooth normals."""

    vertices: Array  # (V, 3)
    normals: Array  # (V, 3), unit vectors
    triangles: Integers  # (T, 3), counter-clockwise seen from the side of the normals

    @cached_property
    def normal(self) -> Array:
        """Their mean normal (3,)."""
        p, q, r = np.moveaxis(self.vertices[self.triangles], 1, 0)
        normal = np.cross(q - p, r - p).sum(axis=0)
        return np.asarray(normal / np.linalg.norm(normal))

    @cached_property
    def diagonal(self) -> float:
        """Diagonal of their box."""
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))

    def foot(self, points: Array) -> Foot:
        """Where points (N, 3) are nearest to them."""
        _, index, feet = self._tree.squared_distance(
            self.vertices, self.triangles, np.ascontiguousarray(points)
        )
        corners = self.triangles[index]
        steps = self.vertices[corners] - feet[:, None]
        return Foot(points - feet, steps, shares_of(steps), self.normals[corners])

    @cached_property
    def _tree(self) -> Any:
        import igl

        tree = igl.AABB()
        tree.init(self.vertices, np.ascontiguousarray(self.triangles))
        return tree


@record
class Piece:
    """Triangles with smooth normals, and a rim of four sides."""

    facets: Facets  # its triangles
    # The top from left to right, the right side downwards, the bottom from right to left and the
    # left side upwards, seen from the side of the normals.
    sides: tuple[Side, Side, Side, Side]

    @classmethod
    def of_lattice(cls, points: Array, normals: Array) -> Piece:
        """The piece of a lattice of points (A, B, 3), its first row the top, with their normals."""
        rows, columns = points.shape[:2]
        number = np.arange(rows * columns).reshape(rows, columns)
        a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
        triangles = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
        sides = number[0], number[:, -1], number[-1, ::-1], number[::-1, 0]
        return cls(Facets(points.reshape(-1, 3), normals.reshape(-1, 3), triangles), sides)

    @cached_property
    def centre(self) -> Array:
        """A point (3,) in its middle: the mean of its corners' means along the rim."""
        return np.asarray(np.mean([line.mean(axis=0) for line in self.rim], axis=0))

    @property
    def vertices(self) -> Array:
        """Those of its triangles (V, 3)."""
        return self.facets.vertices

    @property
    def normals(self) -> Array:
        """Their unit normals (V, 3)."""
        return self.facets.normals

    @property
    def triangles(self) -> Integers:
        """Its triangles (T, 3)."""
        return self.facets.triangles

    @property
    def diagonal(self) -> float:
        """Diagonal of its box."""
        return self.facets.diagonal

    @property
    def rim(self) -> list[Array]:
        """The four sides, as polylines (K, 3)."""
        return [self.vertices[side] for side in self.sides]

    @cached_property
    def axes(self) -> Array:
        """Unit vectors (3, 3): from left to right, from bottom to top, and its mean normal."""
        normal = self.facets.normal
        _, right, _, left = (line.mean(axis=0) for line in self.rim)
        across = right - left - ((right - left) @ normal) * normal
        across /= np.linalg.norm(across)
        return np.stack([across, np.cross(normal, across), normal])

    @property
    def extents(self) -> tuple[float, float]:
        """Mean lengths from left to right and from bottom to top, along the surface."""
        top, right, bottom, left = (
            float(lengths(np.diff(line, axis=0)).sum()) for line in self.rim
        )
        return 0.5 * (top + bottom), 0.5 * (left + right)

    def turned(self, times: int = 1) -> Piece:
        """The piece with its right side as the top, turned so several times."""
        piece = self
        for _ in range(times % 4):
            top, right, bottom, left = piece.sides
            piece = replace(piece, sides=(right, bottom, left, top))
        return piece

    def flattened(self, share: float) -> Piece:
        """The piece whose departures from its mean plane are a share, above 0, of what they are."""
        normal, normals = self.axes[2], self.normals
        normals = normals + (1 / share - 1) * (normals @ normal)[:, None] * normal
        normals = normals / lengths(normals)[:, None]
        vertices = self.pressed(self.vertices, share)
        return replace(self, facets=Facets(vertices, normals, self.triangles))

    def pressed(self, points: Array, share: float) -> Array:
        """Where points (N, 3) go when the piece is flattened to a share of its height."""
        normal = self.axes[2]
        heights = (points - self.centre) @ normal
        return np.asarray(points - ((1 - share) * heights)[:, None] * normal)

    def nearest(self, points: Array) -> tuple[Array, Array]:
        """Signed distances (N,) of points (N, 3), and unit normals (N, 3) where they are nearest.

        Beyond the rim it is the distance from the plane that touches there.
        """
        foot = self.facets.foot(points)
        return foot.distances, foot.direction

    def over(self, points: Array) -> tuple[Array, Array]:
        """Signed distances (N,) of points (N, 3), and their derivatives (N, 3) by the points."""
        foot = self.facets.foot(points)
        return foot.distances, foot.slopes

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
