"""Natural frequencies of small motions about a loaded state.

K mode = omega^2 M mode, with the mass of panels lumped at their nodes.
"""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array
from orishell.structure.inverse import Inverse, largest


def find_frequencies(inverse: Inverse, mass: Array, count: int) -> tuple[Array, Array]:
    """Lowest frequencies (count,) but those of free motions, and their modes (n, count) (Hz).

    Parameters
    ----------
    mass
        Of every free freedom (n,), in force by acceleration in the unit of the sheet.
    count
        How many.
    """
    free = inverse.motions
    heavy = mass[:, None] * free
    held_back = np.linalg.solve(free.T @ heavy, heavy.T) if free.size else heavy.T

    def apply(moved: Array) -> Array:
        # Without the free motions' share, so that what is left is in balance.
        bare = moved - free @ (held_back @ moved)
        return np.asarray(mass * bare - heavy @ (held_back @ bare))

    values, modes = largest(inverse, apply, count)
    return 1 / np.sqrt(values) / (2 * np.pi), modes - free @ (held_back @ modes)
