"""Steps towards closure: the least change of fold angles that closes a sheet, to first order."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from orishell.motion.following.system import Closure
from orishell.numerics.arrays import Array, Booleans

if TYPE_CHECKING:
    from scipy.sparse import csr_array
    from scipy.sparse.linalg import SuperLU

LEAST = 1e-10
"""What is added to normal equations: a motion, which keeps the sheet closed, costs so much."""
CLOSED = 1e-10
"""A state is closed if no vertex misses by more (radians)."""
ENOUGH = 5e-15
"""A state that misses by less is not corrected any more (radians)."""
STEPS = 12
"""Corrections until a state counts as one that cannot be closed."""


class Linearised:
    """The equations about one state, factorised: what fold angles do to closure there.

    In states that are nearly flat the equations across the sheet are smaller than those in its
    plane by the size of fold angles, and are weighed the more.
    """

    def __init__(self, closure: Closure, folds: Array, fixed: Booleans | None = None) -> None:
        self._closure, self._folds, self._fixed = closure, folds, fixed
        left, self._entries = closure.residuals(folds)
        self.residual = float(np.abs(left).max(initial=0.0))
        size = float(np.clip(np.abs(folds).max(initial=0.0), 1e-3, 1.0))
        self._weights = np.tile([1.0, 1.0, 1.0 / size], len(left))
        self._left = left.ravel() * self._weights

    @cached_property
    def _matrix(self) -> csr_array:
        """Derivatives (3 I, N), weighed; 0 by what is fixed."""
        from scipy.sparse import diags_array

        entries = self._entries
        if self._fixed is not None:
            entries = np.where(self._fixed[self._closure.columns], 0.0, entries)
        weighed: csr_array = diags_array(self._weights) @ self._closure.matrix(entries)
        return weighed

    @cached_property
    def _factors(self) -> SuperLU:
        """Of the normal equations."""
        from scipy.sparse import diags_array
        from scipy.sparse.linalg import splu

        normal = self._matrix.T @ self._matrix + diags_array(np.full(len(self._folds), LEAST))
        return splu(
            normal.tocsc(),
            permc_spec="MMD_AT_PLUS_A",
            diag_pivot_thresh=0.0,
            options={"SymmetricMode": True},
        )

    def correction(self, along: Array) -> Array:
        """The least change (N,) of fold angles that closes the sheet, to first order.

        Square to a direction (N,): so far the sheet has moved that way, and so far it stays.
        """
        least, moved = self._factors.solve(
            np.stack([-(self._matrix.T @ self._left), along], axis=1)
        ).T
        across = along @ moved
        return np.asarray(least - moved * (along @ least) / across if across > 0 else least)

    def motion(self, towards: Array) -> Array:
        """The part of a change of fold angles (N,) that keeps the sheet closed, the largest 1."""
        for _ in range(2):
            towards = self._factors.solve(towards)
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
