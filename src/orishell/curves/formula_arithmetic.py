"""The operations of formulas, for numbers and for ranges alike.

A compiled formula is run by rules: with those of jets it gives its value and two derivatives at
parameters, with those of enclosures what these can be over ranges of the parameter. Both propagate
derivatives exactly, without differences.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from typing import Any, Final, Generic, Protocol, TypeAlias, TypeVar

import numpy as np

from orishell.conventions.record import record
from orishell.numerics import Elementary, Enclosure, Jet, power

J = TypeVar("J")
Operator: TypeAlias = type[ast.operator]


@record
class Rules(Generic[J]):
    """The operations of formulas on one kind of value."""

    constant: Callable[[float, J], J]  # a number, beside the variable
    operators: Mapping[Operator, Callable[[J, J], J]]  # + - *, by their nodes in a syntax tree
    function: Callable[[Elementary, J], J]  # a function of a value


def _chain(function: Elementary, inner: Jet) -> Jet:
    value, first, second = function.jet(inner[0])
    return value, first * inner[1], second * inner[1] ** 2 + first * inner[2]


def _times(a: Enclosure, b: Enclosure) -> Enclosure:
    for factor, other in ((a, b), (b, a)):
        if factor.value.low.ndim == 0:  # only constants have no axis for ranges
            return other.times(factor.value.low)
    return a * b


JETS: Final[Rules[Jet]] = Rules(
    constant=lambda value, _: (np.asarray(value), np.zeros(()), np.zeros(())),
    operators={
        ast.Add: lambda a, b: (a[0] + b[0], a[1] + b[1], a[2] + b[2]),
        ast.Sub: lambda a, b: (a[0] - b[0], a[1] - b[1], a[2] - b[2]),
        ast.Mult: lambda a, b: (
            a[0] * b[0],
            a[1] * b[0] + a[0] * b[1],
            a[2] * b[0] + 2 * a[1] * b[1] + a[0] * b[2],
        ),
    },
    function=_chain,
)
ENCLOSURES: Final[Rules[Enclosure]] = Rules(
    constant=lambda value, _: Enclosure.constant(value),
    operators={ast.Add: Enclosure.__add__, ast.Sub: Enclosure.__sub__, ast.Mult: _times},
    function=Elementary.of,
)


class Run(Protocol):
    """A compiled formula: what it makes of the variable by given rules."""

    def __call__(self, variable: J, rules: Rules[J], /) -> J:
        """Evaluate the formula at a value of the variable."""


def the_variable(variable: J, rules: Rules[J], /) -> J:
    """The formula that is the variable alone."""
    return variable


def one_of(number: int) -> Run:
    """The formula that is one variable of several, which are then given as a tuple."""

    def run(variable: Any, rules: Rules[J], /) -> J:
        found: J = variable[number]
        return found

    return run


def lift(value: float | Run) -> Run:
    """A formula as it is, or the formula of a constant."""
    if not isinstance(value, float):
        return value

    def run(variable: J, rules: Rules[J], /) -> J:
        return rules.constant(value, variable)

    return run


def _fold(run: Run) -> float:
    """Evaluate a constant subtree in floating point (inf and nan where it overflows)."""
    zero = np.zeros(())
    with np.errstate(all="ignore"):
        return float(run((zero, zero, zero), JETS)[0])


def combine(operator: Operator, left: float | Run, right: float | Run) -> float | Run:
    """The formula ``left`` ``operator`` ``right``; a number if both are."""
    if operator is ast.Div:
        return combine(ast.Mult, left, apply(power(-1.0), right))
    a, b = lift(left), lift(right)

    def run(variable: J, rules: Rules[J], /) -> J:
        result: J = rules.operators[operator](a(variable, rules), b(variable, rules))
        return result

    return _fold(run) if isinstance(left, float) and isinstance(right, float) else run


def apply(function: Elementary, argument: float | Run) -> float | Run:
    """The formula of a ``function`` of its ``argument``; a number if that is one."""
    inner = lift(argument)

    def run(variable: J, rules: Rules[J], /) -> J:
        return rules.function(function, inner(variable, rules))

    return _fold(run) if isinstance(argument, float) else run
