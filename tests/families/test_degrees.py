"""Radians in keys that take degrees: said, and the degrees are tried where a shell is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from design_tables import formula, made, mended, refused, tables
from orishell import InputError, design_orthodiagonal, design_parallel_repeating
from strategies import graph

F, G = formula("-x**2", -1, 1), formula("0.2*sin(pi*x/2)", 0, 4)
SIZE = {"rows": 5, "columns": 5, "flap": 0.1}


def test_an_angle_that_radians_would_fit_draws_a_warning() -> None:
    shell = made(tables("parallel-repeating", F, G, **SIZE, xi_deg=0.87))
    assert shell.report.warnings[0] == (
        "xi_deg is in degrees (0.87 radians are 49.85 degrees): if radians were meant, write "
        "xi_deg = 49.85"
    )


@pytest.mark.parametrize("keys", [{"xi_deg": 50}, {"theta_deg": 0.5}, {"xi_deg": "auto"}, {}])
def test_other_angles_draw_none(keys: dict[str, Any]) -> None:
    shell = made(tables("parallel-repeating", F, G, **SIZE, **keys))
    assert not any("radians" in warning for warning in shell.report.warnings)


def test_where_the_shell_is_refused_the_degrees_are_tried() -> None:
    design = tables("orthodiagonal", F, G, **SIZE, heading_deg=round(np.pi / 2, 4))
    error = refused(design)
    assert error is not None
    assert "heading_deg is in degrees (1.5708 radians are 90 degrees)" in error.size
    assert error.remedies[0].changes == {"pattern.heading_deg": 90.0}
    assert refused(mended(design, error.remedies[0])) is None


def test_four_angles() -> None:
    angles = [round(float(angle), 4) for angle in np.deg2rad([85, 80, 95, 100])]
    size = {"rows": 7, "columns": 9}
    arc = formula(["cos(t)", "sin(t)"], 0.3, 2.8416)
    design = tables(
        "longitudinal-linear-repeating", arc, formula("0*x", 0, 2.93), **size, sector_deg=angles
    )
    error = refused(design)
    assert error is not None
    assert "sector_deg is in degrees" in error.size
    assert error.remedies[0].changes == {"pattern.sector_deg": [85.0, 80.0, 95.0, 100.0]}


@pytest.mark.parametrize(
    ("make", "key", "value", "expected"),
    [
        (design_parallel_repeating, "xi", 50, "at most 3.13985 (50 degrees are 0.8727)"),
        (design_parallel_repeating, "theta", -30, "at least -6.28319 (-30 degrees are -0.5236)"),
        (design_parallel_repeating, "plane", 90, "less than 3.14159 (90 degrees are 1.571)"),
        (design_orthodiagonal, "heading", 90, "at most 3.14159 (90 degrees are 1.571)"),
        (design_orthodiagonal, "row_angle", 120, "(120 degrees are 2.094)"),
        (design_parallel_repeating, "xi", 500, "an angle in radians, at most 3.13985 or 'auto'"),
    ],
)
def test_functions_take_radians(make: Any, key: str, value: float, expected: str) -> None:
    f, g = graph("-x**2", -1, 1), graph("0.2*sin(pi*x/2)", 0, 4)
    with pytest.raises(InputError) as caught:
        make(f, g, rows=5, columns=5, **{key: value})
    assert "an angle in radians" in caught.value.expected
    assert expected in caught.value.expected
