"""README is true: its commands run, its files are there, its tables are those of the program.

What the shelter's loads are is asked in tests/shell/test_snow_shelter.py, that `make demo` and
`make test` pass by the environments that run them.
"""

from __future__ import annotations

import re
import shutil
import tomllib
from pathlib import Path
from typing import Any

import pytest

from command_line import orishell
from documents import EXAMPLES
from orishell.design_file import DesignFile, check_design, read_design_file
from orishell.design_file.tasks import TASKS
from orishell.families.registry import FAMILIES
from orishell.shell.make import make_shell
from orishell.shell.steps import STEPS

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")
SENTENCES = " ".join(TEXT.split())
TASKS_OF_MAKE = ("demo", "test", "studio", "docs", "paper", "blender")


def fenced(language: str) -> list[str]:
    """Fenced blocks of a language."""
    return re.findall(rf"^```{language}\n(.*?)^```$", TEXT, re.DOTALL | re.MULTILINE)


def table(heading: str) -> list[list[str]]:
    """Cells of the rows of the table with such a first cell in its heading."""
    rows = TEXT[TEXT.index(f"| {heading} |") :].split("\n\n")[0].splitlines()[2:]
    return [[cell.strip() for cell in row.strip("|").split("|")] for row in rows]


def test_it_is_read_at_once_and_its_python_runs() -> None:
    assert len(TEXT.splitlines()) <= 120
    (block,) = fenced("python")
    names: dict[str, Any] = {}
    exec(block, names)
    assert len(block.strip().splitlines()) - 2 == 5, "five lines, with what they import"
    assert [state.shape for state in names["states"]] == [(11, 13, 3)] * 25


def test_a_design_file_is_written_as_it_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (line,) = re.findall(r"`(o\.write_shell\(.*\))`", TEXT)
    monkeypatch.chdir(tmp_path)
    shutil.copy(ROOT / "examples" / "figure1.toml", "shell.toml")
    exec(f"import orishell as o\n{line}", {})
    assert [each.name for each in Path("out").glob("*.glb")] == ["shell.glb"]


def test_a_path_is_read_by_the_function_that_is_named() -> None:
    with pytest.raises(TypeError, match="design_shell reads one from its path"):
        make_shell("shell.toml")  # type: ignore[arg-type]


def test_two_commands_are_two_and_make_knows_its_targets() -> None:
    section = TEXT.split("\n## Two commands\n")[1].split("\n## ")[0]
    (block,) = re.findall(r"^```sh\n(.*?)^```$", section, re.DOTALL | re.MULTILINE)
    assert [line.split("#")[0].split() for line in block.splitlines()] == [
        ["make", "demo"],
        ["make", "test"],
    ]
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    named = set(
        re.findall(r"make ([a-z]+)", "\n".join([*fenced("sh"), *re.findall("`.*?`", TEXT)]))
    )
    assert named == set(TASKS_OF_MAKE)
    for target in named:
        assert re.search(rf"(?m)^(\.PHONY:.* )?{target}\b", makefile), target


def test_every_link_leads_to_a_file() -> None:
    links = re.findall(r"\]\(([^)#]+)", TEXT)
    own = [link for link in links if not link.startswith("http")]
    assert len(own) > 20
    assert [link for link in own if not (ROOT / link).exists()] == []


def test_files_to_begin_with_are_written_by_the_commands_that_it_names(tmp_path: Path) -> None:
    line = next(each for each in TEXT.splitlines() if "orishell new" in each)
    command, _, others = line.partition("# or ")
    calls = [command.split()[2:], *(each.split() for each in others.split(", "))]
    assert [call[0] for call in calls] == [
        *("shelter", "arch", "dome", "canopy", "screen", "card"),
    ]
    assert {call[0] for call in calls} == {*TASKS}
    (tmp_path / "roof.obj").write_bytes((EXAMPLES / "roof.obj").read_bytes())
    for call in calls:
        ran = orishell("new", *call, cwd=tmp_path)
        assert ran.returncode == 0, ran.stderr
        assert read_design_file(tmp_path / f"{call[0]}.toml").family


def test_families_and_commands_are_those_that_there_are() -> None:
    assert [row[0].strip("`") for row in table("family")] == [*FAMILIES]
    for name, takes, _ in table("family"):
        sweeps = FAMILIES[name.strip("`")].pattern.sweeps()
        assert sweeps is takes.startswith(("any f", "a convex f"))
    for name, what in table("command"):
        for word in re.findall(r"`(?:orishell )?(\w+)`", name):
            shown = orishell(word, "--help")
            assert shown.returncode == 0
            for option in re.findall(r"`(--[a-z-]+)`", what):
                assert option in shown.stdout


def test_endings_of_the_patterns_it_reads(tmp_path: Path) -> None:
    """The refusal of another kind names all that README does."""
    path = tmp_path / "sheet.xyz"
    path.write_text("?")
    said = orishell("check", path).stderr.lower()
    for ending in ("fold", "svg", "dxf", "cp", "obj"):
        assert f".{ending}" in said


def test_the_refusal_is_what_is_printed() -> None:
    """Of f = -x**2 from -1 to 1 with xi_deg = 60, and its remedy works."""
    (said,) = (each for each in fenced("text") if each.startswith("orishell:"))
    file = _parabola()
    with pytest.raises(Exception, match="too large for f") as refused:
        make_shell(file)
    assert " ".join(said.split()) == f"orishell: {refused.value}"
    (value,) = re.findall(r"works: xi_deg = ([0-9.]+)\.", said)
    assert make_shell(file.changed({"pattern.xi_deg": float(value)}), skip=STEPS).report.feasible


def _parabola() -> DesignFile:
    tables = {
        "shell": {"family": "parallel-repeating", "unit": "m"},
        "target": {
            "f": {"formula": "-x**2", "range": [-1, 1]},
            "g": {"formula": "5*sin(pi*x/10)", "range": [0, 10]},
        },
        "pattern": {"rows": 5, "columns": 7, "xi_deg": 60},
    }
    return check_design(tables, Path("shell.toml"))


def test_it_needs_the_python_that_it_names_and_is_free_to_use() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    (least,) = re.findall(r"Python ([0-9.]+) or newer", SENTENCES)
    assert project["requires-python"] == f">={least}"
    assert "MIT" in str(project["license"])
    assert "MIT" in (ROOT / "LICENSE").read_text(encoding="utf-8")
    assert "cff-version" in (ROOT / "CITATION.cff").read_text(encoding="utf-8")


def test_the_shelter_packs_and_opens_as_it_says() -> None:
    """To the digits that README has, at the ends of its motion, which is proved."""
    file = read_design_file(EXAMPLES / "shelter_snow.toml")
    assert file.panel is not None
    assert f"of plywood of {1000 * file.panel.thickness:g} mm" in SENTENCES
    report = make_shell(file, skip=[each for each in STEPS if each != "pack"]).report
    assert report.feasible
    packed = report.deployment.packed
    assert packed is not None
    sizes = (packed.length, packed.width, packed.height)
    pack, opened = re.findall(r"pack of ([0-9. x]+) m opens to ([0-9. x]+) m", SENTENCES)[0]
    assert [float(each) for each in pack.split(" x ")] == pytest.approx(sizes, rel=0.02)
    built = report.outside
    sizes = (built.width, built.depth, built.height)
    assert sorted(map(float, opened.split(" x "))) == pytest.approx(sorted(sizes), rel=0.02)
