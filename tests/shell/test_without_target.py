"""A design file without a target, of the family that needs none: report, files and refusals."""

import math
from dataclasses import astuple
from pathlib import Path

import pytest

from command_line import orishell
from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.formatting import tidy_degrees
from orishell.design_file import read_design_file, starter_file
from orishell.families.registry import FAMILIES
from orishell.io import read_fold
from orishell.io.formats import formats_for
from orishell.shell.export import write_shell
from orishell.shell.make import Shell, design_shell
from orishell.verification import inspect_fold
from samples import thorough

EXAMPLE = Path(__file__).parents[2] / "examples" / "sectors.toml"
TEXT = EXAMPLE.read_text()
STAGE = 'stage_deg = "auto"'


def write(directory: Path, text: str) -> Path:
    path = directory / "sheet.toml"
    path.write_text(text)
    return path


@pytest.fixture(scope="module")
def shell() -> Shell:
    return design_shell(EXAMPLE)


def test_report(shell: Shell) -> None:
    report = shell.report
    assert report.deviation is None
    assert (report.feasible, report.not_checked) == (True, ())
    (warning,) = report.warnings
    assert "is larger than any board" in warning
    assert report.residuals is not None
    assert all(value <= 1e-12 for value in astuple(report.residuals))
    lock, contact = report.lock, report.lock.first_contact
    assert contact is not None
    assert lock.drive is not None
    assert (lock.cause, contact.kind) == ("clash", "at the sheet's edge")
    assert lock.target_drive == contact.clear_until
    assert 0 < lock.drive - lock.target_drive < math.radians(1e-8)
    assert report.parameters["stage_deg"] == tidy_degrees(lock.target_drive)


def test_files_of_all_formats(shell: Shell, tmp_path: Path) -> None:
    formats, missing = formats_for(["all"], shell.document)
    assert {each.name for each in missing} <= {"step", "3mf"}  # of panels with a thickness
    names = {path.name for path in write_shell(shell, tmp_path, formats)}
    assert {each.file for each in formats} <= names
    assert "overview.png" in names
    assert "deviation.png" not in names
    assert inspect_fold(read_fold(tmp_path / "shell.fold")).passed


@pytest.mark.usefixtures("unpictured")
def test_the_sine_version(tmp_path: Path) -> None:
    text = TEXT.replace("solution = 0", "solution = 1").replace("rows = 5", "rows = 1")
    lines = [line for line in text.splitlines() if "_lengths" not in line]
    made = design_shell(write(tmp_path, "\n".join(lines).replace("columns = 9", "columns = 4")))
    assert made.report.parameters["version"] == "sine"
    assert made.report.lock.cause in {"clash", "crease"}
    write_shell(made, tmp_path / "out")


@pytest.mark.usefixtures("unpictured")
def test_summary(tmp_path: Path) -> None:
    done = orishell("design", EXAMPLE, "--out", tmp_path / "out")
    assert done.returncode == 0
    (warning,) = done.stderr.splitlines()
    assert "is larger than any board" in warning
    assert "no target: nothing to compare the shell with" in done.stdout
    assert "nothing touches before panels [0, 0] and [5, 0] meet at 8.78 deg" in done.stdout
    assert "locks     at 8.78 degrees: panels that meet stop it closing" in done.stdout


def test_contact_not_looked_for() -> None:
    made = design_shell(EXAMPLE, clash="unexamined")
    assert made.report.parameters["stage_deg"] == made.report.parameters["motion_end_deg"]
    assert made.report.not_checked == ("contact between panels on the way",)


@thorough
def test_a_stage_that_panels_do_not_reach(tmp_path: Path) -> None:
    path = write(tmp_path, TEXT.replace(STAGE, "stage_deg = 12"))
    with pytest.raises(DesignError, match="meet before the shell reaches its stage"):
        design_shell(path)
    made = design_shell(path, clash="allowed")
    assert not made.report.feasible
    assert made.report.warnings
    write_shell(made, tmp_path / "out")


@pytest.mark.parametrize("family", FAMILIES)
def test_other_families_need_their_target(tmp_path: Path, family: str) -> None:
    text = starter_file(family)
    begin, end = text.find("[target."), text.index("[pattern]")
    path = write(tmp_path, text if begin < 0 else text[:begin] + text[end:])
    if FAMILIES[family].pattern.needs_target():
        with pytest.raises(InputError) as caught:
            read_design_file(path)
        missing = {"pattern": "[target.pattern]: this family makes a shell of a drawn sheet"}
        said = missing.get(family, "[target]: this key is missing.")
        assert str(caught.value).startswith(f"{path}: {said}")
    else:
        assert read_design_file(path).target is None


def test_half_a_target(tmp_path: Path) -> None:
    half = '[target.f]\nformula = "-x**2"\nrange = [-1, 1]\n\n[pattern]'
    with pytest.raises(InputError, match=r"\[target\.g\]: this key is missing"):
        read_design_file(write(tmp_path, TEXT.replace("[pattern]", half)))


def test_a_tolerance_needs_a_target(tmp_path: Path) -> None:
    path = write(tmp_path, TEXT + "\n[tolerance]\nsurface = 0.1\n")
    with pytest.raises(InputError, match="a tolerance needs a target") as caught:
        read_design_file(path)
    assert str(caught.value).count("sheet.toml") == 1
