"""The command line as a user meets it: status, messages, files."""

import json
import re
from pathlib import Path

import pytest

from command_line import orishell, orishell_process
from orishell import __version__
from orishell.design_file.tasks import TASKS
from orishell.families.registry import FAMILIES
from samples import led_by

EXAMPLE = Path(__file__).parents[2] / "examples" / "figure1.toml"
FILES = ["deviation.png", "overview.png", "report.json", "shell.fold"]


def smaller(text: str) -> str:
    """The same shell of a fifth of the panels."""
    for many, few in (("rows = 9 ", "rows = 5 "), ("columns = 11 ", "columns = 5 ")):
        assert many in text
        text = text.replace(many, few)
    return text


def test_new_then_design(tmp_path: Path) -> None:
    made = orishell("new", "--family", "parallel-repeating", cwd=tmp_path)
    assert made.returncode == 0
    assert (tmp_path / "parallel-repeating.toml").exists()
    done = orishell_process("design", "parallel-repeating.toml", "--out", "a/b", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert sorted(path.name for path in (tmp_path / "a" / "b").iterdir()) == [
        ".orishell.json",
        *FILES,
    ]
    assert all(f"wrote     a/b/{name}" in done.stdout for name in FILES)
    # Its sheet is larger than a board, and it says so.
    lines = done.stderr.splitlines()
    assert [line for line in lines if not line.startswith("orishell: warning: the ")] == []


def test_json_report_and_the_same_files_again(tmp_path: Path) -> None:
    (tmp_path / "shell.toml").write_text(smaller(EXAMPLE.read_text()))
    first = orishell("design", "shell.toml", "--out", "one", "--json", cwd=tmp_path)
    orishell("design", "shell.toml", "--out", "two", "--write", "svg,csv", cwd=tmp_path)
    (tmp_path / "two" / "panels.csv").write_text("mine")
    refused = orishell("design", "shell.toml", "--out", "two", cwd=tmp_path)
    assert refused.returncode == 2
    assert "panels.csv" in refused.stderr
    again = orishell("design", "shell.toml", "--out", "two", "--force", cwd=tmp_path)
    # What the run before wrote more is gone, but what was changed since is not.
    removed = [line for line in again.stdout.splitlines() if line.startswith("removed")]
    assert removed == [
        f"removed   two/{name}, from an earlier run"
        for name in ("creases.csv", "ground.csv", "order.csv", "pattern.svg", "schedule.csv")
    ]
    assert (tmp_path / "two" / "panels.csv").read_text() == "mine"
    printed = json.loads(first.stdout)
    assert set(printed.pop("seconds")) == {
        "design",
        "clash",
        "deviation",
        "freedom",
        "fold",
        "write",
    }
    assert printed == json.loads((tmp_path / "one" / "report.json").read_text())
    for name in (".orishell.json", *FILES):
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes()


def test_new_without_a_task_lists_them(tmp_path: Path) -> None:
    listed = orishell("new", cwd=tmp_path)
    assert (listed.returncode, listed.stdout) == (2, "")
    first, *lines = listed.stderr.splitlines()
    assert first.startswith("orishell: nothing is named that is to be built. Remedy: orishell new")
    named = {name: each.what for name, each in TASKS.items()}
    named |= {name: each.what for name, each in FAMILIES.items()}
    assert [line.split()[0] for line in lines] == list(named)
    assert all(named[line.split()[0]] in line for line in lines)
    assert not list(tmp_path.iterdir())


def test_the_version(tmp_path: Path) -> None:
    said = orishell("--version", cwd=tmp_path)
    assert (said.returncode, said.stdout) == (0, f"orishell {__version__}\n")
    citation = (EXAMPLE.parents[1] / "CITATION.cff").read_text()
    assert f"\nversion: {__version__}\n" in citation


def test_new_does_not_overwrite(tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text("mine")
    done = orishell("new", "card", "mine.toml", cwd=tmp_path)
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
        ("rows = 9 ", f"rows = 0x{'f' * 9000} ", 2, "36000 bits"),
        ("columns", r'"\u001b[2Jcolumns"', 2, r"[pattern] \x1b[2Jcolumns: unknown key"),
        ("columns", '"a\x1b[2J"', 2, "not TOML"),
        ("flap = 0.3 ", "flap = nan ", 2, "a finite number"),
        ("columns", "colums", 2, "Did you mean columns?"),
        ("[0, 20]", "[20, 0]", 2, "reversed"),
        ('"-x**2"', "\"__import__('os')\"", 2, "character 12"),
        ('"-x**2"', '"1/x"', 2, "not finite"),
        ("xi_deg = 50 ", "xi_deg = 60 ", 1, "53.1301"),
        ("5*sin", "50*sin", 1, "in [target.f], or scale = "),
        ("plane_deg = 90", "plane_deg = 10", 1, "plane_deg must lie between"),
    ],
)
def test_faults_are_one_message_and_nothing_is_written(
    tmp_path: Path, old: str, new: str, status: int, says: str
) -> None:
    text = EXAMPLE.read_text()
    assert old in text
    text = text.replace(old, new)
    if old.startswith("plane_deg"):  # its remedy is looked for by designing it again and again
        text = smaller(text)
    (tmp_path / "shell.toml").write_text(text)
    done = orishell("design", "shell.toml", "--out", "out", cwd=tmp_path)
    assert done.returncode == status, done.stderr
    assert says in done.stderr
    assert "Traceback" not in done.stderr
    assert "\x1b" not in done.stderr
    assert done.stdout == ""
    assert [path.name for path in tmp_path.iterdir()] == ["shell.toml"]


