"""Equation (2): the quantities of every column of a parallel repeating sheet."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from orishell.conventions.formatting import in_one_line
from orishell.families.flap_sheet import other_side
from orishell.numerics.arrays import Array, Complex


@dataclass(frozen=True, slots=True, eq=False)
class Columns:
    """The quantities of equation (2) at lock, for n columns, n-1 segments and both flaps."""

    tau: Array  # tan(xi_j/2), (n,)
    cos_left: Array  # cosine of the angle between t and the crease to the left, (n,)
    cos_right: Array  # and to the right, (n,)
    slope: Array  # nu of every panel column, (n+1,); the tangent of the stop for flaps
    sines: Array  # sin delta_{2j-1}, (n-1,)
    sines_next: Array  # sin delta_{2j}, (n-1,)
    rest: float  # the smallest slope of the panel columns that exist

    __repr__ = in_one_line

    @property
    def slope_beyond(self) -> Array:
        """sqrt(nu**2 - rest**2) of every panel column (n+1,)."""
        return other_side(self.slope, self.rest)

    @property
    def tau_beyond(self) -> Array:
        """sqrt(tau**2 - rest**2) of every column (n,)."""
        return other_side(self.tau, self.rest)


def turned(tau: Array, cosine: Array, sine: Array, w: Array, gain: Array) -> Complex:
    """exp(i (eps - delta)); ``gain`` is w - tau sin(delta)."""
    return _unit(tau * cosine**2 + w * sine + 1j * (cosine * gain))


def from_middle(steps: Array) -> Array:
    """Running sums (K+1,) of steps (K,), K even, zero in the middle."""
    half = len(steps) // 2
    return np.concatenate([-np.cumsum(steps[:half][::-1])[::-1], [0.0], np.cumsum(steps[half:])])


def interleaved(z: Complex) -> Array:
    """(..., n) complex numbers as (..., 3 n) coordinates x, y, 0."""
    coordinates = np.zeros((*z.shape, 3))
    coordinates[..., 0], coordinates[..., 1] = z.real, z.imag
    return coordinates.reshape(*z.shape[:-1], -1)


def _unit(z: Complex) -> Complex:
    """Numbers of modulus 1; exactly 1 where z is real and positive (complex division is not)."""
    size = np.hypot(z.real, z.imag)
    unit = np.empty_like(z)
    unit.real, unit.imag = z.real / size, z.imag / size
    return unit
