"""Jets: values carried together with their first and second derivative.

Every operation propagates all three exactly, so that derivatives of a formula need no differences.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from orishell.numerics.arrays import Array

Jet: TypeAlias = tuple[Array, Array, Array]
"""Value, first and second derivative, each of the shape of the variable."""


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


FUNCTIONS: dict[str, Callable[[Array], Jet]] = {
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


def chain(outer: Jet, inner: Jet) -> Jet:
    """Jet of a function of ``inner``, from the function's own derivatives at ``inner``."""
    value, first, second = outer
    return value, first * inner[1], second * inner[1] ** 2 + first * inner[2]


def times(a: Jet, b: Jet) -> Jet:
    """Jet of a product."""
    return a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + 2 * a[1] * b[1] + a[0] * b[2]


def plus(a: Jet, b: Jet) -> Jet:
    """Jet of a sum."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def minus(a: Jet, b: Jet) -> Jet:
    """Jet of a difference."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def power(base: Jet, exponent: float) -> Jet:
    """Jet of a constant power; derivatives of a constant or linear term are exactly zero."""
    v, n = base[0], exponent

    def term(factor: float, rank: float) -> Array:
        return factor * v**rank if factor != 0 else np.zeros_like(v)

    return chain((v**n, term(n, n - 1), term(n * (n - 1), n - 2)), base)


def over(a: Jet, b: Jet) -> Jet:
    """Jet of a quotient."""
    return times(a, power(b, -1.0))
