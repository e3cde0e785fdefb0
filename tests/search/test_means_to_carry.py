"""A search varies by their keys what a shell carries by: stiffeners, material, ties."""

from __future__ import annotations

from typing import Any

import pytest

from orishell.conventions.toml_file import parse_toml
from orishell.design_file import check_design
from orishell.search.evaluate import evaluate, job_of
from orishell.search.problem import parse_problem
from orishell.shell import make_shell
from orishell.shell.steps import MEASURES
from samples import thorough
from search.problems import PATH
from small_arch import SMALL_ARCH

VARIABLES: dict[str, list[Any]] = {
    "stiffeners.kind": ["gussets", "boxes"],
    "stiffeners.columns": [2, "all"],
    "structure.material": ["birch plywood", "aluminium"],
    "deployment.ties": ["feet", "folds"],
}
ARCH = (
    SMALL_ARCH
    + """[deployment]
from = "pack"
[panel]
thickness = 0.006
construction = "bevel"
gap = 0.002
[stiffeners]
kind = "gussets"
rows = "valleys"
[structure]
material = "birch plywood"
crease_stiffness = "free"
tie_stiffness = 1e6
tie_strength = 20e3
line_strength = 150e3
edge_strength = 150e3
cells = 4
supports = [{ at = "feet", kind = "pinned" }]
[[load_case]]
name = "snow"
self_weight = true
snow = { ground = 500, arrangement = "undrifted" }
[search]
minimise = ["mass", "deflection"]
method = "grid"
subject_to = { utilisation = { most = 1e4 } }
"""
)


PANELS = """[panel]
thickness = 0.006
construction = "bevel"
gap = 0.002
"""
QUICK = ARCH.replace(PANELS, "").replace(
    "cells = 4\n", "cells = 3\nthickness = 0.006\nnonlinear = false\n"
)
"""Of panels without boards, in coarse cells, and displacements by linear theory."""


@pytest.mark.parametrize(
    "text", [QUICK, pytest.param(ARCH, marks=thorough)], ids=["quick", "whole"]
)
def test_stiffeners_material_and_ties_are_variables(text: str) -> None:
    """Figures are those of the whole designs; what holds more moves less, what is denser weighs."""
    raw = parse_toml(text)
    raw["search"]["variables"] = VARIABLES
    problem = parse_problem(raw, PATH)
    first = {key: values[0] for key, values in VARIABLES.items()}
    others = [{**first, key: values[1]} for key, values in VARIABLES.items()]
    found = evaluate(job_of(problem), [first, *others])
    assert all(each.figures for each in found), [each.reason for each in found]
    few, girders, every_column, metal, tied = (each.figures for each in found)
    if text == ARCH:  # by linear theory panels between gussets do not buckle
        assert girders["deflection"] < few["deflection"]
    assert girders["mass"] > 1.3 * few["mass"]
    assert every_column["deflection"] < few["deflection"]
    assert every_column["mass"] > few["mass"]
    assert metal["mass"] > 3 * few["mass"]
    assert tied["deflection"] < few["deflection"]
    tables = {key: each for key, each in raw.items() if key != "search"}
    skip = ("remedies", "verification", "stock", *MEASURES)
    whole = make_shell(check_design(tables, PATH).changed(others[1]), skip=skip)
    assert whole.analysis is not None
    assert every_column["utilisation"] == pytest.approx(
        max(case.used for case in whole.analysis.cases)
    )
