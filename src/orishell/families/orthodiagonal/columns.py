"""What the columns of an orthodiagonal sheet take along f's plane and along their normal."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True, slots=True, eq=False)
class Columns:
    """Panel columns, flaps at both ends (n+1,)."""

    k: Array  # along K
    locked: Array  # along n at lock: l sin eps

    @property
    def step(self) -> Array:
        """Distance of the columns in the flat sheet."""
        return np.hypot(self.locked, self.k)

    def advance(self, q: Array) -> Array:
        """N (..., n+1), distance of the column planes at q = cos(rho/2) (...)."""
        return np.hypot(self.locked, q[..., None] * self.k)


def running(steps: Array) -> Array:
    """Running sums (..., n+2) of steps (..., n+1), zero at column 1."""
    sums = np.cumsum(steps[..., 1:], axis=-1)
    return np.concatenate([-steps[..., :1], np.zeros_like(steps[..., :1]), sums], axis=-1)


def product(turns: Complex) -> Complex:
    """Running products (..., K+1) of unit numbers (..., K), beginning with 1."""
    ones = np.ones((*turns.shape[:-1], 1), dtype=np.complex128)
    return np.asarray(np.concatenate([ones, np.cumprod(turns, axis=-1)], axis=-1))
