"""Elements: what joins a few nodes elastically, assembled into a matrix, or asked for its forces.

A shell that swings far strains its panels little. What a panel is moved as a whole costs no force,
but entries of the assembled matrix are rounded, and cancel for no motion exactly: forces by that
matrix miss its entries times whole displacements times 1e-16, which in a shell of thin panels on
free hinges is 1e-9 of its loads. So forces are found element by element, as it is moved seen from
its own first corner: what is left of displacements there are strains, and rounding is by them.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers

if TYPE_CHECKING:
    from scipy.sparse import csr_array

CHUNK = 1_500_000
"""Numbers that are worked on together, at most."""


@record
class Elements:
    """Elements of one kind."""

    matrices: Array  # their stiffness (T, k, k)
    # their dofs (T, k), those of the first corner first: displacements, if they have any, then
    # rotations
    dofs: Integers
    # from the first corner to each of the others (T, c - 1, 3); None if they have no displacements
    arms: Array | None
    count: int  # number of all dofs D
    # the triangle of a panel (T,) that each is beside, if it has dofs that no panel has
    beside: Integers | None = None

    def assembled(self) -> csr_array:
        """The matrix (D, D) of all."""
        return assemble(self.matrices, self.dofs, self.count)

    def forces(self, moved: Array) -> Array:
        """Forces (T, k) that move them.

        moved: Displacements and rotations (D,).
        """
        width = 3 if self.arms is None else 6
        own = moved[self.dofs].reshape(len(self.dofs), -1, width)
        seen = own[:, 1:] - own[:, :1]
        if self.arms is not None:
            seen[..., :3] -= np.cross(own[:, :1, 3:], self.arms)
        strained = seen.reshape(len(seen), -1, 1)
        others = (self.matrices[:, width:, width:] @ strained).reshape(seen.shape)
        first = -others.sum(axis=1, keepdims=True)
        if self.arms is not None:
            first[:, 0, 3:] -= np.cross(self.arms, others[..., :3]).sum(axis=1)
        return np.concatenate([first, others], axis=1).reshape(self.dofs.shape)

    def total(self, moved: Array) -> Array:
        """Forces (D,) on all dofs of all elements that are moved (D,)."""
        found = np.bincount(self.dofs.ravel(), self.forces(moved).ravel(), self.count)
        return np.asarray(found, dtype=np.float64)


def assemble(elements: Array, dofs: Integers, count: int) -> csr_array:
    """The matrix (D, D) of elements.

    elements: Their matrices (T, k, k).
    dofs: Their dofs (T, k).
    count: Number of all dofs D.
    """
    from scipy.sparse import coo_array, csr_array

    size, place = dofs.shape[1], dofs.astype(np.int32)
    total = csr_array((count, count))
    for some in chunks(len(dofs), size**2):
        rows = np.repeat(place[some], size, axis=1).ravel()
        columns = np.tile(place[some], (1, size)).ravel()
        entries = elements[some].ravel(), (rows, columns)
        total = total + coo_array(entries, shape=(count, count)).tocsr()
    return total


def chunks(count: int, size: int) -> Iterator[slice]:
    """Parts of so many matrices of so many numbers, none larger than is quick to work on."""
    many = max(1, CHUNK // size)
    return (slice(first, first + many) for first in range(0, count, many))
