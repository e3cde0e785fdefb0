"""T-hedral shells over surfaces: to second order where level lines are beside each other."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from orishell.design_file import check_design
from orishell.shell.make import make_shell
from orishell.shell.steps import Step

REST: tuple[Step, ...] = ("remedies", "verification", "pack", "weight", "stock")
SLOPE = "sqrt(1 + 0.36*u**2)"
MOULDING = {
    "formula": [f"u - 0.6*u*v/{SLOPE}", f"0.3*u**2 + v/{SLOPE}", "-0.4*v**2"],
    "u": [-1.5, 1.5],
    "v": [-0.7, 0.7],
}
"""The profile -0.4 d^2 square to the parabola y = 0.3 x^2."""
TRANSLATION = {"formula": "-0.3*x**2 - 0.1*y**2", "x": [-1, 1], "y": [-1, 1]}


def distance(surface: dict[str, Any], count: int) -> float:
    tables = {
        "shell": {"family": "t-hedral", "unit": "m"},
        "target": {"surface": surface},
        "pattern": {"rows": count, "columns": count, "flap": 0},
        "motion": {"frames": 2},
    }
    file = check_design(tables, Path("roof.toml"), files=False)
    shell = make_shell(file, clash="unexamined", skip=REST)
    assert shell.deviation is not None
    return shell.deviation.max


def test_a_moulding_surface_is_followed_to_second_order() -> None:
    """A quarter of the distance with twice the edges, less what a fit of both curves leaves."""
    coarse, fine = (distance(MOULDING, count) for count in (7, 15))
    assert 3.5 < coarse / fine < 6


def test_a_translation_surface_that_bends_both_ways_is_not() -> None:
    coarse, fine = (distance(TRANSLATION, count) for count in (7, 15))
    assert fine == pytest.approx(coarse, rel=0.05)
