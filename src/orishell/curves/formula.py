"""Formulas in one variable or in two: parsed against a whitelist, never evaluated as Python."""

from __future__ import annotations

import ast
from dataclasses import field
from typing import cast

import numpy as np

from orishell.conventions.arguments import checked
from orishell.conventions.errors import FormulaError
from orishell.conventions.record import record
from orishell.curves.formula_arithmetic import (
    ENCLOSURES,
    JETS,
    Run,
    apply,
    combine,
    lift,
    one_of,
    the_variable,
)
from orishell.curves.formula_signs import mended, name_meant
from orishell.curves.formula_syntax import MAX_DEPTH, syntax_tree
from orishell.numerics import FUNCTIONS, Enclosure, Jet, power
from orishell.numerics.arrays import Array

MAX_EXPONENT = 100.0
MAX_NUMBER = 1e300

CONSTANTS = {"pi": np.pi, "e": np.e}


@record
class Formula:
    """A checked formula in at most one variable."""

    text: str  # as the user wrote it
    variable: str | None  # the name of the variable, or None for a constant
    _run: Run
    head: str = field(default="", repr=False)  # what it says it gives, as "y" of "y = x**2"

    def jet(self, t: Array) -> Jet:
        """Value, first and second derivative at ``t`` (...); not finite where undefined."""
        t = np.asarray(t, dtype=np.float64)
        with np.errstate(all="ignore"):
            value, first, second = (
                # Constants have no axis for parameters.
                each if np.shape(each) == t.shape else np.full(t.shape, each)
                for each in self._run((t, np.ones_like(t), np.zeros_like(t)), JETS)
            )
        return value, first, second

    def enclosure(self, low: Array, high: Array) -> Enclosure:
        """Bounds of all three from ``low`` to ``high`` (S,); nan or infinite where unbounded."""
        with np.errstate(all="ignore"):
            found = self._run(Enclosure.variable(low, high), ENCLOSURES)
        return found.each(
            lambda interval: interval.through(lambda ends: np.broadcast_to(ends, low.shape))
        )


@record
class FormulaOfTwo:
    """A checked formula in at most two variables."""

    text: str  # as the user wrote it
    variables: tuple[str, str]  # the names of the variables, in their order
    _run: Run
    head: str = field(default="", repr=False)  # what it says it gives, as "z" of "z = x*y"

    def slopes(self, s: Array, t: Array) -> tuple[Array, Array, Array]:
        """Value, and derivatives by the first and the second variable, at ``s``, ``t`` (...)."""
        s, t = np.broadcast_arrays(np.asarray(s, np.float64), np.asarray(t, np.float64))
        one, zero = np.ones(s.shape), np.zeros(s.shape)
        values, slopes = [], []
        with np.errstate(all="ignore"):
            for by in range(2):
                given = (s, (one, zero)[by], zero), (t, (zero, one)[by], zero)
                # Only formulas' names take the variables apart: see ``one_of``.
                value, first, _ = self._run(cast("Jet", given), JETS)
                values.append(value)
                slopes.append(np.broadcast_to(first, s.shape))
        return np.broadcast_to(values[0], s.shape), slopes[0], slopes[1]


