"""How fast the creases of a flat-foldable sheet fold."""

from __future__ import annotations

import numpy as np

from orishell.families.shared.chains import Rates
from orishell.numerics.arrays import Array


def tangent_rates(m: Array, start: Array, stop: Array) -> Rates:
    """Rates of creases with shares m (K,) in (0, 1], between drives (S,).

    With m the tangent of half the fold angle by the largest, c and s of half the drive:
    rho' = m/(c^2 + m^2 s^2), which grows with the drive, and rho'' = m (1 - m^2) s c/(...)^2.
    """
    m = m[:, None]
    # rho'' is largest where m^2 u^4 - 3 (1 - m^2) u^2 - 1 = 0, u the tangent of half the drive.
    k = 3 * (1 - m * m)
    top = 2 * np.arctan(np.sqrt((k + np.sqrt(k * k + 4 * m * m)) / (2 * m * m)))
    at = np.clip(top, start, stop)

    def size(drive: Array) -> tuple[Array, Array]:
        c, s = np.cos(0.5 * drive), np.sin(0.5 * drive)
        base = c * c + (m * s) ** 2
        return m / base, m * (1 - m * m) * s * c / base**2

    # It has one maximum, so that it is largest there, or at the end that is nearest to it.
    return Rates(size(start)[0], size(stop)[0], size(at)[1])
