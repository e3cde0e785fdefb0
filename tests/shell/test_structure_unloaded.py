"""A load case that loads nothing: wind of no pressure from any side."""

from __future__ import annotations

from pathlib import Path

from design_tables import formula, tables
from orishell.design_file import check_design
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from orishell.structure.pages.files import write_structure_files


def test_nothing_is_displaced_nor_buckles(tmp_path: Path) -> None:
    """What is written of it is written all the same."""
    steep = formula("1-x**2", -1, 1)
    design = tables("parallel-repeating", steep, formula("0", 0, 2), rows=5, columns=3)
    supports = [{"at": "feet", "kind": "pinned"}]
    design["structure"] = {"modulus": 1e9, "thickness": 0.01, "cells": 1, "supports": supports}
    design["structure"]["crease_stiffness"] = "rigid"
    wind = {"speed": 26, "terrain": "II", "direction_deg": 0}
    calm = wind | {"coefficients": [[0, 0], [180, 0]]}
    design["load_case"] = [{"name": "calm", "wind": calm}]
    file = check_design(design, Path("shell.toml"))
    shell = make_shell(file, clash="unexamined", skip=MEASURES)
    assert shell.analysis is not None
    assert shell.report.structure is not None
    (case,) = shell.report.structure.cases
    assert case.equilibrium is not None
    assert case.load == (0, 0, 0)
    assert case.equilibrium.displacement.size == 0
    assert case.equilibrium.buckling is None
    write_structure_files(tmp_path, shell.document, shell.analysis)
    assert "by linear theory it does not" in (tmp_path / "structure.html").read_text("utf-8")
