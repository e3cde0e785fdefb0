"""``orishell kit``: what it prints, and one message for each thing that is wrong."""

from __future__ import annotations

from pathlib import Path

import pytest

from command_line import orishell
from documents import EXAMPLES
from samples import thorough

CARD = EXAMPLES / "figure1_card.toml"
CANOPY = EXAMPLES / "canopy.toml"
GOLDEN = Path(__file__).parents[1] / "io/golden/sheet.fold"


def changed(folder: Path, file: Path, lines: str) -> Path:
    """A design file with lines added to its table [workshop], made if it has none."""
    text = file.read_text()
    if "[workshop]" in text:
        head, _, rest = text.partition("[workshop]")
        end = rest.index("\n") + 1
        text = f"{head}[workshop]{rest[:end]}{lines}\n{rest[end:]}"
    else:
        text += f"\n[workshop]\n{lines}\n"
    path = folder / "changed.toml"
    path.write_text(text)
    return path


def test_a_card_model(tmp_path: Path) -> None:
    ran = orishell("kit", CANOPY, "--out", tmp_path / "kit", "--paper")
    assert ran.returncode == 0
    assert ran.stderr == ""  # that no board is as large as its sheet is of no use here
    first, second, *others = ran.stdout.splitlines()
    assert first == "scale     1:66"
    # Its border has a panel of 0.12 m, by 66.
    assert second.startswith("panels    as narrow as 1.9 mm, which is hard to fold: larger paper")
    assert [line.split("/")[-1] for line in others] == [
        "README.md",
        "booklet.pdf",
        "pattern.dxf",
        "pattern.pdf",
    ]


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        ('language = "fr"', "[workshop] language"),
        ("language = 1", "[workshop] language"),
        ('paper = "A0"', "[workshop] paper"),
        ("paper_scale = 2", "[workshop] paper_scale"),
        ("paper_scale = 0.9", "more than 400 pages"),
        ('palette = "none"', "there is no such palette"),
    ],
)
def test_a_wrong_key_is_one_message(lines: str, said: str, tmp_path: Path) -> None:
    file = changed(tmp_path, CANOPY, lines)
    ran = orishell("kit", file, "--out", tmp_path / "kit", "--paper")
    assert ran.returncode == 2
    (message,) = (line for line in ran.stderr.splitlines() if ": warning: " not in line)
    assert said in message
    assert not (tmp_path / "kit").exists()


def test_wrong_arguments_are_one_message(tmp_path: Path) -> None:
    (tmp_path / "taken").write_text("")
    (tmp_path / "no.toml").write_text("[shell")
    (tmp_path / "other/cut").mkdir(parents=True)
    (tmp_path / "other/README.md").write_text("mine")
    (tmp_path / "partly").mkdir()
    (tmp_path / "partly/ground").write_text("mine")
    there = sorted(tmp_path.rglob("*"))
    for arguments, said in (
        ((tmp_path / "missing.toml", "--out", tmp_path / "kit"), "does not exist"),
        ((tmp_path / "no.toml", "--out", tmp_path / "kit"), "this is not TOML"),
        ((GOLDEN, "--out", tmp_path / "kit"), "check, fold and convert read FOLD files"),
        ((EXAMPLES, "--out", tmp_path / "kit"), "this is not a file"),
        ((CANOPY, "--out", ""), "the name is empty"),
        ((CANOPY, "--out", tmp_path / "taken"), "the output directory cannot be made"),
        ((CANOPY, "--out", tmp_path / "partly"), "ground is a file"),
        ((CANOPY, "--out", tmp_path / "other"), "README.md: this file is not of orishell"),
    ):
        ran = orishell("kit", *arguments)
        assert ran.returncode == 2
        assert said in ran.stderr
        assert ran.stderr.count("orishell: ") == 1
        assert sorted(tmp_path.rglob("*")) == there


@thorough
def test_a_design_that_cannot_be_made_leaves_nothing(tmp_path: Path) -> None:
    file = tmp_path / "clash.toml"
    file.write_text(
        (EXAMPLES / "shelter.toml")
        .read_text()
        .replace("flap = 0.25", "flap = 0.9")
        .replace('from = "pack"', 'from = "flat"')
        .replace('ties = "feet"', "")
    )
    ran = orishell("kit", file, "--out", tmp_path / "kit")
    assert ran.returncode == 1
    assert "the flaps are too wide" in ran.stderr
    assert not (tmp_path / "kit").exists()


def test_a_directory_in_the_way_of_a_file(tmp_path: Path) -> None:
    (tmp_path / "booklet/booklet.pdf").mkdir(parents=True)
    ran = orishell("kit", CANOPY, "--out", tmp_path, "--paper")
    assert ran.returncode == 2
    assert "a directory is in the way of a file" in ran.stderr
