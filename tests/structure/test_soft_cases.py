"""Cases that buckle soon by linear theory: followed by themselves, or not known to carry."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from followed_shells import asked, held
from one_verdict import one_verdict
from orishell.structure import soft_cases
from orishell.structure.analyse import analyse
from orishell.structure.built_shape import usual_imperfection
from orishell.structure.case import CaseResult
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.nonlinear import follow
from orishell.structure.results import Analysis
from orishell.structure.settings import LoadCase

SOFT = 40.0
"""Areal mass (kg/m2) under which the shell of 3 mm buckles at 1.44 times its loads."""


def shell(mass: float, *cases: LoadCase) -> Analysis:
    """Of 3 mm, under cases of its own; made of one that is not soft, which others share."""
    model = asked("pinned", mass, thickness=0.01, nonlinear=False).model
    keys = {"thickness": 0.003, "cases": cases or model.structure.cases}
    return analyse(model.design, model.structure.replace_unchecked(**keys), model.site)


def test_a_case_that_buckles_soon_is_followed() -> None:
    """It has what ``nonlinear`` finds, with as much imperfection or none given; no more doubt."""
    found = shell(SOFT)
    case, stands = found.cases[0], held(found)
    path = stands.path
    assert path is not None
    assert path.linear_buckling is not None
    assert 1 < path.linear_buckling < 3
    assert path.imperfection > 0
    assert all(each.kind != "buckles" for each in case.findings) is path.carries
    for given in (path.imperfection, None):
        same = held(asked("pinned", SOFT, thickness=0.003, imperfection=given))
        np.testing.assert_array_equal(stands.displacements, same.displacements)
    assert stands.displacement.size > 1.05 * path.linear_displacement


def test_how_far_a_shell_is_taken_to_be_off_its_shape() -> None:
    """A vertex by h/200, or the middle of a panel by 1/200 of its shorter side: one is reached.

    With 2 cells a side, the middle node of a panel is at the mean of its corners, where its sides
    are as long as those across.
    """
    linear = held(shell(10.0))
    model, mode = linear.model, linear.buckling_modes[0]
    off = usual_imperfection(linear)
    corners = model.mesh.nodes[:, [0, -1, -1, 0], [0, 0, -1, -1]]
    vertices = off * np.linalg.norm(mode[corners], axis=-1).max()
    bows = off * np.linalg.norm(
        mode[model.mesh.nodes[:, 1, 1]] - mode[corners].mean(axis=1), axis=1
    )
    points = model.mesh.facets.points[corners]
    sides = np.linalg.norm(np.roll(points, 1, axis=1) - points, axis=-1).min(axis=1)
    most = [vertices / model.height, *(bows / sides)]
    assert max(most) == pytest.approx(1 / 200, rel=1e-9)


def test_shells_far_from_buckling_are_not_followed(monkeypatch: pytest.MonkeyPatch) -> None:
    """At three times the loads or more, and below one: that is known to fail."""

    def never(*_: Any, **__: Any) -> Equilibrium:
        raise AssertionError

    monkeypatch.setattr(soft_cases, "follow", never)
    far = shell(15.0)
    assert held(far).buckling is not None
    assert (held(far).buckling or 0) > 3
    assert held(far).unfollowed is None
    below = shell(70.0)
    assert (held(below).buckling or 2) < 1
    assert below.cases[0].carries is False


def buckles(case: CaseResult) -> list[str]:
    return [each.text for each in case.findings if each.kind == "buckles"]


def test_what_would_take_too_long_is_not_known(monkeypatch: pytest.MonkeyPatch) -> None:
    """The same linear figures, a sign that warns, and the reason in words."""
    monkeypatch.setattr(soft_cases, "SECONDS", 0.01)
    found = shell(SOFT, LoadCase(name="own", self_weight=True))
    case, stands = found.cases[0], held(found)
    assert stands.path is None
    assert stands.unfollowed == "work"
    assert one_verdict(found) is None
    assert "following it would take too long" in buckles(case)[0]
    assert stands.buckling == pytest.approx(1.44, rel=0.02)


def test_the_lowest_factor_is_followed_first(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where work ends, what is nearest to buckling is known."""
    order: list[float] = []

    def noted(linear: Equilibrium, *args: Any, **keys: Any) -> Equilibrium:
        order.append(linear.buckling or 0.0)
        return follow(linear, *args, **keys)

    monkeypatch.setattr(soft_cases, "follow", noted)
    own = LoadCase(name="own", self_weight=True)
    cases = [LoadCase(name=f"{k}", combine={"own": k}) for k in (0.6, 1.0, 0.8, 0.4)]
    found = shell(SOFT, own, *cases)
    assert order == sorted(order)
    assert len(order) == 3  # 0.4 has a factor of 3.6
    assert [each.equilibrium.path is None for each in found.cases if each.equilibrium] == [
        False, False, False, True,
    ]  # fmt: skip


def test_a_shell_that_fails_anyway_is_not_followed() -> None:
    """Under twice its weight it buckles: that under one time it may not is no news."""
    own = LoadCase(name="own", self_weight=True)
    cases = [LoadCase(name=f"{k}", combine={"own": k}) for k in (1.0, 2.0)]
    found = shell(SOFT, own, *cases)
    first = found.cases[0].equilibrium
    assert first is not None
    assert first.unfollowed == "fails"
    assert found.cases[0].carries is None
    assert found.carries is False


def test_a_followed_shell_says_so_everywhere() -> None:
    found = shell(SOFT)
    said = found.not_covered
    assert "under 3 times their loads or more" in said[0]
    assert any("of shape but of cases that buckle soon" in each for each in said)
    if found.cases[0].carries:
        assert "large displacements followed" in found.cases[0].in_words()
