"""The operations of formulas, for numbers and for ranges alike.

A compiled formula is run by rules: with those of jets it gives its value and two derivatives at
parameters, with those of enclosures what these can be over ranges of the parameter.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from typing import Any, Final, Generic, Protocol, TypeAlias, TypeVar

import numpy as np

from orishell import numerics
from orishell.conventions.record import record
from orishell.curves import jets
from orishell.curves.jets import Jet
from orishell.numerics import Enclosure, Interval
from orishell.numerics.arrays import Array

J = TypeVar("J")
Operator: TypeAlias = type[ast.operator]


@record
class Rules(Generic[J]):
    """The operations of formulas on one kind of value.

    constant: A number, beside the variable.
    operators: The operators + - * /, by their nodes in a syntax tree.
    power: A power with a number as exponent.
    functions: The functions, by their names.
    """

    constant: Callable[[float, J], J]
    operators: Mapping[Operator, Callable[[J, J], J]]
    power: Callable[[J, float], J]
    functions: Mapping[str, Callable[[J], J]]


def _constant_jet(value: float, _: Jet) -> Jet:
    zero = np.zeros(())
    return np.asarray(value), zero, zero


def _jet_power(base: Jet, exponent: float) -> Jet:
    v = base[0]
    return jets.chain(jets.power((v, np.ones_like(v), np.zeros_like(v)), exponent), base)


def _jet_function(function: Callable[[Array], Jet]) -> Callable[[Jet], Jet]:
    return lambda jet: jets.chain(function(jet[0]), jet)


def _times(a: Enclosure, b: Enclosure) -> Enclosure:
    for factor, other in ((a, b), (b, a)):
        if factor.value.low.ndim == 0:  # only constants have no axis for ranges
            return other.times(factor.value.low)
    return a * b


def _enclosed_power(base: Enclosure, exponent: float) -> Enclosure:
    return numerics.power_of(base.value, exponent).of(base)


def _enclosed_function(
    function: Callable[[Interval], Enclosure],
) -> Callable[[Enclosure], Enclosure]:
    return lambda inner: function(inner.value).of(inner)


JETS: Final[Rules[Jet]] = Rules(
    constant=_constant_jet,
    operators={
        ast.Add: jets.plus,
        ast.Sub: jets.minus,
        ast.Mult: jets.times,
        ast.Div: jets.over,
    },
    power=_jet_power,
    functions={name: _jet_function(each) for name, each in jets.FUNCTIONS.items()},
)
ENCLOSURES: Final[Rules[Enclosure]] = Rules(
    constant=lambda value, _: Enclosure.constant(value),
    operators={
        ast.Add: Enclosure.__add__,
        ast.Sub: Enclosure.__sub__,
        ast.Mult: _times,
        ast.Div: lambda a, b: _times(a, _enclosed_power(b, -1.0)),
    },
    power=_enclosed_power,
    functions={name: _enclosed_function(each) for name, each in numerics.FUNCTIONS.items()},
)

Function = Callable[[Rules[Any]], Callable[[Any], Any]]


class Run(Protocol):
    """A compiled formula: what it makes of the variable by given rules."""

    def __call__(self, variable: J, rules: Rules[J], /) -> J:
        """Evaluate the formula at a value of the variable."""


def the_variable(variable: J, rules: Rules[J], /) -> J:
    """The formula that is the variable alone."""
    return variable


def lift(value: float) -> Run:
    """The formula of a constant ``value``."""

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
    a = lift(left) if isinstance(left, float) else left
    b = lift(right) if isinstance(right, float) else right

    def run(variable: J, rules: Rules[J], /) -> J:
        result: J = rules.operators[operator](a(variable, rules), b(variable, rules))
        return result

    return _fold(run) if isinstance(left, float) and isinstance(right, float) else run


def named(name: str) -> Function:
    """The function with this ``name``."""
    return lambda rules: rules.functions[name]


def apply(function: Function, argument: float | Run) -> float | Run:
    """The formula of a ``function`` of its ``argument``; a number if that is one."""
    inner = lift(argument) if isinstance(argument, float) else argument

    def run(variable: J, rules: Rules[J], /) -> J:
        result: J = function(rules)(inner(variable, rules))
        return result

    return _fold(run) if isinstance(argument, float) else run
