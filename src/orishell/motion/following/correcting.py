"""Steps towards closure: the least change of fold angles that closes a sheet, to first order."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property, partial
from typing import TYPE_CHECKING

import numpy as np

from orishell.motion.following.system import Closure
from orishell.numerics.arrays import Array, Booleans

if TYPE_CHECKING:
    from scipy.sparse import csr_array

REGULARISATION = 1e-10
"""What is added to normal equations, far below their terms: what these leave open, as a motion that
keeps the sheet closed, stays where it is."""
CLOSED = 1e-10
"""A state is closed if no vertex misses by more (radians)."""
ENOUGH = 5e-15
"""A state that misses by less is not corrected any more (radians)."""
DENSE = 150
"""Up to so many creases matrices are dense: the work of sparse ones is not in their entries."""
STEPS = 12
"""Corrections until a state counts as one that cannot be closed."""


class Linearised:
    """The equations about one state, factorised: what fold angles do to closure there.

    In states that are nearly flat some equations are smaller than the others by the size of fold
    angles, and are weighed the more.
    """

    def __init__(self, closure: Closure, folds: Array, fixed: Booleans | None = None) -> None:
        self._closure, self._folds, self._fixed = closure, folds, fixed
        left, self._entries = closure.residuals(folds)
        self.residual = float(np.abs(left).max(initial=0.0))
        size = float(np.clip(np.abs(folds).max(initial=0.0), 1e-3, 1.0))
        self._weights = np.where(closure.quadratic, 1.0 / size, 1.0)
        self._left = left.ravel() * self._weights

    @cached_property
    def _matrix(self) -> csr_array | Array:
        """Derivatives (3 J, N), weighed; 0 by what is fixed."""
        from scipy.sparse import diags_array

        entries = self._entries
        if self._fixed is not None:
            entries = np.where(self._fixed[self._closure.columns], 0.0, entries)
        found = self._closure.matrix(entries)
        if len(self._folds) <= DENSE:
            return np.asarray(self._weights[:, None] * found.toarray())
        weighed: csr_array = diags_array(self._weights) @ found
        return weighed

    @cached_property
    def _solve(self) -> Callable[[Array], Array]:
        """What solves the normal equations, which are factorised once."""
        from scipy.linalg import cho_factor, cho_solve
        from scipy.sparse import diags_array
        from scipy.sparse.linalg import splu

        count, matrix = len(self._folds), self._matrix
        if isinstance(matrix, np.ndarray):
            factors = cho_factor(
                matrix.T @ matrix + REGULARISATION * np.eye(count), check_finite=False
            )
            return partial(cho_solve, factors, check_finite=False)
        normal = matrix.T @ matrix + diags_array(np.full(count, REGULARISATION))
        found = splu(
            normal.tocsc(),
            permc_spec="MMD_AT_PLUS_A",
            diag_pivot_thresh=0.0,
            options={"SymmetricMode": True},
        )
        return found.solve

    def correction(self, along: Array) -> Array:
        """The least change (N,) of fold angles that closes the sheet, to first order.

        Square to a direction (N,): so far the sheet has moved that way, and so far it stays.
        """
        both = np.stack([-(self._matrix.T @ self._left), along], axis=1)
        least, moved = self._solve(both).T
        across = along @ moved
        return np.asarray(least - moved * (along @ least) / across if across > 0 else least)

    def motion(self, towards: Array) -> Array:
        """The part of a change of fold angles (N,) that keeps the sheet closed, the largest 1."""
        for _ in range(2):
            towards = self._solve(towards)
            towards = towards / np.abs(towards).max()
        return towards


def corrected(
    closure: Closure, folds: Array, along: Array, fixed: Booleans | None = None
) -> tuple[Array, float]:
    """A closed state near by, and by how much it misses (radians).

    Parameters
    ----------
    folds
        Fold angles (N,) of the unknowns (radians).
    along
        A direction (N,): they change only square to it.
    fixed
        Which unknowns (N,) do not change.
    """
    best, least = folds, np.inf
    for _ in range(STEPS):
        here = Linearised(closure, folds, fixed)
        if not here.residual < 0.5 * least:
            break
        best, least = folds, here.residual
        if least < ENOUGH:
            break
        folds = folds + here.correction(along)
    return best, least
