"""Interval arithmetic on arrays.

Rounding (about 1e-13 of a bound) is left out; whoever uses a bound adds that much. Where a function
is undefined or unbounded in an interval, ends are infinite, or nan if nothing is known.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.numerics.arrays import Array


@record
class Interval:
    """Arrays of lower and upper ends.

    Parameters
    ----------
    low, high
        Lower and upper ends (...).
    """

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
