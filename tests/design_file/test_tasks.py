"""Files to begin with, by what is to be built: each works as it is, in its own size or another."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from command_line import orishell
from orishell.conventions.errors import InputError
from orishell.conventions.toml_file import parse_toml
from orishell.design_file import check_design
from orishell.design_file.tasks import TASKS, task_file
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES
from samples import led_by, thorough

ROOF = Path(__file__).parents[2] / "examples" / "roof.obj"


def made(text: str) -> Shell:
    return make_shell(check_design(parse_toml(text), Path("x.toml")), skip=MEASURES)


@pytest.mark.parametrize("task", led_by(["card", *(each for each in TASKS if each != "card")]))
def test_each_task_works_as_it_is(task: str) -> None:
    """Proved; what stands on feet has them level, and does not slide open or close."""
    report = made(task_file(task)).report
    assert report.feasible
    assert {row.sign for row in report.verdict} <= {"holds", "warns", "says"}
    words = " ".join(report.warnings)
    assert "not level" not in words
    assert "under its own weight" not in words
    if "structure" in parse_toml(task_file(task)):
        assert report.structure is not None
        assert report.structure.carries


@thorough
@pytest.mark.parametrize("diameter", [3.0, 9.0])
def test_a_dome_has_its_diameter(diameter: float) -> None:
    """The corners of its surface lie on a circle of that diameter, to the digits of the file."""
    shell = made(task_file("dome", diameter=diameter))
    surface = shell.file.surface
    assert surface is not None
    corners = surface.piece.vertices[:, :2]
    assert 2 * np.hypot(*corners.T).max() == pytest.approx(diameter, rel=1e-4)
    assert shell.report.feasible


def test_sizes_stand_where_the_file_has_them() -> None:
    tables = parse_toml(task_file("screen", size=(4.5, 2)))
    assert tables["target"]["fit"] == {"width": 4.5, "depth": 2}
    dome = parse_toml(task_file("dome", diameter=3))
    assert (dome["target"]["surface"]["scale"], dome["pattern"]["flap"]) == (1.5, 0.072)
    odd = 'a "roof"\\é.obj'
    assert parse_toml(task_file("canopy", mesh=odd))["target"]["surface"] == {"mesh": odd}


@thorough
def test_a_canopy_follows_a_mesh() -> None:
    text = task_file("canopy", mesh=str(ROOF)).replace("# unit", "unit")
    assert made(text).report.feasible


def write_vault(place: Path, wide: float, deep: float) -> None:
    """A mesh of a vault that bends both ways, 1.5 m high, on four corners of one height."""
    x, y = np.meshgrid(np.linspace(-1, 1, 25), np.linspace(-1, 1, 17))
    points = np.stack([0.5 * wide * x, 0.5 * deep * y, 1.5 * (1 - x**2) * (1 - 0.5 * y**2)], -1)
    number = 1 + np.arange(x.size).reshape(x.shape)
    quads = np.stack([number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]], -1)
    lines = [f"v {a} {b} {c}" for a, b, c in points.reshape(-1, 3).tolist()]
    lines += [f"f {a} {b} {c} {d}" for a, b, c, d in quads.reshape(-1, 4).tolist()]
    place.write_text("\n".join(lines))


def counts(directory: Path) -> tuple[int, int]:
    """Rows and columns of the file for the mesh of a directory."""
    text = task_file("canopy", mesh="roof.obj", beside=directory / "canopy.toml")
    pattern = parse_toml(text)["pattern"]
    return pattern["rows"], pattern["columns"]


def test_a_canopy_has_panels_by_the_size_of_its_mesh(tmp_path: Path) -> None:
    """About as large as each other, however large the roof; nothing hangs on how it is turned."""
    assert counts(tmp_path) == (15, 15)  # there is no mesh yet
    place = tmp_path / "roof.obj"
    write_vault(place, 12, 8)
    rows, columns = counts(tmp_path)
    assert rows == columns
    assert 0.3 < 12 * 8 / ((rows + 1) * (columns + 1)) < 0.5
    write_vault(place, 20, 5)
    rows, columns = counts(tmp_path)
    assert columns > 1.5 * rows
    write_vault(place, 5, 20)
    assert counts(tmp_path) == (columns, rows)
    write_vault(place, 5, 4)
    assert counts(tmp_path) == (11, 11)
    place.write_text("v 0 0 0\n")  # orishell design says what is wrong with it
    assert counts(tmp_path) == (15, 15)


@pytest.mark.slow
@thorough
def test_a_canopy_over_a_roof_is_even_and_fits_what_is_on_the_market(tmp_path: Path) -> None:
    """Of 12 x 8 m, bent both ways; with 9 x 11 vertices the largest panel was 4 times the mean."""
    write_vault(tmp_path / "roof.obj", 12, 8)
    text = task_file("canopy", mesh="roof.obj", beside=tmp_path / "canopy.toml")
    shell = make_shell(check_design(parse_toml(text), tmp_path / "canopy.toml"), skip=MEASURES)
    assert shell.report.feasible
    areas = shell.document.areas()[: shell.file.panel_count]  # flaps come last
    assert areas.max() < 3 * areas.mean()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["hut"], "there is no such task; got 'hut', expected one of shelter, arch"),
        (["orthodiagonal"], "Remedy: orishell new --family orthodiagonal."),
        (["arch", "--diameter", "3"], "--diameter: a file for this task is not changed by"),
        (["dome", "--diameter", "-1"], "expected more than 0, as 5"),
        (["dome", "--diameter", "nan"], "expected more than 0, as 5"),
        (["screen", "--size", "6 by 3"], "expected as 6x3"),
        (["screen", "--size", "1.2.3x4"], "expected as 6x3"),
        (["screen", "--size", "0x4"], "expected more than 0, as 5"),
        (["--family", "miura"], "unknown family"),
        (["--family", "orthodiagonal", "--diameter", "3"], "a family's file has no sizes"),
        (["card", "there/card.toml"], "the file cannot be written"),
        (["canopy", "--mesh", "none.obj"], "--mesh: none.obj: the file does not exist"),
        (["canopy", "--mesh", "roof.3dm"], "this kind of file holds no mesh that is read here"),
    ],
)
def test_what_is_no_task_is_one_message(tmp_path: Path, arguments: list[str], said: str) -> None:
    ran = orishell("new", *arguments, cwd=tmp_path)
    assert (ran.returncode, ran.stdout) == (2, "")
    assert said in ran.stderr
    assert len(ran.stderr.splitlines()) == 1
    assert not list(tmp_path.iterdir())


def test_a_mesh_is_looked_for_where_the_design_file_is(tmp_path: Path) -> None:
    """The remedy names it from there, and works."""
    (tmp_path / "there").mkdir()
    (tmp_path / "roof.obj").write_bytes(ROOF.read_bytes())
    ran = orishell("new", "canopy", "there/roof.toml", "--mesh", "roof.obj", cwd=tmp_path)
    assert ran.returncode == 2
    assert "Remedy: a mesh is named from where the design file is: --mesh ../roof.obj" in ran.stderr
    ran = orishell("new", "canopy", "there/roof.toml", "--mesh", "../roof.obj", cwd=tmp_path)
    assert ran.returncode == 0
    surface = parse_toml((tmp_path / "there" / "roof.toml").read_text())["target"]["surface"]
    assert surface["mesh"] == "../roof.obj"


def test_an_unknown_task_is_refused_in_python() -> None:
    with pytest.raises(InputError, match="there is no such task"):
        task_file("hut")
