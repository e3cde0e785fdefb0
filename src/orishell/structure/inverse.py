"""A structure with what acts on it, as a matrix that is only solved with: for its modes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans
from orishell.structure.held import Held

SEED = 0
ACCURACY = 1e-8
"""Relative accuracy of modes' values."""


@record
class Inverse:
    """A structure some of whose rows act, as they are in a state that it moves about.

    Parameters
    ----------
    held
        The structure.
    acting
        Which rows act (M,), in both directions.
    motions
        What nothing resists (n, k), orthonormal: it is left out.
    """

    held: Held
    acting: Booleans
    motions: Array
    _law: Array

    @classmethod
    def of(cls, held: Held, acting: Booleans, motions: Array) -> Inverse:
        """The same, prepared, of rows that are acting (M,) and free motions (n, k)."""
        return cls(held, acting, motions, held.law(acting))

    def solve(self, loads: Array) -> Array:
        """Displacements (n,) under loads (n,) without those along free motions."""
        held = self.held
        direct = held.quick_solve(loads - self.motions @ (self.motions.T @ loads))
        moved = direct + held.spread @ (self._law @ (held.rows @ direct))
        return np.asarray(moved - self.motions @ (self.motions.T @ moved))

    def stiffness(self, moved: Array) -> Array:
        """Forces (n,) of a structure that is moved (n,) as rows which act allow."""
        return np.asarray(self.held.soft_stiffness(moved, self.acting))


def largest(inverse: Inverse, apply: Callable[[Array], Array], count: int) -> tuple[Array, Array]:
    """Largest values (count,) of a matrix relative to the stiffness, and their vectors (n, count).

    Parameters
    ----------
    apply
        Products of the symmetric matrix with vectors (n,).
    count
        How many.
    """
    from scipy.sparse.linalg import LinearOperator, eigsh

    size = len(inverse.held.free)
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
