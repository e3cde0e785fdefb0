"""Folded states in space: panel is hinged to panel, from one that stays where it is."""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

import numpy as np

from orishell.conventions.record import record
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.quads import lengths, units
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.components import find_components
from orishell.numerics.equals import classes


class _Hinged(NamedTuple):
    """Panels (K,) hinged to panels that are placed before them."""

    panels: Integers
    before: Integers
    edges: Integers  # the creases (K,) between them
    sides: Array  # 1 where the panel is to the left of its crease, -1 where to the right


class Poses(NamedTuple):
    """How panels are placed in space, from where they lie in the flat sheet."""

    turns: Array  # rotations (F, 3, 3)
    places: Array  # of the flat sheet's origin (F, 3)

    def carried(self, panels: Integers, points: Array) -> Array:
        """Points (N, ..., 3) of the flat sheet as panels (N,) hold them."""
        places = self.places[panels]
        spread = places.reshape(len(panels), *(1,) * (points.ndim - 2), 3)
        return np.asarray(np.einsum("kij,k...j->k...i", self.turns[panels], points) + spread)


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
        pattern, flat = self.pattern, self.flat
        poses = self.poses(folds)
        panels, corners = np.nonzero(pattern.faces >= 0)
        vertices = pattern.faces[panels, corners]
        points = poses.carried(panels, flat[vertices])
        count = np.bincount(vertices, minlength=len(flat))
        sums = np.stack([np.bincount(vertices, each, len(flat)) for each in points.T], axis=-1)
        found = np.where(count[:, None] > 0, sums / np.maximum(count, 1)[:, None], flat)
        creases = pattern.crease
        ends = flat[pattern.edges[creases]]
        first, second = (poses.carried(each, ends) for each in pattern.edge_faces[creases].T)
        return found, float(lengths(first - second).max(initial=0.0))

    def poses(self, folds: Array) -> Poses:
        """How every panel is placed in that state.

        Parameters
        ----------
        folds
            Fold angles (E,) of all edges, valley positive (radians).
        """
        count = len(self.pattern.faces)
        poses = Poses(np.tile(np.eye(3), (count, 1, 1)), np.zeros((count, 3)))
        for panels, before, edges, sides in self._levels:
            self._hang(poses, panels, before, edges, sides * folds[edges])
        return poses

    def beside(self, poses: Poses, edge: int, fold: float) -> Poses:
        """Poses with the panel to the right of a crease turned about it to a fold angle (radians).

        All other panels stay where they are.
        """
        left, right = self.pattern.edge_faces[edge : edge + 1].T
        found = Poses(poses.turns.copy(), poses.places.copy())
        self._hang(found, right, left, np.array([edge]), np.array([-fold]))
        return found

    def _hang(
        self, poses: Poses, panels: Integers, before: Integers, edges: Integers, angles: Array
    ) -> None:
        """Place panels (K,) beside others, turned about creases by angles (K,) (radians)."""
        ends = self.flat[self.pattern.edges[edges]]
        turn = _turns(ends[:, 1] - ends[:, 0], angles)
        moved = ends[:, 0] - np.einsum("kij,kj->ki", turn, ends[:, 0])
        poses.turns[panels] = poses.turns[before] @ turn
        poses.places[panels] = poses.carried(before, moved)

    @cached_property
    def flat(self) -> Array:
        """Vertices (V, 3) of the flat sheet."""
        vertices = self.pattern.vertices
        return np.column_stack([vertices, np.zeros(len(vertices))])

    @cached_property
    def _levels(self) -> list[_Hinged]:
        """Panels by how many creases they are from the middle one of their piece."""
        from scipy.sparse import coo_array
        from scipy.sparse.csgraph import dijkstra

        pattern, count = self.pattern, len(self.pattern.faces)
        creases = np.flatnonzero(pattern.crease)
        pairs = pattern.edge_faces[creases]
        ends = pairs.T.astype(np.int32)  # SciPy before 1.14 finds no ways by longer numbers
        graph = coo_array((np.ones(len(pairs)), ends), shape=(count, count)).tocsr()
        first = _middle_panels(pattern, find_components(pairs, count))
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
    order = np.lexsort((classes(np.linalg.norm(centres - means[pieces], axis=1)), pieces))
    return np.asarray(order[np.cumsum(count) - count])


def _turns(axes: Array, angles: Array) -> Array:
    """Rotations (K, 3, 3) about axes (K, 3) by angles (K,) (radians)."""
    x, y, z = units(axes).T
    zero = np.zeros_like(x)
    cross = np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]).transpose(2, 0, 1)
    sine, versine = np.sin(angles)[:, None, None], 2 * np.sin(angles / 2)[:, None, None] ** 2
    return np.asarray(np.eye(3) + sine * cross + versine * (cross @ cross))
