"""Feet that ballast holds: whether they lift or slip, by hand, and what would hold them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analysed import analysed
from orishell.conventions.errors import InputError
from orishell.conventions.quantities import GRAVITY
from orishell.structure.case import CaseResult
from orishell.structure.combinations import LimitState
from orishell.structure.results import Analysis

from .test_materials import read
from .test_verdicts import arch

UP, ASIDE, MASS = 30.0, 12.0, 5.0


def standing(state: LimitState | None, mass: float = MASS, friction: float = 0.0) -> CaseResult:
    """The tent under wind: a foot is pulled up by 30 N and aside by 12 N, the other is pressed."""
    found = analysed()
    case = next(each for each in found.cases if each.name == "wind")
    held = case.equilibrium
    assert held is not None
    model: Any = type(held.model)(found.model.design, found.model.structure, found.model.site, 2)
    vars(model)["supports"] = SimpleNamespace(
        lost=(), share=0.0, ballast=np.array([0.0, mass]), rubs=np.array([0.0, friction])
    )
    forces = np.array([[0.0, -900.0, -100.0], [0.0, ASIDE, -UP]])
    held = replace(held, model=model, support_forces=forces, displacements=0 * held.displacements)
    return replace(case, equilibrium=held, limit_state=state)


def test_ballast_counts_nine_tenths_in_equ() -> None:
    """3.2 kg weigh 31.4 N and hold 30 N; in EQU they hold 28.3 N only (EN 1990, table A1.2(A))."""
    assert not [each for each in standing(None, 3.2).findings if each.kind == "lifts off"]
    case = standing("EQU", 3.2)
    worst = case.ballast
    assert worst is not None
    assert (worst.at, worst.kind, worst.force) == ((2, 1), "lifts off", UP)
    assert worst.holds == pytest.approx(0.9 * 3.2 * GRAVITY)
    assert worst.used == pytest.approx(UP / worst.holds)
    assert worst.needed == pytest.approx(UP / 0.9 / GRAVITY)
    (finding,) = case.findings
    assert finding.sign == "fails"
    assert finding.excess == worst.used
    assert case.used == worst.used
    assert case.lifts_only
    assert case.said == (
        "lifts its foot 2, 1, which is pulled up by 30 N: ballast of 3.2 kg, times 0.9, holds "
        "28.25 N (3.4 kg would)"
    )


def test_friction_under_ballast() -> None:
    """H <= mu (0.9 W + R): 0.5 x (44.1 - 30) = 7.07 N against 12 N."""
    worst = standing("EQU", MASS, 0.5).ballast
    assert worst is not None
    holds = 0.5 * (0.9 * MASS * GRAVITY - UP)
    assert (worst.kind, worst.force) == ("slips", ASIDE)
    assert worst.holds == pytest.approx(holds)
    assert worst.used == pytest.approx(ASIDE / holds)
    assert worst.needed == pytest.approx((ASIDE / 0.5 + UP) / 0.9 / GRAVITY)
    held = standing("EQU", worst.needed * (1 + 1e-9), 0.5)
    assert held.ballast is not None
    assert held.ballast.used <= 1
    assert not held.findings


def test_a_foot_that_lifts_is_not_said_to_slip() -> None:
    """What is lifted does not press, so no friction would hold it aside: 8.83 N against 30 N."""
    worst = standing(None, 1.0, 0.5).ballast
    assert worst is not None
    assert worst.kind == "lifts off"
    assert worst.used == pytest.approx(UP / GRAVITY)


@pytest.mark.parametrize("state", ["ULS", "SLS"])
def test_equilibrium_is_judged_in_equ_only(state: LimitState) -> None:
    assert standing(state, 0.1).ballast is None


WIND = {"speed": 26, "terrain": "II", "direction_deg": 90, "coefficients": [[0, 0.8], [180, -1]]}
CASES: list[dict[str, Any]] = [
    {"name": "dead", "self_weight": True},
    {"name": "storm", "wind": WIND},
]


def ballasted(mass: float, friction: float) -> Analysis:
    support = {"at": "feet", "kind": "pinned", "ballast": mass, "friction": friction}
    keys = {"supports": [support], "combinations": "EN 1990", "line_strength": 1e6, "cells": 1}
    return arch(keys, CASES)


def test_the_verdict_names_the_combination_that_lifts() -> None:
    """EQU with 0.9 of own weight is the worst; each foot by its reactions; the answer's ballast
    holds, and a hundredth less does not."""
    found = ballasted(20.0, 0.6)
    lifted = {case.name for case in found.cases if case.ballast and case.ballast.used > 1}
    assert "EQU 0.9 dead + 1.5 storm" in lifted
    assert all(name.startswith("EQU") for name in lifted)
    assert found.carries is False
    for case in found.cases:
        if case.limit_state != "EQU":
            continue
        assert case.equilibrium is not None
        x, y, up = case.equilibrium.support_forces.T
        presses = 0.9 * 20 * GRAVITY + up
        slips = np.hypot(x, y) / (0.6 * np.maximum(presses, 1e-300))
        most = max(float((-up / (0.9 * 20 * GRAVITY)).max()), float(slips.max()))
        assert case.ballast is not None
        assert (case.ballast.used > 1) is (most > 1)
        if presses.min() > 0:
            assert case.ballast.used == pytest.approx(most, rel=1e-6)
        else:
            assert case.ballast.kind == "lifts off"
    (equ,) = (each for each in found.envelopes if each.limit_state == "EQU")
    assert equ.part == "ballast"
    needed = max(each.ballast_mass for each in found.anchors)
    assert all(each.given == 20 and each.friction == 0.6 for each in found.anchors)
    assert all(not case.lifts_only for case in ballasted(1.0001 * needed, 0.6).cases)
    assert any(case.lifts_only for case in ballasted(0.99 * needed, 0.6).cases)


STRUCTURE = '[structure]\nmaterial = "steel"\nthickness = 0.002\nsupports = [{supports}]\n'
FEET = '{ at = "feet", kind = "pinned"'


@pytest.mark.parametrize(
    ("supports", "says"),
    [
        (FEET + ", ballast = -5 }", "ballast"),
        (FEET + ', ballast = "5 kg" }', "ballast"),
        (FEET + ", ballast = true }", "ballast"),
        (FEET + ", ballast = 1e13 }", "ballast"),
        (FEET + ", friction = 0.5 }", '"pinned" with ballast'),
        ('{ at = "feet", kind = "sliding", ballast = 50, friction = 0.5 }', "no friction"),
        (
            '{ at = "feet", kind = "friction", ballast = 50, friction = 0.5 }',
            "no ballast where kind = friction",
        ),
    ],
)
def test_bad_values_are_refused(tmp_path: Path, supports: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        read(tmp_path, STRUCTURE.replace("{supports}", supports))


def test_two_ballasts_at_one_foot_are_refused() -> None:
    supports = [
        {"at": "feet", "kind": "pinned", "ballast": 50.0},
        {"at": [[0, 0]], "kind": "pinned", "ballast": 60.0},
    ]
    with pytest.raises(InputError, match="two ways") as refused:
        arch({"supports": supports})
    assert "with ballast of 60 kg" in str(refused.value)
