"""What a message offers has been tried: typed into the design file, it gives a shell that locks."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from design_tables import Tables, formula, made, mended, refused, tables
from orishell.conventions.errors import DesignError
from samples import THOROUGH, led_by, thorough

UNIT_ARC = formula(["cos(t)", "sin(t)"], 0.3, 2.8416)
PARABOLA = formula("-x**2", -1, 1)

FOUND_IN_USE = {
    "a flap below the smallest number": tables(
        "parallel-repeating", PARABOLA, formula("0*x", 0, 4), rows=3, columns=3, flap=1e-320
    ),
    "a depth whose panels met": tables(
        "orthodiagonal",
        PARABOLA,
        formula("0.25*sin(pi*x/2)", 0, 4),
        rows=9,
        columns=11,
        flap=0.15,
        depth=0.638,
        heading_deg=100,
    ),
    "an angle whose panels met": tables(
        "parallel-repeating",
        formula(["t", "1.3*t + 0.05*t**2"], 0, 1),
        formula(["0.05*t*cos(t)", "0.05*t*sin(t)"], 60, 90),
        rows=1,
        columns=40,
        xi_deg=60,
        flap=0.02,
    ),
    "a length far from the nearest": tables(
        "longitudinal-linear-repeating",
        UNIT_ARC,
        formula("0*x", 0, 2.93),
        rows=15,
        columns=9,
        sector_deg=[85, 80, 95, 100],
    ),
}


@pytest.mark.parametrize("case", led_by(FOUND_IN_USE))
def test_what_is_offered_works(case: str) -> None:
    design = FOUND_IN_USE[case]
    error = refused(design)
    assert error is not None
    assert error.remedies
    for remedy in error.remedies:
        assert str(remedy) in str(error)
        assert refused(mended(design, remedy)) is None


@thorough
def test_the_nearest_length_is_offered() -> None:
    # 0.70 of it works, as was found by trying.
    design = FOUND_IN_USE["a length far from the nearest"]
    error = refused(design)
    assert error is not None
    scale = error.remedies[0].changes["target.g.scale"]
    assert isinstance(scale, float)
    assert scale > 0.7


def test_walls_near_vertical_are_for_the_orthodiagonal_family() -> None:
    walls = formula(["cos(t)", "sin(t)"], -0.1, 3.24)
    keys = {"rows": 9, "columns": 4, "xi_deg": 50, "flap": 0.1}
    design = tables("parallel-repeating", walls, formula("0*x", 0, 4), **keys)
    error = refused(design)
    assert error is not None
    first = error.remedies[0]
    assert first.changes["shell.family"] == "orthodiagonal"
    assert made(mended(design, first)).report.family == "orthodiagonal"


def test_where_nothing_works_the_message_says_so_and_what_limits() -> None:
    # A family whose rows all turn the same way follows no straight f, whatever its parameters are.
    line = formula("0.3*x", 0, 2)
    size = {"rows": 3, "columns": 3, "sector_deg": "auto"}
    error = refused(tables("longitudinal-linear-repeating", line, formula("0*x", 0, 2), **size))
    assert error is not None
    assert error.remedies == ()
    assert str(error).endswith("No value was found that works: another f or g is needed.")


def random_design(rng: np.random.Generator) -> Tables:
    """A small request of any family, most of which cannot be made."""

    def number(low: float, high: float) -> float:
        return round(float(rng.uniform(low, high)), 3)

    def curve(size: float) -> Tables:
        a, b, c = number(-0.9, 0.9), number(-0.6, 0.6), number(0.5, 2.5)
        arc = formula([f"{size}*cos(t)", f"{c * size}*sin(t)"], number(-0.4, 1), number(2, 3.6))
        wave = formula(f"{size * b}*sin({c}*x/{size}) + {a}*x", -size, number(0.2, 1.5) * size)
        points = np.cumsum(rng.uniform([0.2, -0.7], [1.2, 0.7], (5, 2)), axis=0) * size
        drawn = {"points": points.round(3).tolist(), "smooth": bool(rng.integers(2))}
        return [arc, wave, formula(f"{a / size}*x**2", -size, size), drawn][rng.integers(4)]

    size = {"rows": 2 * int(rng.integers(0, 3)) + 1, "columns": int(rng.integers(2, 6))}
    flap = [{}, {"flap": number(0.01, 1.5)}][rng.integers(2)]
    pattern: dict[str, Any]
    match rng.integers(20):
        case kind if kind < 9:
            family, g = "parallel-repeating", curve(number(1, 6))
            pattern = {
                "xi_deg": number(5, 170),
                "theta_deg": number(-30, 30),
                "plane_deg": number(30, 150),
            }
        case kind if kind < 19:
            family, g = "orthodiagonal", curve(number(0.3, 3))
            pattern = {"depth": number(0.01, 0.8), "heading_deg": number(20, 160)}
        case _:
            family, g = "longitudinal-linear-repeating", formula("0*x", 0, number(0.2, 4))
            pattern = {"sector_deg": [number(70, 110) for _ in range(4)]}
    return tables(family, curve(1.0), g, **size, **flap, **pattern)


SHARES = 6
REFUSALS = 25 if THOROUGH else 2


@thorough
@pytest.mark.slow
@pytest.mark.parametrize("seed", range(SHARES))
def test_every_offer_of_random_refusals_works(seed: int) -> None:
    rng = np.random.default_rng(seed)
    refusals: list[DesignError] = []
    while len(refusals) < REFUSALS:
        design = random_design(rng)
        error = refused(design)
        if error is None:
            continue
        refusals.append(error)
        assert bool(error.remedies) != bool(error.limit)
        for remedy in error.remedies:
            assert refused(mended(design, remedy)) is None, (design, str(error))
    # Nearly all can be mended; the others say what limits.
    assert sum(bool(error.remedies) for error in refusals) > 0.8 * len(refusals)
