"""Which panels, or boards, touch in one state."""

from __future__ import annotations

import numpy as np

from orishell.clash.bodies import Apartness, Bodies
from orishell.clash.broad_phase import (
    CHUNK,
    Pairs,
    PanelTree,
    child_pairs,
    common_corners,
    gaps,
    in_chunks,
    selected,
)
from orishell.clash.narrow_phase import Slabs, near_slabs
from orishell.clash.separation import corners_of, nearest, overlaps
from orishell.motion.convex import ConvexParts
from orishell.motion.quads import dots, lengths, unit_normals, units
from orishell.numerics.arrays import Array, Booleans, Integers


def near_panels(
    positions: Array, faces: Integers, tolerance: float, over: Array | None = None
) -> Pairs:
    """Return all pairs of panels (P,) that bounds do not keep apart, the smaller number first.

    ``over`` is what panels with a thickness have on both sides (F, 3): normals as long as it.
    """
    tree = PanelTree.over(faces, positions[faces].mean(axis=1))
    extents = tree.extents(positions, over)
    pairs = (np.zeros(1, np.int64), np.zeros(1, np.int64))
    for level in range(tree.depth + 1):
        near = gaps((extents, extents), level, pairs) <= tolerance
        pairs = selected(pairs, near)
        if level < tree.depth:
            pairs = child_pairs(pairs)
    first, second = np.sort([tree.panels[nodes] for nodes in pairs], axis=0)
    real = (first >= 0) & (first != second)
    return first[real], second[real]


def find_contacts(
    positions: Array, faces: Integers, tolerance: float, held: Array | None = None
) -> Integers:
    """Return all pairs (P, 2) of panels that touch, cross or overlap, in ascending order.

    The smaller number is the first. Panels that share a crease count when it is folded flat, panels
    that share one vertex when they cross there.

    Parameters
    ----------
    positions
        Vertices (V, 3).
    faces
        Corners (F, 4) of planar, convex panels, in order around each.
    tolerance
        Distance at which panels count as touching (length).
    held
        Corners (F, 4, 3) where panels hold them, if that is only near the vertices. Panels with
        common vertices are then looked at where vertices are, with so much more tolerance.
    """
    off = 0.0 if held is None else 2 * float(lengths(held - positions[faces]).max(initial=0.0))
    first, second = near_panels(positions, faces, tolerance + off)
    own = positions[faces] if held is None else held
    found = []
    for k in range(0, len(first), CHUNK):
        chunk = (first[k : k + CHUNK], second[k : k + CHUNK])
        shared = np.asarray(common_corners(faces, *chunk).any(axis=(1, 2)))
        touching = np.zeros(len(shared), np.bool_)
        beside = (chunk[0][shared], chunk[1][shared])
        touching[shared] = touching_neighbours(positions, faces, beside, tolerance + off)
        apart = [np.ascontiguousarray(own[panels[~shared]].T) for panels in chunk]
        touching[~shared] = nearest(apart[0], apart[1])[0] <= tolerance
        found.append(np.stack(chunk, axis=-1)[touching])
    contacts = np.concatenate([np.empty((0, 2), np.int64), *found])
    return contacts[np.lexsort((contacts[:, 1], contacts[:, 0]))]


def find_distant_contacts(points: Array, parts: ConvexParts, tolerance: float) -> Integers:
    """Pairs (P, 2) of parts of panels that touch in a state (V, 3), neighbours left out.

    Parameters
    ----------
    tolerance
        Distance at which they count as touching (length).
    """
    near = near_panels(points, parts.faces, tolerance)
    near = selected(near, parts.compared(*near))

    def apart(first: Integers, second: Integers) -> Array:
        return nearest(
            corners_of(points, parts.faces[first]), corners_of(points, parts.faces[second])
        )[0]

    return np.stack(selected(near, in_chunks(apart, *near) <= tolerance), axis=-1)


def overlap_depths(positions: Array, faces: Integers, pairs: Integers) -> Array:
    """How far (P,) panels reach into each other, for pairs (P, 2) of them (length).

    By so much one of the two would have to be moved, at least, for them only to touch: 0 where they
    touch or lie on each other.

    Parameters
    ----------
    positions, faces
        Vertices (V, 3), and corners (F, 4) of planar, convex panels, in order around each.
    pairs
        Numbers (P, 2) of panels.
    """

    def of(first: Integers, second: Integers) -> Array:
        return overlaps(corners_of(positions, faces[first]), corners_of(positions, faces[second]))

    return in_chunks(of, pairs[:, 0], pairs[:, 1])


def touching_neighbours(points: Array, faces: Integers, pairs: Pairs, tolerance: float) -> Booleans:
    """Return which pairs (P,) of panels with common vertices touch beyond these.

    Panels with a common crease touch when it is folded flat. Panels with one common vertex touch
    when the arcs that they cut from a sphere about it meet.
    """
    first, second = faces[pairs[0]], faces[pairs[1]]
    same = first[:, :, None] == second[:, None, :]
    count = same.sum(axis=(1, 2))
    touching: Booleans = count > 2
    crease, corner = count == 2, count == 1
    touching[crease] = _folded_flat(points, first[crease], second[crease], same[crease], tolerance)
    touching[corner] = _crossing(points, first[corner], second[corner], same[corner], tolerance)
    return touching


