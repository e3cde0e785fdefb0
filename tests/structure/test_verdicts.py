"""Verdicts that were wrong once: words, field, colour and exit status say one thing.

The shells of ``verdicts`` and their right answers are those of an independent check, by own statics
and CalculiX; where a file takes long a shell of its kind stands here for it.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from one_verdict import one_verdict
from orishell.conventions.errors import InputError
from orishell.design_file import read_design_file
from orishell.design_file.file import check_design
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from orishell.structure.hinge_lines import LineStrength
from orishell.structure.mesh.sections import Section, thickness_left
from orishell.structure.results import Analysis
from samples import led_by

FILES = Path(__file__).parent / "verdicts"
ARCH = """
[shell]
family = "orthodiagonal"
unit = "m"
[target.f]
formula = ["1.5*cos(t)", "1.6*sin(t)"]
range = [0, 3.141592653589793]
[target.g]
formula = "0.1*cos(2*pi*x)"
range = [0, 2]
[pattern]
rows = 7
columns = 5
flap = 0
depth = 0.16
heading_deg = 90
spacing = "equal"
[deployment]
from = "pack"
ties = "feet"
[workshop]
areal_density = 6
[structure]
modulus = 8e9
thickness = 0.03
strength = 16e6
cells = 2
crease_stiffness = "free"
supports = [{ at = "feet", kind = "pinned", edges = true }]
[[load_case]]
name = "snow"
self_weight = true
snow = { ground = 500, shape = "cylinder", arrangement = "undrifted" }
"""
"""Feet pinned, hinges free, 500 N/m2 of snow: crease lines pull 59.8 kN/m under 3 kN of load."""
POINTS = {"supports": [{"at": "feet", "kind": "pinned"}]}
SKIP = (*MEASURES, "stock", "verification", "remedies")


def arch(
    keys: Mapping[str, Any] | None = None,
    cases: list[dict[str, Any]] | None = None,
    panel: Mapping[str, Any] | None = None,
) -> Analysis:
    """The arch, with other keys of [structure], other load cases and a table [panel]."""
    tables = tomllib.loads(ARCH)
    tables["structure"] |= dict(keys or {})
    if panel:
        tables["panel"] = dict(panel)
        del tables["structure"]["thickness"]
    tables["load_case"] = cases or tables["load_case"]
    shell = make_shell(check_design(tables, Path("arch.toml")), clash="unexamined", skip=SKIP)
    assert shell.analysis is not None
    return shell.analysis


def test_forces_along_hinge_lines_are_not_known_to_be_borne() -> None:
    """Until it is said what crease lines bear; then that is the verdict on each of them."""
    found = arch()
    assert one_verdict(found) is None
    assert found.governs is not None
    assert found.governs.utilisation == pytest.approx(0.25, abs=0.01)
    assert (
        "loaded in crease lines, whose strength is not given (60.31\u00a0kN/m" in found.in_words()
    )
    balanced = found.cases[0].equilibrium
    assert balanced is not None
    # 59.8 kN/m of pull by the independent check, and the shear across it that belongs to it.
    assert max(kind.pull.size for kind in balanced.creases) == pytest.approx(59.8e3, rel=5e-3)
    assert balanced.lines.size == pytest.approx(60.3e3, rel=2e-3)
    for strength, carries in ((70e3, True), (50e3, False)):
        asked = found.model.structure.replace_unchecked(line_strength=LineStrength.alike(strength))
        model = replace(found.model, structure=asked)
        known = replace(found, model=model, cases=tuple(each.of(model) for each in found.cases))
        assert one_verdict(known) is carries
    assert (
        "uses 121 % of the strength of its crease lines at the crease between panels"
        in known.in_words()
    )


def test_forces_that_any_hinge_line_bears_are_none() -> None:
    """A paper model under its own weight: less than what masking tape bears, 100 N/m."""
    light = [{"name": "own", "self_weight": True}]
    found = arch({}, light)
    balanced = found.cases[0].equilibrium
    assert balanced is not None
    few = replace(balanced.edges, per_length=99.0 / balanced.lines.size * balanced.edges.per_length)
    case = replace(found.cases[0], equilibrium=replace(balanced, edges=few))
    assert one_verdict(replace(found, cases=(case,))) is True


def test_a_patch_that_holds_the_whole_shell_is_refused() -> None:
    """100 m, where millimetres were meant; one that holds a quarter of it is warned of."""
    hold = {"at": "feet", "kind": "pinned", "patch": 100}
    with pytest.raises(InputError, match="nothing of the shell is left to move") as error:
        arch({"supports": [hold]})
    assert error.value.got == "patch = 100"
    found = arch({"supports": [{**hold, "patch": 0.9}]})
    assert any("supports hold 25 % of the panels" in text for text in found.warnings)


@pytest.mark.parametrize(
    ("keys", "case", "says"),
    [
        ({}, {"snow": {"ground": 1.2}}, "snow of 1.2 on the ground is 1.2 N/m2; 1 kN/m2 is 1000"),
        ({"thickness": 10}, {"snow": {"ground": 500}}, "panels are 10 m thick, more than a fifth"),
        ({}, {"points": [{"at": [3, 2], "force": [0, 0, -1]}]}, "forces of 1 N at most beside"),
    ],
)
def test_what_hardly_fits_the_shell_is_doubted(
    keys: dict[str, Any], case: dict[str, Any], says: str
) -> None:
    found = arch({**POINTS, **keys}, [{"name": "a", **case}])
    assert any(says in text for text in found.warnings)


@pytest.mark.parametrize(
    "supports",
    [
        [{"at": "feet", "kind": "fixed"}, {"at": "feet", "kind": "friction", "friction": 0.3}],
        [{"at": "feet", "kind": "pinned"}, {"at": [[0, 0]], "kind": "sliding"}],
        [
            {"at": "feet", "kind": "friction", "friction": 0.3},
            {"at": [[0, 0]], "kind": "friction", "friction": 0.5},
        ],
        [
            {"at": [[0, 0], [8, 0]], "kind": "pinned", "patch": 0.8},
            {"at": [[0, 1], [8, 1]], "kind": "friction", "friction": 0.3},
        ],
    ],
)
def test_what_is_held_in_two_ways_is_refused(supports: list[dict[str, Any]]) -> None:
    with pytest.raises(InputError, match="held in two ways that contradict each other"):
        arch({"supports": supports})


def test_stress_at_a_crease_is_not_hidden_by_averages() -> None:
    """Solid boards of 5 mm with rigid creases: 6 M/t2 of a crease moment of some 150 N is 36 MPa.

    With few cells here; ``F5_crease_moment.toml`` has 8.
    """
    rigid = {"thickness": 0.005, "crease_stiffness": "rigid", "cells": 4, "line_strength": 1e6}
    found = arch({**rigid, "crease_strength": 1e4})
    assert one_verdict(found) is False
    balanced = found.cases[0].equilibrium
    assert balanced is not None
    assert balanced.stress.size < 16e6
    assert balanced.crease is not None
    assert balanced.beside is not None
    assert balanced.beside.size > 0.95 * 6 * balanced.crease.moment / 0.005**2
    assert balanced.utilisation.panels == balanced.beside.size / 16e6
    words = "; ".join(each.text for each in found.cases[0].findings)
    assert "% of the strength of its panels at the crease between panels" in words
    assert any("crease_strength = 10000 N is 100 times" in text for text in found.warnings)


def test_chamfers_make_boards_softer() -> None:
    """By their thickness at every place; cut square they are as thick as they are everywhere."""
    bevel = {"construction": "bevel", "thickness": 0.03, "gap": 0.002, "density": 500}
    found = arch({"line_strength": 1e6}, panel=bevel)
    model, boards = found.model, found.model.boards
    assert boards is not None
    assert any("chamfers leave of a board" in text for text in found.not_covered)
    flat = model.sheet.positions(0.0).reshape(-1, 3)[model.grid.faces_vertices(), :2]
    middle = boards.outlines[:, 1:2, :, :2]
    square = replace(
        boards,
        outlines=np.concatenate(
            [
                np.broadcast_to(middle, boards.outlines[..., :2].shape),
                boards.outlines[..., 2:],
            ],
            axis=-1,
        ),
    )
    left, whole = (thickness_left(each, flat, 32) for each in (boards, square))
    assert set(np.unique(whole)) <= {0.0, 1.0}
    assert (left <= whole).all()
    # In the middle of a panel nothing is taken off; right at a chamfered edge half is left.
    assert left.max() == 1.0
    assert 0.0 < left[left > 0].min() < 0.6
    solid = Section.solid(model.structure.modulus, 0.03, model.structure.poisson)
    assert model.membrane_stiffness[1] <= np.asarray(solid.membrane) * (1 + 1e-9)
    assert model.bending_stiffness[0] < 0.8 * np.asarray(solid.bending)
    softer = found.cases[0].equilibrium
    stiff = arch({"line_strength": 1e6, "thickness": 0.03}).cases[0].equilibrium
    assert softer is not None
    assert stiff is not None
    assert softer.displacement.size > 1.02 * stiff.displacement.size


@pytest.mark.parametrize("name", led_by(["BEST_shelter.toml"], 0))
def test_chamfers_of_a_shelter_against_calculix(name: str) -> None:
    """Displaced by 44 % more, its factor 5 % less, with tapered boards in CalculiX.

    Without chamfers 73.8 mm there and a factor of 3.0 at 3 cells and 2.92 at 4 (an independent
    check's figures, of boards that are alike all through: 1.5 GPa, as skins and foam are when
    stretched); here with 4 cells.
    """
    tables = tomllib.loads((FILES / name).read_text(encoding="utf-8"))
    del tables["structure"]["material"]
    tables["structure"] |= {"modulus": 1.5e9, "strength": 7.8e6, "cells": 4}
    tables["panel"]["density"] = 260
    file = check_design(tables, FILES / name)
    found = make_shell(file, clash="unexamined", skip=SKIP).analysis
    assert found is not None
    worst = next(case for case in found.cases if case.name == "snow l").equilibrium
    assert worst is not None
    linear = worst.displacement.size, worst.buckling
    if worst.path is not None:
        linear = worst.path.linear_displacement, worst.path.linear_buckling
    assert linear[0] == pytest.approx(1.44 * 0.0738, rel=0.05)
    assert linear[1] is not None
    assert 0.95 * 2.92 < linear[1] < 1.1 * 0.95 * 3.44


def test_a_buckling_factor_below_three_is_not_known_to_be_safe() -> None:
    """Text and field said two things of 1.16 once."""
    made = arch({"line_strength": 1e6})
    stands, case = made.balanced[0]
    for factor, carries in ((1.16, None), (0.9, False), (3.1, True)):
        sound = replace(
            stands,
            buckling_factors=(factor,),
            buckling_modes=stands.buckling_modes[:1],
            buckling_at_points=stands.buckling_at_points[:1],
        )
        found = replace(made, cases=(replace(case, equilibrium=sound),))
        assert one_verdict(found) is carries
        assert (found.cases[0].used > 1) is (carries is not True)


@pytest.mark.parametrize(
    ("name", "carries", "says"),
    led_by(
        [
            ("F5_crease_moment.toml", False, "% of the strength of its panels at the crease"),
            ("F6_factor_1_16.toml", None, "loaded in crease lines"),
            ("BEST_shelter.toml", None, "loaded in crease lines"),
            ("BEST_en1990_130_ties.toml", None, "loaded in crease lines"),
        ],
        0,
    ),
)
def test_files_as_they_are(name: str, carries: bool | None, says: str) -> None:
    """The best shelters, too: nobody knows what their creases and thin edges bear."""
    file = read_design_file(FILES / name)
    found = make_shell(file, clash="unexamined", skip=SKIP).analysis
    assert found is not None
    assert one_verdict(found) is carries
    assert says in "; ".join(each.text for case in found.cases for each in case.findings)


@pytest.mark.parametrize("name", led_by(["F8_no_remedy.toml"], 0))
def test_what_helps_a_soft_shell_is_offered(name: str) -> None:
    """Ties across its folds, without which free hinges fail."""
    file = read_design_file(FILES / name)
    shell = make_shell(file, clash="unexamined", skip=(*MEASURES, "stock"))
    row = next(row for row in shell.report.verdict if row.subject == "stands")
    assert row.sign == "fails"
    assert row.changes["deployment.ties"] == "folds"
    assert "no case fails (tried)" in row.remedy


@pytest.mark.parametrize("name", led_by(["F6_factor_1_16.toml"], 0))
def test_a_factor_near_one_is_followed(name: str) -> None:
    """Linear factors of 1.04 to 2.05, and in balance off its shape by 1.8 to 2.5 mm, too.

    The fourth case has a factor above 3, and is not followed.
    """
    found = make_shell(read_design_file(FILES / name), clash="unexamined", skip=SKIP).analysis
    assert found is not None
    paths = {case.name: case.equilibrium.path for case in found.cases if case.equilibrium}
    assert paths.pop("storm l") is None
    assert len(paths) == 3
    for path in paths.values():
        assert path is not None
        assert path.linear_buckling is not None
        assert 1 < path.linear_buckling < 3
        assert path.ending == "carries"
        assert 1e-3 < path.imperfection < 3e-3
    assert not any(each.kind == "buckles" for case in found.cases for each in case.findings)
