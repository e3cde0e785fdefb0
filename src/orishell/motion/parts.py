"""Panels of any number of corners as convex quadrilaterals, which contact and pictures work on."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion.crease_pattern import CreasePattern
from orishell.numerics.arrays import Array, Booleans, Integers

STRAIGHT = 1e-9
"""A corner is convex if the sine of its turn is more."""


@record
class Parts:
    """Quadrilaterals that make up panels; a triangle has a fourth corner in the middle of a side.

    These middles are further vertices, behind those of the pattern.
    """

    faces: Integers  # corners (P, 4), counter-clockwise in the flat sheet
    panels: Integers  # the panel (P,) that each is a part of
    middles: Integers  # vertices (T, 2) between which the further ones lie
    convex: Booleans  # which panels (F,) are convex, no vertex on a side

    def extended(self, points: Array) -> Array:
        """Vertices (..., V + T, k) of a state, the middles of sides behind those (..., V, k)."""
        return np.concatenate([points, points[..., self.middles, :].mean(axis=-2)], axis=-2)


def find_parts(pattern: CreasePattern) -> Parts:
    """Part the panels of a pattern: a fan from the first corner, or triangles if not convex."""
    faces, count = pattern.faces, (pattern.faces >= 0).sum(axis=1)
    convex = _are_convex(pattern, count)
    corners, panels = [np.zeros((0, 4), np.int64)], [np.zeros(0, np.int64)]
    for begin in range(1, faces.shape[1] - 1, 2):
        here = np.flatnonzero(convex & (count > begin + 1))
        last = np.where(count[here] > begin + 2, faces[here, (begin + 2) % faces.shape[1]], -1)
        first = faces[here][:, [0, begin, begin + 1]]
        corners.append(np.column_stack([first, last]))
        panels.append(here)
    found, owners = _triangles(pattern, np.flatnonzero(~convex))
    quads = np.concatenate([*corners, np.column_stack([found, np.full(len(found), -1)])])
    owner = np.concatenate([*panels, owners])
    order = np.argsort(owner, kind="stable")
    quads, owner = quads[order], owner[order]
    lacking = np.flatnonzero(quads[:, 3] < 0)
    middles = quads[lacking][:, [2, 0]]
    quads[lacking, 3] = len(pattern.vertices) + np.arange(len(lacking))
    return Parts(quads, owner, middles, convex)


@record
class Refined:
    """Quadrilaterals that meet side to side and make up panels: for pictures.

    A panel has one at each corner, from there to the middles of two sides and the panel's centre.
    Middles and centres are further vertices, behind those of the pattern, in this order.
    """

    faces: Integers  # corners (P, 4), counter-clockwise in the flat sheet
    panels: Integers  # the panel (P,) that each is a part of, ascending
    sides: Integers  # vertices (S, 2) of all sides: those of the pattern's edges first
    halves: Integers  # halves (2 E, 2) of the pattern's edges, the two of one after the other
    loops: Integers  # vertices (C, K) of the polygons that have the centres, -1 behind the last

    def extended(self, points: Array) -> Array:
        """Vertices (..., V + S + C, k) of a state, from those (..., V, k) of the pattern."""
        there = (self.loops >= 0)[..., None]
        centres = np.where(there, points[..., self.loops, :], 0.0).sum(axis=-2) / there.sum(axis=1)
        return np.concatenate([points, points[..., self.sides, :].mean(axis=-2), centres], axis=-2)


def refine(pattern: CreasePattern) -> Refined:
    """Part panels for pictures; those that are not convex are parted into triangles before."""
    convex = _are_convex(pattern, (pattern.faces >= 0).sum(axis=1))
    found, owners = _triangles(pattern, np.flatnonzero(~convex))
    padded = np.full((len(found), pattern.faces.shape[1]), -1)
    padded[:, :3] = found
    loops = np.concatenate([pattern.faces[convex], padded])
    owners = np.concatenate([np.flatnonzero(convex), owners])
    size = len(pattern.vertices)
    after = np.roll(np.where(loops < 0, loops[:, :1], loops), -1, axis=1)
    there = loops >= 0
    keys = np.minimum(loops, after) * size + np.maximum(loops, after)
    known = np.sort(pattern.edges, axis=1) @ [size, 1]
    all_keys = np.concatenate([known, np.setdiff1d(keys[there], known)])
    order = np.argsort(all_keys)
    middles = size + order[np.searchsorted(all_keys, keys, sorter=order) % len(order)]
    before = np.where(np.arange(loops.shape[1]) > 0, np.roll(middles, 1, axis=1), -1)
    last = there.sum(axis=1) - 1
    before[:, 0] = middles[np.arange(len(loops)), last]
    centres = np.broadcast_to(size + len(all_keys) + np.arange(len(loops))[:, None], loops.shape)
    quads = np.stack([loops, middles, centres, before], axis=-1)[there]
    owners = np.repeat(owners, there.sum(axis=1))
    order_of = np.argsort(owners, kind="stable")
    edges = np.arange(len(pattern.edges)) + size
    halves = np.stack([pattern.edges[:, 0], edges, edges, pattern.edges[:, 1]], axis=1)
    return Refined(
        quads[order_of],
        owners[order_of],
        np.stack(np.divmod(all_keys, size), axis=-1),
        halves.reshape(-1, 2),
        loops,
    )


def _are_convex(pattern: CreasePattern, count: Integers) -> Booleans:
    """Which panels (F,) turn the same way at all their vertices."""
    faces = pattern.faces
    place = np.arange(faces.shape[1])[None]
    here, after, before = (
        pattern.vertices[np.take_along_axis(faces, (place + step) % count[:, None], axis=1)]
        for step in (0, 1, -1)
    )
    (a, b), (c, d) = (np.moveaxis(each, -1, 0) for each in (here - before, after - here))
    sine = (a * d - b * c) / np.sqrt((a * a + b * b) * (c * c + d * d))
    return np.asarray(((sine > STRAIGHT) | (place >= count[:, None])).all(axis=1))


def _triangles(pattern: CreasePattern, panels: Integers) -> tuple[Integers, Integers]:
    """Corners (T, 3) of triangles that make up panels, and the panel (T,) of each."""
    if not len(panels):
        return np.zeros((0, 3), np.int64), np.zeros(0, np.int64)
    import shapely

    loops = [row[row >= 0] for row in pattern.faces[panels]]
    outlines = np.array([shapely.Polygon(pattern.vertices[loop]) for loop in loops])
    made, owners = shapely.get_parts(
        shapely.constrained_delaunay_triangles(outlines), return_index=True
    )
    # Their corners are vertices of the panel, bit by bit.
    points, which = shapely.get_coordinates(shapely.normalize(made), return_index=True)
    corners = points[np.flatnonzero(np.diff(which, append=-1) == 0)].reshape(-1, 3, 2)[:, ::-1]
    near = np.array(
        [
            loops[owner][
                np.abs(pattern.vertices[loops[owner]][None] - triangle[:, None])
                .sum(axis=-1)
                .argmin(axis=1)
            ]
            for owner, triangle in zip(owners.tolist(), corners, strict=True)
        ]
    )
    return near, panels[owners]
