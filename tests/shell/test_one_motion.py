"""Sheets of more motions than one: rows, fields, warnings, kit and what else is said of them."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from command_line import orishell
from orishell.conventions.row import Row
from orishell.design_file import read_design_file
from orishell.io import write_fold
from orishell.shell.folded import fold_pattern
from orishell.shell.make import Shell, make_shell
from orishell.shell.one_motion import warn_of_freedom
from orishell.shell.steps import Step
from orishell.workshop.kit.facts import find_facts
from orishell.workshop.kit.steps import kit_steps
from orishell.workshop.kit.words import load_words
from samples import thorough

STRAIGHT = """
[shell]
family = "orthodiagonal"
unit = "m"
[target.f]
formula = "-x**2"
range = [-1, 1]
[target.g]
formula = "0*x"
range = [0, 4]
[pattern]
rows = 5
columns = 4
depth = 0.12
[motion]
frames = 5
"""
MENDED: tuple[Step, ...] = ("remedies",)
PACK = '[deployment]\nfrom = "pack"\nties = "feet"\n'
PARALLEL = STRAIGHT.replace("orthodiagonal", "parallel-repeating").replace("depth = 0.12\n", "")
"""Five rows that nothing joins where no flaps are part of the sheet: 5, by the rank of the closing
equations in two folded states."""


def made(folder: Path, text: str) -> Shell:
    file = folder / "straight.toml"
    file.write_text(text)
    return make_shell(read_design_file(file))


@pytest.fixture(scope="module")
def several(tmp_path_factory: pytest.TempPathFactory) -> Shell:
    return made(tmp_path_factory.mktemp("several"), STRAIGHT + PACK)


def row(shell: Shell, subject: str) -> Row:
    (found,) = (each for each in shell.report.verdict if each.subject == subject)
    return found


def test_it_never_gets_a_tick_for_one_motion(several: Shell) -> None:
    report = several.report
    assert report.degrees_of_freedom == 5
    assert not report.freedom.one_motion
    found = row(several, "folds")
    assert found.sign == "warns"
    assert found.finding.startswith(
        "5 degrees of freedom: rows 1 to 5 fold by themselves; along one of its motions: nothing "
        "touches from flat to 180 degrees (proved"
    )
    assert "in one motion" not in found.finding
    assert warn_of_freedom(report.freedom)[0] in report.warnings
    written = json.loads(json.dumps(report.as_dict()))
    assert written["degrees_of_freedom"] == 5
    assert written["freedom"]["parts"] == [[k, k] for k in range(1, 6)]
    assert written["feasible"] is True  # supports may hold it


def test_what_rests_on_one_motion_is_said_of_one_only(several: Shell) -> None:
    held = several.report.deployment
    assert row(several, "locks").sign == "warns"
    assert (
        "flaps clipped on stop it closing, in all 5 of its motions" in row(several, "locks").finding
    )
    assert "not known whether 4 ties stop them opening" in row(several, "locks").finding
    assert held.closing == "clipped flaps"
    assert held.opening is None
    assert [tie.slack for tie in held.ties] == [None] * 4
    assert not any(tie.slack for tie in several.document.ties)
    for subject in ("weight", "ground"):
        assert row(several, subject).finding.startswith("along one of its motions: ")
    assert not any("own weight" in each for each in several.report.warnings)


def test_what_leaves_one_motion_has_been_tried(several: Shell, tmp_path: Path) -> None:
    found = row(several, "folds")
    assert found.remedy == "with a zigzag row: one motion (tried)"
    changed = make_shell(several.file.changed(found.changes), skip=MENDED)
    assert changed.report.degrees_of_freedom == 1
    assert row(changed, "folds").sign == "holds"
    assert row(changed, "folds").finding.startswith("in one motion: ")
    assert row(changed, "locks").sign == "holds"


@pytest.mark.parametrize(
    ("text", "changes"),
    [
        (STRAIGHT.replace("depth", "flap = 0\ndepth"), {"pattern.flap": "auto"}),
        pytest.param(
            PARALLEL + PACK,
            {"target.g.formula": "0*x + 0.05*(x - 0)*(4 - x)"},
            marks=thorough,
        ),
    ],
)
def test_flaps_or_a_curved_g_are_offered(
    tmp_path: Path, text: str, changes: dict[str, object]
) -> None:
    shell = made(tmp_path, text)
    assert shell.report.degrees_of_freedom == 5
    assert row(shell, "folds").changes == changes


def test_with_flaps_folded_on_it_is_one(tmp_path: Path) -> None:
    shell = made(tmp_path, STRAIGHT)
    assert shell.report.freedom.one_motion
    assert row(shell, "folds").sign == "holds"
    assert row(shell, "locks").finding.startswith("at 180 degrees: its flaps stop it closing")


def test_design_check_and_fold_count_alike(several: Shell, tmp_path: Path) -> None:
    """Of its own file with all states, and of the flat sheet alone."""
    write_fold(tmp_path / "shell.fold", several.document)
    states = json.loads((tmp_path / "shell.fold").read_text())
    flat = {key: value for key, value in states.items() if key != "file_frames"}
    (tmp_path / "flat.fold").write_text(json.dumps(flat))
    for name in ("shell.fold", "flat.fold"):
        said = orishell("check", name, "--json", cwd=tmp_path)
        assert json.loads(said.stdout)["degrees_of_freedom"] == 5
        said = orishell("check", name, cwd=tmp_path)
        assert "freedom   5 degrees of freedom in 3 folded states" in said.stdout
    assert fold_pattern(tmp_path / "flat.fold", frames=3).motion.degrees_of_freedom == 5


@thorough
def test_terminal_and_kit_say_so(several: Shell, tmp_path: Path) -> None:
    (tmp_path / "straight.toml").write_text(STRAIGHT + PACK)
    done = orishell("design", "straight.toml", "--out", "out", cwd=tmp_path)
    assert done.returncode == 0  # supports may hold it
    assert "! folds     5 degrees of freedom: rows 1 to 5 fold by themselves" in done.stdout
    assert "5 degrees of freedom" in done.stderr
    kit = orishell("kit", "straight.toml", "--out", "kit", cwd=tmp_path)
    assert "5 degrees of freedom" in kit.stderr
    readme = (tmp_path / "kit" / "README.md").read_text()
    assert "- Motion: The sheet has 5 degrees of freedom" in readme


def test_builders_are_told(several: Shell) -> None:
    """Ties are fixed when it is open, and the step that opens it says what to look after."""
    facts = find_facts(several.document)
    assert facts.freedoms == ("known", "5")
    assert not facts.ties_early
    steps = kit_steps(several.document, several.file.workshop, facts, ())
    (opening,) = (each for each in steps if each.name == "open")
    assert opening.more == ("several_known",)
    for language in ("en", "de"):
        assert "5" in load_words(language).say(f"more.{opening.more[0]}", **opening.values)
    alone = replace(several.document, measures=None)
    assert find_facts(alone).freedoms is None
