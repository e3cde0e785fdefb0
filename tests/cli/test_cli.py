"""The command line as a user meets it: status, messages, files."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLE = Path(__file__).parents[2] / "examples" / "figure1.toml"
FILES = ["deviation.png", "overview.png", "report.json", "shell.fold"]


def orishell(*arguments: str | Path, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "orishell", *map(str, arguments)],
        cwd=cwd,
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )


def test_new_then_design(tmp_path: Path) -> None:
    made = orishell("new", "parallel-repeating", cwd=tmp_path)
    assert made.returncode == 0
    assert (tmp_path / "parallel-repeating.toml").exists()
    done = orishell("design", "parallel-repeating.toml", "--out", "a/b", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert sorted(path.name for path in (tmp_path / "a" / "b").iterdir()) == FILES
    assert all(f"wrote     a/b/{name}" in done.stdout for name in FILES)
    # Its sheet is larger than a board, and it says so.
    lines = done.stderr.splitlines()
    assert [line for line in lines if not line.startswith("orishell: warning: the ")] == []


def test_json_report_and_the_same_bytes_twice(tmp_path: Path) -> None:
    first = orishell("design", EXAMPLE, "--out", "one", "--json", cwd=tmp_path)
    orishell("design", EXAMPLE, "--out", "two", cwd=tmp_path)
    printed = json.loads(first.stdout)
    assert set(printed.pop("seconds")) == {"design", "clash", "fold", "deviation", "write"}
    assert printed == json.loads((tmp_path / "one" / "report.json").read_text())
    for name in FILES:
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes()


def test_new_does_not_overwrite(tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text("mine")
    done = orishell("new", "parallel-repeating", "mine.toml", cwd=tmp_path)
    assert done.returncode == 2
    assert "exists already" in done.stderr
    assert (tmp_path / "mine.toml").read_text() == "mine"


@pytest.mark.parametrize(
    ("old", "new", "status", "says"),
    [
        ("parallel-repeating", "miura", 2, "unknown family"),
        ("rows = 9 ", "rows = 8 ", 2, "(7 or 9)"),
        ("rows = 9 ", "rows = 1000000001 ", 2, "312 GB"),
        ("rows = 9 ", 'rows = "many" ', 2, "a whole number"),
        ("flap = 0.3 ", "flap = nan ", 2, "a finite number"),
        ("columns", "colums", 2, "write columns"),
        ("[0, 20]", "[20, 0]", 2, "reversed"),
        ('"-x**2"', "\"__import__('os')\"", 2, "character 12"),
        ('"-x**2"', '"1/x"', 2, "not finite"),
        ("xi_deg = 50 ", "xi_deg = 60 ", 1, "53.1301"),
        ("5*sin", "50*sin", 1, "scale in [target.f] times"),
        ("plane_deg = 90", "plane_deg = 10", 1, "plane_deg between"),
    ],
)
def test_faults_are_one_message_and_nothing_is_written(
    tmp_path: Path, old: str, new: str, status: int, says: str
) -> None:
    text = EXAMPLE.read_text()
    assert old in text
    (tmp_path / "shell.toml").write_text(text.replace(old, new))
    done = orishell("design", "shell.toml", "--out", "out", cwd=tmp_path)
    assert done.returncode == status, done.stderr
    assert says in done.stderr
    assert "Traceback" not in done.stderr
    assert done.stdout == ""
    assert [path.name for path in tmp_path.iterdir()] == ["shell.toml"]


def test_usage_errors_have_status_2(tmp_path: Path) -> None:
    assert orishell("design", cwd=tmp_path).returncode == 2
    assert orishell("fold", cwd=tmp_path).returncode == 2
    assert orishell("new", "miura", cwd=tmp_path).returncode == 2
    assert not list(tmp_path.iterdir())


def test_a_file_in_the_way_of_the_output(tmp_path: Path) -> None:
    (tmp_path / "out").write_text("mine")
    done = orishell("design", EXAMPLE, "--out", "out", cwd=tmp_path)
    assert done.returncode == 2
    assert "is a file" in done.stderr
    assert (tmp_path / "out").read_text() == "mine"


def test_warnings_go_to_standard_error(tmp_path: Path) -> None:
    text = EXAMPLE.read_text().replace("5*sin(pi*x/10)", "sin(x)").replace("[0, 20]", "[0, 62.8]")
    (tmp_path / "shell.toml").write_text(text)
    done = orishell("design", "shell.toml", "--out", "out", cwd=tmp_path)
    assert done.returncode == 0
    assert "warning: the polyline of g" in done.stderr
    assert json.loads((tmp_path / "out" / "report.json").read_text())["warnings"]


@pytest.mark.parametrize("example", ["figure1", "figure2"])
@pytest.mark.parametrize("columns", [2, 12])
def test_without_flaps(tmp_path: Path, example: str, columns: int) -> None:
    text = EXAMPLE.with_name(f"{example}.toml").read_text()
    text = re.sub(r"\nflap = \S+ ", "\nflap = 0 ", text)
    text = re.sub(r"\ncolumns = \d+ ", f"\ncolumns = {columns} ", text)
    (tmp_path / "shell.toml").write_text(text)
    done = orishell("design", "shell.toml", "--out", "out", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "warning: without flaps (flap = 0) nothing stops the motion" in done.stderr
    assert "the shell does not lock" in done.stderr
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == FILES
    fold = json.loads((tmp_path / "out" / "shell.fold").read_text())
    assert fold["orishell:grid_shape"] == [11, columns]
    assert len(fold["vertices_coords"]) == 11 * columns
    for frame in fold["file_frames"]:
        assert len(frame["vertices_coords"]) == 11 * columns
    assert max(map(abs, fold["edges_foldAngle"])) < 179
