"""The verdict: independent rows, worst first, each true of its report."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Literal

import numpy as np
import pytest

from orishell.conventions.row import ORDER, Sign
from orishell.design_file import read_design_file
from orishell.shell import make_shell
from orishell.shell.board_warnings import SAW
from orishell.shell.make import Shell
from orishell.shell.report import Report
from orishell.shell.steps import MEASURES
from orishell.shell.verdict import find_verdict
from orishell.structure.hinge_lines import LineStrength

EXAMPLES = Path(__file__).parents[2] / "examples"
STORM = {
    "name": "storm",
    "self_weight": True,
    "wind": {"speed": 32, "terrain": "II", "direction_deg": 90},
}
"""Its free creases give way, and rigid ones stand."""


@cache
def shell(name: str) -> Shell:
    """An example, proved; a third of it under one storm, as it is, where it is analysed."""
    file = read_design_file(EXAMPLES / f"{name}.toml")
    if file.structure is None:
        return make_shell(file, skip=["remedies"])
    third = {
        "pattern.rows": 9,
        "pattern.columns": 5,
        "target.g.range": [0, 2],
        "structure.cells": 1,
        "load_case": [STORM],
    }
    return make_shell(file.changed(third), clash="unexamined", skip=["remedies", *MEASURES])


def rows(report: Report) -> dict[str, tuple[Sign, str]]:
    return {row.subject: (row.sign, row.finding) for row in find_verdict(report)}


def test_the_worst_comes_first_and_the_report_has_it() -> None:
    report = shell("figure1").report
    signs = [ORDER.index(row.sign) for row in report.verdict]
    assert signs == sorted(signs)
    assert [row.finding for row in report.verdict] == [each for _, each in rows(report).values()]
    said = report.as_dict()["verdict"]
    assert isinstance(said, list)
    assert said[0] == {
        "sign": "warns",
        "subject": "locks",
        "finding": "at 180 degrees: its flaps stop it closing; only its supports stop it opening",
        "remedy": "",
        "changes": {},
        "known": True,
    }


def test_nothing_is_called_clear_that_nobody_looked_at() -> None:
    file = read_design_file(EXAMPLES / "figure1.toml")
    report = make_shell(file, clash="unexamined").report
    sign, finding = rows(report)["folds"]
    assert (sign, finding.partition(":")[0]) == ("warns", "not known")


def test_panels_that_meet_speak_against_a_shell() -> None:
    report = shell("figure1").report
    contact = shell("figure1").report.lock.first_contact
    assert contact is not None
    lock = replace(report.lock, cause="clash", first_contact=replace(contact, drive=np.pi / 2))
    found = rows(replace(report, lock=lock, feasible=False))
    sign, finding = found["folds"]
    assert sign == "fails"
    assert "meet at 90 degrees" in finding
    assert "short of the target at 180 degrees" in finding
    assert "locks" not in found


@pytest.mark.parametrize(
    ("closing", "opening", "push", "subject", "sign"),
    [
        (None, None, 0.0, "locks", "warns"),
        (None, "ties", 0.1, "held", "warns"),
        (None, "ties", -0.1, "held", "warns"),
        ("flaps", None, 0.1, "locks", "warns"),
        ("flaps", None, -0.1, "locks", "warns"),
        ("flaps", None, None, "locks", "warns"),
        ("flaps", "ties", 0.1, "locks", "holds"),
        ("flaps", "ties", None, "locks", "holds"),
    ],
)
def test_half_a_lock_wants_attention_whatever_own_weight_does(
    closing: Literal["flaps"] | None,
    opening: Literal["ties"] | None,
    push: float | None,
    subject: str,
    sign: Sign,
) -> None:
    """Of a shell that was made, with other things to hold it, pushed open or closed by weight.

    None: nobody looked what its weight does.
    """
    report = shell("figure1").report
    weight = report.deployment.weight
    assert weight is not None
    other = replace(
        report.deployment,
        closing=closing,
        opening=opening,
        weight=None if push is None else replace(weight, at_feet=push),
    )
    assert rows(replace(report, deployment=other))[subject][0] == sign


def test_a_shell_without_flaps_is_not_said_to_lock() -> None:
    file = read_design_file(EXAMPLES / "figure1.toml").changed({"pattern.flap": 0})
    sign, finding = rows(make_shell(file, skip=MEASURES).report)["locks"]
    assert sign == "warns"
    assert finding.endswith("only its supports stop it closing and opening")


def test_what_is_packed_and_cut_has_rows_where_it_is_asked_for() -> None:
    report = shell("figure1").report
    assert {"packs", "fits"}.isdisjoint(rows(report))
    packed = replace(report, deployment=replace(report.deployment, start="pack"))
    assert rows(packed)["packs"][0] == "holds"
    assert rows(replace(packed, feasible=None))["packs"][0] == "says"
    (fits,) = [row for row in find_verdict(report, stock=(2.5, 1.25)) if row.subject == "fits"]
    assert (fits.sign, fits.finding) == ("holds", "on 1 sheet of 2.5 x 1.25 m")
    unknown = replace(report, quantities=replace(report.quantities, stock=None))
    (fits,) = [row for row in find_verdict(unknown, stock=(2.5, 1.25)) if row.subject == "fits"]
    assert fits.sign == "warns"


@pytest.mark.parametrize(
    ("used", "share", "sign"),
    [(0.5, 0.01, "holds"), (1.01, 0.01, "fails"), (0.5, 0.06, "warns"), (0.5, 0.3, "fails")],
)
def test_a_shell_carries_what_it_bears_without_sinking(
    used: float, share: float, sign: Sign
) -> None:
    """Of a shell that was analysed, with another utilisation and another displacement."""
    report = shell("shelter_structure").report
    assert report.structure is not None
    standing = next(case for case in report.structure.cases if case.equilibrium is not None)
    assert standing.equilibrium is not None
    found, model = standing.equilibrium, report.structure.model
    assert found.lone_board is not None
    largest = max(found.stress.size, found.lone_board.size)
    asked = model.structure.replace_unchecked(
        strength=largest / used,
        membrane_strength=1e12,
        crease_strength=1e9,
        line_strength=LineStrength.alike(1e12),
        tie_strength=1e9,
    )
    stands = replace(
        found,
        model=replace(model, structure=asked),
        displacements=share / found.displacement.share * found.displacements,
        buckling_factors=(),
        feet=(),
    )
    structure = replace(report.structure, cases=(replace(standing, equilibrium=stands),))
    assert rows(replace(report, structure=structure))["stands"][0] == sign


def test_a_shell_that_moves_carries_nothing() -> None:
    sign, finding = rows(shell("shelter_structure").report)["stands"]
    assert sign == "fails"
    assert "gives way under its loads" in finding


def test_what_codes_ask_beyond_is_said_with_what_it_carries() -> None:
    """Each sentence of the list by its first words, in a row that only informs."""
    report = shell("shelter_structure").report
    assert report.structure is not None
    sign, finding = rows(report)["codes"]
    assert sign == "says"
    *first, last = finding.partition(": ")[2].split(", ")
    begins = (*first, *last.split(" and "))
    assert len(begins) == len(report.structure.code_asks)
    for begin, text in zip(begins, report.structure.code_asks, strict=True):
        assert text.startswith(begin)
    assert "codes" not in rows(shell("figure1").report)


BEVELLED = """
[shell]
family = "orthodiagonal"
unit = "m"
[target.f]
formula = "1.5 - 0.7*x**2"
range = [-1.5, 1.5]
[target.g]
formula = "0.1*cos(2*pi*x)"
range = [0, 2]
[pattern]
rows = 5
columns = 3
flap = 0
depth = 0.16
heading_deg = 90
[panel]
construction = "bevel"
thickness = 0.005
gap = 0.001
"""


@pytest.mark.parametrize(("start", "sign"), [("flat", "says"), ("pack", "warns")])
def test_boards_with_chamfers_that_no_saw_cuts_want_attention(
    tmp_path: Path, start: str, sign: Sign
) -> None:
    """Chamfers lean by half the fold angles: those of a pack are steeper than saws tilt."""
    path = tmp_path / "arch.toml"
    path.write_text(BEVELLED)
    deployment = {"from": start, "flap_attachment": "clipped"}
    file = read_design_file(path).changed({"deployment": deployment})
    report = make_shell(file, skip=MEASURES).report
    assert report.panel is not None
    assert report.panel.steepest_chamfer is not None
    leans = np.rad2deg(report.panel.steepest_chamfer)
    assert (leans > SAW) == (sign == "warns")
    found, finding = rows(report)["boards"]
    assert found == sign
    assert (f"chamfers lean by up to {leans:.3g} degrees" in finding) == (sign == "warns")
