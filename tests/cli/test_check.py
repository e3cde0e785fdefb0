"""``orishell check`` as a user meets it: status, messages, summary and JSON."""

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import patterns
from orishell.cli.main import run
from orishell.io import read_pattern
from orishell.shell.folded import fold_pattern
from sheets import miura, write


class Ran:
    """What a run of the command left behind."""

    def __init__(self, capsys: pytest.CaptureFixture[str], status: Any) -> None:
        self.status = status
        self.out, self.err = capsys.readouterr()


def check(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *arguments: str | Path
) -> Ran:
    monkeypatch.setattr(sys, "argv", ["orishell", "check", *map(str, arguments)])
    with pytest.raises(SystemExit) as ended:
        run()
    return Ran(capsys, ended.value.code)


def test_a_good_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write({**miura([0.3, 0.9]), "frame_unit": "mm"}, tmp_path)
    ran = check(monkeypatch, capsys, path)
    assert (ran.status, ran.err) == (0, "")
    lines = ran.out.splitlines()
    assert lines[0] == f"{path}: 20 panels, 31 creases, 12 inner vertices"
    assert lines[1].startswith("frames    3, flat sheet in frame 0, diagonal ")
    assert lines[1].endswith(" mm")
    assert sum(line.startswith("PASS  ") for line in lines) == 10
    assert lines[-1].startswith("not checked: contact between frames")


def test_a_bad_sheet(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    fold = miura([0.3, 0.9])
    fold["file_frames"][1]["vertices_coords"][0][2] += 0.01
    path = write(fold, tmp_path)
    ran = check(monkeypatch, capsys, path)
    assert (ran.status, ran.err) == (1, "")
    wrong = [line for line in ran.out.splitlines() if line.startswith("FAIL  ")]
    assert any("planarity" in line and "panel 0 in frame 2" in line for line in wrong)
    printed = check(monkeypatch, capsys, path, "--json")
    assert printed.status == 1
    report = json.loads(printed.out)
    assert report["passed"] is False
    assert report["checks"]["planarity"]["panel"] == 0
    assert check(monkeypatch, capsys, path, "--tolerance", "0.01").status == 0


def test_the_summary_says_which_panels_were_turned(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    fold = miura([])
    fold["faces_vertices"][3] = fold["faces_vertices"][3][::-1]
    ran = check(monkeypatch, capsys, write(fold, tmp_path))
    assert ran.status == 0
    assert "turned    1 panels listed the other way round" in ran.out


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "the file is empty"),
        ("[shell]\n", "this is not JSON"),
        ("[1, 2]", "this is not FOLD"),
        ("{}", "this key is missing"),
        ('{"vertices_coords": [[0, 0], [1, 0], [1, 1]]}', "faces_vertices: this key is missing"),
        ('{"vertices_coords": [[0, 0], [1, 0]], "faces_vertices": [[0, 1, 2, 3]]}', "no such"),
        ('{"vertices_coords": [[0, NaN]], "faces_vertices": [[0, 1, 2, 3]]}', "not JSON"),
        ('{"vertices_coords": [[0, 0], [1]], "faces_vertices": [[0, 1, 2, 3]]}', "vertex 1"),
        (
            '{"vertices_coords": [[0, 0]], "faces_vertices": [[0, 0, 0]]}',
            "repeats a corner",
        ),
        ('{"vertices_coords": [[0,0],[0,0],[0,0],[0,0]], "faces_vertices": [[0,1,2,3]]}', "size"),
        ('{"file_frames": [{"frame_inherit": true, "frame_parent": 1}]}', "another frame"),
        (
            '{"file_frames": [{"frame_inherit": true, "frame_parent": 2},'
            '{"frame_inherit": true, "frame_parent": 1}]}',
            "in a circle",
        ),
    ],
)
def test_bad_files_are_one_message(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    text: str,
    says: str,
) -> None:
    path = tmp_path / "sheet.fold"
    path.write_text(text)
    ran = check(monkeypatch, capsys, path)
    assert ran.status == 2
    assert ran.out == ""
    assert ran.err.startswith(f"orishell: {path}")
    assert says in ran.err
    assert ran.err.count("\n") == 1


