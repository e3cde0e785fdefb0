"""A rectangle in plan, and the part of a mesh over it."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.design.mesh_errors import place_in_words, refused_mesh
from orishell.design.mesh_facing import require_graph, vertex_normals
from orishell.design.open_mesh import SAME, OpenMesh, joined_vertices, open_piece
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import first_largest

SLIVER = 10.0
"""Triangles that are narrower than vertices are apart that are joined, times this, face nowhere."""


@record
class PlanRectangle:
    """A rectangle in plan, its own axes turned from x and y."""

    centre: tuple[float, float]  # of the rectangle in plan
    size: tuple[float, float]  # along its own axes (lengths)
    turn: float = 0.0  # from x to its own first axis (radians)

    def seen(self, points: Array) -> Array:
        """Coordinates (N, 2) of points (N, 3) from its centre along its own axes.

        Parameters
        ----------
        points
            (N, 3), in space; their heights do not matter.
        """
        c, s = np.cos(self.turn), np.sin(self.turn)
        return np.asarray((points[:, :2] - self.centre) @ np.array([[c, -s], [s, c]]))

    @property
    def corners(self) -> Array:
        """Its corners (4, 2) along its own axes: clockwise from the top left."""
        ends = np.array([[-1, 1], [1, 1], [1, -1], [-1, -1]])
        return np.asarray(0.5 * np.array(self.size) * ends)


def mesh_over(
    rectangle: PlanRectangle, vertices: Array, triangles: Integers
) -> tuple[OpenMesh, Array, Integers]:
    """The part of triangles (T, 3) of vertices (V, 3) over a rectangle, cut along its sides.

    With the unit normals of its vertices, those that the whole mesh has there, and with which four
    of its rim are its corners, from the top left on.

    Raises
    ------
    InputError
        If that is no open piece of surface that covers the rectangle once.
    """
    vertices, triangles = joined_vertices(vertices, triangles)
    near = _near(rectangle, vertices, triangles)
    _require_some(near, vertices)
    narrow = SAME * float(lengths(np.ptp(vertices, axis=0)))
    points = np.hstack([vertices, _upward_normals(vertices, triangles, near)])
    for axis in (0, 1):
        for sign in (1.0, -1.0):
            beyond = sign * rectangle.seen(points)[:, axis] - 0.5 * rectangle.size[axis]
            beyond[np.abs(beyond) <= narrow] = 0.0
            points, near = _cut(points, near, beyond)
    points, near = _used(points, near)
    _require_some(near, vertices)
    mesh = open_piece(points[:, :3], near)
    require_graph(mesh.vertices, mesh.triangles, SLIVER * narrow)
    rim = rectangle.seen(mesh.vertices[mesh.rim])
    half = 0.5 * np.array(rectangle.size)
    inside = (half - np.abs(rim)).min(axis=1)
    if inside.max() > SLIVER * narrow:
        at = mesh.vertices[mesh.rim[first_largest(inside)]]
        raise refused_mesh(
            "the mesh ends within the rectangle",
            f"its rim is {inside.max():.4g} from the nearest side near {place_in_words(at)}",
            "a mesh that covers the whole rectangle",
            "choose a smaller rectangle, or move its centre",
        )
    away = np.linalg.norm(rim[None] - rectangle.corners[:, None], axis=-1)
    normals = points[:, 3:] / lengths(points[:, 3:])[:, None]
    return mesh, normals, away.argmin(axis=1)


def _require_some(triangles: Integers, vertices: Array) -> None:
    if len(triangles):
        return
    low, high = (
        "({:.4g}, {:.4g})".format(*ends[:2]) for ends in (vertices.min(0), vertices.max(0))
    )
    raise refused_mesh(
        "no part of the mesh lies over the rectangle",
        f"a mesh from {low} to {high} in plan",
        "a rectangle within the mesh, in the unit of its coordinates",
        "move the rectangle, or check unit",
    )


def _near(rectangle: PlanRectangle, vertices: Array, triangles: Integers) -> Integers:
    """Triangles (N, 3) that may reach over the rectangle."""
    seen, half = rectangle.seen(vertices)[triangles], 0.5 * np.array(rectangle.size)
    apart = (seen.min(axis=1) > half) | (seen.max(axis=1) < -half)
    return np.asarray(triangles[~apart.any(axis=1)])


def _upward_normals(vertices: Array, triangles: Integers, near: Integers) -> Array:
    """Unit normals (V, 3), upwards, of the vertices of near triangles, by all that are there."""
    at = np.zeros(len(vertices), np.bool_)
    at[near] = True
    beside = triangles[at[triangles].any(axis=1)]
    p, q, r = np.moveaxis(vertices[beside], 1, 0)
    down = np.cross(q - p, r - p)[:, 2] < 0
    return vertex_normals(vertices, np.where(down[:, None], beside[:, ::-1], beside))


def _cut(points: Array, triangles: Integers, beyond: Array) -> tuple[Array, Integers]:
    """The part of triangles where a function of the vertices (V,) is not above 0.

    What points (V, K) say is interpolated where edges are cut.
    """
    sign = np.sign(beyond).astype(np.int64)[triangles]  # (T, 3)
    kept = triangles[(sign <= 0).all(axis=1) & (sign < 0).any(axis=1)]
    some = (sign > 0).any(axis=1) & (sign < 0).any(axis=1)
    triangles, sign = triangles[some], sign[some]
    # The first corner is the one that is alone on its side, or of three signs the one on 0.
    zero = (sign == 0).any(axis=1)
    wanted = np.where(zero, 0, -np.sign(sign.sum(axis=1)))
    first = (sign == wanted[:, None]).argmax(axis=1)
    order = (first[:, None] + np.arange(3)) % 3
    triangles = np.take_along_axis(triangles, order, axis=1)
    a, b, c = triangles.T
    s = np.take_along_axis(sign, order, axis=1)
    pairs = [np.stack([b, c], -1)[zero], np.stack([a, b], -1)[~zero], np.stack([a, c], -1)[~zero]]
    edges, inverse = np.unique(np.sort(np.concatenate(pairs), axis=1), axis=0, return_inverse=True)
    low, high = edges.T
    share = (beyond[low] / (beyond[low] - beyond[high]))[:, None]
    cuts = points[low] + share * (points[high] - points[low])
    number = len(points) + inverse.reshape(-1)
    opposite, beside, other = np.split(number, np.cumsum([len(each) for each in pairs[:2]]))
    inner = s[zero, 1] < 0  # whether b is inside, and c beyond
    a0, b0, c0 = (each[zero] for each in (a, b, c))
    halves = np.where(
        inner[:, None], np.stack([a0, b0, opposite], -1), np.stack([a0, opposite, c0], -1)
    )
    a1, b1, c1 = (each[~zero] for each in (a, b, c))
    tip = s[~zero, 0] < 0  # whether the corner that is alone is inside
    found = [
        kept,
        halves,
        np.stack([a1, beside, other], -1)[tip],
        np.stack([beside, b1, c1], -1)[~tip],
        np.stack([beside, c1, other], -1)[~tip],
    ]
    return np.concatenate([points, cuts]), np.concatenate(found)


def _used(points: Array, triangles: Integers) -> tuple[Array, Integers]:
    used, inverse = np.unique(triangles, return_inverse=True)
    return points[used], inverse.reshape(-1, 3).astype(np.int64)
