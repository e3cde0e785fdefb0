"""The smallest box, in any direction, that points fit into."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import NEAR, descending, first_smallest

if TYPE_CHECKING:
    from scipy.spatial import ConvexHull

FLAT = 1e-9
"""Points that leave a plane, or a line, by less than this share of their extent are in it."""
BATCH = 64
"""Directions that are examined at once."""
MOST_CORNERS = 350
"""Of a body that is examined with all its corners; larger ones by some, :data:`CLOSE` to all."""
MOST_POINTS = 20_000
"""Of which the hull is made before some are chosen."""
CLOSE = 1e-3
"""By this share at most the box of all corners is larger than that of some along the same axes."""
VIEWS = 128
"""Directions to both sides of which the first of some corners are the outermost."""


@record
class Box:
    """A box in any direction."""

    # its sides, the longest first (length)
    length: float
    width: float
    height: float
    axes: Array  # unit directions (3, 3) of the sides, one per row, in their order

    @classmethod
    def along(cls, axes: Array, points: Array) -> Box:
        """The box of points (N, 3) along three directions at right angles, axes (3, 3)."""
        sides = np.ptp(points @ axes.T, axis=0)
        sides[sides < FLAT * sides.max()] = 0.0
        order = descending(sides)
        length, width, height = sides[order].tolist()
        return cls(length, width, height, axes[order])

    @property
    def volume(self) -> float:
        """The product of the sides."""
        return self.length * self.width * self.height


def smallest_box(points: Array) -> Box:
    """Return the box of least volume that holds points; of least area where they are in a plane.

    Parameters
    ----------
    points
        Points (N, 3), one at least, in any unit.

    Notes
    -----
    Of points in a plane or on a line, the box is the smallest there is. Of a body it is the
    smallest of those where a side cannot be made less by turning it a little, and another lies
    along an edge of the body's shadow in that direction: one face of the box lies on a face of the
    convex hull, or two opposite ones on edges that cross. A box that rests on edges with all its
    faces, and can be made shorter in every direction, may be smaller still: by an eighth for an
    octahedron, by a few per cent for few random bodies.

    Of a body with more than :data:`MOST_CORNERS` corners it is that box of some of them, made
    larger to hold all. Corners that stick out are added until that is less than :data:`CLOSE` of
    its volume: so the time grows as the number of points, however many are corners.
    """
    centred = points - points.mean(axis=0)
    axes = np.linalg.svd(centred, full_matrices=len(points) < 3)[2]
    extent = np.ptp(centred @ axes.T, axis=0)
    rank = int((extent > FLAT * extent.max()).sum()) if extent.max() > 0 else 0
    if rank == 3:
        return Box.along(_axes_of_body(points, centred @ axes.T / extent), points)
    if rank == 2:
        axes = _turned_to_edge(centred, axes)
    return Box.along(axes, points)


def _turned_to_edge(points: Array, axes: Array) -> Array:
    """Axes (3, 3), the first two turned so that the rectangle along them is the smallest.

    It has a side on an edge of the points' outline.
    """
    from scipy.spatial import ConvexHull

    plane = points @ axes[:2].T
    outline = plane[ConvexHull(plane).vertices]
    edge = np.roll(outline, -1, axis=0) - outline
    along = edge / np.hypot(edge[:, 0], edge[:, 1])[:, None]
    across = np.stack([-along[:, 1], along[:, 0]], axis=-1)
    area = np.ptp(along @ outline.T, axis=1) * np.ptp(across @ outline.T, axis=1)
    best = first_smallest(area)
    turn = np.stack([along[best], across[best]])
    return np.concatenate([turn @ axes[:2], axes[2:]])


def _axes_of_body(points: Array, even: Array) -> Array:
    """Axes (3, 3) of the box of points (N, 3) that are in no plane, see :func:`smallest_box`.

    ``even`` are the points turned and shrunk, so that they reach as far in all directions.
    """
    from scipy.spatial import ConvexHull

    if len(points) <= MOST_POINTS:
        hull = ConvexHull(points)
        if len(hull.vertices) <= MOST_CORNERS:
            return _axes_of_hull(points, hull)
    some = _outermost(even, _views(VIEWS))
    while True:
        corners = points[some]
        axes = _axes_of_hull(corners, ConvexHull(corners))
        places = points @ axes.T
        if np.ptp(places, axis=0).prod() <= (1 + CLOSE) * np.ptp(places[some], axis=0).prod():
            return axes
        some = np.union1d(some, [places.argmin(axis=0), places.argmax(axis=0)])


def _views(count: int) -> Array:
    """Unit directions (count, 3), evenly over half a sphere: a spiral of equal steps in height."""
    height = (np.arange(count) + 0.5) / count
    around, radius = np.pi * (1 + np.sqrt(5)) * np.arange(count), np.sqrt(1 - height**2)
    return np.stack([radius * np.cos(around), radius * np.sin(around), height], axis=-1)


def _outermost(points: Array, directions: Array) -> Integers:
    """Numbers of the points (N, 3) that are farthest to both sides of directions (D, 3)."""
    found = []
    for direction in directions:
        place = points @ direction
        found += [place.argmin(), place.argmax()]
    return np.unique(found)


def _axes_of_hull(points: Array, hull: ConvexHull) -> Array:
    """Axes (3, 3) of the smallest box of a hull of points (N, 3), see :func:`smallest_box`."""
    corners, normals = points[hull.vertices], hull.equations[:, :3]
    # Edges of the hull by the faces at both sides; those inside a plane face are none.
    face, opposite = np.nonzero(np.arange(len(normals))[:, None] < hull.neighbors)
    beside = hull.neighbors[face, opposite]
    triangle = points[hull.simplices]
    edges = triangle[face, opposite - 1] - triangle[face, opposite - 2]
    edges /= lengths(edges)[:, None]
    left, right = normals[face], normals[beside]
    real = lengths(np.cross(left, right)) > FLAT
    edges, left, right = edges[real], left[real], right[real]

    directions = np.concatenate([normals, _crossing(edges, left, right)])
    # No box is smaller than its height times the body's shadow in that direction.
    areas = 0.5 * lengths(
        np.cross(triangle[:, 1] - triangle[:, 0], triangle[:, 2] - triangle[:, 0])
    )
    shadow = 0.5 * np.abs(directions @ normals.T) @ areas
    least = np.ptp(directions @ corners.T, axis=1) * shadow
    order = np.argsort(least, kind="stable")
    best, axes = np.inf, np.eye(3)
    for batch in np.split(order, np.arange(BATCH, len(order), BATCH)):
        if least[batch[0]] >= best:
            break
        up = directions[batch]
        seen, outline = np.nonzero((up @ left.T) * (up @ right.T) <= FLAT)
        along = edges[outline] - up[seen] * np.einsum("ij,ij->i", edges[outline], up[seen])[:, None]
        size = lengths(along)
        upright = size < FLAT
        seen, along = seen[~upright], along[~upright] / size[~upright, None]
        frames = np.stack([up[seen], along, np.cross(up[seen], along)], axis=1)
        volumes = np.ptp(frames @ corners.T, axis=-1).prod(axis=-1)
        if volumes.min() < best * (1 - NEAR):
            best, axes = float(volumes.min()), frames[first_smallest(volumes)]
    return axes


def _crossing(edges: Array, left: Array, right: Array) -> Array:
    """Directions (D, 3) square to two edges of a hull between which it can be held.

    Edges are unit directions (E, 3), left and right the normals (E, 3) of the faces beside them.
    """
    # On the sphere of normals each edge is an arc from left to right, in the plane square to it.
    # The hull is held between two where one arc crosses the other's antipode.
    parted = (edges @ left.T) * (edges @ right.T) < 0
    first, second = np.nonzero(np.triu(parted & parted.T, 1))
    direction = np.cross(edges[first], edges[second])
    outward = left + right
    facing = np.einsum("ij,ij->i", direction, outward[first])
    held = facing * np.einsum("ij,ij->i", direction, outward[second]) < 0
    direction = direction[held]
    return np.asarray(direction / lengths(direction)[:, None])
