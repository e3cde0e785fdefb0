"""Forces along the edges of what stiffens a sheet, by what holds each of its panels in balance.

The forces K u with which the elements of a plate hold its nodes, less its own weight, are those of
what it is hinged on. Axes at an edge, and N, V_in and V per length, are those of panels
(:mod:`~orishell.structure.mesh.edge_forces`); there is no M, as rotations are the plate's own.

Between its ends an edge has the force of every node over the length that is nearer to this node
than to others. At a corner only the sum for both of its edges is known: each of them is taken to
bear all of it, which is on the safe side.
"""

from __future__ import annotations

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans
from orishell.structure.mesh.edge_forces import by_stretch, edge_axes
from orishell.structure.mesh.sheet import CORNERS, SheetMesh

T = TypeVar("T", bound=np.generic)


@record
class PlateEdges:
    """What holds panels of a strip, or plates, at their edges, in the order of panels' edges."""

    # N, V_in, V and M (force per length; M is 0) on all stretches of edges (F, 4, S, 4), each edge
    # run through counter-clockwise
    per_length: Array
    lengths: Array  # of edges (F, 4)
    # what is missing for the balance of a plate with its weight and all that is at its edges, of
    # forces and of moments over its diagonal the larger, of all plates (N)
    missing: float


def find_plate_edges(
    own: SheetMesh, places: Array, forces: Array, weights: Array, shared: Booleans
) -> PlateEdges:
    """What holds every plate at its edges.

    own: The mesh of the plates alone.
    shared: Which of its nodes (M',) others have as well, within plates where these hang on them.
    places: Where its nodes are (M', 3), as they are moved if displacements are large.
    forces: With which triangles hold their nodes (T', 18).
    weights: Loads of plates (places, 3) by their own nodes (N).
    """
    held = np.zeros((own.nodes.size, 6))
    np.add.at(held, own.places, forces.reshape(-1, 3, 6))
    held[:, :3] -= weights
    count = len(own.nodes)
    both = np.concatenate([held, places[own.nodes.ravel()]], axis=1)
    sides = _sides(both.reshape(*own.nodes.shape, -1))
    corners = places[own.nodes[:, *CORNERS]]
    lengths = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=-1)
    axes = edge_axes(corners)
    per_length = np.stack(
        [_per_length(each[..., :3], each[..., 6:], axes[:, k]) for k, each in enumerate(sides)],
        axis=1,
    )
    weight = np.concatenate([weights, np.zeros_like(weights)], axis=1).reshape(count, -1, 6)
    held_there = _at_edges(own.nodes.shape) | shared[own.nodes].reshape(count, -1)
    middle = corners.mean(axis=1, keepdims=True)
    at = places[own.nodes.reshape(count, -1)] - middle
    acting = weight + np.where(held_there[..., None], held.reshape(count, -1, 6), 0.0)
    force = acting[..., :3].sum(axis=1)
    moment = (acting[..., 3:] + np.cross(at, acting[..., :3])).sum(axis=1)
    size = np.linalg.norm(np.ptp(at, axis=1), axis=-1)
    whole, turning = np.linalg.norm(force, axis=-1), np.linalg.norm(moment, axis=-1)
    return PlateEdges(per_length, lengths, float(max(whole.max(), (turning / size).max())))


def at_edges(own: SheetMesh, fixed: tuple[int, ...]) -> Array:
    """Shares (F, (m+1) (n+1)) of something that lies evenly along some edges of every plate.

    fixed: Which edges.
    """
    places = np.arange(own.nodes.size).reshape(own.nodes.shape)
    found, points = np.zeros(own.nodes.size), own.facets.points[own.nodes.ravel()]
    for edge in fixed:
        side = _sides(places)[edge]
        half = 0.5 * np.linalg.norm(np.diff(points[side], axis=1), axis=-1)
        np.add.at(found, side[:, :-1], half)
        np.add.at(found, side[:, 1:], half)
    by_plate = found.reshape(len(own.nodes), -1)
    return np.asarray(by_plate / by_plate.sum(axis=1, keepdims=True))


def _sides(values: NDArray[T]) -> tuple[NDArray[T], ...]:
    """Values (F, m+1, n+1, ...) of nodes by edges, each (F, n+1, ...) or (F, m+1, ...)."""
    return values[:, :, 0], values[:, -1], values[:, ::-1, -1], values[:, 0, ::-1]


def _at_edges(shape: tuple[int, ...]) -> Booleans:
    """Which of the nodes of a plate ((m+1) (n+1),) are at its edges."""
    inside = np.zeros(shape[1:], dtype=bool)
    inside[1:-1, 1:-1] = True
    return ~inside.ravel()


def _per_length(forces: Array, points: Array, axes: Array) -> Array:
    """N, V_in, V and 0 (F, S, 4) on stretches of an edge, by forces (F, n+1, 3) at its nodes."""
    steps = np.linalg.norm(np.diff(points, axis=1), axis=-1)
    parts = np.einsum("fnx,fax->fna", forces, axes)
    parts = np.concatenate([parts, np.zeros_like(parts[..., :1])], axis=-1)
    return np.asarray(by_stretch(steps) @ parts)
