"""``orishell check`` of shells that are made in strips, and of what only looks like one."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from design_tables import formula, tables
from orishell.cli.main import run
from orishell.design_file import check_design
from orishell.shell.export import write_shell
from orishell.shell.make import make_shell
from sheets import shuffled


@pytest.fixture(scope="module")
def shell(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The files of a vault whose columns zigzag."""
    design = tables("t-hedral", formula("-0.5*x**2", -1.5, 1.5), formula("0", 0, 2))
    design["pattern"] = {"rows": 3, "columns": 5, "flap": 0, "depth": 0.15}
    design["deployment"], design["motion"] = {"from": "pack"}, {"frames": 5}
    made = make_shell(check_design(design, Path("vault.toml")))
    place = tmp_path_factory.mktemp("vault")
    write_shell(made, place, formats=["fold", "obj"])
    return place


def checked(
    path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *more: str
) -> tuple[Any, str]:
    monkeypatch.setattr(sys, "argv", ["orishell", "check", str(path), *more])
    with pytest.raises(SystemExit) as ended:
        run()
    return ended.value.code, capsys.readouterr().out


def moved(path: Path, place: Path, seed: int) -> Path:
    """The FOLD file as another program might write it: turned, shuffled, without our own keys."""
    fold = json.loads(path.read_text("utf-8"))
    turn = Rotation.random(random_state=seed).as_matrix()
    for frame in (fold, *fold["file_frames"]):
        frame["vertices_coords"] = (np.array(frame["vertices_coords"]) @ turn.T + 2).tolist()
    kept = {
        key: value
        for key, value in shuffled(fold, seed).items()
        if not key.startswith(("orishell", "frame_", "file_creator", "file_title"))
    }
    target = place / "other.fold"
    target.write_text(json.dumps(kept), encoding="utf-8")
    return target


WORDS = (
    "PASS  strips",
    "made in 4 strips, each of which lies flat",
    "t-hedral",
    "v folds     rigidly, exactly as t-hedral shells do",
    "1 degree of freedom",
    "180 degrees: a row crease is folded flat",
)


def test_our_file_says_what_it_is(
    shell: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    status, said = checked(shell / "shell.fold", monkeypatch, capsys)
    assert status == 0, said
    assert not [words for words in WORDS if words not in said], said
    assert "developable" not in said
    assert "FAIL" not in said
    status, said = checked(shell / "shell.fold", monkeypatch, capsys, "--json")
    report = json.loads(said)
    assert status == 0
    assert report["strips"] == report["pattern"]["strips"]["strips"] == 4
    assert report["degrees_of_freedom"] == 1
    assert report["checks"]["panel_length"]["worst"] < 1e-12


@pytest.mark.parametrize("seed", range(3))
def test_so_does_that_of_another_program(
    seed: int,
    shell: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    path = moved(shell / "shell.fold", tmp_path, seed)
    status, said = checked(path, monkeypatch, capsys)
    assert status == 0, said
    assert not [words for words in WORDS if not words.startswith("v ") and words not in said], said
    assert "v folds     rigidly, " in said


def test_so_does_a_joined_mesh(
    shell: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    fold = json.loads((shell / "shell.fold").read_text("utf-8"))
    target = next(each for each in fold["file_frames"] if each.get("frame_title") == "target")
    points = np.array(target["vertices_coords"]) @ Rotation.random(random_state=4).as_matrix()
    lines = [f"v {x:.9f} {y:.9f} {z:.9f}" for x, y, z in points]
    lines += ["f " + " ".join(str(k + 1) for k in face) for face in fold["faces_vertices"]]
    path = tmp_path / "vault.obj"
    path.write_text("\n".join(lines), encoding="utf-8")
    status, said = checked(path, monkeypatch, capsys)
    assert status == 0, said
    assert all(words in said for words in WORDS[1:3])
    assert "rigidly, to the tolerance" in said
    assert "1 degree of freedom" in said


def test_what_is_none_is_refused(
    shell: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """One vertex is off by a thousandth of the size, in all frames."""
    fold = json.loads((shell / "shell.fold").read_text("utf-8"))
    size = np.linalg.norm(np.ptp(np.array(fold["vertices_coords"]), axis=0))
    for frame in (fold, *fold["file_frames"]):
        frame["vertices_coords"][7][2] += 1e-3 * size
    path = tmp_path / "off.fold"
    path.write_text(json.dumps(fold), encoding="utf-8")
    status, said = checked(path, monkeypatch, capsys)
    assert status == 1
    assert "FAIL  developable" in said
    assert "strips" not in said
