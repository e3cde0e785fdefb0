"""A family of one file is all that it takes to add one: nothing else knows families by name."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from command_line import orishell
from orishell import InputError, design_shell, write_shell
from orishell.families.pattern import Family, Pattern
from orishell.families.registry import FAMILIES
from orishell.io import read_fold
from orishell.motion import FoldingMotion
from orishell.studio.labels import describe_examples, describe_families
from orishell.verification import inspect_fold
from toy_family import STARTER, MiuraPattern


@pytest.fixture(autouse=True)
def miura(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    starter = tmp_path / "starter.toml"
    starter.write_text(STARTER)
    family = Family("miura", MiuraPattern, "Miura", "A flat sheet that folds", starter)
    monkeypatch.setitem(FAMILIES, family.name, family)


@pytest.fixture
def design_file(tmp_path: Path) -> Path:
    path = tmp_path / "sheet.toml"
    path.write_text(STARTER + "\n[motion]\nframes = 5\n")
    return path


def test_it_is_designed_from_a_file_and_folds(design_file: Path) -> None:
    shell = design_shell(design_file)
    assert (shell.report.family, shell.report.feasible) == ("miura", True)
    assert shell.report.parameters == {"gamma_deg": 60.0}
    motion = FoldingMotion(shell.design.mechanism, 9)
    assert motion.drives[-1] == np.deg2rad(50)
    assert not shell.lock.early


def test_its_files_are_checked(design_file: Path, tmp_path: Path) -> None:
    write_shell(design_shell(str(design_file)), str(tmp_path / "out"))
    assert inspect_fold(read_fold(tmp_path / "out" / "shell.fold")).passed


def test_a_family_follows_what_it_has_a_method_for(tmp_path: Path) -> None:
    """The sheet of its own numbers has no target, so that none is tried on it; others as listed."""
    assert MiuraPattern.aims() == ["none"]
    assert {name: each.pattern.aims() for name, each in FAMILIES.items() if name != "miura"} == {
        "parallel-repeating": ["curves", "surface"],
        "orthodiagonal": ["curves", "surface"],
        "longitudinal-linear-repeating": ["curves", "surface"],
        "flat-foldable": ["surface", "none"],
        "pattern": ["drawing"],
        "t-hedral": ["curves", "surface"],
    }
    with pytest.raises(TypeError, match="Pattern designs nothing"):
        Family("nothing", Pattern, "Nothing", "No sheet", tmp_path / "starter.toml")


def test_it_is_listed_in_the_studio() -> None:
    listed = describe_families()["miura"]
    assert listed["label"] == "Miura"
    assert [each["key"] for each in listed["parameters"]] == ["rows", "columns", "gamma_deg"]
    assert listed["parameters"][-1]["default"] == 60.0
    example = describe_examples()[-1]
    assert (example["name"], example["text"].startswith(STARTER)) == ("miura", True)


def test_a_new_file_of_it_is_designed(tmp_path: Path) -> None:
    path = tmp_path / "new.toml"
    assert orishell("new", "--family", "miura", str(path)).returncode == 0
    done = orishell("design", str(path), "--out", str(tmp_path / "new"))
    assert done.returncode == 0, done.stderr
    assert orishell("check", str(tmp_path / "new" / "shell.fold")).returncode == 0


def test_its_values_are_checked(design_file: Path) -> None:
    design_file.write_text(STARTER.replace("60", "90"))
    with pytest.raises(InputError, match=r"gamma_deg: .*got 90, expected a value less than 90"):
        design_shell(design_file)
