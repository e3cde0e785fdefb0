"""The panels that a tolerance takes, against brute force: every sheet with fewer, and five values.

The problems are drawn at random, but by their number: the same ones every time.
"""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import pytest

from orishell.conventions.errors import OrishellError
from orishell.design_file import DesignFile, check_design
from orishell.families.pattern import Pattern
from orishell.shell.size_trials import measure
from orishell.shell.tolerance import meet_tolerance
from samples import THOROUGH

PARALLEL, ORTHODIAGONAL, LONGITUDINAL = (
    "parallel-repeating",
    "orthodiagonal",
    "longitudinal-linear-repeating",
)
ALL = [(family, n) for n in range(7) for family in (PARALLEL, ORTHODIAGONAL, LONGITUDINAL)][:20]
QUICK = [(PARALLEL, 3), (LONGITUDINAL, 0)]


def problem(family: str, number: int) -> DesignFile:
    """An arch or a wave along a wave, and a distance that some sheet meets."""
    chance = random.Random(f"{family} {number}")

    def drawn(low: float, high: float) -> float:
        return round(chance.uniform(low, high), 2)

    rise, wave = drawn(0.2, 1.1), 0.0 if family == LONGITUDINAL else drawn(0.05, 0.5)
    arch = {"formula": f"-{rise}*x**2", "range": [-1, drawn(0.5, 1)]}
    arc = {"formula": ["cos(t)", f"{rise}*sin(t)"], "range": [drawn(0.3, 0.9), drawn(2, 2.8)]}
    bent = {"formula": f"{rise}/2*sin(2*x)", "range": [-0.5, drawn(1, 2.5)]}
    f = chance.choice([arch, arc] if family == LONGITUDINAL else [arch, arc, bent])
    g = {"formula": f"{wave}*sin({drawn(0.5, 2)}*x)", "range": [0, drawn(2, 6)]}
    surface = {
        PARALLEL: drawn(0.06, 0.25),
        ORTHODIAGONAL: drawn(0.12, 0.3) + 0.3 * wave,
        LONGITUDINAL: drawn(0.03, 0.1),
    }[family]
    return check_design(
        {
            "shell": {"family": family, "unit": "m"},
            "target": {"f": f, "g": g},
            "pattern": {"sector_deg": "auto"} if family == LONGITUDINAL else {},
            "tolerance": {"surface": surface},
        },
        Path("shell.toml"),
    )


def five_values(family: str, surface: float) -> list[dict[str, Any]]:
    """What is "auto" in a family, and four other values of it."""
    if family == PARALLEL:
        return [{"xi_deg": xi} for xi in ("auto", 30.0, 45.0, 60.0, 90.0)]
    if family == ORTHODIAGONAL:
        shares = (0.25, 0.5, 0.75, 0.97)
        return [{"depth": depth} for depth in ("auto", *(share * surface for share in shares))]
    angles = [[90 - k, 90 - 2 * k, 90 + k, 90 + 2 * k] for k in (5.0, 2.0, 1.0, 0.1)]
    return [{"sector_deg": each} for each in ("auto", *angles)]


def does(file: DesignFile, pattern: Pattern) -> bool:
    """Whether a sheet comes as near as asked, carefully measured."""
    assert file.tolerance is not None
    try:
        design = pattern.design(file.f, file.g)
    except OrishellError:
        return False
    limit = file.tolerance.surface
    if measure(design, careful=False, tolerance=file.tolerance).error > limit:
        return False
    return measure(design, careful=True).error <= limit


@pytest.mark.slow
@pytest.mark.parametrize(("family", "number"), ALL if THOROUGH else QUICK)
def test_no_sheet_with_fewer_panels_comes_as_near(family: str, number: int) -> None:
    file = problem(family, number)
    assert file.tolerance is not None
    _, choice = meet_tolerance(file, file.tolerance)
    assert choice.trial.error <= file.tolerance.surface
    better = [
        (rows, columns, values)
        for rows in range(1, choice.trial.panels, file.pattern.row_step)
        for columns in range(2, choice.trial.panels // (rows + 1) + 2)
        if (rows + 1) * (columns - 1) < choice.trial.panels
        for values in five_values(family, file.tolerance.surface)
        if does(file, file.pattern.sized(rows, columns).model_copy(update=values))
    ]
    assert not better


def test_a_shell_of_two_panels_is_found() -> None:
    # 3 x 2 with the depth of "auto" was taken, because no search began below 3 rows.
    file = check_design(
        {
            "shell": {"family": ORTHODIAGONAL, "unit": "m"},
            "target": {
                "f": {"formula": ["2*cos(t)", "2*sin(t)"], "range": [0.3, 2.84]},
                "g": {"formula": "0.1*sin(pi*x/2)", "range": [0, 6]},
            },
            "pattern": {"flap": 0},
            "tolerance": {"surface": 0.35},
        },
        Path("shell.toml"),
    )
    assert file.tolerance is not None
    sized, choice = meet_tolerance(file, file.tolerance)
    assert (sized.pattern.rows, sized.pattern.columns, choice.trial.panels) == (1, 2, 2)
