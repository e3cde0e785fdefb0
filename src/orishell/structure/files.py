"""The files on a shell as a structure: the picture of its deflections, page and creases."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from orishell.conventions.quantities import Quantities
from orishell.document import Document
from orishell.document.loaded import LoadedShell
from orishell.plot import DrawnCase, plot_structure
from orishell.structure.crease_tables import crease_csv
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.page import structure_page
from orishell.structure.results import Analysis


def write_structure_files(directory: Path, document: Document, analysis: Analysis) -> None:
    """Write ``structure.png``, ``structure.html`` and ``creases.csv`` of a loaded document."""
    assert document.loaded is not None
    unit = document.require_unit()
    path = directory / "structure.png"
    draw_structure(path, document.loaded, analysis, unit)
    page = structure_page(analysis, title=document.title, unit=unit, png=path.read_bytes())
    (directory / "structure.html").write_text(page, encoding="utf-8", newline="\n")
    table = crease_csv(analysis, unit)
    (directory / "creases.csv").write_text(table, encoding="utf-8", newline="\n")


def draw_structure(path: Path, loaded: LoadedShell, analysis: Analysis, unit: str) -> None:
    """Draw the shell under its loads, the case that governs first.

    loaded: The shell, in the document's frame, with the load cases of the analysis.
    """
    said, governs = Quantities(unit), analysis.governs
    drawn = []
    for shown, case in zip(loaded.cases, analysis.cases, strict=True):
        taut = np.zeros(len(loaded.ties), dtype=bool)
        if case.stands is not None:
            taut = case.stands.tie_forces > 0
        first = governs is not None and (governs.case, governs.creases) == (case.name, case.creases)
        drawn.append((not first, DrawnCase(shown, taut, _note(case.stands, said))))
    drawn.sort(key=lambda each: each[0])
    title = "Structure: it moves under all loads"
    if analysis.standing:
        found, case = max(analysis.standing, key=lambda each: each[0].displacement.size)
        most = said.displacement(found.displacement.size)
        title = f"Structure: displaced by {most} at most, under {analysis.name_of(case)}"
    plot_structure(path, loaded, [each for _, each in drawn], title=title, unit=unit)


def _note(found: Equilibrium | None, said: Quantities) -> str:
    """How far the shell is displaced, and where most."""
    if found is None:
        return ""
    row, column = found.displacement.panel
    return f"{said.displacement(found.displacement.size)} at panel {row},{column}"
