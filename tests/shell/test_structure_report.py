"""What the report says of an analysis: of results that are made up (``analysed``)."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from analysed import LENGTH, RISE, SPAN, STRUCTURE, analysed
from orishell.conventions.record import as_table
from orishell.structure.changes import (
    ENOUGH,
    Changes,
    Figures,
    Stop,
    find_changes,
    refinement_warnings,
)
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.free_motion import FreeMotion
from orishell.structure.load_settings import NO_CODE, LoadCase
from orishell.structure.results import Analysis

ROOT = np.sqrt(2)
AREA = SPAN * LENGTH * ROOT


@pytest.fixture(scope="module")
def report() -> Analysis:
    return analysed()


def changed(found: Analysis, change: Callable[[Equilibrium], Equilibrium]) -> Analysis:
    """An analysis whose cases stand otherwise."""
    cases = (replace(case, equilibrium=change(stands)) for stands, case in found.balanced)
    return replace(found, cases=tuple(cases))


def words(found: Analysis) -> str:
    """What every case does, a line each."""
    return "\n".join(f"{found.name_of(case)}: {case.in_words()}" for case in found.cases)


def test_the_model(report: Analysis) -> None:
    model = report.model
    assert (model.nodes, model.triangles, model.freedoms) == (15, 16, 3 * 15 + 3 * 18)
    assert (model.mass, model.height, model.thickness) == (32.2, RISE, 0.01)
    assert as_table(model.change) == {"displacement": 0.02, "stress": 0.05, "buckling": 0.01}
    # E t/(1 - nu^2) = 270e6 * 0.01 / 0.91, and t^2/12 of it.
    assert model.membrane_stiffness == pytest.approx([2.967033e6] * 2, rel=1e-6)
    assert model.bending_stiffness == pytest.approx([24.725275] * 2, rel=1e-6)
    assert model.crease_stiffness == ("free", "rigid")
    assert model.tie_stiffness == 1.2e6
    assert [(each.at, each.kind, each.friction) for each in model.structure.supports] == [
        ("feet", "sliding", 0),
        (((0, 1), (2, 1)), "friction", 0.5),
    ]


def test_loads_add_up_kind_by_kind(report: Analysis) -> None:
    case = report.cases[0]
    assert [(load.case, load.factor, load.kind) for load in case.loads] == [
        ("dead", 1.35, "self_weight"),
        ("snow", 1.5, "snow"),
        ("snow", 1.5, "points"),
    ]
    # mu = 0.8 on a plan of 12 m2.
    forces = [-1.35 * 1.9 * 9.81 * AREA, -1.5 * 500 * 0.8 * 12, -1.5 * 80]
    assert [load.force[2] for load in case.loads] == pytest.approx(forces)
    assert case.load == pytest.approx([0, 0, sum(forces)])
    assert [load.pressure for load in case.loads] == [None, 500, None]
    assert "undrifted, mu = 0.8 all over" in case.loads[1].rule


def test_wind_says_what_it_comes_from(report: Analysis) -> None:
    pressure, wind = report.cases[1].loads
    assert (pressure.pressure, pressure.rule) == (10, "square on the outer face")
    # At z_min = 2 m in terrain II, see tests/structure/test_loads.py.
    assert wind.pressure == pytest.approx(601.39, rel=2e-5)
    assert "26 m/s towards 90 degrees from x, terrain II, 2 m over the ground" in wind.rule
    assert "mean wind 18.22 m/s, turbulence 0.271" in wind.rule
    assert wind.rule.endswith("by the angle between each panel and the wind")


def test_what_is_largest_and_where(report: Analysis) -> None:
    """Panels are those of the folding sheet, whose column 0 are flaps here."""
    stands = report.cases[2].equilibrium
    assert stands is not None
    assert stands.displacement.size == 0.15
    assert stands.displacement.vector == (0, 0, -0.15)
    assert stands.displacement.panel == (0, 1)
    assert stands.displacement.share == 0.075
    assert [(tie.ends, tie.force) for tie in stands.ties] == [
        (((0, 2), (2, 2)), 4000),
        (((0, 1), (2, 1)), 1000),
        (((1, 1), (2, 1)), 0),
    ]
    assert [(flap.ends[0], flap.force) for flap in stands.flaps] == [((1, 0), 30), ((0, 0), 0)]
    assert stands.crease is not None
    assert (stands.crease.moment, stands.crease.panels) == (5, ((0, 1), (1, 1)))
    assert (stands.stress.size, stands.stress.panel, stands.stress.face) == (2e6, (1, 1), "upper")
    assert (stands.stress.largest, stands.stress.least) == (2e6, -1e5)
    assert [each.at for each in stands.reactions] == [(0, 1), (2, 1)]
    assert np.sum([each.force for each in stands.reactions], axis=0) == pytest.approx(
        stands.reaction
    )
    assert stands.frequencies == (3, 4, 7)


def test_free_creases_bear_no_moment(report: Analysis) -> None:
    stands = report.cases[1].equilibrium
    assert stands is not None
    assert stands.crease is None
    assert stands.utilisation.creases == 0


def test_what_governs(report: Analysis) -> None:
    stands = report.cases[2].equilibrium
    assert stands is not None
    used = stands.utilisation
    # 2 of 5.5 MPa, 5 of 20 N, 4 of 5 kN, and 1/2.5.
    assert used.panels == pytest.approx(2 / 5.5)
    assert (used.creases, used.ties, used.buckling, used.governs) == (0.25, 0.8, 0.4, "ties")
    assert report.governs is not None
    assert (report.governs.part, report.governs.utilisation) == ("ties", 0.8)


def test_a_strength_that_is_not_known_governs_nothing() -> None:
    bare = STRUCTURE.replace_unchecked(
        strength=None, crease_strength=None, line_strength=None, tie_strength=None
    )
    found = analysed(bare)
    assert found.governs is not None
    assert found.governs.part == "buckling"
    assert changed(found, lambda stands: replace(stands, buckling_factors=())).governs is None


def test_what_moves_is_an_answer(report: Analysis) -> None:
    case = report.cases[0]
    assert case.equilibrium is None
    assert case.carries is False
    assert case.in_words().startswith("opens under its loads: nothing holds the feet together")
    assert report.in_words().startswith("no: 1 of 4 cases fail; under both, free creases it opens")


@pytest.mark.parametrize(
    ("motion", "says"),
    [
        ((True, False), "closes under its loads: nothing holds the feet apart"),
        ((False, None), "slides or tips as a whole under its loads"),
    ],
)
def test_every_motion_has_its_words(motion: tuple[bool, bool | None], says: str) -> None:
    folding, opens = motion
    moving = FreeMotion(np.zeros((15, 3)), folding=folding, opens=opens)
    found = analysed()
    cases = tuple(replace(case, motion=moving, equilibrium=None) for case in found.cases)
    assert says in words(replace(found, cases=cases))


def test_warnings(report: Analysis) -> None:
    told = "\n".join(report.warnings)
    assert "load cases wind: own weight is left out" in told
    assert "of no code" not in told
    said = words(report)
    assert "is displaced by 0.15 m (7.5 % of its height) near panel 0, 1" in said
    assert "buckles under 2.5 times its loads" in said
    assert "strength" not in said
    assert report.cases[1].carries is None


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (
            lambda each: replace(each, stresses=3.025 * each.stresses),
            "uses 110 % of the strength of its panels",
        ),
        (
            lambda each: replace(each, tie_forces=1.5 * each.tie_forces),
            "uses 120 % of the strength of its ties",
        ),
        (
            lambda each: replace(each, crease_moments=6 * each.crease_moments),
            "uses 150 % of the strength of its creases",
        ),
    ],
)
def test_what_bears_too_much(change: Callable[[Equilibrium], Equilibrium], says: str) -> None:
    found = changed(analysed(), change)
    assert says in found.cases[-1].in_words()
    assert found.carries is False


def test_coefficients_of_no_code_are_named() -> None:
    wind = STRUCTURE.cases[3].wind
    assert wind is not None
    gusts = wind.replace_unchecked(coefficients=NO_CODE)
    cases = (*STRUCTURE.cases[:3], LoadCase(name="wind", wind=gusts))
    asked = STRUCTURE.replace_unchecked(cases=cases)
    found = analysed(asked)
    assert found.cases[1].loads[0].rule.endswith("of no code")
    assert any("wind are of no code" in text for text in found.warnings)


def test_a_sound_structure_is_warned_of_nothing() -> None:
    dead = LoadCase(name="wind", self_weight=True)
    found = analysed(STRUCTURE.replace_unchecked(cases=(*STRUCTURE.cases[:3], dead)))
    stands, case = found.balanced[-1]
    sound = replace(stands, displacements=0.1 * stands.displacements, buckling_factors=(4.0,))
    found = replace(found, cases=(replace(case, equilibrium=sound),))
    assert not found.warnings
    assert (found.sign, found.carries) == ("holds", True)


def test_it_is_json(report: Analysis) -> None:
    assert (
        json.loads(json.dumps(as_table(report), allow_nan=False))["cases"][0]["equilibrium"] is None
    )


@pytest.mark.parametrize(
    ("change", "stopped", "says"),
    [
        (Changes(0.1, 0.1, 0.03), None, ""),
        (Changes(0.2, 0.1, 0.01), None, "the next coarser one displacement by 20 %. Use finer"),
        (
            Changes(0.2, 0.3, 0.04),
            None,
            "displacement by 20 %, stress by 30 % and the buckling factor by 4 %. Use finer",
        ),
        (Changes(0.04, 0.06, 0.01), "work", "would take too long. From the next coarser mesh"),
        (Changes(0.2, 0.06, 0.01), "memory", "they changed by 20 % at most: displacement by 20 %"),
    ],
)
def test_figures_that_change_with_the_mesh_are_said(
    change: Changes, stopped: Stop | None, says: str
) -> None:
    """Above 10 % of displacement and stress and 3 % of buckling, and where refinement ended."""
    text = "\n".join(refinement_warnings(change, stopped, ENOUGH))
    assert says in text
    assert "missing" not in text
    assert bool(says) is bool(text)


@pytest.mark.parametrize("stopped", [None, "work"])
def test_a_change_from_few_cells_is_not_said_to_be_the_error(stopped: Stop | None) -> None:
    """Which was up to three times as large (``test_more_is_missing_than_few_cells_change``)."""
    (text,) = refinement_warnings(Changes(0.2, 0.1, 0.01), stopped, 3)
    assert "with 3 cells three times as much may be missing" in text


def test_changes_are_those_of_the_case_that_changes_most() -> None:
    """A case that one mesh only finds to stand, or to buckle, is not settled at all."""
    coarse = [Figures(1.0, 4.0, 2.0), Figures(3.0, 2.0, None)]
    fine = [Figures(1.25, 4.0, 2.5), Figures(2.0, 2.0, None)]
    assert as_table(find_changes(coarse, fine)) == {
        "displacement": 0.5,
        "stress": 0.0,
        "buckling": 0.2,
    }
    assert find_changes(coarse, [Figures(), Figures(3.0, 2.0, 5.0)]).largest == 1.0
    assert find_changes([], []).largest == 0.0
