"""The verdict: independent rows, worst first, each true of its report."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from orishell.conventions.row import ORDER, Sign
from orishell.design_file import read_design_file
from orishell.shell import make_shell
from orishell.shell.make import Shell
from orishell.shell.report import Report
from orishell.shell.verdict import find_verdict

EXAMPLES = Path(__file__).parents[2] / "examples"


@cache
def shell(name: str) -> Shell:
    """Half of it, of one mesh that is not fine, where it is analysed: its verdict is the same."""
    file = read_design_file(EXAMPLES / f"{name}.toml")
    if file.structure is not None:
        half = {"pattern.columns": 7, "target.g.range": [0, 3], "structure.cells": 2}
        file = file.changed(half)
    return make_shell(file)


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
        "subject": "held",
        "finding": "at 180 degrees: its flaps stop it closing; only its supports stop it opening",
        "remedy": "",
    }


def test_nothing_is_called_clear_that_nobody_looked_at() -> None:
    file = read_design_file(EXAMPLES / "figure1.toml")
    report = make_shell(file, clash="unexamined").report
    sign, finding = rows(report)["clear"]
    assert (sign, finding.partition(":")[0]) == ("warns", "not known")


def test_panels_that_meet_speak_against_a_shell() -> None:
    report = shell("figure1").report
    contact = shell("figure1").report.lock.first_contact
    assert contact is not None
    lock = replace(report.lock, cause="clash", first_contact=replace(contact, drive=np.pi / 2))
    found = rows(replace(report, lock=lock, feasible=False))
    sign, finding = found["clear"]
    assert sign == "fails"
    assert "meet at 90 degrees" in finding
    assert "short of the target at 180 degrees" in finding
    assert "held" not in found


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
    asked = model.structure.having(
        strength=largest / used, membrane_strength=1e12, crease_strength=1e9, tie_strength=1e9
    )
    stands = replace(
        found,
        model=replace(model, structure=asked),
        displacements=share / found.displacement.share * found.displacements,
        buckling_factors=(),
        feet=(),
    )
    structure = replace(report.structure, cases=(replace(standing, equilibrium=stands),))
    assert rows(replace(report, structure=structure))["carries"][0] == sign


def test_a_shell_that_moves_carries_nothing() -> None:
    sign, finding = rows(shell("shelter_structure").report)["carries"]
    assert sign == "fails"
    assert "gives way under its loads" in finding
