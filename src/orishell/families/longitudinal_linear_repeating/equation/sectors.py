"""The four sector angles that a column of the tessellation is made of.

They are kept as deviations from the right angle: where all are near 90 degrees, fold angles depend
on the ratios of the deviations, and these keep their digits.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.errors import InputError
from orishell.numerics.arrays import Array

NAMES = ("alpha", "beta", "gamma", "delta")


@dataclass(frozen=True, slots=True)
class Sectors:
    """Deviations of a column's four sector angles from pi/2, in (-pi/2, pi/2) (radians).

    Red in the paper's Figure 3(a) for column 1.

    Parameters
    ----------
    alpha, beta
        Of F vertices, which are flat-foldable: (LU, LD, RD, RU) is
        (pi - beta, alpha, beta, pi - alpha).
    gamma, delta
        Of S vertices, whose column creases are straight: (LU, LD, RD, RU) is
        (pi - delta, delta, gamma, pi - gamma).
    """

    alpha: float
    beta: float
    gamma: float
    delta: float

    @classmethod
    def of(cls, deviations: ArrayLike) -> Sectors:
        """From deviations (4,)."""
        return cls(*(float(angle) for angle in np.asarray(deviations)))

    @classmethod
    def from_degrees(cls, angles: ArrayLike) -> Sectors:
        """From the angles alpha, beta, gamma, delta (4,) in degrees.

        Raises
        ------
        InputError
            If there are not four, or one is not between 0 and 180 degrees.
        """
        degrees = np.asarray(angles, dtype=np.float64)
        if degrees.shape != (4,):
            raise InputError(
                "a column has four sector angles", got=f"{degrees.size}", expected=", ".join(NAMES)
            )
        for name, angle in zip(NAMES, degrees, strict=True):
            if not 0 < angle < 180:
                raise InputError(
                    f"the sector angle {name} is out of range",
                    got=f"{angle:g} degrees",
                    expected="an angle between 0 and 180 degrees, both left out",
                )
        return cls.of(np.deg2rad(degrees - 90))

    @property
    def deviations(self) -> Array:
        """Deviations from pi/2 (4,) (radians)."""
        return np.array([self.alpha, self.beta, self.gamma, self.delta])

    @property
    def degrees(self) -> list[float]:
        """The four angles in degrees."""
        return [float(angle) for angle in 90 + np.rad2deg(self.deviations)]

    @property
    def opposite(self) -> Sectors:
        """Sectors of the column that continues this one as a parallel strip.

        They solve equation (4) for any input, with c = -1: the degenerate solution.
        """
        return Sectors.of(-self.deviations[[1, 0, 3, 2]])
