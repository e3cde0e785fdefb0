"""The files on a shell as a structure: the picture of its deflections, page and creases."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Final

import numpy as np

from orishell.conventions.quantities import Quantities
from orishell.document import Document
from orishell.document.loaded import LoadedShell
from orishell.io.formats.tables import write_csv
from orishell.io.html_pages import static_page
from orishell.io.sections import Bullets, Paragraph, Picture, Section, sections_html
from orishell.numerics.arrays import Array
from orishell.plot import DrawnCase, DrawnPath, draw_load_paths, plot_structure
from orishell.structure.case import CaseResult
from orishell.structure.pages.anchor_tables import HEAD as ANCHOR_HEAD
from orishell.structure.pages.anchor_tables import anchor_rows
from orishell.structure.pages.crease_tables import crease_head, crease_rows
from orishell.structure.pages.details import sentence
from orishell.structure.pages.force_tables import write_forces
from orishell.structure.pages.sections import answer, structure_sections
from orishell.structure.results import Analysis

FILES: Final = ("structure.html", "structure.png", "creases.csv", "anchors.csv", "forces.csv")
SHOWN: Final = "The shell under its loads, coloured by displacement."


def write_structure_files(directory: Path, document: Document, analysis: Analysis) -> None:
    """Write ``structure.png``, ``structure.html``, and the tables."""
    assert document.loaded is not None
    unit = document.require_unit()
    path = directory / "structure.png"
    walls = [
        each.shell.positions[np.asarray(each.mesh.faces)]
        for each in document.attached
        if each.kind == "end_wall"
    ]
    draw_structure(path, document.loaded, analysis, unit, walls)
    drawn = [
        DrawnPath(
            analysis.name_of(case), found.path.factors, found.path.displacements,
            found.path.linear_displacement,
        )
        for found, case in analysis.balanced
        if found.path is not None
    ]  # fmt: skip
    paths = draw_load_paths(drawn, unit=unit) if drawn else None
    page = structure_page(
        analysis, title=document.title, unit=unit, png=path.read_bytes(), paths=paths
    )
    (directory / "structure.html").write_text(page, encoding="utf-8", newline="\n")
    write_csv(directory / "anchors.csv", ANCHOR_HEAD, anchor_rows(analysis))
    write_csv(directory / "creases.csv", crease_head(unit), crease_rows(analysis))
    write_forces(directory / "forces.csv", analysis, document)


def structure_page(
    report: Analysis, *, title: str, unit: str, png: bytes, paths: bytes | None = None
) -> str:
    """The text of ``structure.html``: model, loads, results and what is not covered.

    title: What the shell is.
    png: The picture of the loaded shell.
    paths: That of loads against displacements, if large displacements were followed.
    """
    top = (
        Paragraph(f"Does it carry its loads? {sentence(report.in_words())}", f"lead {report.sign}"),
        *answer(report, unit).parts,
        Picture(png, SHOWN),
    )
    sections = (
        Section(f"Structure: {title}", top, level=1),
        Section("Warnings", (Bullets(report.warnings),)),
        *structure_sections(report, unit, paths),
    )
    return static_page(f"Structure: {title}", sections_html(sections))


def draw_structure(
    path: Path,
    loaded: LoadedShell,
    analysis: Analysis,
    unit: str,
    walls: Sequence[Array] = (),
) -> None:
    """Draw the shell under its loads, the worst case first.

    loaded: The shell, in the document's frame, with the load cases of the analysis.
    walls: Corners (P, K, 3) of panels of the walls that close its ends, in that frame.
    """
    said = Quantities(unit)
    shown = {case: each for each, case in zip(loaded.cases, analysis.cases, strict=True)}
    drawn = []
    for case in analysis.ranked:
        taut = np.zeros(len(loaded.ties), dtype=bool)
        if case.equilibrium is not None:
            taut = case.equilibrium.tie_forces > 0
        drawn.append(DrawnCase(shown[case], taut, _note(case, said)))
    title = f"Structure: {VERDICTS[analysis.sign]}"
    plot_structure(path, loaded, drawn, title=title, sign=analysis.sign, unit=unit, walls=walls)


VERDICTS = {
    "fails": "it does not carry its loads",
    "warns": "it is not known to carry its loads",
    "holds": "it carries its loads",
}
"""What an analysis found, as a heading says it."""


def _note(case: CaseResult, said: Quantities) -> str:
    """How it fails, or how far the shell is displaced, and where most."""
    if case.sign == "fails":
        return ", ".join(dict.fromkeys(each.kind for each in case.findings if each.sign == "fails"))
    assert case.equilibrium is not None
    most = case.equilibrium.displacement
    where = f"{said.displacement(most.size)} at panel {most.panel[0]}, {most.panel[1]}"
    return f"not known; {where}" if case.sign == "warns" else where
