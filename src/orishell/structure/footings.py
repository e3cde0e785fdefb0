"""What a support holds beside vertices: edges of panels between them, or what is near to them."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import first_largest
from orishell.structure.mesh.sheet import SheetMesh

LEVEL = 1e-6
"""An edge is level if its ends differ in height by less than this share of the shell's height."""
AS_NEAR = 1e-9
"""Vertices are as near as the nearest if they are further away by less than this share of that."""


def edge_nodes(
    mesh: SheetMesh, grid: Grid, vertices: Integers, where: str, *, level: bool
) -> Integers:
    """Nodes along all edges both of whose ends are among vertices.

    where: The key that asks for them.
    level: Whether these edges have to be level.
    Raises InputError: If there are none, or one is not level.
    """
    along = np.asarray(np.isin(grid.edges_vertices(), vertices).all(axis=1))
    if not along.any():
        raise InputError(
            "no edge of a panel joins two of these vertices",
            where=where,
            expected="vertices that follow each other along a row or a column",
            remedy="name more vertices, or give patch instead: a length around each of them",
        )
    edges, seats = grid.faces_edges(), mesh.seats
    held = along[edges]  # (F, 4), in the same order as sides
    ends = np.stack([each[:, [0, -1]] for each in _sides(seats)], axis=1)
    steps = np.where(held, np.abs(np.diff(mesh.facets.points[ends, 2]))[..., 0], 0.0)
    if level and steps.max() > LEVEL * np.ptp(mesh.facets.points[:, 2]):
        panel, side = np.unravel_index(first_largest(steps), steps.shape)
        row = int(grid.edges_vertices()[edges[panel, side], 0]) // grid.columns
        raise InputError(
            f"the edge between feet at row {row} is not on the ground",
            where=where,
            got=f"an edge whose ends differ in height by {steps.max():.4g}",
            expected="feet that are at one height: the shell stands on its vertices only",
            remedy="give patch instead: a length around each foot",
        )
    sides = enumerate(_sides(mesh.nodes))
    return np.unique(np.concatenate([side[held[:, k]].ravel() for k, side in sides]))


def _sides(nodes: Integers) -> list[Integers]:
    """Nodes (F, cells+1) along the left, bottom, right and top of panels."""
    return [nodes[:, :, 0], nodes[:, -1], nodes[:, :, -1], nodes[:, 0]]


def patch_nodes(mesh: SheetMesh, vertices: Integers, radius: float) -> Integers:
    """Nodes of plates no further than a radius from one of the vertices."""
    points, nodes = mesh.facets.points, np.unique(mesh.seats)
    nodes = nodes[nodes < mesh.node_count]
    away = np.stack([np.linalg.norm(points[nodes] - each, axis=1) for each in points[vertices]])
    return np.asarray(nodes[(away <= radius * (1 + AS_NEAR)).any(axis=0)])


def to_nearest(points: Array, vertices: Integers, forces: Array) -> Array:
    """Forces (S, 3) at vertices (S,): those on nodes (N, 3), each with the nearest vertex.

    Where several are equally near each has its part.
    """
    bearing = np.flatnonzero(forces.any(axis=1))
    away = np.linalg.norm(points[bearing, None] - points[vertices], axis=2)
    near = away <= away.min(axis=1, keepdims=True) * (1 + AS_NEAR)
    return np.asarray((near / near.sum(axis=1, keepdims=True)).T @ forces[bearing])
