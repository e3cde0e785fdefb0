"""Four sector angles, and the solutions of the paper's equation (4) for them, in closed form.

They are kept as deviations from the right angle: where all are near 90 degrees, fold angles depend
on the ratios of the deviations, and these keep their digits.

In deviations from pi/2 (see ``sectors``), with s = (alpha_1 + beta_1)/2 and delta_2 = x - gamma_1,
the degenerate solution, a strip of parallel columns, is x = 0. Divided out of (4) it leaves one
equation linear in tan x: one further solution in either version, or none. With P = sin A sin B and
C = sin(A + B),

    A = delta_1 - s, B = gamma_1 - s in the cosine version, both less pi/2 in the sine version,

    tan delta_2 = (tan gamma_1 sin(delta_1 - gamma_1) - 2 P) / C,
    tan gamma_2 = (tan delta_1 sin(delta_1 - gamma_1) + 2 P) / C,
    c           = sin(delta_1 - gamma_1) cos delta_2 / (C cos gamma_1),

and alpha_2 = x - beta_1, beta_2 = x - alpha_1. It merges with the degenerate solution where
sin A = 0, and only there; c = 0 where gamma_1 = delta_1. Derived in
docs/theory/longitudinal-linear-repeating.md.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, hypot, pi, sin
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.errors import InputError
from orishell.numerics.arrays import Array

NAMES = ("alpha", "beta", "gamma", "delta")


@dataclass(frozen=True, slots=True)
class Sectors:
    """Deviations of a column's four sector angles from pi/2, in (-pi/2, pi/2) (radians).

    Red in the paper's Figure 3(a) for column 1.
    """

    # of F vertices, which are flat-foldable: (LU, LD, RD, RU) is (pi - beta, alpha, beta, pi -
    # alpha)
    alpha: float
    beta: float
    # of S vertices, whose column creases are straight: (LU, LD, RD, RU) is (pi - delta, delta,
    # gamma, pi - gamma)
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


Version = Literal["cosine", "sine"]
VERSIONS: tuple[Version, Version] = ("cosine", "sine")

ANGLE_ROUNDING = 1e-15
"""Sums of four angles that were given in degrees are known to this (radians)."""


@dataclass(frozen=True, slots=True)
class Solution:
    """A solution of equation (4)."""

    version: Version  # which version of the last line of (4) it solves
    # sectors of columns 1 and 2
    first: Sectors
    second: Sectors
    c: float  # tan(v_2/2) / tan(v_1/2), the columns' fold angles, throughout the motion


def find_solutions(first: Sectors, *, inside: bool = True) -> tuple[Solution, ...]:
    """All solutions of (4) but the degenerate one: that of the cosine version, that of the sine.

    Left out are vertices with two straight lines crossing, which fold along one of them alone, and
    angles for which every delta_2 solves (4), see ``is_free``.

    Parameters
    ----------
    inside
        False gives the solutions whose sector angles are not inside (0, pi) instead: sums that
        close no panel.

    Examples
    --------
    >>> found = find_solutions(Sectors.from_degrees([85, 80, 95, 100]))
    >>> [solution.version for solution in found]
    ['cosine', 'sine']
    >>> [round(angle, 2) for angle in found[0].second.degrees]
    [91.23, 86.23, 106.23, 76.23]
    """
    found = (_solve(first, version) for version in VERSIONS)
    limit = pi / 2 - ANGLE_ROUNDING
    return tuple(
        each
        for each in found
        if each is not None and (abs(each.second.deviations).max() < limit) == inside
    )


def is_free(first: Sectors) -> bool:
    """Whether every delta_2 solves (4): gamma_1 = delta_1, and column 2 may be any."""
    merged = min(abs(_products(first, version)[0]) for version in VERSIONS)
    return max(merged, abs(first.gamma - first.delta)) <= ANGLE_ROUNDING


def _products(first: Sectors, version: Version) -> tuple[float, float]:
    """Sin A, and P = sin A sin B."""
    mean = (first.alpha + first.beta) / 2
    if version == "cosine":
        merged, other = sin(first.delta - mean), sin(first.gamma - mean)
    else:
        merged, other = -cos(first.delta - mean), -cos(first.gamma - mean)
    return merged, merged * other


def _solve(first: Sectors, version: Version) -> Solution | None:
    alpha, beta, gamma, delta = first.alpha, first.beta, first.gamma, first.delta
    merged, product = _products(first, version)
    closing = sin(gamma + delta - alpha - beta) * (1 if version == "cosine" else -1)
    still = sin(delta - gamma)
    crossing = gamma + delta, alpha + beta if version == "cosine" else alpha - beta
    if min(abs(each) for each in (merged, closing, still, *crossing)) <= ANGLE_ROUNDING:
        return None
    sign = 1 if closing > 0 else -1
    up = sign * (sin(gamma) * still - 2 * cos(gamma) * product)
    right = cos(gamma) * abs(closing)
    delta_2 = atan2(up, right)
    gamma_2 = atan2(
        sign * (sin(delta) * still + 2 * cos(delta) * product), cos(delta) * abs(closing)
    )
    total = gamma + delta_2
    second = Sectors(total - beta, total - alpha, gamma_2, delta_2)
    return Solution(version, first, second, sign * still / hypot(up, right))
