"""Elementary functions with their first two derivatives, at numbers and over intervals.

One table serves both: over an interval a function, or a derivative, has its extremes at the ends
and where it turns. Where a function is not defined throughout an interval nothing is known of it,
nor of the second derivative where the first one jumps.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans
from orishell.numerics.enclosure import Enclosure, Interval

Jet: TypeAlias = tuple[Array, Array, Array]
"""Value, first and second derivative, each of the shape of the variable."""


@record
class Elementary:
    """A function of one argument."""

    jet: Callable[[Array], Jet]  # value and two derivatives at arguments (...); nan if undefined
    over: Callable[[Interval], Enclosure]  # bounds of all three over intervals (...) of arguments

    def of(self, inner: Enclosure) -> Enclosure:
        """The function of ``inner``, by the chain rule."""
        return self.over(inner.value).of(inner)


Turns: TypeAlias = tuple[float, ...]


def _smooth(
    jet: Callable[[Array], Jet],
    value: Turns = (),
    first: Turns = (),
    second: Turns = (),
    *,
    period: float | None = None,
    defined: Callable[[Interval], Booleans] | None = None,
) -> Elementary:
    """A function, the arguments at which it and its derivatives turn, and where it is defined.

    With a ``period`` they turn again after each. What is nan at an end is nan over the interval.
    """
    turns = [
        [(turn, jet(np.asarray(turn))[k]) for turn in each]
        for k, each in enumerate((value, first, second))
    ]

    def over(v: Interval) -> Enclosure:
        found = []
        for begin, end, extremes in zip(jet(v.low), jet(v.high), turns, strict=True):
            low, high = np.asarray(np.minimum(begin, end)), np.asarray(np.maximum(begin, end))
            for turn, extreme in extremes:
                within = (v.low < turn) & (turn < v.high) if not period else _meets(v, turn, period)
                np.minimum(low, extreme, out=low, where=within)
                np.maximum(high, extreme, out=high, where=within)
            found.append(Interval(low, high))
        result = Enclosure(*found)
        if defined is None:
            return result
        known = defined(v)
        return result.each(lambda interval: _known(known, interval))

    return Elementary(jet, over)


def _known(where: Booleans, interval: Interval) -> Interval:
    return interval.through(lambda ends: np.where(where, ends, np.nan))


def _meets(v: Interval, start: float, period: float) -> Booleans:
    """Whether an interval holds a value of start + period * k, k a whole number."""
    last = np.floor((v.high - start) / period)
    return np.asarray(last >= np.ceil((v.low - start) / period))


def _sin(v: Array) -> Jet:
    s, c = np.sin(v), np.cos(v)
    return s, c, -s


def _cos(v: Array) -> Jet:
    s, c = np.sin(v), np.cos(v)
    return c, -s, -c


def _tan(v: Array) -> Jet:
    t = np.tan(v)
    return t, 1 + t * t, 2 * t * (1 + t * t)


def _asin(v: Array) -> Jet:
    r = 1 / np.sqrt(1 - v * v)
    return np.arcsin(v), r, v * r**3


def _acos(v: Array) -> Jet:
    r = 1 / np.sqrt(1 - v * v)
    return np.arccos(v), -r, -v * r**3


def _atan(v: Array) -> Jet:
    r = 1 / (1 + v * v)
    return np.arctan(v), r, -2 * v * r * r


def _sinh(v: Array) -> Jet:
    s, c = np.sinh(v), np.cosh(v)
    return s, c, s


def _cosh(v: Array) -> Jet:
    s, c = np.sinh(v), np.cosh(v)
    return c, s, c


def _tanh(v: Array) -> Jet:
    t = np.tanh(v)
    return t, 1 - t * t, -2 * t * (1 - t * t)


def _exp(v: Array) -> Jet:
    y = np.exp(v)
    return y, y, y


def _log(v: Array) -> Jet:
    return np.log(v), 1 / v, -1 / (v * v)


def _sqrt(v: Array) -> Jet:
    y = np.sqrt(v)
    return y, 0.5 / y, -0.25 / (v * y)


def _abs(v: Array) -> Jet:
    return np.abs(v), np.sign(v), np.zeros_like(v)


def _abs_over(v: Interval) -> Enclosure:
    kink = (v.low < 0) & (v.high > 0)
    value = Interval.between(np.abs(v.low), np.abs(v.high))
    # At the end of an interval the derivative is that of its inside.
    first = Interval.between(np.where(v.low < 0, -1.0, 1.0), np.where(v.high > 0, 1.0, -1.0))
    second = np.where(kink, np.nan, np.zeros_like(v.low))
    result = Enclosure(
        Interval(np.where(kink, 0.0, value.low), value.high), first, Interval(second, second)
    )
    return result.each(lambda interval: _known(v.low <= v.high, interval))


_QUARTERS, _HALVES, _THIRD = (-np.pi / 2, np.pi / 2), (0.0, np.pi), 1 / np.sqrt(3.0)

FUNCTIONS: dict[str, Elementary] = {
    "sin": _smooth(_sin, _QUARTERS, _HALVES, _QUARTERS, period=2 * np.pi),
    "cos": _smooth(_cos, _HALVES, _QUARTERS, _HALVES, period=2 * np.pi),
    "tan": _smooth(
        _tan, first=(0.0,), period=np.pi, defined=lambda v: ~_meets(v, np.pi / 2, np.pi)
    ),
    "asin": _smooth(_asin, first=(0.0,)),
    "acos": _smooth(_acos, first=(0.0,)),
    "atan": _smooth(_atan, first=(0.0,), second=(-_THIRD, _THIRD)),
    "sinh": _smooth(_sinh, first=(0.0,)),
    "cosh": _smooth(_cosh, (0.0,), second=(0.0,)),
    "tanh": _smooth(_tanh, first=(0.0,), second=(-np.arctanh(_THIRD), np.arctanh(_THIRD))),
    "exp": _smooth(_exp),
    "log": _smooth(_log, defined=lambda v: v.low > 0),
    "sqrt": _smooth(_sqrt),
    "abs": Elementary(_abs, _abs_over),
}
"""The functions of formulas."""


def power(exponent: float) -> Elementary:
    """The power of a constant exponent; derivatives of a constant or linear term are exactly 0.

    Parameters
    ----------
    exponent
        Any number; with a fraction, the power is defined for arguments that are not negative.
    """
    n = exponent
    terms = (1.0, n), (n, n - 1), (n * (n - 1), n - 2)

    def jet(v: Array) -> Jet:
        value, first, second = (
            factor * v**rank if factor != 0 else np.zeros_like(v) for factor, rank in terms
        )
        return value, first, second

    return Elementary(jet, lambda v: Enclosure(*(_term(*each, v) for each in terms)))


def _term(factor: float, rank: float, v: Interval) -> Interval:
    """The range of factor * v**rank."""
    if factor == 0 or rank == 0:
        return Interval(np.asarray(factor), np.asarray(factor))
    ends = Interval.between(v.low**rank, v.high**rank)
    within = (v.low < 0) & (v.high > 0)
    if rank % 1:
        ends = _known(v.low >= 0, ends)
    elif rank < 0:
        ends = _known((v.low > 0) | (v.high < 0), ends)
    elif rank % 2 == 0:
        ends = Interval(np.where(within, 0.0, ends.low), ends.high)
    return ends.times(factor)
