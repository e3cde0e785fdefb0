"""Slips that are legal: said, and what may have been meant is tried where a shell is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from design_tables import formula, made, mended, refused, tables

F, G = formula("-x**2", -1, 1), formula("0.2*sin(pi*x/2)", 0, 4)
SIZE = {"rows": 5, "columns": 5, "flap": 0.1}


def test_an_angle_that_radians_would_fit_draws_a_warning() -> None:
    shell = made(tables("parallel-repeating", F, G, **SIZE, xi_deg=0.87))
    assert shell.report.warnings[0] == (
        "xi_deg is in degrees (0.87 radians are 49.85): if radians were meant, write xi_deg = 49.85"
    )


@pytest.mark.parametrize("keys", [{"xi_deg": 50}, {"theta_deg": 0.5}, {"xi_deg": "auto"}, {}])
def test_other_angles_draw_none(keys: dict[str, Any]) -> None:
    shell = made(tables("parallel-repeating", F, G, **SIZE, **keys))
    assert not any("radians" in warning for warning in shell.report.warnings)


def test_where_the_shell_is_refused_the_degrees_are_tried() -> None:
    design = tables("orthodiagonal", F, G, **SIZE, heading_deg=round(np.pi / 2, 4))
    error = refused(design)
    assert error is not None
    assert "heading_deg is in degrees (1.5708 radians are 90)" in error.size
    assert error.remedies[0].changes == {"pattern.heading_deg": 90.0}
    assert refused(mended(design, error.remedies[0])) is None


def test_four_angles() -> None:
    angles = [round(float(angle), 4) for angle in np.deg2rad([85, 80, 95, 100])]
    size = {"rows": 3, "columns": 5}
    arc = formula(["cos(t)", "sin(t)"], 0.3, 2.8416)
    design = tables(
        "longitudinal-linear-repeating", arc, formula("0*x", 0, 2.93), **size, sector_deg=angles
    )
    error = refused(design)
    assert error is not None
    assert "sector_deg is in degrees" in error.size
    assert error.remedies[0].changes == {"pattern.sector_deg": [85.0, 80.0, 95.0, 100.0]}


ARCH = {"points": [[-2000, 0], [-1000, 1100], [0, 1400], [1000, 1100], [2000, 0]]}
WAVE = formula("0.3*sin(pi*x/4)", 0, 8)


def test_a_curve_in_millimetres_beside_one_in_metres_is_asked_for_its_unit() -> None:
    design = tables("parallel-repeating", ARCH, WAVE, rows=5, columns=5)
    error = refused(design)
    assert error is not None
    assert error.size.endswith(
        "f is 530 times as large as g: if it is in another unit, say which (unit in [target.f])"
    )
    assert error.remedies[0].changes == {"target.f.scale": 0.001}
    assert refused(mended(design, error.remedies[0])) is None
    assert (
        refused(tables("parallel-repeating", {**ARCH, "unit": "mm"}, WAVE, rows=5, columns=5))
        is None
    )


def test_where_a_shell_can_be_made_of_it_a_warning_asks() -> None:
    f = formula("1400 - 1400*(x/2000)**2", -2000, 2000)
    shell = made(tables("orthodiagonal", f, WAVE, rows=5, columns=5))
    assert shell.report.warnings[0] == (
        "f is 530 times as large as g: formulas are in the unit of [shell]"
    )


def test_a_whole_shell_in_another_unit_draws_a_warning() -> None:
    far = formula("300*sin(pi*x/4000)", 0, 8000)
    warnings = made(tables("parallel-repeating", ARCH, far, rows=5, columns=5)).report.warnings
    assert any("is m the unit of its curves?" in warning for warning in warnings)


def test_stock_in_another_unit_draws_a_warning() -> None:
    design = tables("parallel-repeating", F, G, **SIZE)
    shell = made({**design, "workshop": {"stock": [2440, 1220]}})
    assert any(
        "sheets of 2440 x 1220 m are larger than any that is sold" in warning
        for warning in shell.report.warnings
    )


def test_curves_of_like_sizes_draw_no_question() -> None:
    long = formula("0.1*sin(x/4)", 0, 50)  # a tunnel
    for warning in made(tables("parallel-repeating", F, long, rows=3, columns=9)).report.warnings:
        assert "unit" not in warning.partition(" as large as ")[2]
