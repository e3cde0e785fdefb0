"""Geometric stiffness: what membrane forces add to the stiffness of triangles as they turn.

Membrane forces N, constant in a triangle, take up the energy

    1/2 A (g_u . N g_u + g_v . N g_v + g_w . N g_w)

as it turns, g being mean slopes of its displacements. By Gauss they follow from its sides alone,

    g_w = 1/A sum over sides of n int w ds,

n being the outer normal. Along a side from corner i to j, d = x_j - x_i, w is a cubic, as it is in
bending (DKT), by w and its slopes s at both ends:

    int w ds = abs(d) ((w_i + w_j)/2 + d . (s_i - s_j)/12).

u and v are linear. Slopes at nodes are those of parabolas through w at three nodes in a row, along
both rows of a panel's nodes. The plate's own rotations would not do: a cell alone bends without
displacements of nodes, DKT resists that far too little, and panels would buckle in waves of a cell.

Where a force enters at a point, N grows as 1/r towards it. So in triangles there w is linear, too:
by the integral of N dw/dr dw/dr r, what counts is the slope along r, not its mean over the area.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.structure.mesh.sheet import SheetMesh, points_by_dofs
from orishell.structure.mesh.triangle import DOFS

if TYPE_CHECKING:
    from scipy.sparse import csr_array


STRAIGHT = 1e-9
"""An angle whose sine is less than this is straight (radians)."""


@record
class Turned:
    """What forces add to the stiffness of a structure as it turns: symmetric, of free dofs (n, n).

    It is G^T W G + K, and only ever multiplied with vectors: G is nearly the same for all cases.
    """

    # G: mean slopes (6 T, n) of u, v and w along x and y, for every triangle: linear ones, and what
    # rotations add
    slopes: csr_array
    curved: csr_array
    bent: Booleans  # of which triangles (T,) the second counts
    weights: Array  # W: membrane forces times area of triangles (T, 2, 2)
    others: csr_array  # K: of ties, struts and arms (n, n)

    def times(self, moved: Array) -> Array:
        """Forces (n, p) of displacements (n, p)."""
        shape = len(self.weights), 3, 2, moved.shape[1]
        curved = (self.curved @ moved).reshape(shape) * self.bent[:, None, None, None]
        slopes = (self.slopes @ moved).reshape(shape) + curved
        turned = np.einsum("tde,taep->tadp", self.weights, slopes)
        straight = turned.reshape(-1, shape[-1])
        round_ = (turned * self.bent[:, None, None, None]).reshape(straight.shape)
        return np.asarray(self.slopes.T @ straight + self.curved.T @ round_ + self.others @ moved)

    @property
    def loaded(self) -> bool:
        """Whether there are any forces."""
        return bool(self.weights.any()) or bool(self.others.count_nonzero())


def geometric_stiffness(
    mesh: SheetMesh, forces: Array, points: Integers, free: Integers, others: csr_array
) -> Turned:
    """What triangles that turn under membrane forces add to the stiffness of free dofs.

    forces: Along x, along y and in shear (T, 3), in a triangle's axes (force per length).
    points: Nodes (k,) at which forces enter.
    free: Free dofs (n,).
    others: What other parts add (D, D).
    """
    from scipy.sparse import csr_array

    x, y, xy = (forces * mesh.facets.areas()[:, None]).T
    weights = np.stack([np.stack([x, xy], axis=-1), np.stack([xy, y], axis=-1)], axis=-2)
    bent = np.asarray(~np.isin(mesh.facets.triangles, points).any(axis=1))
    slopes, curved = _slopes(mesh, free.tobytes())
    return Turned(slopes, curved, bent, weights, csr_array(others[free][:, free]))


@lru_cache(maxsize=2)
def _slopes(mesh: SheetMesh, free: bytes) -> tuple[csr_array, csr_array]:
    """Mean slopes (6 T, n) of triangles by free dofs, kept for the load cases of a mesh.

    Those by displacements of their corners, and what rotations there add.
    """
    from scipy.sparse import coo_array, csr_array

    facets, smooth, wanted = mesh.facets, _smoothing(mesh), np.frombuffer(free, np.int64)
    local = mean_slopes(facets.flat())
    apart = local.reshape(len(local), 6, 3, 2, 3)  # of corners, displacements and rotations
    values = np.einsum("trcki,tij->trckj", apart, facets.axes())
    own = 3 * facets.triangles[..., None] + np.arange(3)
    turns = 3 * (len(facets.points) + mesh.places[..., None]) + np.arange(3)
    rows = np.arange(6 * len(local)).reshape(-1, 6, 1, 1)

    def by_free_dofs(values: Array, columns: Integers) -> csr_array:
        places = [np.broadcast_to(each, values.shape) for each in (rows, columns[:, None])]
        there = values != 0
        kept = values[there], tuple(each[there] for each in places)
        matrix = coo_array(kept, shape=(6 * len(local), smooth.shape[0]))
        return csr_array((csr_array(matrix) @ smooth)[:, wanted])

    return by_free_dofs(values[..., 0, :], own), by_free_dofs(values[..., 1, :], turns)


def _smoothing(mesh: SheetMesh) -> csr_array:
    """Displacements of points and rotations of panels there by displacements, as dofs have them.

    (3 N + 3 F (cells+1)^2, D).
    """
    from scipy.sparse import csr_array, vstack

    return csr_array(vstack([points_by_dofs(mesh), smooth_rotations(mesh)], format="csr"))


def mean_slopes(corners: Array) -> Array:
    """Mean slopes (T, 3, 2, 18) of u, v and w along x and y, by the dofs of triangles.

    corners: Corners (T, 3, 2), counter-clockwise (length).
    """
    slopes = np.zeros((len(corners), 3, 2, 3, DOFS))
    u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = 0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    for i, j in ((0, 1), (1, 2), (2, 0)):
        side = corners[:, j] - corners[:, i]
        outwards = np.stack([side[:, 1], -side[:, 0]], axis=-1)
        normal = outwards / area[:, None]
        for axis in range(3):
            slopes[:, axis, :, i, axis] += 0.5 * normal
            slopes[:, axis, :, j, axis] += 0.5 * normal
        # Slopes of w along x and y are rotations about -y and x.
        bulge = normal[:, :, None] * outwards[:, None] / 12
        slopes[:, 2, :, i, 3:5] += bulge
        slopes[:, 2, :, j, 3:5] -= bulge
    return slopes.reshape(len(corners), 3, 2, 3 * DOFS)


def smooth_rotations(mesh: SheetMesh) -> csr_array:
    """Rotations (3 * F * (cells+1)^2, D) of panels at their points, by displacements of those.

    About their normals they are 0.
    """
    from scipy.sparse import coo_array, csr_array

    nodes, points = mesh.seats, mesh.facets.points[mesh.seats]
    corners = points[:, [0, -1, -1, 0], [0, 0, -1, -1]]
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normal = (normal / np.linalg.norm(normal, axis=1, keepdims=True))[:, None, None]
    rows, columns = (_in_a_row(each) for each in nodes.shape[1:])
    down = _slope_weights(points, rows)
    right = _slope_weights(points.swapaxes(1, 2), columns).swapaxes(1, 2)
    below, beside = nodes[:, rows].swapaxes(2, 3), nodes[:, :, columns]
    along, across = (
        np.einsum("fijs,fijsx->fijx", weights, mesh.facets.points[those])
        for weights, those in ((down, below), (right, beside))
    )
    # A slope s of w goes with the rotation s x normal. s by its components along two directions; at
    # a corner that is a straight angle there is one, and no rotation.
    volume = (np.cross(along, across) * normal).sum(axis=-1, keepdims=True)
    sizes = np.linalg.norm(along, axis=-1) * np.linalg.norm(across, axis=-1)
    volume[volume[..., 0] <= STRAIGHT * sizes] = np.inf
    rotations = (
        np.cross(np.cross(across, normal) / volume, normal),
        np.cross(np.cross(normal, along) / volume, normal),
    )
    own = np.arange(nodes.size).reshape(nodes.shape)[..., None, None, None]
    shape = 3 * nodes.size, mesh.facets.points.size
    total = csr_array(shape)
    for weights, turn, those in zip((down, right), rotations, (below, beside), strict=True):
        # (F, cells+1, cells+1, 3, 3, 3): of which node, neighbour, rotation, displacement
        values = weights[..., None, None] * turn[..., None, :, None] * normal[..., None, None, :]
        places = tuple(
            np.broadcast_to(each, values.shape).ravel()
            for each in (3 * own + np.arange(3)[:, None], 3 * those[..., None, None] + np.arange(3))
        )
        total = total + coo_array((values.ravel(), places), shape=shape).tocsr()
    return csr_array(total @ points_by_dofs(mesh))


def _in_a_row(count: int) -> Integers:
    """Which nodes (n, 3) of so many in a line there are with each, two if there are no more."""
    first = np.clip(np.arange(count) - 1, 0, max(count - 3, 0))
    return np.asarray(first[:, None] + np.arange(min(3, count)))


def _slope_weights(points: Array, near: Integers) -> Array:
    """Weights (F, n, m, 3) of three nodes in a column for the slope at every node.

    points: Nodes (F, n, m, 3), whose columns are straight, or nearly so: places are along them.
    near: Which nodes (n, 3) of a column there are with every node.
    """
    steps = np.linalg.norm(np.diff(points, axis=1), axis=-1)
    place = np.pad(np.cumsum(steps, axis=1), ((0, 0), (1, 0), (0, 0)))
    x = place[:, near] - place[:, :, None]  # (F, n, 3, m), from the node itself
    weights = np.empty_like(x)
    for k in range(near.shape[1]):
        others = [x[:, :, other] for other in range(near.shape[1]) if other != k]
        apart = np.prod([x[:, :, k] - other for other in others], axis=0)
        weights[:, :, k] = (-sum(others) if len(others) == 2 else 1.0) / apart
    return np.asarray(weights.swapaxes(2, 3))
