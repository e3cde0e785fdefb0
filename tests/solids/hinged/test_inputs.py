"""Bad inputs about whole boards: one line, and the status that says whose fault it is."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import pytest

from command_line import orishell
from orishell.conventions.errors import InputError
from orishell.design_file.file import check_design
from samples import thorough

EXAMPLES = Path(__file__).parents[3] / "examples"
SHELTER = (EXAMPLES / "shelter_hinged.toml").read_text()
for whole, third in {
    "range = [0, 6]": "range = [0, 1]",
    "frames = 25": "frames = 3",
    "columns = 13 ": "columns = 3 ",
    "[workshop]\nstock = [2.44, 1.22]": "",
}.items():
    assert whole in SHELTER
    SHELTER = SHELTER.replace(whole, third)  # a sixth of its length: as high, with the same arms
PANEL = SHELTER[SHELTER.index("[panel]") : SHELTER.index("[deployment]")]
HINGED = 'construction = "hinged"\nthickness = 0.01\n'

IN_PANEL = {
    "a negative arm": ("largest_arm = -0.1", 2, "largest_arm"),
    "an arm in words": ('largest_arm = "long"', 2, "largest_arm"),
    "an endless arm": ("largest_arm = inf", 2, "largest_arm"),
    "an arm that is no number": ("largest_arm = nan", 2, "largest_arm"),
    "fins of nothing": ("arm_width = 0", 2, "arm_width"),
    "fins of less": ("arm_width = -1", 2, "arm_width"),
    "fins in words": ('arm_width = "thin"', 2, "arm_width"),
    "a membrane": ("membrane = 0.001", 2, "no membrane"),
    "the weight of a membrane": ("membrane_density = 900", 2, "no membrane"),
    "set-backs": ("largest_setback = { share = 0.4 }", 2, "largest_setback"),
    "a stop of flaps": ("stop_deg = 5", 2, "stop_deg"),
    "a key that there is not": ("arm = 0.1", 2, "arm"),
    "short arms": ("largest_arm = 0.05", 1, "arms of 0.11 are needed, 11 times the thickness"),
    "no arms": ("largest_arm = 0", 1, "arms of 0.11 are needed"),
    "pieces of nothing": ("pieces = 0", 2, "pieces"),
    "pieces of one row": ("pieces = 1", 2, "pieces"),
    "pieces of half rows": ("pieces = 2.5", 2, "pieces"),
    "pieces in words": ('pieces = "four"', 2, "pieces"),
    "pieces of more rows than there are": ("pieces = 13", 1, "fewer rows of panels than a piece"),
    "long arms of pieces": ("pieces = 6\nlargest_arm = 0.04", 1, "arms of 0.05 are needed"),
    "long arms of all pieces": ('pieces = "auto"\nlargest_arm = 0.005', 1, "arms of 0.01 are"),
    "fins wider than panels": ("arm_width = 0.5", 1, "thicker than its panel has room for"),
    "a gap wider than panels": ("gap = 0.7", 1, "nothing of a panel"),
}
IN_HINGE = {
    "a leaf of nothing": ("leaf = 0", "leaf"),
    "a leaf of less": ("leaf = -0.02", "leaf"),
    "a leaf in words": ('leaf = "wide"', "leaf"),
    "a leaf that is no number": ("leaf = nan", "leaf"),
    "a negative knuckle": ("knuckle = -0.002", "knuckle"),
    "an endless knuckle": ("knuckle = inf", "knuckle"),
    "holes on top of each other": ("screw_spacing = 0", "screw_spacing"),
    "holes backwards": ("screw_spacing = -0.05", "screw_spacing"),
    "no holes": ("hole = 0", "hole"),
    "holes as wide as leaves": ("hole = 0.02", "at most half the width of a leaf, 0.01"),
    "a leaf narrower than two holes": ("leaf = 0.004", "at most half the width of a leaf"),
    "hinges lighter than nothing": ("linear_density = -1", "linear_density"),
    "a key that there is not": ("pin = 0.001", "pin"),
}
UNFIT = {
    "a leaf wider than its panel has room for": ("leaf = 0.3", "wider than its panel has room"),
    "holes farther apart than hinges are long": (
        "screw_spacing = 0.5",
        "holes of a hinge would be farther apart than it is long",
    ),
    "knuckles that need longer arms": ("knuckle = 0.005", "arms of 0.225 are needed"),
}
WHOLE = {
    "no such construction": (
        PANEL,
        '[panel]\nconstruction = "hinge"\nthickness = 0.01\n',
        2,
        "hinged",
    ),
    "arms on a membrane": (
        PANEL,
        "[panel]\nthickness = 0.01\nmembrane = 0.001\nlargest_arm = 0.1\n",
        2,
        'construction = "hinged"',
    ),
    "fins of bevelled panels": (
        PANEL,
        '[panel]\nconstruction = "bevel"\ngap = 0.001\nthickness = 0.01\narm_width = 0.1\n',
        2,
        'construction = "hinged"',
    ),
    "pieces of a sandwich": (
        PANEL,
        "[panel]\nthickness = 0.01\nmembrane = 0.001\npieces = 4\n",
        2,
        "only whole boards have hinges, arms and pieces",
    ),
    "hinges on a membrane": (
        PANEL,
        "[panel]\nthickness = 0.01\nmembrane = 0.001\nhinge = { leaf = 0.02 }\n",
        2,
        "only whole boards have hinges, arms and pieces",
    ),
    "the density of arms of bevelled panels": (
        PANEL,
        '[panel]\nconstruction = "bevel"\ngap = 0.001\nthickness = 0.01\narm_density = 7850\n',
        2,
        'construction = "hinged"',
    ),
    "no table of hinges": (PANEL, f"[panel]\n{HINGED}hinge = 0.02\n", 2, "hinge"),
    "arms lighter than nothing": (PANEL, f"[panel]\n{HINGED}arm_density = -1\n", 2, "arm_density"),
    "no thickness": (PANEL, '[panel]\nconstruction = "hinged"\n', 2, "a thickness above 0"),
    "flaps": ("flap = 0  ", "flap = 0.25", 1, "a flap folds flat before the sheet does"),
    "a sheet that does not fold flat": (
        "columns = 3 ",
        "columns = 4 ",  # beside the crests of g
        1,
        "need a sheet that folds flat",
    ),
}


def seldom(cases: Iterable[str], *slow: str) -> list[Any]:
    """Cases, of which some (parts of their names) try much: only ``make thorough`` runs those."""
    return [
        pytest.param(each, marks=thorough) if any(part in each for part in slow) else each
        for each in cases
    ]


def refused(text: str, status: int, words: str, place: Path) -> str:
    (place / "shell.toml").write_text(text)
    ran = orishell("design", "shell.toml", "--out", "out", cwd=place)
    lines = [line for line in ran.stderr.splitlines() if "warning" not in line]
    assert ran.returncode == status, ran.stderr
    assert len(lines) == 1, ran.stderr
    assert words in lines[0]
    assert "fault of the program" not in lines[0]
    assert not (place / "out").exists()
    return lines[0]


@pytest.mark.parametrize(
    "case",
    seldom(IN_PANEL, "arms of pieces", "arms of all", "short arms", "more rows", "fins wider"),
)
def test_a_key_of_the_panel(case: str, tmp_path: Path) -> None:
    key, status, words = IN_PANEL[case]
    text = SHELTER.replace(PANEL, f"[panel]\n{HINGED}{key}\n")
    refused(text, status, words, tmp_path)


def of_hinge(key: str) -> str:
    table = f"[panel]\n{HINGED}largest_arm = 0.12\n\n[panel.hinge]\n{key}\n"
    return SHELTER.replace(PANEL, table)


@pytest.mark.parametrize("case", IN_HINGE)
def test_a_key_of_the_hinge(case: str) -> None:
    key, words = IN_HINGE[case]
    with pytest.raises(InputError) as refusal:
        check_design(tomllib.loads(of_hinge(key)), Path("shell.toml"))
    assert "[panel] hinge" in str(refusal.value)
    assert words in str(refusal.value)
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize("case", seldom(UNFIT, "knuckles", "holes"))
def test_hinges_that_do_not_fit(case: str, tmp_path: Path) -> None:
    key, words = UNFIT[case]
    assert "Nearest found that works" in refused(of_hinge(key), 1, words, tmp_path)


@pytest.mark.parametrize("case", WHOLE)
def test_what_does_not_go_together(case: str, tmp_path: Path) -> None:
    before, after, status, words = WHOLE[case]
    assert before in SHELTER
    refused(SHELTER.replace(before, after), status, words, tmp_path)


@thorough
def test_remedies_are_tried(tmp_path: Path) -> None:
    text = SHELTER.replace("largest_arm = 0.03\npieces = 4 ", "largest_arm = 0.05\n")
    refused(text, 1, "Nearest found that works: pieces = 6 in [panel]", tmp_path)
