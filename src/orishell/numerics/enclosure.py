"""Interval arithmetic on arrays, and enclosures of a function and its first two derivatives.

Rounding (about 1e-13 of a bound) is left out; whoever uses a bound adds that much. Where a function
is undefined or unbounded in an interval, ends are infinite, or nan if nothing is known.

The variable is the drive of a motion or the parameter of a curve. Every function is taken through
its monotone pieces, so that the bounds are met as the ranges shrink.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.numerics.arrays import Array


@record
class Interval:
    """Arrays of lower and upper ends."""

    # lower and upper ends (...)
    low: Array
    high: Array

    @classmethod
    def between(cls, first: ArrayLike, second: ArrayLike) -> Interval:
        """From ends ``first`` and ``second`` (...) in any order, as of a monotone function."""
        return cls(np.minimum(first, second), np.maximum(first, second))

    def through(self, rising: Callable[[Array], Array]) -> Interval:
        """Return the range (...) that a ``rising`` function takes the two ends to."""
        return Interval(rising(self.low), rising(self.high))

    def __add__(self, other: Interval) -> Interval:
        return Interval(self.low + other.low, self.high + other.high)

    def __sub__(self, other: Interval) -> Interval:
        return Interval(self.low - other.high, self.high - other.low)

    def __mul__(self, other: Interval) -> Interval:
        ends = (
            self.low * other.low,
            self.low * other.high,
            self.high * other.low,
            self.high * other.high,
        )
        return Interval(
            np.minimum(np.minimum(ends[0], ends[1]), np.minimum(ends[2], ends[3])),
            np.maximum(np.maximum(ends[0], ends[1]), np.maximum(ends[2], ends[3])),
        )

    def over(self, positive: Interval) -> Interval:
        """Quotient by a ``positive`` interval, one above zero."""
        return self * Interval(1 / positive.high, 1 / positive.low)

    def times(self, factor: Array | float) -> Interval:
        """Product with a known ``factor`` (...)."""
        return Interval.between(self.low * factor, self.high * factor)

    def plus(self, shift: Array | float) -> Interval:
        """Sum with a known ``shift`` (...)."""
        return self.through(lambda ends: ends + shift)

    def squared(self) -> Interval:
        """The intervals of the squares."""
        low, high = self.low**2, self.high**2
        within = (self.low < 0) & (self.high > 0)
        return Interval(np.where(within, 0.0, np.minimum(low, high)), np.maximum(low, high))

    def magnitude(self) -> Array:
        """The largest absolute values (...)."""
        return np.asarray(np.maximum(np.abs(self.low), np.abs(self.high)))


@record
class Enclosure:
    """Intervals for a function and its first and second derivative."""

    # intervals (...) of the function and of its first and second derivative
    value: Interval
    first: Interval
    second: Interval

    @classmethod
    def constant(cls, value: float) -> Enclosure:
        """The number ``value``, for all ranges alike."""
        exact, zero = np.asarray(value), np.zeros(())
        flat = Interval(zero, zero)
        return cls(Interval(exact, exact), flat, flat)

    @classmethod
    def variable(cls, low: Array, high: Array) -> Enclosure:
        """The variable itself, from ``low`` to ``high`` (S,)."""
        one, zero = np.ones_like(low), np.zeros_like(low)
        return cls(Interval(low, high), Interval(one, one), Interval(zero, zero))

    @classmethod
    def half_cosine(cls, start: Array, stop: Array) -> Enclosure:
        """cos(drive/2) for drives from ``start`` to ``stop`` (S,), in [0, pi] (radians)."""
        cosine, sine = _half_angle(start, stop)
        return cls(cosine, sine.times(-0.5), cosine.times(-0.25))

    @classmethod
    def half_sine(cls, start: Array, stop: Array) -> Enclosure:
        """sin(drive/2) for drives from ``start`` to ``stop`` (S,), in [0, pi] (radians)."""
        cosine, sine = _half_angle(start, stop)
        return cls(sine, cosine.times(0.5), sine.times(-0.25))

    def each(self, function: Callable[[Interval], Interval]) -> Enclosure:
        """Apply an operation to the intervals of the function and of both derivatives."""
        return Enclosure(function(self.value), function(self.first), function(self.second))

    def __add__(self, other: Enclosure) -> Enclosure:
        return Enclosure(
            self.value + other.value, self.first + other.first, self.second + other.second
        )

    def __sub__(self, other: Enclosure) -> Enclosure:
        return Enclosure(
            self.value - other.value, self.first - other.first, self.second - other.second
        )

    def __mul__(self, other: Enclosure) -> Enclosure:
        cross = self.first * other.first
        return Enclosure(
            self.value * other.value,
            self.first * other.value + self.value * other.first,
            self.second * other.value + cross.times(2.0) + self.value * other.second,
        )

    def times(self, factor: Array | float) -> Enclosure:
        """Product with a known ``factor`` (...)."""
        return self.each(lambda interval: interval.times(factor))

    def plus(self, shift: Array | float) -> Enclosure:
        """Sum with a known ``shift`` (...)."""
        return Enclosure(self.value.plus(shift), self.first, self.second)

    def mirrored(self) -> Enclosure:
        """The function of the variable with its sign changed."""
        return Enclosure(self.value, self.first.times(-1.0), self.second)

    def hypot(self, side: Array) -> Enclosure:
        """sqrt(side**2 + u**2) of this u, not negative, and a known ``side`` (...)."""
        low, high = np.hypot(side, self.value.low), np.hypot(side, self.value.high)
        ones = np.ones_like(low)
        outer = Enclosure(
            Interval(low, high),
            Interval(
                np.divide(self.value.low, low, out=ones.copy(), where=low > 0),
                np.divide(self.value.high, high, out=ones.copy(), where=high > 0),
            ),
            Interval(
                np.divide(side**2, high**3, out=0 * ones, where=high > 0),
                np.divide(side**2, low**3, out=0 * ones, where=low > 0),
            ),
        )
        return outer.of(self)

    def arctan2(self, along: Array) -> Enclosure:
        """Angle of the point (along, u) of this u, not negative, nor 0 where ``along`` is."""
        u = self.value
        square = Interval(along**2 + u.low**2, along**2 + u.high**2)
        first = Interval.between(along / square.high, along / square.low)
        # The second derivative is -2 along u / square**2.
        outer = Enclosure(
            Interval.between(np.arctan2(u.low, along), np.arctan2(u.high, along)),
            first,
            (u.over(square) * first).times(-2.0),
        )
        return outer.of(self)

    def running(self) -> Enclosure:
        """Running sums (..., K+1) along the last axis (..., K), beginning with 0."""

        def of(ends: Array) -> Array:
            zero = np.zeros((*ends.shape[:-1], 1))
            return np.concatenate([zero, np.cumsum(ends, axis=-1)], axis=-1)

        return self.each(lambda interval: interval.through(of))

    def mean(self, weights: Array) -> Enclosure:
        """Weighted sum (..., 1) over the last axis; none of the ``weights`` (K,) is negative."""

        def of(ends: Array) -> Array:
            return np.asarray((ends * weights).sum(axis=-1, keepdims=True))

        return self.each(lambda interval: interval.through(of))

    def part(self, index: slice) -> Enclosure:
        """Entries along the last axis, by their ``index``."""
        return self.each(lambda interval: interval.through(lambda ends: ends[..., index]))

    def of(self, inner: Enclosure) -> Enclosure:
        """Chain rule: this function, which is known over ``inner``'s values, of ``inner``."""
        return Enclosure(
            self.value,
            self.first * inner.first,
            self.second * inner.first.squared() + self.first * inner.second,
        )


def turning_acceleration(length: Enclosure, angle: Enclosure) -> Array:
    """Bounds (...) of the second derivative of a planar vector of this length and direction angle.

    Parameters
    ----------
    length, angle
        Its length, in any unit, and its direction angle (radians).
    """
    along = length.second - length.value * angle.first.squared()
    across = (length.first * angle.first).times(2.0) + length.value * angle.second
    return np.asarray(np.hypot(along.magnitude(), across.magnitude()))


def spinning_acceleration(angle: Enclosure) -> Array:
    """Bounds (...) of the second derivative of a unit vector with this direction angle in a plane.

    Parameters
    ----------
    angle
        The direction angle (radians).
    """
    return np.asarray(np.hypot(angle.first.magnitude() ** 2, angle.second.magnitude()))


def _half_angle(start: Array, stop: Array) -> tuple[Interval, Interval]:
    """Ranges of the cosine and of the sine of half the drives from ``start`` to ``stop`` (S,)."""
    cosine = Interval(np.maximum(np.cos(stop / 2), 0.0), np.cos(start / 2))
    return cosine, Interval(np.sin(start / 2), np.sin(stop / 2))
