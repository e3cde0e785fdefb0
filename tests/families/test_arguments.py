"""Patterns that are typed in refuse what the design file refuses, and say it in the same form."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from orishell import (
    Curve,
    Design,
    InputError,
    LongitudinalPattern,
    OrthodiagonalPattern,
    ParallelRepeatingPattern,
    design_longitudinal_linear_repeating,
    design_orthodiagonal,
    design_parallel_repeating,
)
from orishell.families.pattern import Pattern
from strategies import graph, pair

F, LINE = graph("-x**2", -1, 1), graph("0*x", 0, 4)
SECTORS = [85, 80, 95, 100]

GOOD: dict[type[Pattern], dict[str, Any]] = {
    ParallelRepeatingPattern: {"rows": 5, "columns": 4},
    OrthodiagonalPattern: {"rows": 5, "columns": 4},
    LongitudinalPattern: {"rows": 5, "columns": 5, "sector_deg": SECTORS},
}
CURVES: dict[type[Pattern], tuple[Curve, Curve]] = {
    ParallelRepeatingPattern: (F, LINE),
    OrthodiagonalPattern: (F, LINE),
    LongitudinalPattern: (pair("cos(t)", "sin(t)", 0.3, 2.8), graph("0*x", 0, 3)),
}
OF_ALL: dict[str, tuple[tuple[Any, str], ...]] = {
    "rows": (
        (0, "a value of at least 1"),
        (-3, "a value of at least 1"),
        (5.0, "a whole number"),
        ("5", "a whole number"),
        (True, "a whole number"),
        (None, "a whole number"),
    ),
    "columns": ((1, "a value of at least 2"), (np.int64(0), "a value of at least 2")),
    "flap": (
        (-1, "'auto'"),
        (np.nan, "a finite number"),
        (np.inf, "a finite number"),
        ("wide", "a number or 'auto'"),
        ([1.0], "a number or 'auto'"),
    ),
}
OF_TWO: dict[str, tuple[tuple[Any, str], ...]] = {
    "rows": ((8, "7 or 9"), (np.int64(8), "7 or 9")),
    "spacing": (("x", "'curvature' or 'equal'"),),
    "placement": ((1, "'inscribed' or 'balanced'"),),
    "flap_side": ((0, "'start'"), (("end",), "2 entries"), (("end", "up"), "'start'")),
}
OF_ONE: dict[type[Pattern], dict[str, tuple[tuple[Any, str], ...]]] = {
    ParallelRepeatingPattern: {
        "xi_deg": ((0, "at least 0.1"), (180, "at most 179.9"), (np.nan, "finite")),
        "theta_deg": ((361, "at most 360"), ("left", "a number or 'auto'")),
        "plane_deg": ((0.0, "greater than 0"), (180, "less than 180"), ("auto", "a number")),
        "flap_side": ((("auto", "end"), "'start' or 'end'"),),
    },
    OrthodiagonalPattern: {
        "depth": ((0, "greater than 0"), (-0.1, "greater than 0")),
        "heading_deg": ((-0.1, "at least 0"), (181, "at most 180")),
    },
    LongitudinalPattern: {
        "sector_deg": (([85, 80, 95], "4 entries"), ([85, 80, 95, 180], "less than 180")),
        "solution": ((-1, "at least 0"), (0.5, "a whole number")),
        "couplings": ((["solve"], "4 entries"), (["bend"] * 4, "'solve' or 'parallel'")),
        "first_row": (("G", "'F' or 'S'"),),
        "row_lengths": (([1.0], "4 entries"), ([1, 1, 0, 1], "greater than 0")),
        "column_lengths": ((np.ones(5), "6 entries"), ("even", "'auto'")),
        "stage_deg": ((0, "greater than 0"), (181, "at most 180")),
        "flap": ((0, "greater than 0"),),
    },
}
BAD = [
    pytest.param(family, key, value, expected, id=f"{family.__name__}-{key}-{number}")
    for family in GOOD
    for table in (
        OF_ALL,
        *([OF_TWO] if family is not LongitudinalPattern else []),
        OF_ONE[family],
    )
    for key, cases in table.items()
    for number, (value, expected) in enumerate(cases)
]


@pytest.mark.parametrize(("family", "key", "value", "expected"), BAD)
def test_an_argument_without_meaning(
    family: type[Pattern], key: str, value: Any, expected: str
) -> None:
    with pytest.raises(InputError) as caught:
        family(**{**GOOD[family], key: value})
    error = caught.value
    assert error.where.startswith(f"{family.__name__}: {key}")
    assert error.got
    assert expected in error.expected


@pytest.mark.parametrize("family", GOOD)
def test_numbers_of_numpy_are_numbers(family: type[Pattern]) -> None:
    plain = family(**GOOD[family], flap=0.25).design(*CURVES[family])
    sizes = {key: np.int64(GOOD[family][key]) for key in ("rows", "columns")}
    pattern = family(**{**GOOD[family], **sizes}, flap=np.float64(0.25))
    typed = pattern.design(*CURVES[family])
    assert typed.parameters == plain.parameters
    drive = 0.5 * plain.mechanism.target_drive
    assert np.array_equal(typed.mechanism.positions(drive), plain.mechanism.positions(drive))


def test_several_faults_are_said_together() -> None:
    with pytest.raises(InputError, match="rows") as caught:
        OrthodiagonalPattern(rows=8, columns=1)
    assert "columns" in caught.value.detail


def test_one_of_two_curves() -> None:
    pattern = LongitudinalPattern(**GOOD[LongitudinalPattern])
    curves: tuple[tuple[Curve | None, Curve | None], ...] = ((F, None), (None, LINE))
    for f, g in curves:
        with pytest.raises(InputError, match="belong together"):
            design_longitudinal_linear_repeating(f, g, pattern)


@pytest.mark.parametrize("design", [design_parallel_repeating, design_orthodiagonal])
@pytest.mark.parametrize("odd", ["-x**2", np.eye(2), 4.0, None])
def test_curves_and_patterns_that_are_none(design: Callable[..., Design], odd: Any) -> None:
    makes_parallel = design is design_parallel_repeating
    family = ParallelRepeatingPattern if makes_parallel else OrthodiagonalPattern
    other = OrthodiagonalPattern if makes_parallel else ParallelRepeatingPattern
    fitting = (F, LINE, family(rows=5, columns=4))
    for number, name in enumerate(("f", "g", "pattern")):
        arguments = [*fitting]
        arguments[number] = odd
        with pytest.raises(InputError, match=f"{design.__name__}: {name}: this value"):
            design(*arguments)
    with pytest.raises(InputError, match="pattern: this value"):
        design(F, LINE, other(rows=5, columns=4))


def test_an_unknown_key_is_named_with_the_nearest_known_one() -> None:
    keys: dict[str, Any] = {"rows": 5, "columns": 4, "xi_dg": 50}
    with pytest.raises(InputError, match="ParallelRepeatingPattern: xi_dg: unknown key") as caught:
        ParallelRepeatingPattern(**keys)
    assert "xi_deg" in caught.value.remedy
