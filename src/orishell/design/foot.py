"""Distances from triangles that stand for a smooth surface, and from polylines for its rim.

They are of third order in the size of the triangles: over the foot q of a point p in a triangle
with corners v_i, shares b_i and unit normals n_i, a surface with these normals is the height

    h = 1/2 sum_i b_i ((v_i - q) . n_i) (n_i . n),     n = sum_i b_i n_i, of unit length,

exactly so for a quadratic one: half of the tangent planes' mean (Boubekeur and Alexa, Phong
tessellation, ACM TOG 27 (2008) 141). The distance is (p - q) . n - h.
"""

from __future__ import annotations

from functools import cached_property

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
