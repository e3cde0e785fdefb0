"""How far from failing comparisons of numbers were: ``pytest --margins``, ``make portable``.

Of every ``assert a < b``, every ``assert_allclose`` and every ``pytest.approx`` that holds, the
bound by what was found, the least of all examples and processes. Where that is less than ``NARROW``
another processor may find otherwise; those are printed. Only tolerances count, which are there
because of rounding, or may be: constants of at most ``SMALL``.
"""

from __future__ import annotations

import ast
import operator
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

HERE = Path(__file__).parent
NARROW = 3.0
SMALL = 1e-5
MARGIN = "margin of "
"""How names of what is kept with a test's report begin."""
OPERATORS: dict[type, Callable[..., Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
    ast.USub: operator.neg,
}


class Margins:
    """The plugin: hooks of pytest, and what stands in for two functions that compare."""

    def __init__(self) -> None:
        self.found: dict[str, float] = {}

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_call(self, item: pytest.Item) -> Any:
        self.found = {}
        result = yield
        item.user_properties += [(MARGIN + place, each) for place, each in self.found.items()]
        return result

    def pytest_assertion_pass(self, item: pytest.Item, lineno: int, orig: str, expl: str) -> None:
        for bound, found in _compared(orig, expl):
            self.keep(f"{item.path.relative_to(HERE)}:{lineno}", bound, found)

    def keep(self, place: str, bound: float, found: float) -> None:
        """Keep a comparison, if none at that place was nearer to failing."""
        margin = float(bound / found) if found else np.inf
        if margin >= 1:
            self.found[place] = min(margin, self.found.get(place, np.inf))

    def instead_of_allclose(self, original: Callable[..., None]) -> Callable[..., None]:
        def assert_allclose(
            actual: Any, desired: Any, rtol: float = 1e-7, atol: float = 0.0, **more: Any
        ) -> None:
            original(actual, desired, rtol=rtol, atol=atol, **more)
            bound = atol + rtol * np.abs(desired)
            left, right, bound = np.broadcast_arrays(actual, desired, bound)
            away = np.abs(left - right)
            known = np.isfinite(away) & (away > 0)
            if known.any() and _is_small(float(bound.max()), float(np.abs(right[known]).max())):
                self.keep(_place(), 1.0, float(np.max(away[known] / bound[known])))

        return assert_allclose

    def instead_of_approx(self, original: Callable[..., bool]) -> Callable[..., bool]:
        def equals(approx: Any, actual: object) -> bool:
            same = original(approx, actual)
            if same and isinstance(actual, float) and np.isfinite(actual):  # NumPy's are floats
                bound = float(approx.tolerance)
                if _is_small(bound, abs(approx.expected)):
                    self.keep(_place(), bound, abs(actual - approx.expected))
            return same

        return equals


def install(config: pytest.Config) -> None:
    """Have comparisons of this process kept."""
    margins = Margins()
    config.pluginmanager.register(margins)
    np.testing.assert_allclose = margins.instead_of_allclose(np.testing.assert_allclose)
    scalar: Any = type(pytest.approx(1.0))
    scalar.__eq__ = margins.instead_of_approx(scalar.__eq__)


def report(reporter: pytest.TerminalReporter) -> None:
    """Print the narrow ones, the narrowest first."""
    least: dict[str, float] = {}
    for test in reporter.getreports("passed"):
        for name, value in test.user_properties:
            if name.startswith(MARGIN):
                least[name] = min(float(value), least.get(name, np.inf))
    narrow = sorted((value, name) for name, value in least.items() if value < NARROW)
    reporter.section(f"{len(least)} small bounds, {len(narrow)} of less than {NARROW:g} times")
    for value, name in narrow:
        reporter.write_line(f"{value:6.3f} {name.removeprefix(MARGIN)}")


def _compared(source: str, explained: str) -> list[tuple[float, float]]:
    """Slack of a comparison and how much of it was needed, from pytest's explanation of it.

    Of ``a < b + 1e-9`` they are 1e-9 and a - b, of ``a < 1e-9`` they are 1e-9 and a.
    """
    try:
        asked = ast.parse(source.strip(), mode="eval").body
        said = ast.parse(explained.split("\n", 1)[0].strip(), mode="eval").body
        if not (isinstance(asked, ast.Compare) and isinstance(said, ast.Compare)):
            return []
        both = zip([asked.left, *asked.comparators], [said.left, *said.comparators], strict=True)
        values = [(_value(which), _value(which, each)) for each, which in both]
    except (SyntaxError, ValueError, TypeError, ZeroDivisionError, OverflowError):
        return []
    found = []
    for first, way, second in zip(values, said.ops, values[1:], strict=False):
        rising = isinstance(way, (ast.Lt, ast.LtE))
        if rising or isinstance(way, (ast.Gt, ast.GtE)):
            (low, strict_low), (high, strict_high) = (first, second) if rising else (second, first)
            needed = strict_low - strict_high
            slack = needed + high - low
            if slack > 0 and (low, high) != (strict_low, strict_high):
                found.append((slack, max(needed, 0.0)))
    return found


def _value(tree: ast.expr, source: ast.expr | None = None) -> float:
    """The number that an explanation stands for: constants, NumPy's numbers, sums and products.

    With its source, that with 0 in place of tolerances: small constants, by value or name.
    """
    match tree:
        case ast.Constant(value=int() | float() as value):
            return 0.0 if abs(value) <= SMALL and _is_tolerance(source) else float(value)
        case ast.Call(func=ast.Attribute(attr="float64"), args=[inner]):
            return _value(inner, source)
        case ast.UnaryOp(op=op, operand=inner) if type(op) in OPERATORS:
            part = source.operand if isinstance(source, ast.UnaryOp) else None
            return float(OPERATORS[type(op)](_value(inner, part)))
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATORS:
            parts = (source.left, source.right) if isinstance(source, ast.BinOp) else (None, None)
            values = (_value(each, part) for each, part in zip((left, right), parts, strict=True))
            return float(OPERATORS[type(op)](*values))
    raise ValueError


def _is_tolerance(source: ast.expr | None) -> bool:
    match source:
        case ast.Constant():
            return True
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name.isupper()
    return False


def _is_small(bound: float, size: float) -> bool:
    """Whether a bound is a tolerance, by the size of what is compared."""
    return bound <= SMALL * (size or 1.0)


def _place() -> str:
    """The line of a test or its helper that compares."""
    frame = sys._getframe(1)
    while frame.f_back is not None:
        path = Path(frame.f_code.co_filename)
        if HERE in path.parents and path != Path(__file__):
            return f"{path.relative_to(HERE)}:{frame.f_lineno}"
        frame = frame.f_back
    return "?"