def test_usage_errors_have_status_2(tmp_path: Path) -> None:
    assert orishell("design", cwd=tmp_path).returncode == 2
    assert orishell("fold", cwd=tmp_path).returncode == 2
    assert orishell("new", "--family", "miura", cwd=tmp_path).returncode == 2
    assert not list(tmp_path.iterdir())


def test_a_file_in_the_way_of_the_output(tmp_path: Path) -> None:
    (tmp_path / "out").write_text("mine")
    done = orishell("design", EXAMPLE, "--out", "out", cwd=tmp_path)
    assert done.returncode == 2
    assert "is a file" in done.stderr
    assert (tmp_path / "out").read_text() == "mine"


@pytest.mark.parametrize("name", ["", "x" * 300, f"a/{'x' * 300}/b"])
def test_names_that_no_directory_can_have(tmp_path: Path, name: str) -> None:
    for command in (["design", str(EXAMPLE), "--out", name], ["check", name]):
        done = orishell(*command, cwd=tmp_path)
        assert done.returncode == 2
        assert done.stderr.count("\n") == 1
        assert "a fault of the program" not in done.stderr
    assert not list(tmp_path.iterdir())


def test_what_files_and_their_names_say_is_printable(tmp_path: Path) -> None:
    (tmp_path / "a\x1b[2J\udcff.toml").write_text(smaller(EXAMPLE.read_text()))
    options = ["--no-clash-test", "--write", "svg,pdf,dxf,glb,vtu"]
    done = orishell(
        "design", "a\x1b[2J\udcff.toml", "--out", "b\x1b[2J\udcff", *options, cwd=tmp_path
    )
    assert done.returncode == 0
    assert "\x1b" not in done.stderr
    assert r"wrote     b\x1b[2J\udcff/shell.fold" in done.stdout
    for path in (tmp_path / "b\x1b[2J\udcff").iterdir():
        if path.suffix not in {".png", ".glb", ".vtu"}:  # these are not all text
            assert b"\x1b" not in path.read_bytes()
    fold = json.loads((tmp_path / "b\x1b[2J\udcff" / "shell.fold").read_text())
    (tmp_path / "c.fold").write_text(json.dumps({**fold, "frame_unit": "\x1b[2J"}))
    said = orishell("check", "c.fold", cwd=tmp_path)
    assert r"\x1b[2J" in said.stdout
    assert "\x1b" not in said.stdout + said.stderr


def test_warnings_go_to_standard_error(tmp_path: Path) -> None:
    text = EXAMPLE.read_text().replace("5*sin(pi*x/10)", "sin(x)").replace("[0, 20]", "[0, 62.8]")
    (tmp_path / "shell.toml").write_text(text)
    done = orishell("design", "shell.toml", "--out", "out", "--no-clash-test", cwd=tmp_path)
    assert done.returncode == 0
    assert "warning: the polyline of g" in done.stderr
    assert json.loads((tmp_path / "out" / "report.json").read_text())["warnings"]


@pytest.mark.parametrize("example", led_by(["figure1", "figure2"]))
@pytest.mark.parametrize("columns", [2, 6])
def test_without_flaps(tmp_path: Path, example: str, columns: int) -> None:
    text = EXAMPLE.with_name(f"{example}.toml").read_text()
    text = re.sub(r"\nflap = \S+ ", "\nflap = 0 ", text)
    text = re.sub(r"\ncolumns = \d+ ", f"\ncolumns = {columns} ", text)
    (tmp_path / "shell.toml").write_text(text)
    done = orishell("design", "shell.toml", "--out", "out", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "warning: without flaps (flap = 0) nothing but its supports" in done.stderr
    assert "keeps the shell from closing beyond its target" in done.stderr
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == [".orishell.json", *FILES]
    fold = json.loads((tmp_path / "out" / "shell.fold").read_text())
    assert fold["orishell:grid_shape"] == [11, columns]
    assert len(fold["vertices_coords"]) == 11 * columns
    for frame in fold["file_frames"]:
        assert len(frame["vertices_coords"]) == 11 * columns
    assert max(map(abs, fold["edges_foldAngle"])) < 179
