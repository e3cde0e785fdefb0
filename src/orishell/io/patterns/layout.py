"""The flat sheet of panels in space: laid out one beside the other, if that is possible."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.quantities import counted
from orishell.conventions.record import record
from orishell.motion.mesh import folds_between
from orishell.motion.panel_sides import JoinedLoops
from orishell.motion.quads import units
from orishell.numerics.arrays import Array, Booleans, Complex, Integers
from orishell.numerics.equals import first_largest, first_smallest

FLATNESS = 1e-6
"""How far corners may leave the plane of their panel, and the flat sheet, by the diagonal."""
IN_PLANE = 1e-9
"""How far a flat sheet that is saved in space may leave its plane, by the diagonal."""
UNFOLDED = 1e-6
"""Creases that fold by less are flat (radians)."""
DEVELOPABLE_DEG = 1e-3
"""By how much sectors may miss 360 degrees together."""


@record
class Layout:
    """Flat vertices, or why there are none."""

    vertices: Array | None  # (V, 2)
    reason: str  # in a sentence; empty if there are


def seen_from_above(points: Array) -> Array | None:
    """Points (V, 3) that lie in one plane, as z = 0 with that plane seen from above; else None.

    From above: from where the largest component of the normal is positive, the first axis that lies
    in the plane, or is nearest to it, to the right.
    """
    if not points[:, 2].any():
        return points
    centred = points - points.mean(axis=0)
    normal = np.linalg.eigh(centred.T @ centred)[1][:, 0]
    diagonal = float(np.linalg.norm(np.ptp(points, axis=0)))
    if not np.abs(centred @ normal).max() <= IN_PLANE * diagonal:
        return None
    normal = np.where(np.abs(normal) < IN_PLANE, 0.0, normal)
    normal *= np.sign(normal[first_largest(np.abs(normal))])
    right = np.eye(3)[first_smallest(np.abs(normal))]
    right = right - (right @ normal) * normal
    right /= np.linalg.norm(right)
    up = np.cross(normal, right)
    return np.column_stack([points @ right, points @ up, np.zeros(len(points))])


def lay_out(positions: Array, joined: JoinedLoops) -> Layout:
    """Turn panels about their creases into one plane, beginning with the first.

    Parameters
    ----------
    positions
        Vertices (V, 3).
    joined
        Panels that go round the same way, in one piece.
    """
    loops = joined.loops
    there = loops >= 0
    diagonal = float(np.linalg.norm(np.ptp(positions[np.unique(loops[there])], axis=0)))
    local, height = _in_own_planes(positions, loops)
    if not height.max() <= FLATNESS * diagonal:
        panel = first_largest(height)
        return Layout(
            None,
            f"panel {panel} is not flat: its corners leave a plane by {height[panel]:.3g}, "
            f"{height[panel] / diagonal:.2g} of the diagonal",
        )
    excess = _excess_deg(local, joined, len(positions))
    vertex = first_largest(np.abs(excess))
    if abs(excess[vertex]) > DEVELOPABLE_DEG:
        wrong = int((np.abs(excess) > DEVELOPABLE_DEG).sum())
        return Layout(
            None,
            f"{counted(wrong, 'vertex is', 'vertices are')} not developable: sectors at vertex "
            f"{vertex} add up to {360 + excess[vertex]:.6g} degrees",
        )
    turn, shift = _pivoted(local, joined)
    placed = turn[:, None] * local + shift[:, None]
    count = np.maximum(np.bincount(loops[there], minlength=len(positions)), 1)
    mean = np.empty(len(positions), dtype=np.complex128)
    mean.real, mean.imag = (
        np.bincount(loops[there], part[there], minlength=len(positions)) / count
        for part in (placed.real, placed.imag)
    )
    gap = np.where(there, np.abs(placed - mean[loops]), 0.0).max(axis=1)
    if not gap.max() <= FLATNESS * diagonal:
        return Layout(
            None,
            f"the panels do not close into a flat sheet: at panel {first_largest(gap)} they miss "
            f"each other by {gap.max():.3g}",
        )
    return Layout(np.stack([mean.real, mean.imag], axis=-1), "")


def letters_of_folds(positions: Array, joined: JoinedLoops) -> NDArray[np.str_]:
    """Letter (E,) of every edge by how it is folded in a state: M, V, F where it is not; or B."""
    loops = joined.loops
    around = positions[np.where(loops < 0, loops[:, :1], loops)]
    around = around - around[:, :1]
    normals = units(np.cross(around, np.roll(around, -1, axis=1)).sum(axis=1))
    folds = folds_between(normals, joined.edges, joined.edge_faces, joined.crease, positions)
    letters = np.array(["M", "F", "V"])[
        (np.sign(folds) * (np.abs(folds) > UNFOLDED)).astype(int) + 1
    ]
    return np.where(joined.crease, letters, "B")


def _in_own_planes(positions: Array, loops: Integers) -> tuple[Complex, Array]:
    """Corners (F, K) in the plane of their panel, its first side along x; heights (F,) above it."""
    around = positions[np.where(loops < 0, loops[:, :1], loops)]
    apart = around - around[:, :1]
    normal = np.cross(apart, np.roll(apart, -1, axis=1)).sum(axis=1)
    tiny = np.finfo(np.float64).tiny
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), tiny)
    along = apart[:, 1] - (apart[:, 1] * normal).sum(axis=1, keepdims=True) * normal
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), tiny)
    across = np.cross(normal, along)
    x, y, z = (np.einsum("fkc,fc->fk", apart, axis) for axis in (along, across, normal))
    return x + 1j * y, np.asarray(np.abs(z).max(axis=1), dtype=np.float64)


def _excess_deg(local: Complex, joined: JoinedLoops, vertex_count: int) -> Array:
    """By how much (V,) the sectors at an inner vertex exceed a full turn; 0 at others."""
    loops = joined.loops
    there = loops >= 0
    size = there.sum(axis=1)[:, None]
    place = np.arange(loops.shape[1])[None]
    after, before = (
        np.take_along_axis(local, (place + step) % size, axis=1) - local for step in (1, -1)
    )
    with np.errstate(divide="ignore", invalid="ignore"):
        sector = np.mod(np.angle(before * after.conj()), 2 * np.pi)
    sums = np.bincount(loops[there], sector[there], minlength=vertex_count)
    inner = _inner(joined, vertex_count)
    return np.where(inner, np.rad2deg(sums - 2 * np.pi), 0.0)


def _inner(joined: JoinedLoops, vertex_count: int) -> Booleans:
    inner = np.zeros(vertex_count, dtype=np.bool_)
    inner[joined.loops[joined.loops >= 0]] = True
    inner[joined.edges[~joined.crease]] = False
    return inner


def _pivoted(local: Complex, joined: JoinedLoops) -> tuple[Complex, Complex]:
    """Turn and shift (F,) that bring every panel into the plane of the first one."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import breadth_first_order

    faces = len(joined.loops)
    crease = np.flatnonzero(joined.crease)
    left, right = joined.edge_faces[crease].T
    graph = coo_array((crease + 1, (left, right)), shape=(faces, faces)).tocsr()
    _, parent = breadth_first_order(graph, 0, directed=False)
    parent = np.where(parent < 0, 0, parent).astype(np.int64)
    both = np.sort(np.stack([np.arange(faces), parent], axis=-1), axis=1)
    # the crease between a panel and its parent
    pairs = np.sort(joined.edge_faces[crease], axis=1)
    keys = pairs[:, 0] * faces + pairs[:, 1]
    order = np.argsort(keys, kind="stable")
    wanted = both[:, 0] * faces + both[:, 1]
    found = crease[order[np.minimum(np.searchsorted(keys[order], wanted), len(keys) - 1)]]
    turn, shift = np.ones(faces, np.complex128), np.zeros(faces, np.complex128)
    child = np.arange(1, faces)
    ends = joined.edges[found[child]]
    own, other = (
        np.stack([_at(local[panel], joined.loops[panel], ends[:, k]) for k in (0, 1)], axis=-1)
        for panel in (child, parent[child])
    )
    turn[child] = (other[:, 1] - other[:, 0]) / (own[:, 1] - own[:, 0])
    turn[child] /= np.abs(turn[child])
    shift[child] = other.mean(axis=1) - turn[child] * own.mean(axis=1)
    while parent.any():
        shift = turn[parent] * shift + shift[parent]
        turn = turn[parent] * turn
        turn /= np.abs(turn)
        parent = parent[parent]
    return turn, shift


def _at(local: Complex, loops: Integers, vertices: Integers) -> Complex:
    """Where vertices (N,) lie in the planes of panels (N, K)."""
    place = (loops == vertices[:, None]).argmax(axis=1)
    return np.asarray(np.take_along_axis(local, place[:, None], axis=1)[:, 0])
