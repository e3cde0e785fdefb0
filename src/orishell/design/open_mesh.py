"""Triangles checked and mended: one open piece of surface with one rim."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.design.mesh_errors import ELSE_PART, place_in_words, refused_mesh
from orishell.design.mesh_facing import require_no_folds
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.components import find_components
from orishell.numerics.equals import descending, first_largest, first_smallest

MOST_TRIANGLES = 400_000
"""Triangles of a mesh, at most."""
SAME = 1e-7
"""Vertices are the same one if they lie nearer than this share of the mesh's size."""
FARTHEST = 1e60
"""The largest coordinate; its fourth power still is a number."""
CORNER = np.deg2rad(25)
"""A rim that turns by less has no corner there."""
SHORTEST_SIDE = 0.08
"""Sides are at least this share of the rim."""
LOOK = 0.01
"""Turns of the rim are seen over this share of it, both ways."""


@record
class OpenMesh:
    """Triangles of one open piece of surface."""

    vertices: Array  # (V, 3)
    triangles: Integers  # (T, 3), counter-clockwise seen from above, as far as that can be said
    rim: Integers  # (K,) vertices along the rim, clockwise seen from there


def open_mesh(vertices: Array, triangles: Integers) -> OpenMesh:
    """One open piece of surface with one rim, of triangles whose vertices may be there repeatedly.

    Raises
    ------
    InputError
        Where it is none.
    """
    mesh = open_piece(*joined_vertices(vertices, triangles))
    require_no_folds(mesh.vertices, mesh.triangles)
    return mesh


def open_piece(vertices: Array, triangles: Integers) -> OpenMesh:
    """One open piece of surface with one rim, of triangles whose vertices are there once.

    Raises InputError where it is none.
    """
    _require_two_each(vertices, triangles)
    triangles = _oriented(vertices, triangles)
    rim = _rim(vertices, triangles)
    edges = (3 * len(triangles) + len(rim)) // 2
    if len(vertices) - edges + len(triangles) != 1:
        raise refused_mesh(
            "the mesh has a handle", "", "a piece of surface without", "remove it" + ELSE_PART
        )
    p, q, r = np.moveaxis(vertices[triangles], 1, 0)
    upward = np.cross(q - p, r - p).sum(axis=0)
    facing_up = abs(upward[2]) > 1e-6 * lengths(upward)
    main = upward[2 if facing_up else first_largest(np.abs(upward))]
    if main < 0:
        triangles, rim = triangles[:, ::-1], rim[::-1]
    return OpenMesh(vertices, np.ascontiguousarray(triangles), rim[::-1])


def find_corners(mesh: OpenMesh, places: Array | None) -> Integers:
    """Which four of a rim (K,) are its corners, in its order: where it turns most, or at places.

    A rim with fewer sharp turns has the rest where its longest side is cut in two. The first
    corner is where the top begins, the side that is farthest along y.
    """
    points = mesh.vertices[mesh.rim]
    if places is None:
        corners = _sharpest(points)
    else:
        corners = np.unique([first_smallest(lengths(points - place)) for place in places])
        if len(corners) < 4:
            raise InputError(
                "two corners are the same vertex of the rim",
                keys=("corners",),
                where="corners",
                expected="four different vertices of the rim",
            )
    middles = [
        points[np.arange(first, last + (len(points) if last <= first else 0) + 1) % len(points)]
        for first, last in zip(corners, np.roll(corners, -1), strict=True)
    ]
    centres = np.array([line.mean(axis=0) for line in middles])
    up = centres - np.roll(centres, 2, axis=0)
    axis = 1 if np.abs(up[:, 1]).max() > 1e-6 * lengths(up).max() else 2
    return np.roll(corners, -first_largest(up[:, axis]))


def _sharpest(points: Array) -> Integers:
    """The four vertices at which a closed line (K, 3) turns most, a side apart."""
    count = len(points)
    steps = lengths(np.roll(points, -1, axis=0) - points)
    arc = np.concatenate([[0.0], np.cumsum(steps)])
    whole = arc[-1]
    around = np.concatenate([points, points[:1]])

    def at(place: Array) -> Array:
        place = np.mod(place, whole)
        return np.stack([np.interp(place, arc, each) for each in around.T], axis=-1)

    here = arc[:-1]
    before, after = points - at(here - LOOK * whole), at(here + LOOK * whole) - points
    sizes = np.maximum(lengths(before) * lengths(after), 1e-300)
    turns = np.arccos(np.clip((before * after).sum(axis=-1) / sizes, -1, 1))
    # Bends inwards are no corners: there the rim turns against the rest of it.
    axis = np.cross(points, np.roll(points, -1, axis=0)).sum(axis=0)
    turns = np.where(np.cross(before, after) @ axis > 0, turns, 0.0)
    chosen: list[int] = []
    for k in descending(turns):
        if turns[k] < CORNER or len(chosen) == 4:
            break
        apart = np.abs(here[k] - here[chosen]) if chosen else np.full(1, np.inf)
        if np.minimum(apart, whole - apart).min() >= SHORTEST_SIDE * whole or not chosen:
            chosen.append(int(k))
    if not chosen:
        chosen = [0]
    while len(chosen) < min(4, count):
        chosen.sort()
        begins = here[chosen]
        long = np.diff(np.concatenate([begins, [begins[0] + whole]]))
        side = first_largest(long)
        middle = np.mod(begins[side] + 0.5 * long[side], whole)
        away = np.abs(here - middle)
        away[chosen] = np.inf
        chosen.append(first_smallest(away, size=whole))
    if len(chosen) < 4:
        raise refused_mesh("the rim has too few vertices", f"{count}", "four at least")
    return np.sort(np.array(chosen))


