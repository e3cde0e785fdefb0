"""Equation (2): the quantities of every column of a parallel repeating sheet."""

from __future__ import annotations

from dataclasses import field

import numpy as np

from orishell.conventions.record import record
from orishell.families.flap_sheet import ALIKE, other_side
from orishell.numerics.arrays import Array, Complex


@record
class Columns:
    """The quantities of equation (2) at lock, for n columns, n-1 segments and both flaps."""

    tau: Array  # tan(xi_j/2), (n,)
    cos_left: Array  # cosine of the angle between t and the crease to the left, (n,)
    cos_right: Array  # and to the right, (n,)
    slope: Array  # nu of every panel column, (n+1,); the tangent of the stop for flaps
    sines: Array  # sin delta_{2j-1}, (n-1,)
    sines_next: Array  # sin delta_{2j}, (n-1,)
    existing: slice  # the panel columns but for missing flaps
    rest: float = field(init=False)  # the slope of the tightest of those that exist
    slope_beyond: Array = field(init=False)  # sqrt(nu**2 - rest**2) of every panel column, (n+1,)
    tau_beyond: Array = field(init=False)  # sqrt(tau**2 - rest**2) of every column, (n,)

    def __post_init__(self) -> None:
        nearly = int(self.slope[self.existing].argmin()) + self.existing.start
        squares, _ = self._squares_beyond(nearly)
        tightest = int(squares[self.existing].argmin()) + self.existing.start
        squares, lost = self._squares_beyond(tightest)
        rest = float(self.slope[tightest])
        slope = np.sqrt(np.where(squares > lost, squares, 0.0))
        slope = np.where(self.slope > 2 * rest, other_side(self.slope, rest), slope)
        # The same from both of its creases; those to the right of the last column may not exist.
        tau = np.hypot(self.tau * self.cos_right, slope[1:])
        tau[-1] = np.hypot(self.tau[-1] * self.cos_left[-1], slope[-2])
        tau = np.where(self.tau > 2 * rest, other_side(self.tau, rest), tau)
        object.__setattr__(self, "rest", rest)
        object.__setattr__(self, "slope_beyond", slope)
        object.__setattr__(self, "tau_beyond", tau)

    def _squares_beyond(self, start: int) -> tuple[Array, Array]:
        """nu**2 (n+1,) less that of a panel column, and what is as good as nothing of it.

        Squares of slopes that differ by less than a half of them would lose it, so what they change
        by at each column is summed, in the form that loses less:

            nu_{j+1}**2 - nu_j**2 = tau_j**2 (cos_left_j**2 - cos_right_j**2).
        """
        left, right = self.tau * np.abs(self.cos_left), self.tau * np.abs(self.cos_right)
        before, after = self.slope[:-1], self.slope[1:]
        upright = left + right < before + after
        one, other = np.where(upright, (left, right), (after, before))
        size = np.where(upright, self.tau, one + other) * (one + other)
        squares = running_sums((one - other) * (one + other), start)
        return squares, ALIKE * np.abs(running_sums(size, start))


def turned(tau: Array, cosine: Array, sine: Array, w: Array, gain: Array) -> Complex:
    """exp(i (eps - delta)); ``gain`` is w - tau sin(delta)."""
    return _unit(tau * cosine**2 + w * sine + 1j * (cosine * gain))


def running_sums(steps: Array, start: int) -> Array:
    """Running sums (K+1,) of steps (K,) from a place on, where they are 0."""
    return np.concatenate([-np.cumsum(steps[:start][::-1])[::-1], [0.0], np.cumsum(steps[start:])])


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
