"""Equation (2): what every column of a parallel repeating sheet carries."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Columns:
    """Locked quantities of equation (2), n columns and n-1 segments, flaps at both ends."""

    tau: Array  # tan(xi_j/2), (n,)
    cos_left: Array  # cosine of the angle between t and the crease to the left, (n,)
    cos_right: Array  # and to the right, (n,)
    slope: Array  # nu of every panel column, (n+1,)
    sines: Array  # sin delta_{2j-1}, (n-1,)
    sines_next: Array  # sin delta_{2j}, (n-1,)
