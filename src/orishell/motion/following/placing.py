"""Folded states in space: panel is hinged to panel, from one that stays where it is."""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

import numpy as np

from orishell.conventions.record import record
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.quads import lengths, units
from orishell.numerics.arrays import Array, Integers


class _Hinged(NamedTuple):
    """Panels (K,) hinged to panels that are placed before them."""

    panels: Integers
    before: Integers
    edges: Integers  # the creases (K,) between them
    sides: Array  # 1 where the panel is to the left of its crease, -1 where to the right


@record
class Placing:
    """How the panels of a pattern are placed: a middle one first, then neighbours, and so on."""

    pattern: CreasePattern

    def placed(self, folds: Array) -> tuple[Array, float]:
        """Vertices (V, 3) of a folded state, and how far panels part at creases (length).

        The middle panel of every piece lies in the flat sheet. Each panel is rigid; where creases
        do not meet exactly, as in a state that does not close, vertices are the means of what
        panels say. The second is the largest distance, along all creases, of a point of one panel
        from the same point of the other: the play that hinges need.

        Parameters
        ----------
        folds
            Fold angles (E,) of all edges, valley positive (radians).
        """
        pattern = self.pattern
        flat = np.column_stack([pattern.vertices, np.zeros(len(pattern.vertices))])
        turns = np.tile(np.eye(3), (len(pattern.faces), 1, 1))
        places = np.zeros((len(pattern.faces), 3))
        for panels, before, edges, sides in self._levels:
            ends = flat[pattern.edges[edges]]
            turn = _turns(ends[:, 1] - ends[:, 0], sides * folds[edges])
            moved = ends[:, 0] - np.einsum("kij,kj->ki", turn, ends[:, 0])
            turns[panels] = turns[before] @ turn
            places[panels] = places[before] + np.einsum("kij,kj->ki", turns[before], moved)

        def carried(panels: Integers, vertices: Integers) -> Array:
            points = np.einsum("kij,k...j->k...i", turns[panels], flat[vertices])
            spread = (len(panels), *(1,) * (vertices.ndim - 1), 3)
            return np.asarray(points + places[panels].reshape(spread))

        panels, corners = np.nonzero(pattern.faces >= 0)
        vertices = pattern.faces[panels, corners]
        points = carried(panels, vertices)
        count = np.bincount(vertices, minlength=len(flat))
        sums = np.stack([np.bincount(vertices, each, len(flat)) for each in points.T], axis=-1)
        found = np.where(count[:, None] > 0, sums / np.maximum(count, 1)[:, None], flat)
        creases = pattern.crease
        first, second = (
            carried(panels, pattern.edges[creases]) for panels in pattern.edge_faces[creases].T
        )
        return found, float(lengths(first - second).max(initial=0.0))

    @cached_property
    def _levels(self) -> list[_Hinged]:
        """Panels by how many creases they are from the middle one of their piece."""
        from scipy.sparse import coo_array
        from scipy.sparse.csgraph import connected_components, dijkstra

        pattern, count = self.pattern, len(self.pattern.faces)
        creases = np.flatnonzero(pattern.crease)
        pairs = pattern.edge_faces[creases]
        graph = coo_array((np.ones(len(pairs)), pairs.T), shape=(count, count)).tocsr()
        pieces = connected_components(graph, directed=False)[1]
        first = _middle_panels(pattern, pieces.astype(np.int64))
        depths, before, _ = dijkstra(
            graph,
            directed=False,
            indices=first,
            unweighted=True,
            return_predecessors=True,
            min_only=True,
        )
        keys = np.sort(pairs, axis=1) @ [count, 1]
        order = np.argsort(keys, kind="stable")
        levels = []
        for depth in range(1, int(depths.max(initial=0)) + 1):
            panels = np.flatnonzero(depths == depth)
            above = before[panels].astype(np.int64)
            wanted = np.sort(np.stack([panels, above], axis=1), axis=1) @ [count, 1]
            edges = creases[order[np.searchsorted(keys, wanted, sorter=order)]]
            sides = np.where(pattern.edge_faces[edges, 0] == panels, 1.0, -1.0)
            levels.append(_Hinged(panels, above, edges, sides))
        return levels


def _middle_panels(pattern: CreasePattern, pieces: Integers) -> Integers:
    """Of every piece the panel whose corners' mean is nearest to the mean of the piece."""
    there = pattern.faces >= 0
    corners = np.where(there[..., None], pattern.vertices[pattern.faces], 0.0)
    centres = corners.sum(axis=1) / there.sum(axis=1)[:, None]
    count = np.bincount(pieces)
    means = np.stack([np.bincount(pieces, each) / count for each in centres.T], axis=-1)
    order = np.lexsort((np.linalg.norm(centres - means[pieces], axis=1), pieces))
    return np.asarray(order[np.cumsum(count) - count])


def _turns(axes: Array, angles: Array) -> Array:
    """Rotations (K, 3, 3) about axes (K, 3) by angles (K,) (radians)."""
    x, y, z = units(axes).T
    zero = np.zeros_like(x)
    cross = np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]).transpose(2, 0, 1)
    sine, versine = np.sin(angles)[:, None, None], 2 * np.sin(angles / 2)[:, None, None] ** 2
    return np.asarray(np.eye(3) + sine * cross + versine * (cross @ cross))
