"""``orishell convert`` and ``orishell design --write`` as a user meets them."""

import csv
import json
import re
import resource
from pathlib import Path

import pytest

from command_line import orishell, orishell_process
from documents import demo_document, folded_only
from orishell.design_file import starter_file
from orishell.io import write_fold
from orishell.io.formats import all_formats, find_formats, step
from orishell.io.manifest import NAME
from sheets import miura, write

EXAMPLE = Path(__file__).parents[2] / "examples" / "figure1.toml"
SHEETS = [each for each in all_formats() if not (each.solid or each.analysed)]
FILES = {each.file for each in SHEETS if each.ready()}


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    directory = tmp_path_factory.mktemp("written")
    (directory / "notes.txt").write_text("mine")
    done = orishell("design", EXAMPLE, "--out", directory, "--write", "all", cwd=directory)
    assert done.returncode == 0, done.stderr
    assert all(line.startswith("orishell: warning: ") for line in done.stderr.splitlines())
    return directory


def test_write_all(written: Path) -> None:
    names = {path.name for path in written.iterdir()}
    others = [each for each in all_formats() if each not in SHEETS]
    assert names.isdisjoint(each.file for each in others)
    assert FILES | {"report.json", "overview.png", "deviation.png", "creases.csv"} <= names
    # 25 frames
    assert {f"shell-{number:04d}.vtu" for number in range(25)} <= names
    # Files of other names stay.
    assert (written / "notes.txt").read_text() == "mine"


