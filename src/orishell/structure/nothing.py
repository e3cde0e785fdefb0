"""Forces of ties and flaps that are nothing but rounding."""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array

ROUNDING = 1e-9
"""A tie or flap that bears no more than this share of all loads together bears nothing."""


def borne_by(forces: Array, total: float) -> Array:
    """Forces (K,) of ties or flaps, 0 where they are rounding (N).

    Parameters
    ----------
    total
        The sizes of all loads together (N).
    """
    return np.where(np.abs(forces) > ROUNDING * total, forces, 0.0)
