"""The steps from column to column of an orthodiagonal sheet, along f's plane and across it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from orishell.numerics.arrays import Array, Complex


@dataclass(frozen=True, slots=True, eq=False)
class Columns:
    """Steps over the panel columns (n+1,), flaps at both ends."""

    k: Array  # along K
    locked: Array  # along n at lock: l sin eps

    @property
    def step(self) -> Array:
        """Distances (n+1,) between neighbouring columns in the flat sheet."""
        return np.hypot(self.locked, self.k)

    def advance(self, q: Array) -> Array:
        """Distances N (..., n+1) of neighbouring column planes at q = cos(rho/2) (...)."""
        return np.hypot(self.locked, q[..., None] * self.k)


def running(steps: Array) -> Array:
    """Running sums (..., n+2) of steps (..., n+1), zero at column 1."""
    sums = np.cumsum(steps[..., 1:], axis=-1)
    return np.concatenate([-steps[..., :1], np.zeros_like(steps[..., :1]), sums], axis=-1)


def product(turns: Complex) -> Complex:
    """Running products (..., K+1) of numbers (..., K) of modulus 1, beginning with 1."""
    ones = np.ones((*turns.shape[:-1], 1), dtype=np.complex128)
    return np.asarray(np.concatenate([ones, np.cumprod(turns, axis=-1)], axis=-1))
