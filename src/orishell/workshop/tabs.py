"""Tabs along creases that are cut: where they lie in the flat sheet, and how wide they are.

A tab is a trapezium on the far side of the crease, under the neighbouring panel, in the region of
that panel nearer to this crease than to its other sides. So tabs never overlap each other, nor
the panels of their own part.
"""

from __future__ import annotations

import numpy as np

from orishell.document import Part
from orishell.motion.mesh import QuadMesh
from orishell.motion.quads import signed_areas
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.workshop.settings import Workshop

AUTO_SHARE = 0.25
"""Width of joints that follow the panels, as a share of the median height of panels."""
SLANT = np.pi / 4
"""The ends of tabs rise from the crease at this angle, or half the sector angle if it is less."""
TOP_SHARE = 1 / 3
"""The far side of a tab is at least this share of its root."""
REACH = 0.9
"""Largest width of a tab, relative to that at which it is midway to the opposite side."""


def choose_joint_width(document: Part, workshop: Workshop) -> float:
    """The width that tabs have where panels leave room for it.

    "auto" is a quarter of the median height of panels, measured from their creases.
    """
    if workshop.joint_width != "auto":
        return workshop.joint_width
    mesh = document.mesh
    length = document.edge_lengths()[mesh.crease]
    heights = document.areas()[mesh.edge_faces[mesh.crease]] / length[:, None]
    return AUTO_SHARE * float(np.median(heights)) if len(heights) else 0.0


def tab_shapes(document: Part, width: float) -> Array:
    """Corners (E, 2, 4, 2) of tabs of a width, or less where a panel has no room for it.

    For every edge, in the panel to its left and to its right as ``edge_faces`` lists them, the two
    ends of the crease, then the far side, in the order of the panel counter-clockwise. NaN at edges
    that are no creases.
    """
    flat, mesh = document.require_flat(), document.mesh
    shapes = np.full((len(mesh.edges), 2, 4, 2), np.nan)
    edges = np.flatnonzero(mesh.crease)
    corners = flat[_panels_from(mesh, edges)]
    # Counter-clockwise, the edge still first.
    clockwise = signed_areas(corners) < 0
    corners = np.where(clockwise[..., None, None], corners[..., [1, 0, 3, 2], :], corners)
    height = np.minimum(width, _room(corners))
    tabs = _tabs_of_height(corners, height)
    for _ in range(12):
        outside = _outside(tabs, corners)
        if not outside.any():
            break
        height = np.where(outside, height / 2, height)
        tabs = _tabs_of_height(corners, height)
    shapes[edges] = tabs
    return shapes


def find_owners(document: Part) -> tuple[Integers, Integers]:
    """For every edge, the panel (E,) whose part has the tab and the panel (E,) it is glued to.

    -1 at edges that are no creases.
    """
    mesh = document.mesh
    low, high = np.sort(mesh.edge_faces, axis=1).T
    return np.where(mesh.crease, low, -1), np.where(mesh.crease, high, -1)


def _panels_from(mesh: QuadMesh, edges: Integers) -> Integers:
    """Corners (E, 2, 4) of the panels beside edges (E,), the ends of the edge first.

    Where an edge is only a part of a side its ends take the place of that side's.
    """
    panels = mesh.edge_faces[edges]
    place = np.argmax(mesh.loops_edges()[panels] == edges[:, None, None], axis=-1)
    corner = (mesh.loops[..., None] == mesh.faces[:, None]).any(axis=-1)
    side = (np.cumsum(corner, axis=1) - 1)[panels, place]
    turned = (side[..., None] + np.arange(4)) % 4
    faces = np.take_along_axis(mesh.faces[panels], turned, axis=-1)
    ends = mesh.edges[edges]
    faces[:, 0, :2], faces[:, 1, :2] = ends, ends[:, ::-1]
    return faces


def _slopes(corners: Array) -> tuple[Array, Array, Array]:
    """How both ends of a tab on the first side (..., 2) go, and how much shorter it gets (...).

    All per height.
    """
    run = corners[..., 1, :] - corners[..., 0, :]
    length = np.linalg.norm(run, axis=-1, keepdims=True)
    along = run / length
    square = np.stack([-along[..., 1], along[..., 0]], axis=-1)

    def lean(corner: int, before: int, after: int) -> Array:
        p = corners[..., after, :] - corners[..., corner, :]
        q = corners[..., before, :] - corners[..., corner, :]
        sector = np.arctan2(_cross(p, q), (p * q).sum(axis=-1)) % (2 * np.pi)
        return np.asarray(1 / np.tan(np.minimum(SLANT, sector / 2)))

    lean_a, lean_b = lean(0, 3, 1)[..., None], lean(1, 0, 2)[..., None]
    closer = (lean_a + lean_b)[..., 0]
    return square + lean_a * along, square - lean_b * along, closer


def _tabs_of_height(corners: Array, height: Array) -> Array:
    way_a, way_b, _ = _slopes(corners)
    a, b, h = corners[..., 0, :], corners[..., 1, :], height[..., None]
    return np.stack([a, b, b + h * way_b, a + h * way_a], axis=-2)


def _room(corners: Array) -> Array:
    """Largest height (...) of a tab: its far side stays long enough, and off the opposite side."""
    *ways, closer = _slopes(corners)
    length = np.linalg.norm(corners[..., 1, :] - corners[..., 0, :], axis=-1)
    room = (1 - TOP_SHARE) * length / closer
    across = corners[..., 3, :] - corners[..., 2, :]
    inward = np.stack([-across[..., 1], across[..., 0]], axis=-1)
    inward /= np.linalg.norm(across, axis=-1, keepdims=True)
    for end, way in enumerate(ways):
        distance = ((corners[..., end, :] - corners[..., 2, :]) * inward).sum(axis=-1)
        closing = 1 - (way * inward).sum(axis=-1)
        limit = np.where(closing > 0, distance / np.where(closing > 0, closing, 1), np.inf)
        room = np.minimum(room, REACH * np.where(limit > 0, limit, np.inf))
    return np.asarray(room)


def _cross(p: Array, q: Array) -> Array:
    return np.asarray(p[..., 0] * q[..., 1] - p[..., 1] * q[..., 0])


def _outside(tabs: Array, corners: Array) -> Booleans:
    """Which tabs (...) leave their panel: only possible where a corner points inwards."""
    import shapely

    shapes, panels = shapely.polygons(tabs), shapely.polygons(corners)
    over = shapely.area(shapely.difference(shapes, panels))
    return np.asarray(over > 1e-9 * shapely.area(shapes))
