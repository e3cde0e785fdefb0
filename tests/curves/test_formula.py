"""Formulas: values and derivatives, and everything that must be refused."""

import math
import time
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from orishell.conventions.errors import FormulaError
from orishell.curves.formula import parse_formula
from orishell.curves.formula_syntax import MAX_DEPTH, MAX_LENGTH
from timing import HANGS

FUNCTIONS: dict[str, Callable[[float], float]] = {
    "5*sin(pi*x/10)": lambda x: 5 * math.sin(math.pi * x / 10),
    "-x**2": lambda x: -(x**2),
    "2**x - e**(-x)": lambda x: 2**x - math.exp(-x),
    "sqrt(1 + x**2)/(2 + cos(x))": lambda x: math.sqrt(1 + x**2) / (2 + math.cos(x)),
    "tanh(x)*atan(x) + sinh(x/3) - cosh(x/4)": lambda x: (
        math.tanh(x) * math.atan(x) + math.sinh(x / 3) - math.cosh(x / 4)
    ),
    "asin(x/9) + acos(x/8) + tan(x/5)": lambda x: (
        math.asin(x / 9) + math.acos(x / 8) + math.tan(x / 5)
    ),
    "log(4 + x) + exp(x/5) + abs(x - 7)": lambda x: math.log(4 + x) + math.exp(x / 5) + abs(x - 7),
    "(x + 4)**-1.5 + 3": lambda x: (x + 4) ** -1.5 + 3,
    "7": lambda _: 7.0,
}
ALIKE = {
    "−x²": "-x**2",
    "5×sin(π·x÷10)": "5*sin(pi*x/10)",
    "2^x – e^(−x)": "2**x - e**(-x)",
    "x¹⁰ + x⁻²": "x**10 + x**-2",
    "2^3^2*x": "2**9*x",
    "y = x + 1": "x + 1",
    "f(x) = x + 1": "x + 1",
    "x(t) = t": "t",
}
"""Formulas as people write them, and what they mean."""


@pytest.mark.parametrize("text", FUNCTIONS)
@given(x=st.floats(-3, 3).map(lambda x: round(x, 3)))
def test_value_and_derivatives(text: str, x: float) -> None:
    # Derivatives against central differences of Python's own evaluation (error about h**2).
    exact = FUNCTIONS[text]
    value, first, second = (float(part) for part in parse_formula(text).jet(np.array(x)))
    h = 1e-4
    assert value == pytest.approx(exact(x), rel=1e-13, abs=1e-13)
    assert first == pytest.approx((exact(x + h) - exact(x - h)) / (2 * h), rel=1e-5, abs=1e-5)
    differences = (exact(x + h) - 2 * exact(x) + exact(x - h)) / h**2
    assert second == pytest.approx(differences, rel=1e-4, abs=1e-4)


@pytest.mark.parametrize("text", ALIKE)
def test_signs_of_print_are_read_as_what_they_stand_for(text: str) -> None:
    at = np.linspace(0.5, 1.5, 7)
    found, meant = (np.array(parse_formula(each).jet(at)) for each in (text, ALIKE[text]))
    np.testing.assert_array_equal(found, meant)


@pytest.mark.parametrize(
    ("text", "column", "remedy"),
    [
        ("2x + π²y", 0, "write products with *: 2*x"),
        ("y = 2x", 4, "write products with *: 2*x"),
        ("π²·foo", 3, ""),
        ("x2", 0, "did you mean x**2 or 2*x?"),
        ("arcsin(x)", 0, "did you mean asin?"),
        ("ln(x)", 0, "did you mean log?"),
        ("log10(x)", 0, "write log(x)/log(10): log is the natural logarithm"),
        ("5*sin x", 2, "write sin(x)"),
        ("sin²(x)", 0, "write powers behind the argument, as in sin(x)**2"),
        ("math.sin(x)", 0, "write sin, without what stands before it"),
        ("|x|", 0, "write abs(x) for the size of x"),
        ("f(t) = x**2", 0, ""),
        ("x = x**2", 0, ""),
    ],
)
def test_what_is_to_be_written_is_said(text: str, column: int, remedy: str) -> None:
    with pytest.raises(FormulaError) as caught:
        parse_formula(text)
    assert abs(caught.value.column - column) <= 1
    assert caught.value.remedy == remedy


def test_polynomials_have_derivatives_at_zero() -> None:
    value, first, second = parse_formula("x**1 + x**2 + x**3").jet(np.array(0.0))
    assert (float(value), float(first), float(second)) == (0.0, 1.0, 2.0)


def test_shape_is_kept() -> None:
    value, first, second = parse_formula("3").jet(np.zeros((2, 5)))
    assert value.shape == first.shape == second.shape == (2, 5)


@pytest.mark.parametrize(
    ("text", "column"),
    [
        ("", 0),
        ("   ", 0),
        ("x +", 3),
        ("(x", 0),
        ("x)", 1),
        ("2 + sn(x)", 4),
        ("x + y", 4),
        ("x*t", 2),
        ("foo + 1", 0),
        ("sin", 0),
        ("sin(x, x)", 0),
        ("sin(x=1)", 5),
        ("x**x", 3),
        ("x**101", 3),
        ("1e999*x", 0),
        ("1j*x", 0),
        ("True", 0),
        ("x if x else 2", 0),
        ("x and 1", 0),
        ("x//2", 0),
        ("x@x", 1),
        ("x.real", 0),
        ("x.__class__", 0),
        ("__import__('os').system('ls')", 11),
        ("(lambda: 1)()", 7),
        ("[x]", 0),
        ("{x}", 0),
        ("x := 1", 2),
        ("exec(x)", 0),
        ("sin(x)(x)", 0),
        ("()", 1),
        ("x + 2,5*x", 5),
        ("ｘ", 0),
        ("x\n+ 1", 1),
        ("9**9**9**9", 6),
        ("2**(9**99)", 3),
        ("sin x", 0),
    ],
)
def test_refused_with_the_place(text: str, column: int) -> None:
    with pytest.raises(FormulaError) as caught:
        parse_formula(text)
    assert abs(caught.value.column - column) <= 1
    message = str(caught.value)
    assert f"character {caught.value.column + 1}" in message
    assert message.splitlines()[-1].strip() == "^"


@pytest.mark.parametrize(
    "text",
    [
        "x" + " + x" * MAX_LENGTH,
        "(" * (MAX_DEPTH + 1) + "x" + ")" * (MAX_DEPTH + 1),
        "-" * (MAX_DEPTH + 20) + "x",
        "sin(" * (MAX_DEPTH + 1) + "x" + ")" * (MAX_DEPTH + 1),
        "9**9**9**9**9**9**9",
        "1" * 400 + "*x",
        "x**(10**90)",
    ],
)
def test_attacks_by_size_are_refused_at_once(text: str) -> None:
    begin = time.process_time()
    with pytest.raises(FormulaError):
        parse_formula(text)
    assert time.process_time() - begin < HANGS


@given(st.text(alphabet="x+-*/().,0123456789e pisncoqrt^_[]'\"=π²⁻×−|√", max_size=40))
def test_any_text_is_a_formula_or_a_formula_error(text: str) -> None:
    try:
        formula = parse_formula(text)
    except FormulaError:
        return
    assert formula.jet(np.array([0.5]))[0].shape == (1,)
