"""Forces that are nothing but rounding."""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array

NEGLIGIBLE_FORCE = 1e-9
"""Forces no larger than this share of all loads together, or of the largest force, are rounding of
the solution: nothing is borne."""


def borne_by(forces: Array, total: float) -> Array:
    """Forces (K,) of ties or flaps, 0 where they are rounding (N).

    Parameters
    ----------
    total
        The sizes of all loads together (N).
    """
    return np.where(np.abs(forces) > NEGLIGIBLE_FORCE * total, forces, 0.0)
