"""Linear buckling, and natural frequencies of small motions about a loaded state.

K mode = omega^2 M mode, with the mass of panels lumped at their nodes.

With K_g the stiffness that forces in the plane of triangles, in ties and in flaps have by turning,

    (K + factor K_g) mode = 0.

Ties, flaps and feet that act under the load are taken to go on active.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.structure.mesh.elements import assemble
from orishell.structure.mesh.triangle import Facets
from orishell.structure.solve.factorised import Factorised

if TYPE_CHECKING:
    from scipy.sparse import csr_array

SEED = 0
ACCURACY = 1e-8
"""Relative accuracy of modes' values."""


@record
class Inverse:
    """A structure some of whose rows act, as they are in a state that it moves about."""

    structure: Factorised  # the structure
    active: Booleans  # which rows act (M,), in both directions
    motions: Array  # what nothing resists (n, k), orthonormal: it is left out
    _law: Array

    @classmethod
    def of(cls, structure: Factorised, active: Booleans, motions: Array) -> Inverse:
        """The same, prepared, of rows that are active (M,) and free motions (n, k)."""
        return cls(structure, active, motions, structure.law(active))

    def solve(self, loads: Array) -> Array:
        """Displacements (n,) under loads (n,) without those along free motions."""
        structure = self.structure
        direct = structure.quick_solve(loads - self.motions @ (self.motions.T @ loads))
        moved = direct + structure.spread @ (self._law @ (structure.rows @ direct))
        return np.asarray(moved - self.motions @ (self.motions.T @ moved))

    def stiffness(self, moved: Array) -> Array:
        """Forces (n,) of a structure that is moved (n,) as rows which act allow."""
        return np.asarray(self.structure.soft_stiffness(moved, self.active))


def largest(inverse: Inverse, apply: Callable[[Array], Array], count: int) -> tuple[Array, Array]:
    """Largest values (count,) of a matrix relative to the stiffness, and their vectors (n, count).

    apply: Products of the symmetric matrix with vectors (n,).
    """
    from scipy.sparse.linalg import LinearOperator, eigsh

    size = len(inverse.structure.free)
    start = inverse.solve(np.random.default_rng(SEED).standard_normal(size))
    matrix, stiffness, solved = (
        LinearOperator((size, size), matvec=each, dtype=np.float64)
        for each in (apply, inverse.stiffness, inverse.solve)
    )
    values, vectors = eigsh(
        matrix, count, M=stiffness, Minv=solved, which="LA", v0=start, tol=ACCURACY
    )
    order = np.argsort(values)[::-1]
    return values[order], vectors[:, order]


def find_frequencies(inverse: Inverse, mass: Array, count: int) -> tuple[Array, Array]:
    """Lowest frequencies (count,) but those of free motions, and their modes (n, count) (Hz).

    mass: Of every free degree of freedom (n,), in force by acceleration in the unit of the sheet.
    """
    free = inverse.motions
    heavy = mass[:, None] * free
    held_back = np.linalg.solve(free.T @ heavy, heavy.T) if free.size else heavy.T

    def apply(moved: Array) -> Array:
        # Without the free motions' share, so that what is left is in balance.
        bare = moved - free @ (held_back @ moved)
        return np.asarray(mass * bare - heavy @ (held_back @ bare))

    values, modes = largest(inverse, apply, count)
    return 1 / np.sqrt(values) / (2 * np.pi), modes - free @ (held_back @ modes)


NEVER = 1e-9
"""Factors above the inverse of this are none."""


def geometric_stiffness(facets: Facets, forces: Array, count: int) -> csr_array:
    """The matrix (D, D) of triangles that turn under membrane forces.

    Displacements are linear in a triangle; dofs begin with those of nodes.

    forces: Along x, along y and in shear (T, 3), in a triangle's axes (force per length).
    count: Number of all dofs D.
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

    points: Nodes (N, 3).
    pairs: Nodes (m, 2) between which they are.
    pulls: With which force they pull (m,); struts push, less than 0 (N).
    count: Number of all dofs D.
    """
    away = points[pairs[:, 1]] - points[pairs[:, 0]]
    length = np.linalg.norm(away, axis=1)
    along = away / length[:, None]
    across = np.eye(3) - along[:, :, None] * along[:, None]
    block = (pulls / length)[:, None, None] * across
    elements = np.concatenate(
        [np.concatenate([block, -block], axis=2), np.concatenate([-block, block], axis=2)], axis=1
    )
    dofs = 3 * pairs[:, :, None] + np.arange(3)
    return assemble(elements, dofs.reshape(-1, 6), count)


def find_buckling(inverse: Inverse, geometric: csr_array) -> tuple[float, Array] | None:
    """The factor at which the shell buckles, and the mode (n,); None if it does not.

    geometric: K_g (n, n) of free dofs.
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
    dofs = 3 * nodes[:, :, None] + np.arange(3)
    return assemble(elements, dofs.reshape(-1, 3 * size), count)
