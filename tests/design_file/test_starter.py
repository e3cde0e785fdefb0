"""The files to begin with: every example in their comments works where it stands."""

from __future__ import annotations

import copy
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import ezdxf
import pytest

from orishell.conventions.toml_file import parse_toml
from orishell.design_file import check_design, starter_file
from orishell.families.registry import FAMILIES
from orishell.search.problem import parse_problem
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from samples import THOROUGH, thorough

Tables = dict[str, Any]
KEY = re.compile(r"# \w+ = ")
WITH: dict[str, dict[str, Any]] = {
    **{key: {"points": "profile.csv", "unit": "mm"} for key in ("unit", "smooth", "part")},
    "row_angle_deg": {"row": "zigzag"},
}
"""What a key goes with, as its comment says."""
MILLIMETRES = [(-1000, 0), (-500, 400), (0, 500), (500, 400), (1000, 0)]

OF_PANELS = ("membrane_strength", "arm_modulus", "arm_strength")
"""Keys of [structure] that ask for a table [panel]."""
SLOW = {"": {"tolerance"}, "orthodiagonal": set[str]()}
"""Examples by family that `make test` leaves out."""


@pytest.fixture(scope="module")
def directory(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the drawings lie that the comments name."""
    found = tmp_path_factory.mktemp("drawings")
    (found / "profile.csv").write_text("".join(f"{x}, {y}\n" for x, y in MILLIMETRES))
    (found / "profile.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="2000mm" viewBox="-1 -1 2 1">'
        '<path d="M -1 0 A 1.25 1.25 0 0 1 1 0"/></svg>'
    )
    drawing = ezdxf.new(units=4)
    drawing.modelspace().add_arc((0, -750), 1250, 36.87, 143.13)
    drawing.saveas(found / "profile.dxf")
    return found


def examples(family: str) -> Iterator[tuple[str, Tables]]:
    """Name and tables of the file with each of its examples in turn: a key, or a table."""
    base = parse_toml(starter_file(family))
    for block in starter_file(family).split("\n\n"):
        lines = block.strip().splitlines()
        if lines[0].startswith("# [["):
            continue  # needs another table: below
        if lines[0].startswith("# ["):
            tables = parse_toml("\n".join(line.removeprefix("# ") for line in lines))
            ((name, table),) = tables.items()
            inner = base.get(name, {}) if name == "target" else {}
            yield name, copy.deepcopy({**base, name: {**inner, **table}})
            continue
        header = next((line for line in lines if line.startswith("[")), "")
        for line in filter(KEY.match, lines):
            tables = copy.deepcopy(base)
            table = tables
            for name in header.partition("]")[0].strip("[]").split("."):
                table = table[name]
            ((key, value),) = parse_toml(line.removeprefix("# ")).items()
            table |= {**WITH.get(key, {}), key: value}
            if {"points", "svg", "dxf", "path"} & set(table):
                del table["formula"], table["range"]
            if key == "points":
                table["unit"] = "mm"  # of the drawing
            if "row" in table or table.get("plane") == "bisector":
                table.pop("placement", None)
            yield key, tables


EXAMPLES = [
    pytest.param(tables, id=f"{family}-{name}")
    for family in FAMILIES
    for name, tables in examples(family)
    if THOROUGH or name not in SLOW.get(family, SLOW[""])
]


def test_they_show_every_way_to_give_a_curve_and_every_table() -> None:
    for family in FAMILIES:
        shown = {name for name, _ in examples(family)}
        assert shown >= {"search", "workshop", "deployment", "panel", "structure"}
        if "f" in parse_toml(starter_file(family)).get("target", {}):
            assert shown >= {"points", "svg", "dxf", "path", "tolerance"}


@pytest.mark.parametrize("tables", EXAMPLES)
def test_an_example_works(tables: Tables, directory: Path) -> None:
    path = directory / "shell.toml"
    if "tolerance" in tables:
        del tables["pattern"]["rows"], tables["pattern"]["columns"]
    if "structure" in tables:
        tables["workshop"] = {"areal_density": 5}
        # There is a strength, which goes without a grain; and the material has one.
        for key in (*OF_PANELS, "grain", "sandwich"):
            del tables["structure"][key]
    if "search" in tables:
        assert parse_problem(tables, path).figures
        del tables["search"]
    if not THOROUGH:
        tables["motion"] = {"frames": 3}
    file = check_design(tables, path)
    if THOROUGH:
        assert make_shell(file, skip=MEASURES).report.feasible
    else:
        make_shell(file, clash="unexamined", skip=(*MEASURES, "structure"))


@thorough
def test_the_example_of_loads_works(directory: Path) -> None:
    family = "orthodiagonal"
    text = starter_file(family)
    blocks = [block for block in text.split("\n\n") if "# [structure]" in block or "[[" in block]
    lines = "\n".join(blocks).splitlines()
    commented = "\n".join(line.removeprefix("# ") for line in lines if "combine" not in line)
    tables = {**parse_toml(text), **parse_toml(commented), "workshop": {"areal_density": 5}}
    for key in (*OF_PANELS, "grain", "sandwich"):
        del tables["structure"][key]
    file = check_design(tables, directory / "shell.toml")
    shell = make_shell(file, clash="unexamined", skip=MEASURES)
    assert shell.report.structure is not None
    assert {case.name for case in shell.report.structure.cases} == {"winter"}
