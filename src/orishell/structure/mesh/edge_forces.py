"""Forces along the edges of panels, by what holds each panel in balance.

The forces K u with which the elements of a panel hold its nodes, less the loads on the panel, are
those of its neighbours and supports on it. With the panel's own axes at an edge - t along it,
counter-clockwise, n up from the flat sheet, and m = t x n out of the panel - a force q and a moment
c per length are

    N = q m,    V_in = q t,    V = q n,    M = - c t.

So N pulls where it is positive, and M where it is positive stretches the lower face. Seen from the
panel on the other side of a crease V_in and M are the same; N and V turn by the fold angle.

Between its ends an edge has the force of every node over the length that is nearer to this node
than to others. At a vertex only the sum for each panel is known, F_k less its part of what acts on
the vertex from outside: supports, ties, point loads, in equal parts on all panels there. With c_k
what panel k + 1, counter-clockwise, does to panel k across the crease between them,

    F_k = c_k - c_k-1,

of which the smallest c are taken: about an inner vertex a force that is the same in all four could
be added. What creases pass on at a vertex belongs to their ends, and they do so by hinges only: M
is that of their springs.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.sheet import CORNERS, Offsets, SheetMesh, crease_places

STRETCHES = 4
"""Forces are averaged over so many equal stretches of an edge: finer ones would grow with finer
cells, as its ends are singular."""
NORMAL, IN_PLANE, ACROSS, ABOUT = range(4)
"""N, V_in, V and M among the forces per length."""


@record
class OnPanels:
    """What acts on panels otherwise than at their edges, and where they are."""

    points: Array  # corners (F, 4, 3) of panels, counter-clockwise, as they are moved (length)
    loads: Array  # force and moment (F, 6) of the loads on each, about the mean of its corners
    within: Array  # the same of supports between its edges
    at_corners: Array  # that part of the loads that acts at corners (F, 4, 3) (N)

    @property
    def middles(self) -> Array:
        """Means (F, 3) of the corners of panels."""
        return np.asarray(self.points.mean(axis=1))

    @property
    def between(self) -> Array:
        """Middles (F, 4, 3) of edges, each of which begins at a corner."""
        return np.asarray(0.5 * (self.points + np.roll(self.points, -1, axis=1)))


@record
class EdgeForces:
    """What holds every panel at its edges, in the order of ``Grid.faces_edges``."""

    # N, V_in, V (force per length) and M (force) on all stretches of edges (F, 4, S, 4), each edge
    # run through counter-clockwise
    per_length: Array
    # force and moment about its middle (F, 4, 6) of every edge, along x, y and z
    resultants: Array
    # force and moment (F, 4, 6) from outside at the corner that every edge begins at
    corners: Array
    # what is missing for the balance of a panel, of forces and of moments over its diagonal the
    # larger, of all panels (N)
    missing: float
    on_panels: OnPanels  # what else acts on panels
    # what hinges beside creases do to the first and the second board (C, 2, cells+1, 6) at nodes
    # along them, moments about their axes, 0 beyond their ends; None if hinges are in creases
    hinged: Array | None = None
    factor: float = 1.0  # of the loads that all this is in balance with


def find_edge_forces(
    mesh: SheetMesh,
    grid: Grid,
    forces: Array,
    turning: Array | None,
    panel_loads: Array,
    *,
    supported: Integers | None = None,
) -> EdgeForces:
    """What holds every panel at its edges.

    mesh: The mesh, its nodes where they are moved to if displacements are large.
    grid: The grid of the sheet.
    forces: With which triangles hold their nodes (T, 18).
    turning: With which springs of creases hold both panels (C (cells+1), 6), in the order of
    :func:`~orishell.structure.mesh.hinges.hinge_elements`; None if creases turn freely.
    panel_loads: Loads on panels (F (cells+1)^2, 3) by their own nodes (N).
    supported: Nodes that are restrained: supports hold panels at those within them, too.
    """
    held = np.zeros((mesh.nodes.size, 6))
    np.add.at(held, mesh.places, forces.reshape(-1, 3, 6))
    held[:, 3:] -= np.cross(mesh.arms_at_places(), held[:, :3])
    held[:, :3] -= panel_loads
    own = mesh.facets.points[mesh.seats]
    hinged = None if mesh.offsets is None else _at_hinges(mesh.offsets, grid, held, own)
    spread, points = (_sides(each.reshape(*mesh.nodes.shape, -1)) for each in (held, own))
    axes = edge_axes(points[:, :, 0])
    along = axes[:, :, 1]
    about = np.zeros(spread.shape[:3])
    if hinged is not None:
        about = _hinged(grid, -hinged[:, 0, :, 3:], along)
    elif turning is not None:
        about = _hinged(grid, turning[:, :3], along)
    at_corners = spread[:, :, 0].copy()
    begin = end = np.zeros((len(own), 4, 3))
    if mesh.offsets is None:  # else no crease joins corners
        begin, end = _at_vertices(grid, at_corners[..., :3])
    spread[:, :, 0, :3], spread[:, :, -1, :3] = begin, end
    spread[:, :, [0, -1], 3:] = (-about[..., None] * along[:, :, None])[:, :, [0, -1]]
    corners = at_corners - spread[:, :, 0] - np.roll(spread[:, :, -1], 1, axis=1)
    middle = 0.5 * (points[:, :, :1] + points[:, :, -1:])
    resultants = _about(spread, points - middle)

    force = np.einsum("fsnx,fsax->fsna", spread[..., :3], axes)
    parts = np.concatenate([force, about[..., None]], axis=-1)
    per_length = by_stretch(np.linalg.norm(np.diff(points, axis=2), axis=-1)) @ parts

    on_panels = _on_panels(mesh, held, panel_loads, own, supported)
    origin = on_panels.middles[:, None]
    total = (
        on_panels.loads
        + on_panels.within
        + _about(corners, points[:, :, 0] - origin)
        + _about(resultants, middle[:, :, 0] - origin)
    )
    size = np.linalg.norm(np.ptp(own.reshape(len(own), -1, 3), axis=1), axis=1)
    whole, turning = (np.linalg.norm(each, axis=1) for each in (total[:, :3], total[:, 3:]))
    missing = float(max(whole.max(), (turning / size).max()))
    return EdgeForces(per_length, resultants, corners, missing, on_panels, hinged)


def _on_panels(
    mesh: SheetMesh, held: Array, panel_loads: Array, own: Array, supported: Integers | None
) -> OnPanels:
    """Loads and supports on panels.

    held: Forces and moments (places, 6) that hold plates at their points.
    own: These points (F, cells+1, cells+1, 3).
    """
    points = own[:, *CORNERS]
    loaded = np.concatenate([panel_loads, 0 * panel_loads], axis=1).reshape(*mesh.nodes.shape, 6)
    within = np.zeros((*mesh.nodes.shape, 1), dtype=bool)
    if supported is not None:
        within[:, 1:-1, 1:-1, 0] = np.isin(mesh.nodes[:, 1:-1, 1:-1], supported)
    by_supports = np.where(within, held.reshape(loaded.shape), 0.0)
    arms = own - points.mean(axis=1)[:, None, None]
    loads, within_them = (
        _about(each.reshape(len(own), -1, 6), arms.reshape(len(own), -1, 3))
        for each in (loaded, by_supports)
    )
    return OnPanels(points, loads, within_them, loaded[:, *CORNERS, :3])


def _at_hinges(hinges: Offsets, grid: Grid, held: Array, own: Array) -> Array:
    """What hinges beside creases do to boards (C, 2, cells+1, 6), moments about their axes.

    held: Forces and moments (places, 6) that hold plates at their points.
    own: These points (F, cells+1, cells+1, 3).
    """
    _, *sides = crease_places(grid, own.shape[1] - 1)
    places = np.stack(sides, axis=1)
    found = np.where(hinges.lengths[:, None, :, None] > 0, held[places], 0.0)
    away = own.reshape(-1, 3)[places] - hinges.axes[:, None]
    found[..., 3:] += np.cross(away, found[..., :3])
    return found


def _sides(values: Array) -> Array:
    """Values (F, n+1, n+1, k) of nodes as those of edges (F, 4, n+1, k), counter-clockwise."""
    return np.stack(
        [values[:, :, 0], values[:, -1], values[:, ::-1, -1], values[:, 0, ::-1]], axis=1
    )


def _hinged(grid: Grid, turning: Array, along: Array) -> Array:
    """Moments (F, 4, n+1) on the nodes of edges, by how they stretch the lower face.

    turning: Moments of springs on their first panels (C (n+1), 3), in any shape.
    along: Directions (F, 4, 3) of edges.
    """
    creases, sides = crease_sides(grid)
    # The first panel of a spring runs counter-clockwise along it: a bottom or a left edge.
    own = sides[np.arange(len(sides)), (sides[:, 0, 1] != 1).astype(np.int64)]
    first = turning.reshape(len(creases), -1, 3)
    by_edge = np.zeros((len(grid.edges_vertices()), first.shape[1]))
    by_edge[creases] = np.einsum("cnx,cx->cn", first, along[own[:, 0], own[:, 1]])
    found = by_edge[grid.faces_edges()]
    found[:, 2:] = found[:, 2:, ::-1]
    return np.asarray(found)


def _at_vertices(grid: Grid, forces: Array) -> tuple[Array, Array]:
    """What creases pass on at the begin and the end (F, 4, 3) of every edge of panels.

    forces: What holds each panel at its corners (F, 4, 3).
    """
    vertices, corner = grid.faces_vertices(), np.arange(4)
    # Corner k of a panel is at place k about its vertex, counter-clockwise.
    around = np.zeros((grid.vertex_count, 4, 3))
    there = np.zeros((grid.vertex_count, 4), dtype=bool)
    around[vertices, corner], there[vertices, corner] = forces, True
    outside = around.sum(axis=1, keepdims=True) / there.sum(axis=1)[:, None, None]
    creases = there & np.roll(there, -1, axis=1)
    balance = (np.eye(4) - np.roll(np.eye(4), 1, axis=0)) * creases[:, None]
    passed = np.asarray(
        np.linalg.pinv(balance) @ np.where(there[..., None], around - outside, 0.0), np.float64
    )
    begin = -passed[vertices, corner - 1]
    end = np.roll(passed[vertices, corner], -1, axis=1)
    return np.asarray(begin, np.float64), np.asarray(end, np.float64)


def edge_axes(corners: Array) -> Array:
    """Axes (F, 4, 3, 3) m, t and n of the edges of panels, each of which begins at a corner.

    corners: Of panels (F, 4, 3), counter-clockwise.
    """
    along = np.roll(corners, -1, axis=1) - corners
    along /= np.linalg.norm(along, axis=-1, keepdims=True)
    normal = np.cross(along, np.roll(along, -1, axis=1)).sum(axis=1, keepdims=True)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    return np.stack([np.cross(along, normal), along, normal + 0 * along], axis=2)


def by_stretch(steps: Array) -> Array:
    """What stretches have of nodes, per length (..., S, n+1), by steps (..., n) between these."""
    place = np.cumsum(np.concatenate([0 * steps[..., :1], steps], axis=-1), axis=-1)
    length = place[..., -1:]
    between = 0.5 * (place[..., 1:] + place[..., :-1])
    bounds = np.concatenate([0 * length, between, length], axis=-1)[..., None, :]
    start = (length * np.arange(STRETCHES) / STRETCHES)[..., None]
    stretch = length[..., None] / STRETCHES
    inside = np.minimum(bounds[..., 1:], start + stretch) - np.maximum(bounds[..., :-1], start)
    return np.asarray(np.maximum(inside, 0.0) / np.diff(bounds) / stretch)


def spread_over(values: Array, stretch: Array, thickness: float) -> Array:
    """Values (..., S, k) on stretches of edges, spread over a thickness at least.

    What acts on a shorter piece of an edge spreads over about as much of its panel.

    stretch: How long a stretch of every edge is (...) (length).
    """
    most = values.shape[-2]
    count = np.clip(np.ceil(thickness / stretch), 1, most)
    spread = values.copy()
    for many in range(2, most + 1):
        windows = np.lib.stride_tricks.sliding_window_view(values, many, axis=-2).mean(axis=-1)
        unmoved = [(0, 0)] * (values.ndim - 2)
        more = np.pad(windows, (*unmoved, (0, many - 1), (0, 0)))
        spread = np.where((count == many)[..., None, None], more, spread)
    share = np.minimum(1.0, count * stretch / thickness)
    return np.asarray(share[..., None, None] * spread)


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
