"""Pairs of convex panels in space: separating axes, their gaps, distances, nearest points.

Corners are arrays (3, 4, P): coordinates first and pairs last, so that every operation runs over
all pairs at once.
"""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array, Booleans, Integers

Views = list[tuple[Array, Array]]
"""How far along a direction the corners (4, P) of both panels are, for every state."""

PARALLEL = 1e-14
"""Edges whose directions differ by less (squared sine) are taken as parallel."""


def corners_of(points: Array, faces: Integers) -> Array:
    """Corners (3, 4, P) of faces (P, 4), from vertices (V, 3)."""
    return np.ascontiguousarray(points.T)[:, faces.T]


def normals(corners: Array) -> Array:
    """Unit normals (3, P): across both diagonals."""
    normal = cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    length = np.sqrt(_dot(normal, normal))
    return np.asarray(normal / np.where(length > 0, length, 1.0))


def views_along(direction: Array, states: list[tuple[Array, Array]]) -> Views:
    """Coordinates of both panels' corners in every state along directions (3, P) or (3, X, P)."""
    if direction.ndim == 3:
        states = [(first[:, :, None], second[:, :, None]) for first, second in states]
    return [(_seen(direction, first), _seen(direction, second)) for first, second in states]


def common_gap(views: Views) -> Array:
    """Gap (P,) along the direction in all states, on the same side; negative if there is none."""
    above = [b.min(axis=0) - a.max(axis=0) for a, b in views]
    below = [a.min(axis=0) - b.max(axis=0) for a, b in views]
    return np.asarray(np.maximum(np.min(above, axis=0), np.min(below, axis=0)))


def turning_gap(first: Views, last: Views) -> Array:
    """Gap (P,) that stays along directions which turn evenly from one state to the other.

    Between two states with straight lines in between, the view of a vector v along a direction d
    is a parabola with the control values d0 v0, (d0 v1 + d1 v0)/2 and d1 v1: it is nowhere less
    than the least of the three. The directions (3, P), whose views of both states are given, are
    unit vectors, so that no direction in between is longer than that.
    """
    middle = [0.5 * (after + now) for after, now in zip(first[1], last[0], strict=True)]
    return common_gap([first[0], (middle[0], middle[1]), last[1]])


def nearest(first: Array, second: Array) -> tuple[Array, Array]:
    """Distance (P,) of the panels of every pair, and the vector (3, P) between nearest points.

    Both are zero where panels cross, touch or overlap. The nearest points of two convex
    polygons that are apart lie on two edges, or one is a corner.
    """
    square, between = _between_edges(first, second)
    for panel, other, sign in ((first, second, -1.0), (second, first, 1.0)):
        normal = normals(panel)
        height = _seen(normal, other - panel[:, :1])
        over = _inside(panel, normal, other)
        above = np.where(over, height**2, np.inf)
        corner = above.argmin(axis=0)[None]
        best = np.take_along_axis(above, corner, axis=0)[0]
        closer = best < square
        square = np.where(closer, best, square)
        at = np.take_along_axis(height, corner, axis=0)[0]
        between = np.where(closer, -sign * at * normal, between)
        following = _next(height)
        with np.errstate(divide="ignore", invalid="ignore"):
            share = np.where(height * following < 0, height / (height - following), np.nan)
        through = other + share * (_next(other) - other)
        pierced = _inside(panel, normal, through).any(axis=0)
        square = np.where(pierced, 0.0, square)
    between = np.where(square > 0, between, 0.0)
    return np.sqrt(square), between


