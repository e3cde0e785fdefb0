"""The variants of a design as points of a unit cube: one side for each variable."""

from __future__ import annotations

import itertools
import json
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from orishell.conventions.formatting import rounded
from orishell.conventions.record import record
from orishell.design_file.search import Range
from orishell.design_file.tables import Values, value_at
from orishell.numerics.arrays import Array

DIGITS = 6
"""Digits of numbers that are chosen, from the first one of their range on."""
LONGEST = 15
"""Significant digits of a number."""
ENDS = 1e-9
"""Share of a step by which rounding may pass the end of a range."""


@dataclass(frozen=True, slots=True)
class Interval:
    """All numbers from one to another."""

    # the ends
    low: float
    high: float

    def value(self, share: float) -> float:
        """The number next to a share of the way from low to high."""
        number = rounded(float(self._numbers(np.float64(share))), LONGEST)
        return min(max(number, self.low), self.high)

    def snapped(self, shares: Array) -> Array:
        """The shares of the numbers that are next to shares of the way."""
        snapped: Array = (self._numbers(shares) - self.low) / (self.high - self.low)
        return snapped

    def share(self, value: Any) -> float | None:
        """Where a value lies; None if it is none of these."""
        fits = isinstance(value, int | float) and self.low <= value <= self.high
        return (value - self.low) / (self.high - self.low) if fits else None

    def _numbers(self, shares: Any) -> Any:
        step = 10.0 ** (math.floor(math.log10(self.high - self.low)) + 1 - DIGITS)
        numbers = np.round((self.low + shares * (self.high - self.low)) / step) * step
        return np.clip(numbers, self.low, self.high)


@dataclass(frozen=True, slots=True)
class Choices:
    """Single values."""

    # the values, in an order in which neighbours are alike, if there is one
    values: tuple[Any, ...]

    def value(self, share: float) -> Any:
        """The value in whose part of the side a share lies."""
        return self.values[int(self._index(np.float64(share)))]

    def snapped(self, shares: Array) -> Array:
        """The middle of the part of the side in which each share lies."""
        middles: Array = (self._index(shares) + 0.5) / len(self.values)
        return middles

    def share(self, value: Any) -> float | None:
        """Where a value lies; None if it is none of these."""
        return (self.values.index(value) + 0.5) / len(self.values) if value in self.values else None

    def _index(self, shares: Any) -> Any:
        count = len(self.values)
        return np.minimum(np.floor(shares * count), count - 1)


@record
class Space:
    """All variants of a design."""

    axes: dict[str, Interval | Choices]  # what each key may be

    @property
    def count(self) -> float:
        """Number of variants, infinite where a variable may be any number."""
        return math.prod(
            len(axis.values) if isinstance(axis, Choices) else math.inf
            for axis in self.axes.values()
        )

    @property
    def continuous(self) -> list[str]:
        """Keys that may be any number of a range."""
        return [key for key, axis in self.axes.items() if isinstance(axis, Interval)]

    def values(self, point: Array) -> Values:
        """The variant at a point of the unit cube, (variables,)."""
        return {
            key: axis.value(float(share))
            for (key, axis), share in zip(self.axes.items(), point, strict=True)
        }

    def point(self, tables: Any) -> Array | None:
        """The point of the variant that a file itself is, (variables,); None if it is none."""
        shares = []
        for key, axis in self.axes.items():
            value = value_at(tables, key)
            share = None if value is None else axis.share(value)
            if share is None:
                return None
            shares.append(share)
        return np.array(shares)

    def snapped(self, points: Array) -> Array:
        """Points, (count, variables), moved so that equal variants have equal points."""
        return np.column_stack(
            [axis.snapped(points[:, k]) for k, axis in enumerate(self.axes.values())]
        )

    def grid(self) -> Iterator[Values]:
        """All variants; none where a variable may be any number."""
        if self.continuous:
            return iter(())
        sides = [axis.values for axis in self.axes.values() if isinstance(axis, Choices)]
        return (dict(zip(self.axes, each, strict=True)) for each in itertools.product(*sides))


def stepped(range_: Range, *, whole: bool) -> Interval | Choices:
    """The values of a range; ``whole`` where only whole numbers fit."""
    step = 1.0 if whole and range_.step is None else range_.step
    if step is None:
        return Interval(float(range_.low), float(range_.high))
    count = math.floor((range_.high - range_.low) / step + ENDS) + 1
    numbers = (rounded(range_.low + k * step, 12) for k in range(count))
    return Choices(tuple(int(each) if whole else each for each in numbers))


def key_of(values: Values) -> str:
    """What tells a variant from others."""
    return json.dumps(values, sort_keys=True)
