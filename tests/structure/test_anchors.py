"""What supports ask of the ground, against the reactions of every case."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from analysed import analysed
from orishell.structure.anchors import ASSUMED, anchors_in_words
from orishell.structure.pages.anchor_tables import HEAD, anchor_rows
from orishell.structure.results import Analysis

UP, ASIDE = 30.0, 12.0


@pytest.fixture(scope="module")
def lifted() -> Analysis:
    """The tent: a foot is pulled up by 30 N and aside by 12 N in one case, the other is pressed."""
    found = analysed()
    cases = []
    for case in found.cases:
        held = case.equilibrium
        if held is not None and case.name == "wind":
            forces = np.array([[3.0, 4.0, 100.0], [0.0, ASIDE, -UP]])
            held = replace(held, support_forces=forces)
        cases.append(replace(case, equilibrium=held))
    return replace(found, cases=tuple(cases))


def test_ballast_holds_a_foot_down_and_in_place(lifted: Analysis) -> None:
    """30 N so that it is not pulled up, and 12/0.3 more so that friction holds it."""
    first, second = lifted.anchors
    assert (second.pull.force, second.sideways.force) == (UP, ASIDE)
    assert second.ballast.force == pytest.approx(UP + ASIDE / ASSUMED)
    assert second.ballast_mass == pytest.approx((UP + ASIDE / ASSUMED) / 9.81)
    assert second.assumed
    assert first.pull.force == 0
    assert first.pull.case is None
    assert second.pull.case is not None
    assert second.pull.case.startswith("wind")
    for number, anchor in enumerate(lifted.anchors):
        forces = [held.support_forces[number] for held, _ in lifted.balanced]
        assert anchor.push.force == max(0.0, *(force[2] for force in forces))
        weight = anchor.ballast.force * (1 + 1e-12)
        assert all(weight + force[2] >= 0 for force in forces)
        assert all(np.hypot(*force[:2]) <= ASSUMED * (weight + force[2]) for force in forces)


def test_what_is_pulled_up_is_told(lifted: Analysis) -> None:
    assert any("1 support is pulled up, by 30 N" in text for text in lifted.warnings)
    assert anchors_in_words(lifted.anchors).startswith("pulled up by 30 N at most at [2, 1]")


def test_the_table_has_every_support(lifted: Analysis) -> None:
    rows = [dict(zip(HEAD, row, strict=True)) for row in anchor_rows(lifted)]
    assert [(row["row"], row["column"]) for row in rows] == [(0, 1), (2, 1)]
    assert [float(str(row["pull_N"])) for row in rows] == [0.0, UP]
