"""What is said of a table [deployment] that does not fit, and settings that work together."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from command_line import Ran, orishell
from deployed_shelters import shelter
from orishell.conventions.errors import InputError
from orishell.design_file import read_design_file
from orishell.shell.candidate import prove
from orishell.shell.steps import Work
from samples import led_by, thorough

EXAMPLES = Path(__file__).parents[2] / "examples"
SHELTER = shelter(columns=5)
"""A third of the example: 2 m of its 6, without its own table [deployment]."""
PACK = 'from = "pack"\n'
WHERE = "[deployment] "


pytestmark = pytest.mark.usefixtures("unpictured")


def design(directory: Path, text: str, *options: str) -> Ran:
    (directory / "s.toml").write_text(text, encoding="utf-8")
    return orishell("design", "s.toml", "--out", "out", *options, cwd=directory)


def deployed(keys: str, text: str = SHELTER) -> str:
    return f"{text}\n[deployment]\n{keys}"


def report(directory: Path) -> Any:
    return json.loads((directory / "out" / "report.json").read_text())


@pytest.mark.parametrize(
    ("keys", "where", "got", "expected"),
    [
        (PACK + 'flap_attachment = "folded"', "flap_attachment", "'folded'", '"clipped"'),
        ('flap_attachment = "glued"', "flap_attachment", "'glued'", "'folded' or 'clipped'"),
        ('from = "sky"', "from", "'sky'", "'flat' or 'pack'"),
        ("largest_fold_deg = 0", "largest_fold_deg", "0", "greater than 0"),
        ("largest_fold_deg = nan", "largest_fold_deg", "nan", "a finite number"),
        ("largest_fold_deg = 181", "largest_fold_deg", "181", "at most 180"),
        ('largest_fold_deg = "90"', "largest_fold_deg", "'90'", "a number"),
        ('ties = "hands"', "ties", "'hands'", "'none', 'feet' or 'folds'"),
        ("ties = [[[0, 1]]]", "ties", "[[[0, 1]]]", "2 entries"),
        ("ties = [[[-1, 1], [12, 1]]]", "ties", "[[[-1, 1], [12, 1]]]", "at least 0"),
        ("ties = [[[0.5, 1], [12, 1]]]", "ties", "[[[0.5, 1], [12, 1]]]", "a whole number"),
        (PACK + "ties = [[[0, 1], [12, 2]]]", "ties", "[0, 1], [12, 2]", "two rows of 0 to 12"),
        (PACK + "ties = [[[0, 1], [13, 1]]]", "ties", "[0, 1], [13, 1]", "two rows of 0 to 12"),
        (PACK + "ties = [[[0, 1], [0, 1]]]", "ties", "[0, 1], [0, 1]", "two rows of 0 to 12"),
        # With flaps as parts of the sheet, their columns are no inner ones.
        ("ties = [[[0, 0], [12, 0]]]", "ties", "[0, 0], [12, 0]", "one column of 1 to 5"),
    ],
)
def test_what_does_not_fit_is_named(
    tmp_path: Path, keys: str, where: str, got: str, expected: str
) -> None:
    done = design(tmp_path, deployed(keys))
    assert done.returncode == 2
    assert done.stdout == ""
    (message,) = done.stderr.splitlines()
    assert message.startswith(f"orishell: s.toml: {WHERE}{where}: ")
    before, after = message.split(", expected ", 1)
    assert f"; got {got}" in before or f"; got rows and columns {got}" in before
    assert expected in after
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("folds", "got", "expected"),
    [
        ("[]", "[]", "1 entries"),
        ("[2.5]", "2.5", "a whole number"),
        ("[0]", "row 0", "rows of inner vertices, 1 to 11"),
        ("[2, 12]", "row 12", "rows of inner vertices, 1 to 11"),
    ],
)
def test_rows_of_ties_are_those_of_folds(
    tmp_path: Path, folds: str, got: str, expected: str
) -> None:
    path = tmp_path / "s.toml"
    path.write_text(deployed(f"{PACK}ties = {{ folds = {folds} }}"), encoding="utf-8")
    with pytest.raises(InputError) as refused:
        prove(read_design_file(path), Work(clash="unexamined"))
    error = refused.value
    assert any(key.endswith("folds") for key in error.keys) or "folds" in error.where
    assert error.got == got
    assert expected in error.expected


def test_keys_that_are_not_there(tmp_path: Path) -> None:
    done = design(tmp_path, deployed(PACK + 'tie = "feet"\n'))
    assert done.returncode == 2
    assert f"{WHERE}tie: unknown key" in done.stderr
    assert "Did you mean ties?" in done.stderr
    assert "one of from, flap_attachment, largest_fold_deg, ties" in done.stderr


@thorough
def test_a_motion_from_a_pack_has_three_states_at_least(tmp_path: Path) -> None:
    """The pack, the target and the flat sheet."""
    done = design(tmp_path, deployed(PACK, SHELTER.replace("frames = 3", "frames = 2")))
    assert done.returncode == 2
    (message,) = done.stderr.splitlines()
    assert message.startswith("orishell: s.toml: [motion] frames: ")
    assert "got 2, expected 3 to 1000. Remedy: frames = 3, or more" in message
    assert not (tmp_path / "out").exists()
    done = design(tmp_path, deployed(PACK, SHELTER))
    assert done.returncode == 0
    frames = json.loads((tmp_path / "out" / "shell.fold").read_text())["file_frames"]
    assert [frame["frame_title"] for frame in frames] == ["pack", "target", "flat"]
    drives = [frame["orishell:drive_deg"] for frame in frames]
    assert drives == [180, pytest.approx(report(tmp_path)["lock"]["target_drive_deg"]), 0]


def test_a_shell_without_feet_has_none_to_tie(tmp_path: Path) -> None:
    text = (EXAMPLES / "canopy.toml").read_text(encoding="utf-8")
    done = design(tmp_path, deployed('ties = "feet"', text))
    assert done.returncode == 2
    assert f'{WHERE}ties: there are no feet to tie; got "feet"' in done.stderr
    assert "Remedy: name pairs of vertices" in done.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("given", led_by(["from the flat sheet", "without flaps"]))
def test_the_sheet_is_the_same_wherever_it_starts(tmp_path: Path, given: str) -> None:
    """Clipped flaps are no part of it: the motion is that of a sheet without flaps.

    The grid has 5 columns instead of 7, and the drive goes on to 180 degrees.
    """
    if given == "from the flat sheet":
        done = design(tmp_path, deployed('flap_attachment = "clipped"'))
        held, first = "flaps clipped on stop it closing", 0
    else:
        done = design(tmp_path, deployed(PACK, SHELTER.replace("flap = 0.25", "flap = 0")))
        held, first = "only its supports stop it closing", 180
    assert done.returncode == 0
    assert held in done.stdout
    fold = json.loads((tmp_path / "out" / "shell.fold").read_text())
    assert fold["orishell:grid_shape"] == [13, 5]
    assert fold["file_frames"][0]["orishell:drive_deg"] == first
    said = report(tmp_path)
    assert said["deployment"]["end_drive_deg"] == 180
    clipped = "clipped" if given == "from the flat sheet" else None
    assert said["deployment"]["flap_attachment"] == clipped


def test_contact_not_looked_for_or_allowed(tmp_path: Path) -> None:
    """Nothing meets on this way, so the files are the same; only what is proved is not."""
    frames = []
    for option in ("--no-clash-test", "--allow-clash"):
        done = design(tmp_path, deployed(PACK), option)
        assert done.returncode == 0
        frames.append(json.loads((tmp_path / "out" / "shell.fold").read_text())["file_frames"])
        looked = option == "--allow-clash"
        assert report(tmp_path)["feasible"] is (True if looked else None)
        assert (
            "folds     in one motion: nothing touches from flat to 180 degrees" in done.stdout
        ) is looked
    assert frames[0] == frames[1]


@thorough
def test_rows_and_columns_are_chosen_for_a_pack_too(tmp_path: Path) -> None:
    """The same table without a pack chooses as many: the surface is that of the target."""
    text = shelter().replace("rows = 11\n", "").replace("columns = 13 ", "# ")
    text = text.replace("stock = [2.44, 1.22]\n", "")
    text += "\n[tolerance]\nsurface = 0.6\n"
    chosen = []
    for keys in (PACK, 'from = "flat"\nflap_attachment = "clipped"\n'):
        done = design(tmp_path, deployed(keys, text))
        assert done.returncode == 0, done.stderr
        said = report(tmp_path)
        assert said["deviation"]["surface"]["max"] <= 0.6
        chosen.append((said["rows"], said["columns"], said["deployed"]))
    assert chosen[0] == chosen[1]
