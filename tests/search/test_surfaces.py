"""Searches for shells on surfaces: rows, columns and fold angle of sheets that are fitted."""

from __future__ import annotations

import shutil
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.design_file import check_design
from orishell.search.front import scores
from orishell.search.journal import journal_in_memory
from orishell.search.problem import Problem, parse_problem
from orishell.search.run import search_designs
from orishell.search.worker_pool import alone
from orishell.search.write import variant_text
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES, Step
from samples import thorough

EXAMPLES = Path(__file__).parents[2] / "examples"
SADDLE = {"formula": "0.25*(x**2 - y**2)", "x": [-1, 1], "y": [-1, 1]}


def problem(path: Path = Path("saddle.toml"), surface: Any = SADDLE, **search: Any) -> Problem:
    tables = {
        "shell": {"family": "flat-foldable", "unit": "m"},
        "target": {"surface": surface},
        "pattern": {"rows": 3, "columns": 3, "direction_deg": 0},
        "motion": {"frames": 2},
        "search": {
            "variables": {
                "pattern.rows": [3, 4],
                "pattern.columns": {"low": 2, "high": 3},
                "pattern.fold_deg": {"low": 80, "high": 100, "step": 20},
            },
            "minimise": ["panels", "sheet_area"],
            **search,
        },
    }
    return parse_problem(tables, path)


def unbeaten(figures: np.ndarray) -> list[tuple[float, ...]]:
    """Rows of figures that no other row beats in one and equals in the rest, in ascending order."""
    beaten = [
        any((other <= each).all() and (other < each).any() for other in figures) for each in figures
    ]
    return sorted(tuple(each) for each in figures[~np.array(beaten)])


@thorough
@pytest.mark.parametrize("figure", ["sheet_area", "deviation.surface.max"])
def test_front_is_that_of_shells_made_one_by_one(figure: str) -> None:
    grid = problem(minimise=["panels", figure], method="grid")
    with alone() as pool:
        found = search_designs(grid, pool, journal_in_memory())
    assert len(found.outcomes) == grid.space.count == 8
    area = figure == "sheet_area"
    figures = []
    for outcome in found.outcomes:
        file = check_design(grid.tables, grid.path).changed(outcome.values)
        skip: tuple[Step, ...] = MEASURES if area else ("pack", "weight")
        report = make_shell(file, clash="unexamined", skip=skip).report
        panels = (outcome.values["pattern.rows"] + 1) * (outcome.values["pattern.columns"] + 1)
        found_far = report.deviation and report.deviation.surface
        second = report.sheet.area if area else found_far and found_far.max
        figures.append((panels, second))
        assert (outcome.figures["panels"], outcome.figures[figure]) == figures[-1]
    assert sorted(scores(grid, each) for each in found.front.members) == unbeaten(np.array(figures))


@thorough
def test_bred_variants_are_made_once() -> None:
    bred = problem(method="nsga2", population=4, evaluations=6)
    with alone() as pool:
        found = search_designs(bred, pool, journal_in_memory())
    assert len({str(each.values) for each in found.outcomes}) == len(found.outcomes) == 6


def test_mesh_of_a_surface_is_found_from_where_variants_are_written(tmp_path: Path) -> None:
    shutil.copy(EXAMPLES / "roof.obj", tmp_path / "roof.obj")
    roof = problem(tmp_path / "roof.toml", {"mesh": "roof.obj", "unit": "mm"})
    assert roof.files() == [tmp_path / "roof.obj"]
    text = variant_text(roof, {"pattern.rows": 4}, tmp_path / "out")
    assert tomllib.loads(text)["target"]["surface"]["mesh"] == "../roof.obj"
    # Another mesh of that name is another problem: what a journal knows of the first is not its.
    before = roof.fingerprint()
    with (tmp_path / "roof.obj").open("a") as file:
        file.write("# changed\n")
    assert roof.fingerprint() != before