def joined_vertices(vertices: Array, triangles: Integers) -> tuple[Array, Integers]:
    """The mesh with every vertex once, without vertices that no triangle has.

    And without triangles that have lost a side, or that are there repeatedly. Neighbours are sought
    in a tree, so that none are parted by rounding.

    Raises
    ------
    InputError
        If there are no triangles, or too many.
    """
    from scipy.spatial import cKDTree

    if len(triangles) > MOST_TRIANGLES:
        raise refused_mesh(
            "the mesh is too large",
            f"{len(triangles)} triangles",
            f"at most {MOST_TRIANGLES}",
            "write it with larger triangles",
        )
    used, inverse = np.unique(triangles, return_inverse=True)  # what none uses has no size
    vertices, triangles = vertices[used], inverse.reshape(-1, 3)
    require_size(vertices)
    size = float(lengths(np.ptp(vertices, axis=0))) if len(vertices) else 0.0
    pairs = cKDTree(vertices).query_pairs(SAME * size, output_type="ndarray")
    number = find_components(pairs, len(vertices))
    triangles = number[triangles]
    first = np.unique(number, return_index=True)[1]
    vertices = vertices[first]
    p, q, r = triangles.T
    triangles = triangles[(p != q) & (q != r) & (r != p)]
    if not len(triangles):
        raise refused_mesh("the mesh has no triangles", "", "an open piece of surface")
    first = np.unique(np.sort(triangles, axis=1), axis=0, return_index=True)[1]
    triangles = triangles[np.sort(first)]
    used, inverse = np.unique(triangles, return_inverse=True)
    return vertices[used], inverse.reshape(-1, 3).astype(np.int64)


def require_size(vertices: Array) -> None:
    """Refuse coordinates that are no numbers, or whose squares of squares would be none."""
    if not np.isfinite(vertices).all():
        raise refused_mesh("the mesh has coordinates that are no numbers", "", "finite coordinates")
    largest = float(np.abs(vertices).max(initial=0.0))
    if largest > FARTHEST or 0 < largest < 1 / FARTHEST:
        raise refused_mesh(
            "the mesh is too large or too small for its coordinates",
            f"coordinates up to {largest:.4g}",
            f"from {1 / FARTHEST:g} to {FARTHEST:g}",
            "check unit and scale",
        )


def _require_two_each(vertices: Array, triangles: Integers) -> None:
    """Refuse edges of three triangles, and several pieces."""
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    found, counts = np.unique(edges, axis=0, return_counts=True)
    if counts.max() > 2:
        place = vertices[found[counts.argmax()]].mean(axis=0)
        raise refused_mesh(
            "more than two triangles meet at an edge",
            f"{counts.max()} near {place_in_words(place)}",
            "a surface without branches",
            "remove what stands on it there" + ELSE_PART,
        )
    piece = find_components(found, len(vertices))
    sizes = np.bincount(piece)
    if len(sizes) > 1:
        place = vertices[piece == sizes.argmin()].mean(axis=0)
        raise refused_mesh(
            "the mesh has several pieces",
            f"{len(sizes)}, the smallest near {place_in_words(place)}",
            "one piece",
            "remove the others, or join them" + ELSE_PART,
        )


def _oriented(vertices: Array, triangles: Integers) -> Integers:
    """The triangles run through one way round, neighbour by neighbour."""
    import igl

    turned, _ = igl.bfs_orient(triangles)
    edges = turned[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    found, counts = np.unique(edges, axis=0, return_counts=True)
    if counts.max() > 1:
        place = vertices[found[counts.argmax()]].mean(axis=0)
        raise refused_mesh(
            "the mesh has no two sides",
            f"a twist near {place_in_words(place)}",
            "a surface with two sides",
            "cut it there" + ELSE_PART,
        )
    return np.asarray(turned, np.int64)


def _rim(vertices: Array, triangles: Integers) -> Integers:
    """The vertices (K,) along the rim of oriented triangles, as their edges run."""
    edges = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    count = len(vertices)
    forth, back = edges[:, 0] * count + edges[:, 1], edges[:, 1] * count + edges[:, 0]
    rim = edges[~np.isin(forth, back)]
    if not len(rim):
        raise refused_mesh(
            "the mesh is closed",
            "no rim",
            "an open piece of surface",
            "remove its underside" + ELSE_PART,
        )
    start, times = np.unique(rim[:, 0], return_counts=True)
    if times.max() > 1:
        raise refused_mesh(
            "the rim of the mesh meets itself",
            f"at {place_in_words(vertices[start[times.argmax()]])}",
            "a rim that passes every vertex once",
            "close the hole there" + ELSE_PART,
        )
    after = np.full(count, -1)
    after[rim[:, 0]] = rim[:, 1]
    loops = []
    left = np.zeros(count, np.bool_)
    left[rim[:, 0]] = True
    while left.any():
        loop = [int(left.argmax())]
        left[loop[0]] = False
        while left[after[loop[-1]]]:
            loop.append(int(after[loop[-1]]))
            left[loop[-1]] = False
        loops.append(np.array(loop))
    if len(loops) > 1:
        loops.sort(key=lambda loop: float(lengths(np.ptp(vertices[loop], axis=0))))
        place = vertices[loops[0]].mean(axis=0)
        raise refused_mesh(
            "the mesh has holes",
            f"{len(loops)} rims, one of {len(loops[0])} edges near {place_in_words(place)}",
            "one rim",
            "close the holes" + ELSE_PART,
        )
    return loops[0]
