"""Linear buckling, and natural frequencies of small motions about a loaded state.

K mode = omega^2 M mode, with the mass of panels lumped at their nodes.

With K_g the stiffness that forces in the plane of triangles, in ties and in flaps have by turning,

    (K + factor K_g) mode = 0.

Ties, flaps and feet that act under the load are taken to go on active.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.structure.mesh.elements import assemble
from orishell.structure.solve.factorised import Factorised
from orishell.structure.solve.krylov import Apply, largest_values

if TYPE_CHECKING:
    from scipy.sparse import csr_array

SEED = 0
SPARE = 2
"""Vectors of a block beyond the values that are asked for."""
BLOCKS = 80
"""Krylov's iteration is given up after so many blocks: what it has not found by then is none. A
shell that is pulled all over has no positive value to find, and many just below 0."""
LOOSE = 1e-4
"""Modes that are off by more than this share by energy are none that are found."""


@record
class Inverse:
    """A structure some of whose rows act, as they are in a state that it moves about."""

    structure: Factorised  # the structure
    active: Booleans  # which rows act (M,), in both directions
    motions: Array  # what nothing resists (n, k), orthonormal: it is left out
    _law: Array

    @classmethod
    def of(cls, structure: Factorised, active: Booleans, motions: Array) -> Inverse:
        """The structure, prepared, with rows that are active (M,) and free motions (n, k)."""
        return cls(structure, active, motions, structure.reaction_operator(active))

    def solve(self, loads: Array) -> Array:
        """Displacements (n, p) under loads (n, p) without those along free motions."""
        structure = self.structure
        direct = structure.quick_solve(loads - self.motions @ (self.motions.T @ loads))
        moved = direct + structure.spread @ (self._law @ (structure.rows @ direct))
        return np.asarray(moved - self.motions @ (self.motions.T @ moved))

    def stiffness(self, moved: Array) -> Array:
        """Forces (n, p) of a structure that is moved (n, p) as rows which act allow."""
        return np.asarray(self.structure.soft_stiffness(moved, self.active))


def largest(inverse: Inverse, apply: Apply, count: int) -> tuple[Array, Array]:
    """Largest values (k,) of a matrix relative to the stiffness, and their vectors (n, k).

    Those that are found: maybe fewer, if most are about 0.

    apply: Products of the symmetric matrix with vectors (n, p).
    count: Number k of values.
    """
    size = len(inverse.structure.free)
    start = np.random.default_rng(SEED).standard_normal((size, min(count + SPARE, size)))
    values, vectors, errors = largest_values(
        inverse.solve, inverse.stiffness, apply, start, count, blocks=BLOCKS
    )
    found = errors <= LOOSE * np.abs(values)
    return values[found], vectors[:, found]


def find_frequencies(inverse: Inverse, mass: csr_array, count: int) -> tuple[Array, Array]:
    """Lowest frequencies (count,) but those of free motions, and their modes (n, count) (Hz).

    mass: Of free dofs (n, n), in force by acceleration in the unit of the sheet.
    """
    free = inverse.motions
    heavy = np.asarray(mass @ free)
    held_back = np.linalg.solve(free.T @ heavy, heavy.T) if free.size else heavy.T

    def apply(moved: Array) -> Array:
        # Without the free motions' share, so that what is left is in balance.
        bare = moved - free @ (held_back @ moved)
        return np.asarray(mass @ bare - heavy @ (held_back @ bare))

    values, modes = largest(inverse, apply, count)
    return 1 / np.sqrt(values) / (2 * np.pi), modes - free @ (held_back @ modes)


NEVER = 1e-9
"""Factors above the inverse of this are none."""


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


def find_buckling(inverse: Inverse, geometric: csr_array, count: int) -> tuple[Array, Array]:
    """The lowest factors (at most count) at which the shell buckles, and their modes (n, k).

    Fewer, or none, if it buckles in no more ways.

    geometric: K_g (n, n) of free dofs.
    """
    if not geometric.count_nonzero():  # nothing is loaded
        return np.zeros(0), np.zeros((len(inverse.structure.free), 0))
    values, modes = largest(inverse, lambda moved: -(geometric @ moved), count)
    buckles = values > NEVER
    return 1 / values[buckles], modes[:, buckles]