def overlaps(first: Array, second: Array) -> Array:
    """How far (P,) the panels of every pair reach into each other: 0 where they only touch.

    That is the shortest way by which one of them is moved clear of the other. The vectors from
    points of the first to points of the second fill a convex polyhedron, and the way leads from
    the origin to the nearest of its faces, each of which is parallel to a panel or to an edge of
    both. Panels that lie on each other, or of which one stands on the other with an edge or a
    corner, do not reach into each other; panels that pass through each other do.
    """
    u, v = _next(first) - first, _next(second) - second
    across = cross(u[:, :, None], v[:, None]).reshape(3, 16, -1)
    directions = np.concatenate([normals(first)[:, None], normals(second)[:, None], across], axis=1)
    length = np.sqrt(_dot(directions, directions))
    found = length > 0
    directions = directions / np.where(found, length, 1.0)
    gap = common_gap(views_along(directions, [(first, second)]))
    return np.asarray(np.maximum(0.0, -np.where(found, gap, -np.inf).max(axis=0)))


def _between_edges(first: Array, second: Array) -> tuple[Array, Array]:
    """Smallest squared distance (P,) of two edges, and the vector (3, P) from first to second."""
    p, q = first[:, :, None], second[:, None]
    u = (_next(first) - first)[:, :, None]
    v = (_next(second) - second)[:, None]
    r = p - q
    uu, vv, uv = _dot(u, u), _dot(v, v), _dot(u, v)
    ur, vr = _dot(u, r), _dot(v, r)
    area = uu * vv - uv**2
    flat = area <= PARALLEL * uu * vv
    s = np.where(flat, 0.0, np.clip((uv * vr - ur * vv) / np.where(flat, 1.0, area), 0, 1))
    t = np.clip((uv * s + vr) / np.where(vv > 0, vv, 1.0), 0, 1)
    s = np.clip((uv * t - ur) / np.where(uu > 0, uu, 1.0), 0, 1)
    between = (t * v - s * u - r).reshape(3, 16, -1)
    square = _dot(between, between)
    which = square.argmin(axis=0)

    pair = np.arange(which.size)
    one, other = np.divmod(which, 4)
    between = _squared_with(
        between[:, which, pair],
        (u[:, one, 0, pair], s.reshape(16, -1)[which, pair]),
        (v[:, 0, other, pair], t.reshape(16, -1)[which, pair]),
    )
    return square[which, pair], between


def _squared_with(between: Array, *edges: tuple[Array, Array]) -> Array:
    """A vector (3, P) between two edges, at right angles to those that it ends within.

    Each edge (3, P) comes with the share (P,) of it at which the vector ends. As a difference of
    points the vector has their rounding, by which it is no longer a separating axis where an edge
    is that much longer than they are apart.
    """
    (u, s), (v, t) = edges
    within = [(share > 0) & (share < 1) for share in (s, t)]
    normal = cross(u, v)
    slanted = _dot(normal, normal) > PARALLEL * _dot(u, u) * _dot(v, v)
    both = within[0] & within[1] & slanted
    for edge, inside in ((u, within[0] & ~both), (v, within[1] & ~within[0])):
        length = np.where(inside, _dot(edge, edge), 1.0)
        between = between - np.where(inside, _dot(between, edge) / length, 0.0) * edge
    length = np.where(both, _dot(normal, normal), 1.0)
    return np.asarray(np.where(both, _dot(between, normal) / length * normal, between))


def _inside(panel: Array, normal: Array, points: Array) -> Booleans:
    """Whether points (3, K, P) lie over the panel, seen along its normal."""
    inward = cross(normal[:, None], _next(panel) - panel)
    level = _dot(inward, panel)
    within = _dot(inward[:, :, None], points[:, None]) >= level[:, None]
    return np.asarray(within.all(axis=0))


def _seen(direction: Array, corners: Array) -> Array:
    """Coordinates (K, P) of points (3, K, P) along directions (3, P)."""
    return _dot(direction[:, None], corners)


def _next(corners: Array) -> Array:
    """Every corner's successor, of arrays (..., 4, P)."""
    return corners[..., [1, 2, 3, 0], :]


def _dot(u: Array, v: Array) -> Array:
    return np.asarray(u[0] * v[0] + u[1] * v[1] + u[2] * v[2])


def cross(u: Array, v: Array) -> Array:
    """Vector products (3, ...) of vectors (3, ...)."""
    (a, b, c), (d, e, f) = u, v
    return np.stack([b * f - c * e, c * d - a * f, a * e - b * d])
