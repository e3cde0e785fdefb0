"""Elementary functions over intervals: their values and first two derivatives there.

Where a function is not defined throughout an interval nothing is known of it, nor of the second
derivative where the first one jumps.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from orishell.numerics.arrays import Array, Booleans
from orishell.numerics.enclosure import Enclosure, Interval

Curved = Callable[[Array], Array]


def _known(where: Booleans, interval: Interval) -> Interval:
    return interval.through(lambda ends: np.where(where, ends, np.nan))


def _if_defined(where: Booleans, result: Enclosure) -> Enclosure:
    return result.each(lambda interval: _known(where, interval))


def _bending(function: Curved, v: Interval, turns: tuple[float, ...]) -> Interval:
    """The range of a function that is monotone but for extrema at ``turns``."""
    first, second = function(v.low), function(v.high)
    low, high = np.minimum(first, second), np.maximum(first, second)
    for turn in turns:
        within = (v.low < turn) & (turn < v.high)
        extreme = function(np.asarray(turn))
        low = np.where(within, np.minimum(low, extreme), low)
        high = np.where(within, np.maximum(high, extreme), high)
    return Interval(low, high)


def _meets(v: Interval, start: float, period: float) -> Booleans:
    """Whether an interval holds a value of start + period * k, k a whole number."""
    last = np.floor((v.high - start) / period)
    return np.asarray(last >= np.ceil((v.low - start) / period))


def _cosine(v: Interval) -> Interval:
    ends = Interval.between(np.cos(v.low), np.cos(v.high))
    return Interval(
        np.where(_meets(v, np.pi, 2 * np.pi), -1.0, ends.low),
        np.where(_meets(v, 0.0, 2 * np.pi), 1.0, ends.high),
    )


def _sine(v: Interval) -> Interval:
    ends = Interval.between(np.sin(v.low), np.sin(v.high))
    return Interval(
        np.where(_meets(v, -np.pi / 2, 2 * np.pi), -1.0, ends.low),
        np.where(_meets(v, np.pi / 2, 2 * np.pi), 1.0, ends.high),
    )


def _sin(v: Interval) -> Enclosure:
    s = _sine(v)
    return Enclosure(s, _cosine(v), s.times(-1.0))


def _cos(v: Interval) -> Enclosure:
    c = _cosine(v)
    return Enclosure(c, _sine(v).times(-1.0), c.times(-1.0))


def _tan(v: Interval) -> Enclosure:
    t = v.through(np.tan)
    result = Enclosure(t, t.squared().plus(1.0), t.through(lambda u: 2 * u * (1 + u * u)))
    return _if_defined(~_meets(v, np.pi / 2, np.pi), result)


def _asin(v: Interval) -> Enclosure:
    first = v.squared().through(lambda u: 1 / np.sqrt(1 - u))
    second = v.through(lambda u: u / np.sqrt(1 - u * u) ** 3)
    result = Enclosure(v.through(np.arcsin), first, second)
    return _if_defined((v.low >= -1) & (v.high <= 1), result)


def _acos(v: Interval) -> Enclosure:
    sine = _asin(v).times(-1.0)
    return Enclosure(sine.value.plus(np.pi / 2), sine.first, sine.second)


def _atan(v: Interval) -> Enclosure:
    square = v.squared()
    turn = 1 / np.sqrt(3.0)
    return Enclosure(
        v.through(np.arctan),
        Interval(1 / (1 + square.high), 1 / (1 + square.low)),
        _bending(lambda u: -2 * u / (1 + u * u) ** 2, v, (-turn, turn)),
    )


def _sinh(v: Interval) -> Enclosure:
    s = v.through(np.sinh)
    return Enclosure(s, _bending(np.cosh, v, (0.0,)), s)


def _cosh(v: Interval) -> Enclosure:
    c = _bending(np.cosh, v, (0.0,))
    return Enclosure(c, v.through(np.sinh), c)


def _tanh(v: Interval) -> Enclosure:
    t = v.through(np.tanh)
    square = t.squared()
    turn = 1 / np.sqrt(3.0)
    return Enclosure(
        t,
        Interval(1 - square.high, 1 - square.low),
        _bending(lambda u: -2 * u * (1 - u * u), t, (-turn, turn)),
    )


def _exp(v: Interval) -> Enclosure:
    y = v.through(np.exp)
    return Enclosure(y, y, y)


def _log(v: Interval) -> Enclosure:
    result = Enclosure(
        v.through(np.log), Interval(1 / v.high, 1 / v.low), v.through(lambda u: -1 / (u * u))
    )
    return _if_defined(v.low > 0, result)


def _sqrt(v: Interval) -> Enclosure:
    y = v.through(np.sqrt)
    first = Interval(0.5 / y.high, 0.5 / y.low)
    return _if_defined(v.low >= 0, Enclosure(y, first, v.through(lambda u: -0.25 / u**1.5)))


def _abs(v: Interval) -> Enclosure:
    kink = (v.low < 0) & (v.high > 0)
    zero = np.zeros_like(v.low)
    value = Interval.between(np.abs(v.low), np.abs(v.high))
    # At the end of an interval the derivative is that of its inside.
    first = Interval.between(np.where(v.low < 0, -1.0, 1.0), np.where(v.high > 0, 1.0, -1.0))
    value = Interval(np.where(kink, 0.0, value.low), value.high)
    result = Enclosure(value, first, _known(~kink, Interval(zero, zero)))
    return _if_defined(v.low <= v.high, result)


FUNCTIONS: dict[str, Callable[[Interval], Enclosure]] = {
    "sin": _sin,
    "cos": _cos,
    "tan": _tan,
    "asin": _asin,
    "acos": _acos,
    "atan": _atan,
    "sinh": _sinh,
    "cosh": _cosh,
    "tanh": _tanh,
    "exp": _exp,
    "log": _log,
    "sqrt": _sqrt,
    "abs": _abs,
}
"""The functions of formulas, each of an interval of its argument."""


def power_of(v: Interval, exponent: float) -> Enclosure:
    """The power v**exponent over an interval.

    Parameters
    ----------
    v
        Interval (...) of the base.
    exponent
        The exponent.
    """
    n = exponent
    return Enclosure(_monomial(1.0, v, n), _monomial(n, v, n - 1), _monomial(n * (n - 1), v, n - 2))


def _monomial(factor: float, v: Interval, rank: float) -> Interval:
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
