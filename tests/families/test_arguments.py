"""Functions that design refuse what the design file refuses, and say it in the same form."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from orishell import (
    Curve,
    Design,
    InputError,
    design_longitudinal_linear_repeating,
    design_orthodiagonal,
    design_parallel_repeating,
)
from orishell.families.longitudinal_linear_repeating import Sectors
from strategies import graph, pair

F, LINE = graph("-x**2", -1, 1), graph("0*x", 0, 4)
SECTORS = Sectors.from_degrees([85, 80, 95, 100])

GOOD: dict[Callable[..., Design], dict[str, Any]] = {
    design_parallel_repeating: {"f": F, "g": LINE, "rows": 5, "columns": 4},
    design_orthodiagonal: {"f": F, "g": LINE, "rows": 5, "columns": 4},
    design_longitudinal_linear_repeating: {
        "f": pair("cos(t)", "sin(t)", 0.3, 2.8),
        "g": graph("0*x", 0, 3),
        "rows": 5,
        "columns": 5,
        "sectors": SECTORS,
    },
}
OF_ALL: dict[str, tuple[tuple[Any, str], ...]] = {
    "f": (("-x**2", "a Curve"), (np.eye(2), "a Curve")),
    "g": ((4.0, "a Curve"),),
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
    "flap_sides": (("end", "a list"), (("end",), "2 entries"), (("end", "up"), "'start'")),
}
OF_ONE: dict[Callable[..., Design], dict[str, tuple[tuple[Any, str], ...]]] = {
    design_parallel_repeating: {
        "xi": ((0, "at least 0.00174533"), (np.pi, "at most 3.13985"), (np.nan, "finite")),
        "theta": ((6.3, "at most 6.28319"), ("left", "a number or 'auto'")),
        "plane": ((0.0, "greater than 0"), (np.pi, "less than 3.14159"), ("auto", "a number")),
        "flap_sides": ((("auto", "end"), "'start' or 'end'"),),
    },
    design_orthodiagonal: {
        "depth": ((0, "greater than 0"), (-0.1, "greater than 0")),
        "heading": ((-0.1, "at least 0"), (3.2, "at most 3.14159")),
    },
    design_longitudinal_linear_repeating: {
        "sectors": (([85, 80, 95, 100], "a Sectors or 'auto'"),),
        "solution": ((-1, "at least 0"), (0.5, "a whole number")),
        "couplings": ((["solve"], "4 entries"), (["bend"] * 4, "'solve' or 'parallel'")),
        "first_row": (("G", "'F' or 'S'"),),
        "row_lengths": (([1.0], "4 entries"), ([1, 1, 0, 1], "greater than 0")),
        "column_lengths": ((np.ones(5), "6 entries"), ("even", "'auto'")),
        "stage": ((0, "greater than 0"), (4, "at most 3.14159")),
        "flap": ((0, "greater than 0"),),
    },
}
BAD = [
    pytest.param(make, key, value, expected, id=f"{make.__name__}-{key}-{number}")
    for make in GOOD
    for table in (
        OF_ALL,
        *([OF_TWO] if make is not design_longitudinal_linear_repeating else []),
        OF_ONE[make],
    )
    for key, cases in table.items()
    for number, (value, expected) in enumerate(cases)
]


@pytest.mark.parametrize(("make", "key", "value", "expected"), BAD)
def test_an_argument_without_meaning(
    make: Callable[..., Design], key: str, value: Any, expected: str
) -> None:
    with pytest.raises(InputError) as caught:
        make(**{**GOOD[make], key: value})
    error = caught.value
    assert error.where.startswith(f"{make.__name__}: {key}")
    assert error.got
    assert expected in error.expected


@pytest.mark.parametrize("make", GOOD)
def test_numbers_of_numpy_are_numbers(make: Callable[..., Design]) -> None:
    plain = make(**GOOD[make], flap=0.25)
    sizes = {key: np.int64(GOOD[make][key]) for key in ("rows", "columns")}
    typed = make(**{**GOOD[make], **sizes}, flap=np.float64(0.25))
    assert typed.parameters == plain.parameters
    drive = 0.5 * plain.mechanism.target_drive
    assert np.array_equal(typed.mechanism.positions(drive), plain.mechanism.positions(drive))


def test_several_faults_are_said_together() -> None:
    with pytest.raises(InputError, match="rows") as caught:
        design_orthodiagonal(F, LINE, rows=8, columns=1)
    assert "columns" in caught.value.detail


def test_one_of_two_curves() -> None:
    size: dict[str, Any] = {"rows": 5, "columns": 5, "sectors": SECTORS}
    curves: tuple[tuple[Curve | None, Curve | None], ...] = ((F, None), (None, LINE))
    for f, g in curves:
        with pytest.raises(InputError, match="belong together"):
            design_longitudinal_linear_repeating(f, g, **size)
