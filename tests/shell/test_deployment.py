"""Design files with a table [deployment], through the command line: from pack to shell."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from command_line import Ran, orishell
from deployed_shelters import shelter as shelter_text
from orishell.design_file import check_design
from orishell.document.from_design import states_of
from orishell.io import read_fold
from orishell.io.fold import document_of_fold
from orishell.shell.make import design_shell, make_shell
from orishell.workshop.kit.facts import find_facts
from orishell.workshop.kit.parts import kit_tools
from orishell.workshop.kit.steps import kit_steps
from samples import thorough

EXAMPLES = Path(__file__).parents[2] / "examples"
SHELTER = shelter_text(columns=5)
"""A third of the example: 2 m of its 6, without its own table [deployment]."""
FIGURE_1 = (
    (EXAMPLES / "figure1.toml").read_text(encoding="utf-8").replace("frames = 25", "frames = 3")
)
FROM_PACK = 'from = "pack"\n'


def deployed(text: str, keys: str) -> str:
    return f"{text}\n[deployment]\n{keys}"


def design(directory: Path, text: str, *options: str) -> Ran:
    (directory / "s.toml").write_text(text, encoding="utf-8")
    return orishell("design", "s.toml", "--out", "out", *options, cwd=directory)


def report(directory: Path) -> Any:
    return json.loads((directory / "out" / "report.json").read_text())


@pytest.fixture(scope="module")
def shelter(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Ran]:
    directory = tmp_path_factory.mktemp("shelter")
    ran = design(directory, deployed(shelter_text(), FROM_PACK + 'ties = "feet"\n'))
    assert ran.returncode == 0, ran.stderr
    return directory, ran


@pytest.mark.slow
def test_a_shelter_travels_as_a_bundle(shelter: tuple[Path, Ran]) -> None:
    """Deployed as its file asks: 3 x 6 m of floor within, 2 m of headroom.

    Packed, no longer than its longest row crease beyond its tallest panels.
    """
    directory, ran = shelter
    said = report(directory)
    box, packed = said["deployed"], said["deployment"]["packed"]
    assert box["width"] == pytest.approx(6.0, abs=1e-9)
    assert box["depth"] == pytest.approx(3.3, abs=0.02)
    assert box["height"] == pytest.approx(2.4, abs=0.02)
    assert packed["length"] < 2.1
    assert packed["width"] < 1.33
    assert packed["height"] < 0.001
    assert packed["drive_deg"] == 180
    assert said["lock"]["cause"] == "crease"
    assert said["lock"]["path"]["states"] > 2
    assert said["lock"]["target_drive_deg"] < 180
    assert max(said["residuals"].values()) < 1e-12
    assert "flaps clipped on stop it closing; 13 ties stop it opening" in ran.stdout
    assert ran.stderr == ""


def test_ties_of_a_shelter_are_slack_until_it_stands(shelter: tuple[Path, Ran]) -> None:
    """One for each of its 13 columns, all shorter in the pack and longer in the flat sheet."""
    ties = report(shelter[0])["deployment"]["ties"]
    assert len(ties) == 13
    assert all(tie["grows"] and tie["slack"] for tie in ties)
    assert all(tie["packed"] < tie["length"] < tie["flat"] for tie in ties)


def test_a_shelter_closes_under_its_own_weight(shelter: tuple[Path, Ran]) -> None:
    """By 31.25 N of 812 N, found on its own in tests/deployment/test_weight.py."""
    weight = report(shelter[0])["deployment"]["weight"]
    assert weight["force_unit"] == "N"
    assert weight["at_feet"] == pytest.approx(-31.25, rel=0.005)
    assert weight["total"] == pytest.approx(812, rel=0.005)


@pytest.mark.slow
def test_files_have_pack_target_and_flat_sheet(shelter: tuple[Path, Ran]) -> None:
    directory, _ = shelter
    frames = json.loads((directory / "out" / "shell.fold").read_text())["file_frames"]
    titles = [frame.get("frame_title") for frame in frames]
    named = {title: k for k, title in enumerate(titles) if title in {"pack", "target", "flat"}}
    assert len(named) == 3
    assert (named["pack"], named["flat"]) == (0, len(frames) - 1)
    shell = design_shell(directory / "s.toml")
    assert shell.document.named == named
    points = {name: np.array(frames[k]["vertices_coords"]) for name, k in named.items()}
    for name in named:
        ours = shell.document.in_world(shell.document.state(name).positions)
        np.testing.assert_array_equal(points[name], ours)
        command = ["convert", "out/shell.fold", f"{name}.obj", "--state", name]
        done = orishell(*command, cwd=directory)
        assert done.returncode == 0, done.stderr
        lines = (directory / f"{name}.obj").read_text().splitlines()
        written = [[float(x) for x in line.split()[1:]] for line in lines if line[:2] == "v "]
        x, up, front = np.array(written[: len(ours)]).T  # y is up in OBJ
        np.testing.assert_allclose(np.column_stack([x, -front, up]), ours, atol=1e-9)
    assert np.ptp(points["flat"][:, 2]) < 1e-12
    # The pack stands on edge: rows lie side by side, and no panel is as long as the shell.
    assert np.ptp(points["target"], axis=0)[0] > 2 * np.ptp(points["pack"], axis=0).min()
    read = read_fold(directory / "out" / "shell.fold")
    assert document_of_fold(read).named == named


@pytest.mark.usefixtures("unpictured")
def test_a_shell_that_rolls_up_is_packed_where_it_meets_itself(tmp_path: Path) -> None:
    """The paper's Figure 1: brute force finds 157 degrees in tests/locking/test_beyond_target.py.

    The pack ends where the path is proved to be free.
    """
    done = design(tmp_path, deployed(FIGURE_1, FROM_PACK))
    assert done.returncode == 0
    lock, packed = report(tmp_path)["lock"], report(tmp_path)["deployment"]["packed"]
    contact = lock["first_contact"]
    assert lock["cause"] == "clash"
    assert contact["drive_deg"] == pytest.approx(156.9, abs=0.05)
    assert contact["drive_deg"] > contact["clear_until_deg"] == packed["drive_deg"]
    panels = "panels {} and {}".format(*contact["panels"])
    assert f"is no flat bundle: {panels} meet at drive 156.8967 degrees" in done.stderr
    assert f"nothing touches before {panels} meet at 156.89 degrees (" in done.stdout
    assert "), beyond the target (proved" in done.stdout
    frames = json.loads((tmp_path / "out" / "shell.fold").read_text())["file_frames"]
    assert frames[0]["orishell:drive_deg"] == contact["clear_until_deg"]


@pytest.mark.usefixtures("unpictured")
def test_a_straight_shell_packs_flat(tmp_path: Path) -> None:
    """A straight g: all row creases close together, so that the pack is one row crease long."""
    text = FIGURE_1.replace("5*sin(pi*x/10)", "0*x")
    done = design(tmp_path, deployed(text, FROM_PACK + 'ties = "feet"\n'))
    assert done.returncode == 0
    said = report(tmp_path)
    assert said["lock"]["cause"] == "crease"
    assert said["deployment"]["packed"]["height"] < 1e-9
    assert said["deployment"]["packed"]["length"] == pytest.approx(20, abs=1e-9)
    assert "no flat bundle" not in done.stderr
    assert max(said["residuals"].values()) < 1e-12


@thorough
@pytest.mark.usefixtures("unpictured")
def test_the_third_family_goes_on_to_where_it_meets_itself(tmp_path: Path) -> None:
    text = (EXAMPLES / "figure3.toml").read_text(encoding="utf-8")
    done = design(tmp_path, deployed(text, FROM_PACK))
    assert done.returncode == 0
    said = report(tmp_path)
    assert said["deployment"]["flap_attachment"] is None
    assert said["deployment"]["end_drive_deg"] > said["lock"]["target_drive_deg"]
    assert max(said["residuals"].values()) < 1e-12


@pytest.mark.usefixtures("unpictured")
def test_a_shell_that_ends_at_its_stage_is_refused(tmp_path: Path) -> None:
    text = (EXAMPLES / "sectors.toml").read_text(encoding="utf-8")
    done = design(tmp_path, deployed(text, FROM_PACK))
    assert done.returncode == 1
    assert "does not close beyond its target" in done.stderr
    assert done.stderr.endswith('Nearest found that works: from = "flat" in [deployment].\n')
    assert not (tmp_path / "out").exists()
    assert design(tmp_path, deployed(text, 'from = "flat"\n')).returncode == 0


@pytest.mark.usefixtures("unpictured")
def test_hinges_end_the_motion_at_their_angle(tmp_path: Path) -> None:
    """The fold angles of the pack as they are written: the largest of all is what was given."""
    done = design(tmp_path, deployed(SHELTER, FROM_PACK + "largest_fold_deg = 150\n"))
    assert done.returncode == 0
    frame = json.loads((tmp_path / "out" / "shell.fold").read_text())["file_frames"][0]
    assert np.abs(frame["edges_foldAngle"]).max() == pytest.approx(150, abs=1e-9)
    assert report(tmp_path)["lock"]["cause"] == "hinges"
    assert "its hinges close no further than 150 degrees" in done.stderr


@pytest.mark.slow
@pytest.mark.usefixtures("unpictured")
@pytest.mark.parametrize(
    ("columns", "keys", "offered"),
    [
        pytest.param(
            13, FROM_PACK + "largest_fold_deg = 60\n", ["largest_fold_deg = 180"], marks=thorough
        ),
        # As far as the target asks, and no further: it is not what a pack asks.
        pytest.param(
            13,
            FROM_PACK + "largest_fold_deg = 95.133\n",
            ["largest_fold_deg = 180", 'from = "flat"|flap_attachment = "clipped"'],
            marks=thorough,
        ),
        (5, "largest_fold_deg = 150\n", ['flap_attachment = "clipped"', "largest_fold_deg = 180"]),
    ],
)
def test_hinges_that_do_not_reach_the_target(
    tmp_path: Path, columns: int, keys: str, offered: list[str]
) -> None:
    """Each value that is offered works in place of what was given."""
    text = shelter_text(columns)
    done = design(tmp_path, deployed(text, keys))
    assert done.returncode == 1
    starts = ("hinges do not close", "the shell does not", "the shell hardly closes beyond")
    assert done.stderr.startswith(tuple(f"orishell: {start}" for start in starts))
    assert not (tmp_path / "out").exists()
    for changes in offered:
        each = changes.split("|")
        assert " with ".join(f"{change} in [deployment]" for change in each) in done.stderr
        kept = keys
        for change in each:
            kept = re.sub(f"{change.split()[0]} = .*\n", "", kept)
        changed = "\n".join(each)
        assert design(tmp_path, deployed(text, f"{kept}{changed}\n")).returncode == 0


@pytest.mark.parametrize(("unit", "threads"), [("mm", True), ("m", False)])
def test_feet_of_a_small_shell_are_tied_with_threads_and_not_anchored(
    unit: str, threads: bool
) -> None:
    """Of the same numbers 300 mm wide, or 300 m; without ties both open under their weight."""
    tables = {
        "shell": {"family": "parallel-repeating", "unit": unit},
        "target": {
            "f": {"formula": "40 - x**2/45", "range": [-30, 30]},
            "g": {"formula": "40*sin(pi*x/120)", "range": [0, 240]},
        },
        "pattern": {"rows": 5, "columns": 5, "flap": 10, "xi_deg": 60},
    }
    shell = make_shell(check_design(tables, Path("x.toml")), skip=["remedies", "deviation"])
    (note,) = [each for each in shell.report.warnings if "opens under its own weight" in each]
    assert ("tie its feet together with threads" in note) is threads
    document = replace(shell.document, states=states_of(shell.motion))
    facts = find_facts(document)
    assert facts.feet > 0
    steps = [each.name for each in kit_steps(document, shell.file.workshop, facts, ())]
    tools = [name for name, _ in kit_tools(document, facts, ())]
    assert ("anchor" in steps, "anchors" in tools) == (not threads, not threads)
