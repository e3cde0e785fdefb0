"""Panels that are thick under loads and have no thickness where they fold: no tick for both."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from orishell.conventions.row import Row
from orishell.design_file import DesignFile, check_design
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES

SKIP = {*MEASURES} - {"pack"}


def arch(loaded: float, start: str = "pack", **panel: Any) -> DesignFile:
    """An arch of 3 x 2 m whose sheet folds flat, 20 panels on each other."""
    structure = {"modulus": 9e9, "supports": [{"at": "feet", "kind": "pinned"}]}
    tables = {
        "shell": {"family": "orthodiagonal", "unit": "m"},
        "target": {
            "f": {"formula": ["1.5*cos(t)", "1.6*sin(t)"], "range": [0, 3.141592653589793]},
            "g": {"formula": "0.1*cos(2*pi*x)", "range": [0, 2]},
        },
        "pattern": {"rows": 7, "columns": 5, "flap": 0, "depth": 0.16, "heading_deg": 90},
        "deployment": {"from": start},
        "motion": {"frames": 3},
        "workshop": {"areal_density": 12},
        "structure": structure | ({"thickness": loaded} if loaded else {}),
    }
    if panel:
        tables["panel"] = panel
    return check_design(tables, Path("arch.toml"))


def made(file: DesignFile) -> Shell:
    """Its proof and its pack; loads and distances are looked at by others."""
    return make_shell(file, skip={*SKIP, "structure", "stock", "verification"})


def row_of(shell: Shell, subject: str) -> Row:
    return next(row for row in shell.report.verdict if row.subject == subject)


def test_a_pack_of_panels_that_are_thick_under_loads_fails_and_one_thickness_is_offered() -> None:
    """24 mm of plywood: 20 panels on each other make 0.48 m, and the pack that is said is flat."""
    file = arch(0.024)
    shell = made(file)
    packed = shell.report.deployment.packed
    assert packed is not None
    assert packed.layers == 20
    assert packed.height == pytest.approx(0, abs=1e-9)
    boards, packs = row_of(shell, "boards"), row_of(shell, "packs")
    assert boards.sign == "fails"
    assert "the structure has panels 24 mm thick" in boards.finding
    assert f"20 of them on each other make {20 * 0.024:g} m at least" in boards.finding
    assert packs.sign == "says"
    assert packs.finding.endswith("20 panels deep, without their thickness")
    # What is offered has one thickness, and is proved to fold with it.
    assert "with thickness = 0.024" in boards.remedy
    one = made(file.changed(boards.changes))
    assert one.report.panel is not None
    assert (one.report.panel.thickness, one.report.feasible) == (0.024, True)
    boards = row_of(one, "boards")
    assert boards.sign == "warns"  # chamfers lean by more than a saw tilts
    assert "none meet on the way (proved)" in boards.finding
    assert row_of(one, "packs").sign == "holds"
    thick = one.report.deployment.packed
    assert thick is not None
    assert thick.height > 20 * 0.024


def test_panels_that_set_backs_leave_no_room_for_fail_from_the_flat_sheet_too() -> None:
    thick = made(arch(1.0, "flat"))
    most = thick.report.deployment.largest_thickness
    assert most is not None
    assert most < 1.0
    row = row_of(thick, "boards")
    assert row.sign == "fails"
    assert f"set-backs leave room for {most:.3g} m at most at the target" in row.finding
    assert (row.remedy, row.changes) == ("", {})


def test_thin_panels_that_may_fold_are_not_known_to() -> None:
    """Of 5 mm, folded up from flat: nothing says they cannot, and nothing was proved of them."""
    row = row_of(made(arch(0.005, "flat")), "boards")
    assert row.sign == "warns"
    assert row.changes["panel.thickness"] == 0.005


def test_nothing_is_tried_where_nothing_is_to_be_offered() -> None:
    shell = make_shell(
        arch(0.024), clash="unexamined", skip={*SKIP, "structure", "remedies", "verification"}
    )
    row = row_of(shell, "boards")
    assert (row.sign, row.remedy, row.changes) == ("fails", "", {})


def test_one_thickness_has_no_such_row() -> None:
    shell = made(arch(0, "flat", thickness=0.01, construction="bevel", gap=0.002))
    assert "two thicknesses" not in row_of(shell, "boards").finding
    bare = arch(0.024, "flat").changed({"structure": None})
    assert "boards" not in {row.subject for row in made(bare).report.verdict}


def test_a_panel_of_no_thickness_is_none() -> None:
    """A table [panel] that is kept with thickness 0 leaves the structure's the only one."""
    row = row_of(made(arch(0.024, "pack", thickness=0)), "boards")
    assert row.sign == "fails"


def test_the_analysis_says_that_it_does_not_cover_how_its_panels_fold() -> None:
    words = "folding, contact and pack of panels of this thickness"
    for file, there in (
        (arch(0.024, "flat"), True),
        (arch(0, "flat", thickness=0.01, construction="bevel", gap=0.002), False),
    ):
        coarse = file.changed({"structure.cells": 2})
        skip = {*MEASURES, "stock", "verification", "remedies"}
        analysis = make_shell(coarse, clash="unexamined", skip=skip).analysis
        assert analysis is not None
        assert any(text.startswith(words) for text in analysis.not_covered) == there