@pytest.mark.parametrize("tolerance", ["0", "-1", "nan", "inf", "small"])
def test_bad_tolerances(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    tolerance: str,
) -> None:
    ran = check(monkeypatch, capsys, write(miura([]), tmp_path), "--tolerance", tolerance)
    assert (ran.status, ran.out) == (2, "")
    assert "--tolerance" in ran.err


def test_paths_that_are_no_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert "does not exist" in check(monkeypatch, capsys, tmp_path / "none.fold").err
    ran = check(monkeypatch, capsys, tmp_path)  # what design wrote there
    assert ran.status == 2
    assert "shell.fold: the file does not exist" in ran.err
    (tmp_path / "shell.fold").mkdir()
    assert "this is not a file; got a directory" in check(monkeypatch, capsys, tmp_path).err


def test_as_a_process(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "orishell", "check", str(write(miura([0.3]), tmp_path)), "--json"],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert json.loads(done.stdout)["passed"] is True


@pytest.mark.parametrize("ending", [".svg", ".dxf"])
def test_a_drawing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], ending: str
) -> None:
    path = patterns.write(tmp_path / f"miura{ending}", patterns.miura())
    ran = check(monkeypatch, capsys, path)
    assert (ran.status, ran.err) == (0, "")
    assert "30 panels, 71 edges, 20 inner vertices" in ran.out
    assert "rigidly, exactly as Miura sheets do" in ran.out
    report = json.loads(check(monkeypatch, capsys, path, "--json").out)
    assert report["degrees_of_freedom"] == 1
    assert report["recognised"]["family"] == "Miura"


def test_a_gap_is_welded_as_the_message_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    drawn = patterns.svg_of(patterns.scaled(patterns.miura(2, 2), 10.0), width_mm=20.0)
    x2 = re.search(r'x2="([^"]+)" y2="[^"]+" stroke="#ff0000"', drawn)
    assert x2 is not None
    end = f"{float(x2[1]) + 0.3:.4f}"
    path = tmp_path / "gap.svg"
    path.write_text(drawn[: x2.start(1)] + end + drawn[x2.end(1) :])
    ran = check(monkeypatch, capsys, path)
    assert (ran.status, ran.out) == (2, "")
    assert ran.err.count("\n") == 1
    weld = ran.err.split("--weld ")[1].split()[0]
    ran = check(monkeypatch, capsys, path, "--weld", weld)
    assert "4 panels, 12 edges, 1 inner vertex" in ran.out
    folded = fold_pattern(path, frames=3, weld=float(weld))
    assert len(folded.pattern.faces) == 4


def test_triangles_in_fold(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = patterns.write(tmp_path / "bomb.fold", patterns.waterbomb())
    ran = check(monkeypatch, capsys, path)
    assert (ran.status, ran.err) == (0, "")
    assert "23 degrees of freedom in 3 folded states" in ran.out


def test_a_flat_sheet_that_does_not_fold(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = patterns.write(tmp_path / "twist.fold", patterns.square_twist())
    ran = check(monkeypatch, capsys, path)
    assert (ran.status, ran.err) == (1, "")
    assert "x folds     not with these letters" in ran.out
    assert json.loads(check(monkeypatch, capsys, path, "--json").out)["pattern"]["passed"] is False


def test_a_sheet_nearby_is_written_and_folds(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Moved by 1e-4 of an edge; back again by no more than twice that."""
    sheet = patterns.jittered(patterns.miura(4, 4), 1e-4)
    path = patterns.write(tmp_path / "off.svg", sheet)
    target = tmp_path / "near.fold"
    ran = check(monkeypatch, capsys, path, "--nearby", target)
    assert ran.status == 1
    assert "a sheet nearby folds, its vertices moved by up to" in ran.out
    before, moved = read_pattern(path).flat, read_pattern(target).flat
    assert before is not None
    assert moved is not None
    away = np.linalg.norm(moved.vertices - before.vertices, axis=1)
    assert 0 < away.max() < 2e-4 * np.sqrt(2)
    again = check(monkeypatch, capsys, target, "--nearby", tmp_path / "none.fold")
    assert "v folds     rigidly" in again.out
    assert "the pattern folds as it is" in again.err
    assert not (tmp_path / "none.fold").exists()
