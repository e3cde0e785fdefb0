"""Forces along the edges of panels, by what holds each panel in balance.

The forces K u with which the elements of a panel hold its nodes, less the loads on the panel, are
those of its neighbours and supports on it. With the panel's own axes at an edge - t along it,
counter-clockwise, n up from the flat sheet, and m = t x n out of the panel - a force q and a moment
c per length are

    N = q m,    V_in = q t,    V = q n,    M = - c t.

So N pulls where it is positive, and M where it is positive stretches the lower face. Seen from the
panel on the other side of a crease V_in and M are the same; N and V turn by the fold angle.

Between its ends an edge has the force of every node over the length that is nearer to this node
than to others; as far as the ends, that of the last node. What a corner has beyond this is a force
of its own there: of supports and ties, of the plate's twist, and of what is singular.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.elements import Elements
from orishell.structure.mesh.sheet import SheetMesh

STRETCHES = 4
"""Forces are averaged over so many equal stretches of an edge: finer ones would grow with finer
cells, as its ends are singular."""
NORMAL, IN_PLANE, ACROSS, ABOUT = range(4)
"""N, V_in, V and M among the forces per length."""


@record
class EdgeForces:
    """What holds every panel at its edges, in the order of ``Grid.faces_edges``."""

    # N, V_in, V (force per length) and M (force) on all stretches of edges (F, 4, S, 4), each edge
    # run through counter-clockwise
    per_length: Array
    # force and moment about its middle (F, 4, 6) of every edge, along x, y and z
    resultants: Array
    corners: Array  # force and moment (F, 4, 6) at the corner that every edge begins at
    # what is missing for the balance of a panel, of forces and of moments over its diagonal the
    # larger, of all panels (N)
    missing: float


def find_edge_forces(
    mesh: SheetMesh,
    elements: Elements,
    moved: Array,
    panel_loads: Array,
    supported: Integers | None = None,
) -> EdgeForces:
    """What holds every panel at its edges.

    elements: The triangles of the mesh as elements.
    moved: Displacements and rotations (D,).
    panel_loads: Loads on panels (F (cells+1)^2, 3) by their own nodes (N).
    supported: Nodes that are held: supports hold panels at those within them, too.
    """
    return edge_forces(mesh, elements.forces(moved), panel_loads, supported)


def edge_forces(
    mesh: SheetMesh, forces: Array, panel_loads: Array, supported: Integers | None = None
) -> EdgeForces:
    """The same by forces (T, 18) with which triangles hold their nodes, where these are."""
    held = np.zeros((mesh.nodes.size, 6))
    np.add.at(held, mesh.places, forces.reshape(-1, 3, 6))
    held[:, :3] -= panel_loads
    round_, points = (
        _sides(each.reshape(*mesh.nodes.shape, -1))
        for each in (held, mesh.facets.points[mesh.nodes])
    )
    steps = np.linalg.norm(np.diff(points, axis=2), axis=-1)
    inner, reach = _per_length(round_, steps)

    ends = 0.5 * steps[..., [0, -1], None] * inner[:, :, [0, -1]]
    spread = round_.copy()
    spread[:, :, [0, -1]] = ends
    middle = 0.5 * (points[:, :, :1] + points[:, :, -1:])
    resultants = _about(spread, points - middle)
    corners = round_[:, :, 0] - ends[:, :, 0] - np.roll(ends[:, :, 1], 1, axis=1)

    along = points[:, :, -1] - points[:, :, 0]
    along /= np.linalg.norm(along, axis=-1, keepdims=True)
    normal = np.cross(along, np.roll(along, -1, axis=1)).sum(axis=1, keepdims=True)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    out = np.cross(along, normal)
    force, moment = inner[..., :3], inner[..., 3:]
    parts = [
        np.einsum("fsnx,fsx->fsn", each, axis)
        for each, axis in ((force, out), (force, along), (force, normal + 0 * out))
    ]
    parts.append(-np.einsum("fsnx,fsx->fsn", moment, along))
    per_length = _by_stretch(reach) @ np.stack(parts, axis=-1)

    origin = points[:, :1, 0]
    loaded = np.concatenate([panel_loads, 0 * panel_loads], axis=1)
    loaded = loaded.reshape(len(mesh.nodes), -1, 6)
    own = mesh.facets.points[mesh.nodes].reshape(*loaded.shape[:2], 3)
    within = np.zeros((*mesh.nodes.shape, 1), dtype=bool)
    if supported is not None:
        within[:, 1:-1, 1:-1, 0] = np.isin(mesh.nodes[:, 1:-1, 1:-1], supported)
    by_supports = np.where(within, held.reshape(*mesh.nodes.shape, 6), 0.0)
    total = (
        _about(loaded + by_supports.reshape(loaded.shape), own - origin)
        + _about(corners, points[:, :, 0] - origin)
        + _about(resultants, middle[:, :, 0] - origin)
    )
    size = np.linalg.norm(np.ptp(own, axis=1), axis=1)
    force, moment = (np.linalg.norm(each, axis=1) for each in (total[:, :3], total[:, 3:]))
    missing = float(max(force.max(), (moment / size).max()))
    return EdgeForces(per_length, resultants, corners, missing)


def _sides(values: Array) -> Array:
    """Values (F, n+1, n+1, k) of nodes as those of edges (F, 4, n+1, k), counter-clockwise."""
    return np.stack(
        [values[:, :, 0], values[:, -1], values[:, ::-1, -1], values[:, 0, ::-1]], axis=1
    )


def _per_length(forces: Array, steps: Array) -> tuple[Array, Array]:
    """Forces per length (F, 4, n-1, 6) of nodes between the ends, and where these begin and end.

    That is (F, 4, n), from 0 to 1 along the edge. A single cell has no node between the ends: then
    it is half of what is at the ends, the other half being the next edges'.
    """
    length = steps.sum(axis=-1, keepdims=True)
    start, end = 0 * length, 0 * length + 1
    if steps.shape[-1] == 1:
        mean = 0.5 * forces.sum(axis=2, keepdims=True) / length[..., None]
        return mean, np.concatenate([start, end], axis=-1)
    nearer = 0.5 * (steps[..., 1:] + steps[..., :-1])
    place = np.cumsum(steps, axis=-1)
    between = (place - 0.5 * steps)[..., 1:-1] / length
    begins = np.concatenate([start, between, end], axis=-1)
    return forces[:, :, 1:-1] / nearer[..., None], begins


def _by_stretch(begins: Array) -> Array:
    """Shares (F, 4, S, n-1) of stretches that nodes have, reaching from (F, 4, n) to the next."""
    start = np.arange(STRETCHES)[:, None] / STRETCHES
    low = np.maximum(begins[..., None, :-1], start)
    high = np.minimum(begins[..., None, 1:], start + 1 / STRETCHES)
    return np.asarray(STRETCHES * np.maximum(high - low, 0.0))


def _about(forces: Array, arms: Array) -> Array:
    """Sums (..., 6) of forces and moments (..., n, 6) at arms (..., n, 3)."""
    turning = forces[..., 3:] + np.cross(arms, forces[..., :3])
    return np.asarray(np.concatenate([forces[..., :3], turning], axis=-1).sum(axis=-2))


def crease_sides(grid: Grid) -> tuple[Integers, Integers]:
    """Edges (C,) that are creases, and the panels beside them and which of their edges (C, 2, 2).

    Of a row crease the upper panel is first, of a column crease the left one.
    """
    edges = grid.faces_edges()
    # Bottom and right edges are the first panel's, left and top edges the second's.
    order = [1, 2, 0, 3]
    edge, panel = edges[:, order].T.ravel(), np.tile(np.arange(len(edges)), len(order))
    place = np.stack([panel, np.repeat(order, len(edges))], axis=-1)
    ascending = np.argsort(edge, kind="stable")
    edge, place = edge[ascending], place[ascending]
    pair = np.flatnonzero(edge[1:] == edge[:-1])
    return edge[pair], np.stack([place[pair], place[pair + 1]], axis=1)


def on_creases(values: Array, grid: Grid) -> Array:
    """Values (F, 4, S, k) of edges as those of both sides (C, 2, S, k) of creases, run alike."""
    _, sides = crease_sides(grid)
    found = values[sides[..., 0], sides[..., 1]]
    found[:, 1] = found[:, 1, ::-1]
    return np.asarray(found)
