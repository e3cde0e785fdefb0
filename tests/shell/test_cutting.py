"""What errors of cutting are said to do: in the report, as rows, warnings and refusals."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from command_line import orishell
from orishell.design_file import read_design_file
from orishell.shell.make import make_shell
from orishell.shell.report import Report
from orishell.shell.steps import MEASURES

EXAMPLES = Path(__file__).parents[2] / "examples"
REST = tuple(step for step in MEASURES if step != "cutting")


def report_of(name: str, **changes: Any) -> Report:
    """Of a shell of few panels whose path nobody examines."""
    small = {f"workshop.{key}": value for key, value in changes.items()}
    file = read_design_file(EXAMPLES / f"{name}.toml").changed({**small, "motion.frames": 3})
    skip = (*REST, "remedies", "verification", "stock", "structure")
    return make_shell(file, clash="unexamined", skip=skip).report


def subjects(report: Report) -> dict[str, str]:
    return {row.subject: row.finding for row in report.verdict}


def test_nothing_is_said_that_nobody_asked_for() -> None:
    report = report_of("figure1")
    assert report.cutting is None
    assert "cutting" not in report.as_dict()
    assert "cut" not in subjects(report)


def test_a_sheet_has_creases_that_must_give() -> None:
    """Without a thickness it is one sheet; 0.31 errors rms, 1.3 at most, as elsewhere."""
    report = report_of("figure1", cutting_error=0.001)
    assert report.cutting is not None
    assert report.cutting.cutting == "sheet"
    said = subjects(report)
    assert "hinges need 0.308 mm of play (rms)" in said["cut"]
    assert "feet miss their places by" in said["cut"]
    assert "degrees of the target" in said["flaps"]
    warned = [each for each in report.warnings if "at ends of creases" in each]
    assert len(warned) == 1
    table = report.as_dict()["cutting"]
    assert isinstance(table, dict)
    assert table["flaps"].keys() == {"off_deg", "last_deg", "shape"}


def test_boards_need_a_gap_as_wide_as_the_play() -> None:
    """The gap that is named is enough, and draws no warning."""
    file = read_design_file(EXAMPLES / "shelter_boards.toml")
    narrow = file.changed({"workshop.cutting_error": 0.0002, "panel.gap": 0.0005})
    skip = (*REST, "remedies", "verification", "stock", "structure")
    report = make_shell(narrow, clash="unexamined", skip=skip).report
    assert report.cutting is not None
    assert report.cutting.cutting == "boards"
    (warned,) = (each for each in report.warnings if "boards need up to" in each)
    offered = float(warned.partition("at least ")[2].partition(" ")[0])
    assert offered >= report.cutting.play.largest
    wide = narrow.changed({"panel.gap": offered})
    again = make_shell(wide, clash="unexamined", skip=skip).report
    assert not any("boards need up to" in each for each in again.warnings)


def test_whole_boards_are_left_out_and_the_report_says_so() -> None:
    report = report_of("shelter_hinged", cutting_error=0.0003)
    assert report.cutting is None
    assert "the play that errors of cutting ask for" in report.not_checked


@pytest.mark.parametrize(
    ("lines", "says"),
    [
        ("cutting_error = -0.1", "[workshop] cutting_error"),
        ('cutting_error = "much"', "[workshop] cutting_error"),
        ("cutting_error = 3.0", "panels cannot be cut as wrong as that"),
        ('cutting = "saw"', "[workshop] cutting"),
        ("cutting_bias = 0.001", "creases in one sheet are not cut too small"),
        ('cutting = "boards"\ncutting_bias = -3.0', "panels cannot be cut as wrong as that"),
    ],
)
def test_bad_input_is_one_message(tmp_path: Path, lines: str, says: str) -> None:
    text = (EXAMPLES / "figure1.toml").read_text()
    file = tmp_path / "shell.toml"
    file.write_text(f"{text}\n[workshop]\n{lines}\n")
    ran = orishell("design", file, "--out", tmp_path / "out", "--no-clash-test")
    assert ran.returncode == 2
    assert ran.stderr.startswith("orishell: ")
    assert says in ran.stderr
    assert "Traceback" not in ran.stderr
    assert not (tmp_path / "out").exists()


GUIDE = Path(__file__).parents[2] / "docs" / "guide" / "cutting.md"
NAMES = {"Figure 1": "figure1", "`shelter.toml`": "shelter"}


def test_the_table_of_the_guide() -> None:
    """All rows of Figure 1 and the shelter, to three digits; angles have two."""
    rows = [line.strip("| \n").split(" | ") for line in GUIDE.read_text().splitlines()]
    shell, seen = "", 0
    for row in rows:
        if len(row) < 6 or not row[-6].strip("| ").replace(".", "").isdigit():
            continue
        shell = row[0] if len(row) == 7 else shell
        name, _, cutting = shell.partition(", ")
        if name not in NAMES:
            continue
        error, play, lift, feet, angle, left = row[-6:]
        kind = "sheet" if cutting == "one sheet" else "boards"
        error = error.strip("| ")
        found = report_of(NAMES[name], cutting=kind, cutting_error=1e-3 * float(error)).cutting
        assert found is not None
        assert found.ends is not None
        assert found.flaps is not None
        for said, each in ((play, found.play), (lift, found.lift), (feet, found.ends)):
            assert [float(part) for part in said.split(", ")] == pytest.approx(
                [1e3 * each.rms, 1e3 * each.largest], rel=5e-3
            )
        assert float(angle.rstrip("°")) == pytest.approx(np.rad2deg(found.flaps.off), rel=0.07)
        assert float(left) == pytest.approx(1e3 * found.flaps.shape, rel=5e-3)
        seen += 1
    assert seen == 12
