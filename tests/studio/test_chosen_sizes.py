"""What a search of sizes chooses beside rows and columns, as the page keeps it: sizing.ts."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from orishell.conventions.toml_file import parse_toml
from orishell.design_file import DesignFile, read_design_file, starter_file
from orishell.families.tolerance import Tolerance
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES

SIZING = Path(__file__).parents[2] / "frontend" / "src" / "studio" / "state" / "sizing.ts"
FAMILIES = ("parallel-repeating", "orthodiagonal", "longitudinal-linear-repeating")
AUTO = {
    "parallel-repeating": {"xi_deg": "auto", "theta_deg": "auto"},
    "orthodiagonal": {"depth": "auto"},
    "longitudinal-linear-repeating": {"sector_deg": "auto", "stage_deg": "auto"},
}
"""What a pattern leaves to the search, where that is so by a word."""


def kept() -> set[str]:
    """The keys that the page takes from the report of the shell that was chosen."""
    (found,) = re.findall(r"const SETTLED = \[([^\]]*)\]", SIZING.read_text("utf-8"))
    return set(re.findall(r'"(\w+)"', found))


def left_open(family: str, place: Path) -> DesignFile:
    """The family's starter, without a size."""
    path = place / "open.toml"
    path.write_text(starter_file(family))
    without = {"rows", "columns", "spacing", "placement"}
    given = parse_toml(path.read_text())["pattern"]
    pattern = {key: each for key, each in given.items() if key not in without} | AUTO[family]
    return read_design_file(path).changed({"pattern": pattern | {"rows": 5, "columns": 7}})


@pytest.mark.parametrize("family", FAMILIES)
def test_the_page_keeps_all_that_a_search_may_choose(family: str, tmp_path: Path) -> None:
    file = left_open(family, tmp_path)
    limits = Tolerance(surface=0.3, panel_min=0.1, panel_max=2.0)
    variants = file.pattern.variants(file.f, limits)
    own = file.pattern.model_dump()
    changed = {
        key
        for each in (*variants.telling, *variants.others)
        for key, value in each.model_dump().items()
        if value != own[key]
    }
    assert changed
    assert changed <= kept()


@pytest.mark.parametrize("family", FAMILIES)
def test_what_it_keeps_makes_the_same_shell(family: str, tmp_path: Path) -> None:
    """Angles of the report have 13 digits."""
    file = left_open(family, tmp_path).changed(
        {"pattern.rows": None, "pattern.columns": None, "tolerance": {"surface": 0.36}}
    )
    chosen = make_shell(file, clash="unexamined", skip=MEASURES).report
    settled = {key: chosen.parameters[key] for key in kept() if key in chosen.parameters}
    given = file.tables["pattern"]
    pattern = given | {
        key: each for key, each in settled.items() if given.get(key, "auto") == "auto"
    }
    sized = file.changed(
        {"tolerance": None, "pattern": {**pattern, "rows": chosen.rows, "columns": chosen.columns}}
    )
    again = make_shell(sized, clash="unexamined", skip=MEASURES).report
    assert again.sheet.area == pytest.approx(chosen.sheet.area, rel=1e-10)
    assert again.deployed.height == pytest.approx(chosen.deployed.height, rel=1e-9)