class _Compiler:
    """Turns the whitelisted part of a syntax tree into nested functions on jets."""

    def __init__(self, text: str, names: tuple[str, ...] = ()) -> None:
        self.text = text
        self.names = names  # of the variables; one of any name if none are given
        self.variable: str | None = None

    def fault(self, what: str, node: ast.expr, **details: str) -> FormulaError:
        return FormulaError(what, self.text, node.col_offset, **details)

    def compile(self, node: ast.expr, depth: int = 0) -> float | Run:
        """Return a number for a constant subtree, otherwise a function from t to its jet."""
        if depth > MAX_DEPTH:
            raise self.fault(
                "the formula is nested too deeply", node, expected=f"at most {MAX_DEPTH} levels"
            )
        match node:
            case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
                if not abs(value) < MAX_NUMBER:
                    raise self.fault("this number is too large", node)
                return float(value)
            case ast.Name(id=name):
                return self.name(node, name)
            case ast.UnaryOp(op=ast.USub() | ast.UAdd() as op, operand=operand):
                inner = self.compile(operand, depth + 1)
                return combine(ast.Sub, 0.0, inner) if isinstance(op, ast.USub) else inner
            case ast.BinOp(left=left, op=ast.Pow(), right=right):
                return self.power(
                    self.compile(left, depth + 1), self.compile(right, depth + 1), right
                )
            case ast.BinOp(
                left=left, op=ast.Add() | ast.Sub() | ast.Mult() | ast.Div() as op, right=right
            ):
                return combine(
                    type(op), self.compile(left, depth + 1), self.compile(right, depth + 1)
                )
            case ast.Call(func=ast.Name(id=name), args=[argument], keywords=[]) if (
                name in FUNCTIONS
            ):
                return apply(FUNCTIONS[name], self.compile(argument, depth + 1))
            case ast.Call(func=ast.Name(id=name)) if name in FUNCTIONS:
                raise self.fault(f"{name} takes one argument", node)
            case ast.Call(func=ast.Name(id=name)):
                raise self.fault(
                    "unknown function",
                    node,
                    got=repr(name),
                    expected="one of " + ", ".join(FUNCTIONS),
                    remedy=name_meant(name, tuple(FUNCTIONS)),
                )
        raise self.fault(
            "this is not allowed in a formula",
            node,
            expected="numbers, one variable, + - * / **, parentheses, pi, e and "
            + ", ".join(FUNCTIONS),
            remedy=mended(self.text)[0],
        )

    def name(self, node: ast.expr, name: str) -> float | Run:
        if name in CONSTANTS:
            return CONSTANTS[name]
        if name in FUNCTIONS:
            remedy, at = mended(self.text)
            remedy = f"write {name}(...)" if at is None else remedy
            raise self.fault(f"{name} needs an argument", node, remedy=remedy)
        if name in self.names:
            return one_of(self.names.index(name))
        if self.names:
            raise self.fault(
                "unknown name",
                node,
                got=repr(name),
                expected=f"the variables {' and '.join(self.names)}, pi or e",
                remedy=name_meant(name, (*self.names, *CONSTANTS)),
            )
        if len(name) > 1 or not name.isascii() or name == "y":
            raise self.fault(
                "unknown name",
                node,
                got=repr(name),
                expected="the variable (x or t), pi or e",
                remedy=name_meant(name, tuple(CONSTANTS)),
            )
        if self.variable not in (None, name):
            raise self.fault(
                "a second variable",
                node,
                got=f"{name!r} beside {self.variable!r}",
                expected="one variable",
            )
        self.variable = name
        return the_variable

    def power(self, base: float | Run, exponent: float | Run, node: ast.expr) -> float | Run:
        if isinstance(exponent, float):
            if not abs(exponent) <= MAX_EXPONENT:
                raise self.fault(
                    "the exponent is too large",
                    node,
                    got=f"{exponent:g}",
                    expected=f"at most {MAX_EXPONENT:g} in size",
                )
            return apply(power(exponent), base)
        if isinstance(base, float) and base > 0:
            return apply(FUNCTIONS["exp"], combine(ast.Mult, float(np.log(base)), exponent))
        raise self.fault(
            "the exponent varies",
            node,
            expected="a number as exponent, or a positive number as base",
        )


@checked()
def parse_formula(text: str) -> Formula:
    """Check a formula against the whitelist.

    Parameters
    ----------
    text
        Numbers, one variable (a single letter), ``+ - * / **``, parentheses, ``pi``, ``e`` and
        :data:`FUNCTIONS`; ``^``, ``π``, ``²`` and typographic signs are read as what they stand
        for, and "y =" or "f(x) =" may stand in front. At most :data:`MAX_LENGTH` characters,
        :data:`MAX_DEPTH` levels, exponents up to :data:`MAX_EXPONENT`.

    Raises
    ------
    FormulaError
        With the place of the fault.

    Examples
    --------
    >>> value, first, second = parse_formula("x**2 + 1").jet(np.array([3.0]))
    >>> value[0], first[0], second[0]
    (np.float64(10.0), np.float64(6.0), np.float64(2.0))
    """
    compiler = _Compiler(text)
    run, head = _compiled(compiler)
    return Formula(text.strip(), compiler.variable, run, head)


@checked()
def parse_formula_of_two(text: str, first: str, second: str) -> FormulaOfTwo:
    """Check a formula in two variables against the whitelist, as :func:`parse_formula` does.

    Parameters
    ----------
    text
        The formula.
    first, second
        Names of its variables.

    Raises
    ------
    FormulaError
        With the place of the fault.

    Examples
    --------
    >>> value, by_x, by_y = parse_formula_of_two("x**2 * y", "x", "y").slopes(3.0, 2.0)
    >>> float(value), float(by_x), float(by_y)
    (18.0, 12.0, 9.0)
    """
    run, head = _compiled(_Compiler(text, (first, second)))
    return FormulaOfTwo(text.strip(), (first, second), run, head)


def _compiled(compiler: _Compiler) -> tuple[Run, str]:
    """The formula as a function, checked, and what it gives; the compiler knows its variable."""
    tree, plain = syntax_tree(compiler.text)
    result = compiler.compile(tree)
    own = compiler.names or ((compiler.variable,) if compiler.variable else plain.of)
    if plain.head in own or not {*plain.of} <= {*own}:
        raise FormulaError(
            "what stands before = does not go with what stands behind it",
            compiler.text,
            0,
            expected="the formula alone, or as in y = x**2 or f(x) = x**2",
        )
    return lift(result) if isinstance(result, float) else result, plain.head
