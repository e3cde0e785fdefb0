"""``orishell structure``: what it refuses, prints and writes."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from analysed import analysed
from command_line import orishell
from design_tables import formula, made, tables
from orishell.cli.structure import summarize_structure
from orishell.conventions.errors import InputError
from orishell.shell.export import write_structure
from orishell.shell.make import Shell
from orishell.structure.results import Analysis
from samples import led_by
from small_arch import SMALL_ARCH

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def report() -> Analysis:
    return analysed()


@pytest.fixture(scope="module")
def bare() -> Shell:
    """A shell that was not analysed."""
    f, g = formula("-x**2", -1, 1), formula("5*sin(pi*x/10)", 0, 10)
    return made(tables("parallel-repeating", f, g, rows=3, columns=5, flap=0, xi_deg=50))


def test_a_file_without_the_table_is_refused(tmp_path: Path) -> None:
    done = orishell("structure", EXAMPLES / "figure1.toml", "--out", "out", cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert "figure1.toml: [structure]: there is no structure to analyse" in done.stderr
    assert not list(tmp_path.iterdir())


def test_the_summary(report: Analysis) -> None:
    """It has the sections of the page, in their words, but for tables that list one by one."""
    lines = list(summarize_structure(report, "m", [Path("a/structure.json")]))
    cells = [re.split(r"\s{2,}", line.strip()) for line in lines]
    for row in (
        ["Mesh", "16 triangles, 15 nodes, 99 degrees of freedom"],
        ["Mass of panels", "32.2 kg"],
        ["Thickness of panels, t", "10 mm"],
        ["Young's modulus, E", "270 MPa"],
        ["vertices 0,1, 2,1", "on the ground, which pushes only, with friction of 0.5"],
        ["dead: own weight", "1.35", "0", "0", "-427", "-", "mass of panels times 9.81 m/s2"],
        ["all loads", "0", "0", "-7747"],
        ["reactions, rigid creases", "0", "0", "7747", "missing: 1e-12 of the loads"],
        ["Ties", "2 of 3 pull, 4000 N at most from 0,2 to 2,2"],
        ["Buckling", "under 2.5 times these loads, by linear theory"],
        ["Natural frequencies", "3, 4, 7 Hz"],
        ["The force in a tie governs, 80 % of what can be borne, under wind, free creases."],
        ["wrote", "a/structure.json"],
    ):
        assert row in cells
    assert lines[0].startswith(
        "x stands    no: 1 of 4 cases fail; under both, free creases it opens"
    )
    begin = lines.index(next(line for line in lines if line.split()[:2] == ["load", "case"]))
    assert lines[begin + 1].split("  ")[0] == "x both, free creases"
    assert [line[0] for line in lines[begin + 1 : begin + 5]] == ["x", "!", "!", "!"]
    # Loads are said once, cases with every stiffness of creases.
    assert [line for line in lines if line.startswith(("both", "wind"))] == [
        "both, free creases", "wind, free creases", "both, rigid creases", "wind, rigid creases"
    ]  # fmt: skip
    last = lines.index("What is not covered")
    assert lines[last + 1 : -1] == [f"  - {text}" for text in report.not_covered]


ARCH = (
    SMALL_ARCH.replace("flap = 0", "flap = 0.15")
    + """[deployment]
flap_attachment = "clipped"
ties = "feet"
[workshop]
areal_density = 1.9
[structure]
modulus = 270e6
thickness = 0.01
cells = 1
supports = [{ at = "feet", kind = "sliding" }]
"""
)


def test_what_is_written(tmp_path: Path) -> None:
    (tmp_path / "arch.toml").write_text(ARCH)
    first = orishell("structure", "arch.toml", "--out", "one", cwd=tmp_path)
    assert first.returncode == 0, first.stderr
    tables = ["anchors.csv", "creases.csv", "forces.csv"]
    files = [*tables, "structure.html", "structure.json", "structure.png"]
    listed = [".orishell.json", *files]  # with the list of what was written
    assert sorted(path.name for path in (tmp_path / "one").iterdir()) == listed
    assert first.stdout.splitlines()[-6:] == [f"wrote     one/{name}" for name in files]
    printed = orishell("structure", "arch.toml", "--out", "two", "--json", cwd=tmp_path)
    written = json.loads((tmp_path / "one" / "structure.json").read_text())
    assert json.loads(printed.stdout) == written
    assert [case["name"] for case in written["cases"]] == ["self-weight", "self-weight"]
    for name in files:
        same = (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes()
        assert same, name


@pytest.mark.parametrize(
    ("old", "new", "status"),
    led_by(
        [
            (
                "cells = 1",
                "cells = 1\nstrength = 1e9\ncrease_strength = 1e9\nline_strength = 1e9\n"
                "tie_strength = 1e9",
                0,
            ),
            ("cells = 1", "cells = 1\nstrength = 10", 1),  # pascals
            ("cells = 1", "cells = 1", 1),  # strengths are not known
            ('ties = "feet"', "", 1),  # opens
        ],
        2,
    ),
)
def test_check_asks_for_status_1(tmp_path: Path, old: str, new: str, status: int) -> None:
    """Of a shell that is not known to carry; otherwise 0, as the answer was found."""
    (tmp_path / "arch.toml").write_text(ARCH.replace(old, new))
    done = orishell("structure", "arch.toml", "--check", cwd=tmp_path)
    assert done.returncode == status, done.stderr
    assert done.stdout.split()[1] == "stands"
    if status:
        assert orishell("structure", "arch.toml", cwd=tmp_path).returncode == 0


def test_a_shell_that_was_not_analysed_is_not_written(tmp_path: Path, bare: Shell) -> None:
    with pytest.raises(InputError, match="not analysed"):
        write_structure(bare, tmp_path / "a")
    assert not (tmp_path / "a").exists()


ZONE = "zones = [{ rows = [0, 1], coefficient = 1 }]"


@pytest.mark.parametrize(
    ("old", "new", "where"),
    [
        ('at = "feet"', "at = [[9, 0]]", "[structure] supports[0] at"),
        ("", "points = [{ at = [9, 0], force = [0, 0, 1] }]", '"case": points[0] at'),
        (
            "",
            f'wind = {{ speed = 26, terrain = "II", direction_deg = 0, {ZONE} }}',
            '"case": wind zones',
        ),
        ("areal_density = 1.9", "", "[[load_case]] self_weight"),
    ],
)
@pytest.mark.parametrize("command", ["design", "structure"])
def test_what_does_not_fit_the_sheet_is_one_message_and_nothing_is_written(
    tmp_path: Path, command: str, old: str, new: str, where: str
) -> None:
    text = ARCH.replace(old, new) if old else f'{ARCH}[[load_case]]\nname = "case"\n{new}\n'
    (tmp_path / "arch.toml").write_text(text)
    done = orishell(command, "arch.toml", "--out", "out", cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.count("orishell:") == 1
    assert done.stderr.startswith("orishell: arch.toml: ")
    assert where in done.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["arch.toml"]