@pytest.mark.parametrize(
    "name", [each.name for each in SHEETS if each.name != "html" and not each.designed]
)
def test_convert_writes_what_design_writes(name: str, written: Path, tmp_path: Path) -> None:
    (format_,) = find_formats([name])
    done = orishell("convert", written / "shell.fold", format_.file, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    names = sorted(path.name for path in tmp_path.iterdir() if path.name != NAME)
    assert format_.file in names
    assert f"wrote {format_.file}" in done.stdout.splitlines()
    for file in names:
        # FOLD does not know the curves that the shell follows, Rhino's file shows them.
        same = (tmp_path / file).read_bytes() == (written / file).read_bytes()
        assert same == (format_.name != "3dm")


def test_quantities_are_those_of_the_tables(written: Path) -> None:
    report = json.loads((written / "report.json").read_text())["quantities"]
    with (written / "panels.csv").open(newline="") as file:
        panels = list(csv.DictReader(file))
    with (written / "creases.csv").open(newline="") as file:
        creases = list(csv.DictReader(file))
    assert report["panels"] == len(panels) == 120
    assert report["area"] == pytest.approx(sum(float(row["area_m2"]) for row in panels))
    for letter, name in (("M", "mountain"), ("V", "valley"), ("F", "unfolded")):
        total = sum(float(row["length_m"]) for row in creases if row["assignment"] == letter)
        assert report["crease_length"][name] == pytest.approx(total)
    perimeter = sum(float(row["perimeter_m"]) for row in panels)
    inner = 2 * sum(report["crease_length"].values())
    assert report["outline_length"] == pytest.approx(perimeter - inner)
    assert report["mass_kg"] is None


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("shell.fold", "shell.dwg"), "no format has this ending"),
        (("missing.fold", "shell.obj"), "does not exist"),
        (("shell.fold", "shell.obj", "--state", "half"), "there is no such state"),
        (("shell.fold", "shell.obj", "--state", "99"), "there is no such state"),
        (("shell.fold", "shell.dxf", "--unit", "furlong"), "there is no such unit"),
        (("shell.fold", "shell.dxf", "--workshop", "shell.fold"), "this is not TOML"),
        (("shell.fold", "shell.dxf", "--workshop", "none.toml"), "does not exist"),
        (("shell.fold", "shell.dxf", "--workshop", "wrong.toml"), "[workshop] duty"),
        (("shell.fold", "shell.dxf", "--workshop", "other.toml"), "no table [workshop]"),
        (("shell.fold", "shell.fold/x.obj"), "is a file"),
        (("shell.fold", "taken.obj"), "a directory is in the way"),
        (("folded.fold", "flat.dxf"), "no flat sheet"),
        (("shell.fold", "shell.3mf"), "shell.fold: a FOLD file does not say how thick"),
        (("shell.fold", "shell.step"), "--write step, where the design file has the table [panel]"),
        (
            ("shell.fold", "shell.inp"),
            "--write inp, where the design file has the table [structure]",
        ),
        (("miura.fold", "flat.dxf"), "--unit says which it is."),
        (("miura.fold", "solid.glb"), "--unit says which it is."),
    ],
)
def test_faults_of_convert(
    arguments: tuple[str, ...], says: str, written: Path, tmp_path: Path
) -> None:
    (tmp_path / "shell.fold").write_bytes((written / "shell.fold").read_bytes())
    (tmp_path / "wrong.toml").write_text("[workshop]\nduty = 2.0\n")
    (tmp_path / "other.toml").write_text("[shell]\n")
    (tmp_path / "taken.obj").mkdir()
    write(miura([0.5]), tmp_path).rename(tmp_path / "miura.fold")
    write_fold(tmp_path / "folded.fold", folded_only(demo_document()))
    before = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")}
    done = orishell("convert", *arguments, cwd=tmp_path)
    assert done.returncode == 2
    assert says in done.stderr
    assert done.stderr.startswith("orishell: ")
    assert done.stderr.count("\n") == 1
    assert {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")} == before


def test_a_foreign_pattern_with_a_stated_unit(tmp_path: Path) -> None:
    write(miura([0.5]), tmp_path).rename(tmp_path / "miura.fold")
    done = orishell("convert", "miura.fold", "flat.svg", "--unit", "cm", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "cm" in (tmp_path / "flat.svg").read_text()


def test_unknown_formats_are_refused_before_any_work(tmp_path: Path) -> None:
    done = orishell("design", EXAMPLE, "--out", "out", "--write", "svg,dwg", cwd=tmp_path)
    assert done.returncode == 2
    assert "'dwg'" in done.stderr
    assert not list(tmp_path.iterdir())


THICK = """
[deployment]
flap_attachment = "clipped"

[panel]
thickness = 0.002
membrane = 0.0002
"""


@pytest.mark.slow
def test_solids_of_thick_panels(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """With them "all" means 3MF, and STEP where build123d is; who names STEP is told at once."""
    monkeypatch.setattr(step, "find_spec", lambda name: None)
    text = re.sub(r"(?m)^(rows|columns) = \d+", r"\1 = 5", starter_file("orthodiagonal"))
    (tmp_path / "thick.toml").write_text(text + THICK)
    command = ("design", "thick.toml", "--out", "out", "--no-clash-test", "--write")
    done = orishell(*command, "step", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stderr == (
        "orishell: --write: STEP needs the library build123d, which is not installed. "
        'Remedy: pip install "orishell[cad]".\n'
    )
    assert not (tmp_path / "out").exists()
    done = orishell(*command, "all", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    warning = 'warning: shell-target.step is not written: pip install "orishell[cad]"'
    assert warning in done.stderr
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert "shell.3mf" in names
    assert not [name for name in names if name.endswith(".step")]
    obj = (tmp_path / "out" / "shell.obj").read_text()
    assert "\ng 0,0_top\n" in obj


@pytest.mark.slow
def test_a_full_disk_leaves_no_half_file(tmp_path: Path) -> None:
    # No file may be larger than 60 kB: as on a full disk, writing fails half way.
    out = tmp_path / "out"
    out.mkdir()
    (out / "mine.fold").write_text("old")

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (60_000, 60_000))

    done = orishell_process(
        *("design", EXAMPLE, "--out", out, "--write", "all", "--no-clash-test"),
        cwd=tmp_path,
        before=limit,
    )
    assert done.returncode == 2, done.stderr
    assert "cannot be written" in done.stderr
    assert {path.name: path.read_text() for path in out.iterdir()} == {"mine.fold": "old"}


def test_a_directory_that_cannot_be_written_to(written: Path) -> None:
    done = orishell("convert", written / "shell.fold", "/proc/shell.obj", cwd=written)
    assert done.returncode == 2
    assert "cannot be written" in done.stderr
