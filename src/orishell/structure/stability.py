"""Linear buckling: by which factor all loads may grow until the shell gives way sideways.

With K_g the stiffness that forces in the plane of triangles, in ties and in flaps have by turning,

    (K + factor K_g) mode = 0.

Ties, flaps and feet that act under the load are taken to go on acting.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.numerics.arrays import Array, Integers
from orishell.structure.elements import assemble
from orishell.structure.facets import Facets
from orishell.structure.inverse import Inverse, largest

if TYPE_CHECKING:
    from scipy.sparse import csr_array

NEVER = 1e-9
"""Factors above the inverse of this are none."""


def geometric_stiffness(facets: Facets, forces: Array, count: int) -> csr_array:
    """The matrix (D, D) of triangles that turn under membrane forces.

    Displacements are linear in a triangle; freedoms begin with those of nodes.

    Parameters
    ----------
    forces
        Along x, along y and in shear (T, 3), in a triangle's axes (force per length).
    count
        Number of all freedoms D.
    """
    flat, area = facets.flat(), facets.areas()
    ahead, behind = np.roll(flat, -1, axis=1), np.roll(flat, 1, axis=1)
    side = ahead - behind
    slope = np.stack([side[..., 1], -side[..., 0]], axis=-1) / (2 * area)[:, None, None]
    x, y, xy = forces.T
    tensor = np.stack([np.stack([x, xy], axis=-1), np.stack([xy, y], axis=-1)], axis=-2)
    by_node = slope @ tensor @ slope.swapaxes(1, 2) * area[:, None, None]
    return _on_axes(by_node, facets.triangles, count)


def turning_stiffness(points: Array, pairs: Integers, pulls: Array, count: int) -> csr_array:
    """The matrix (D, D) of straight ties and struts.

    Parameters
    ----------
    points
        Nodes (N, 3).
    pairs
        Nodes (m, 2) between which they are.
    pulls
        With which force they pull (m,); struts push, less than 0 (N).
    count
        Number of all freedoms D.
    """
    away = points[pairs[:, 1]] - points[pairs[:, 0]]
    length = np.linalg.norm(away, axis=1)
    along = away / length[:, None]
    across = np.eye(3) - along[:, :, None] * along[:, None]
    block = (pulls / length)[:, None, None] * across
    elements = np.concatenate(
        [np.concatenate([block, -block], axis=2), np.concatenate([-block, block], axis=2)], axis=1
    )
    freedoms = 3 * pairs[:, :, None] + np.arange(3)
    return assemble(elements, freedoms.reshape(-1, 6), count)


def find_buckling(inverse: Inverse, geometric: csr_array) -> tuple[float, Array] | None:
    """The factor at which the shell buckles, and the mode (n,); None if it does not.

    Parameters
    ----------
    geometric
        K_g (n, n) of free freedoms.
    """
    if not geometric.count_nonzero():  # nothing is loaded
        return None
    values, modes = largest(inverse, lambda moved: -(geometric @ moved), 1)
    if values[0] <= NEVER:
        return None
    return float(1 / values[0]), modes[:, 0]


def _on_axes(by_node: Array, nodes: Integers, count: int) -> csr_array:
    """Matrices (T, k, k) of nodes (T, k), alike for all three directions."""
    axes = np.eye(3)
    size = nodes.shape[1]
    elements = np.einsum("tij,xy->tixjy", by_node, axes).reshape(-1, 3 * size, 3 * size)
    freedoms = 3 * nodes[:, :, None] + np.arange(3)
    return assemble(elements, freedoms.reshape(-1, 3 * size), count)