def _folded_flat(
    points: Array, first: Integers, second: Integers, same: Booleans, tolerance: float
) -> Booleans:
    """Whether the far corners of one panel lie on the plane of the other, on its side."""
    if not len(first):
        return np.zeros(0, np.bool_)
    a, b = points[first], points[second]
    on_a, on_b = same.any(axis=2), same.any(axis=1)
    shared = a[on_a].reshape(-1, 2, 3)
    along = units(shared[:, 1] - shared[:, 0])
    far_a, far_b = (
        corners[~on].reshape(-1, 2, 3) - shared[:, :1] for corners, on in ((a, on_a), (b, on_b))
    )
    height = np.abs(dots(unit_normals(a)[:, None], far_b)).max(axis=1)
    # Parts of the far corners square to the crease point the same way.
    sides = [far.sum(axis=1) for far in (far_a, far_b)]
    across = [side - along * dots(side, along)[:, None] for side in sides]
    return np.asarray((height <= tolerance) & (dots(across[0], across[1]) > 0))


def _crossing(
    points: Array, first: Integers, second: Integers, same: Booleans, tolerance: float
) -> Booleans:
    """Whether the edges of one panel at the common vertex lie on both sides of the other."""
    if not len(first):
        return np.zeros(0, np.bool_)
    rows = np.arange(len(first))
    of_first, of_second = np.divmod(same.reshape(len(first), 16).argmax(axis=1), 4)
    vertex = points[first[rows, of_first]]

    def arms(faces: Integers, at: Integers) -> tuple[Array, Array]:
        after, before = (points[faces[rows, (at + step) % 4]] - vertex for step in (1, -1))
        return after, before

    a, b = arms(first, of_first), arms(second, of_second)
    normal_a, normal_b = units(np.cross(*a)), units(np.cross(*b))
    over_a = [dots(normal_a, arm) for arm in b]
    over_b = [dots(normal_b, arm) for arm in a]
    line = np.cross(normal_a, normal_b)
    facing = dots(line, units(a[0]) + units(a[1])) * dots(line, units(b[0]) + units(b[1]))
    result = _straddle(over_a, tolerance) & _straddle(over_b, tolerance) & (facing > 0)
    for sector, normal, arms_of, over in ((a, normal_a, b, over_a), (b, normal_b, a, over_b)):
        for arm, height in zip(arms_of, over, strict=True):
            result |= (np.abs(height) <= tolerance) & _between(sector, normal, arm)
    return result


def _straddle(heights: list[Array], tolerance: float) -> Booleans:
    low, high = np.minimum(*heights), np.maximum(*heights)
    return np.asarray((low < -tolerance) & (high > tolerance))


def _between(arms: tuple[Array, Array], normal: Array, vector: Array) -> Booleans:
    """Whether a vector near the plane of two arms lies in the sector between them."""
    small = 1e-12 * lengths(vector)
    return np.asarray(
        (dots(np.cross(units(arms[0]), vector), normal) > small)
        & (dots(np.cross(vector, units(arms[1])), normal) > small)
    )


def deepest_contact(
    bodies: Bodies,
    points: Array,
    tolerance: float,
    *,
    only: Booleans,
    settled: Integers,
    hinged: Integers,
) -> tuple[tuple[int, int], float] | None:
    """Return the two bodies that reach farthest into each other, and how far; None if none touch.

    Left out are bodies of panels with a common crease, which meet by design, also where that ends
    between corners, for ``hinged`` panels (H, 2); of panels opposite each other at a settled
    vertex; and pairs without a panel of ``only`` (F,).
    """
    slabs = Slabs.of(points, bodies.faces, bodies.height)
    near = near_panels(points, bodies.faces, tolerance, bodies.height * slabs.normals.T)
    near = selected(near, only[near[0]] | only[near[1]])
    near = selected(near, ~_apart_by_design(bodies.faces, near, settled, hinged))
    near = near_slabs((slabs, slabs), near, np.full(len(near[0]), tolerance))
    pairs, _ = bodies.pairs_of(near)
    state = bodies.carried(points)
    apart = Apartness.of((state, state), pairs)
    found = apart.touching(0, pairs, tolerance)
    return None if found is None else (found, max(0.0, -float(apart.gaps[0].min())))


def deepest_between(
    bodies: Bodies, points: Array, tolerance: float, groups: Integers
) -> tuple[tuple[int, int], float] | None:
    """Return the two bodies of different groups (B,) that reach farthest into each other.

    And how far; None if none touch.
    """
    import shapely

    state = bodies.carried(points)
    low, high = state.corners.min(axis=1) - tolerance, state.corners.max(axis=1) + tolerance
    frames = shapely.box(*low[:2], *high[:2])
    first, second = shapely.STRtree(frames).query(frames)
    near = (groups[first] < groups[second]) & (low[2, first] <= high[2, second])
    near &= low[2, second] <= high[2, first]
    pairs = selected((first, second), near)
    apart = Apartness.of((state, state), pairs)
    found = apart.touching(0, pairs, tolerance)
    return None if found is None else (found, max(0.0, -float(apart.gaps[0].min())))


def _apart_by_design(
    faces: Integers, pairs: Pairs, settled: Integers, hinged: Integers
) -> Booleans:
    """Pairs (P,) of panels with a common crease, or opposite each other at a settled vertex."""
    corners = common_corners(faces, *pairs).any(axis=2)
    at_settled = (corners & np.isin(faces[pairs[0]], settled)).any(axis=1)
    keys, known = (
        np.sort(each, axis=-1) @ [len(faces), 1] for each in (np.stack(pairs, axis=-1), hinged)
    )
    return np.asarray((corners.sum(axis=1) > 1) | np.isin(keys, known) | at_settled)
