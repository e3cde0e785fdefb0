"""The files on a shell as a structure: the picture of its deflections, and the page."""

from __future__ import annotations

from pathlib import Path

from orishell.conventions.quantities import Quantities
from orishell.document import Document
from orishell.document.loaded import LoadedShell
from orishell.plot import DrawnCase, plot_structure
from orishell.structure.build_warnings import name_of
from orishell.structure.case_report import StandingReport
from orishell.structure.page import structure_page
from orishell.structure.report import StructureReport
from orishell.structure.results import Analysis


def write_structure_files(
    directory: Path, document: Document, report: StructureReport, analysis: Analysis
) -> None:
    """Write ``structure.png`` and ``structure.html``.

    Parameters
    ----------
    directory
        Where to.
    document
        The shell, loaded.
    report
        What was found, as the report says it.
    analysis
        What was found; its cases are those of the document and of the report.
    """
    assert document.loaded is not None
    path = directory / "structure.png"
    draw_structure(path, document.loaded, report, analysis, document.require_unit())
    page = structure_page(
        report, title=document.title, unit=document.require_unit(), png=path.read_bytes()
    )
    (directory / "structure.html").write_text(page, encoding="utf-8", newline="\n")


def draw_structure(
    path: Path, loaded: LoadedShell, report: StructureReport, analysis: Analysis, unit: str
) -> None:
    """Draw the shell under its loads, the case that governs first.

    Parameters
    ----------
    path
        Where to.
    loaded
        The shell with its load cases.
    report
        What was found, as the report says it.
    analysis
        What was found.
    unit
        Unit of length.
    """
    said = Quantities(unit)
    governs = report.governs
    first = None if governs is None else (governs.case, governs.creases)
    drawn = [
        (described, DrawnCase(case, found.tie_forces > 0, _note(described.stands, said)))
        for case, described, found in zip(loaded.cases, report.cases, analysis.cases, strict=True)
    ]
    drawn.sort(key=lambda each: (each[0].name, each[0].creases) != first)
    title = "Structure: it moves under all loads"
    standing = [(each.stands, each) for each in report.cases if each.stands is not None]
    if standing:
        found, case = max(standing, key=lambda each: each[0].displacement.size)
        most = said.displacement(found.displacement.size)
        title = f"Structure: displaced by {most} at most, under {name_of(case, report.cases)}"
    plot_structure(path, loaded, [each for _, each in drawn], title=title, unit=unit)


def _note(found: StandingReport | None, said: Quantities) -> str:
    """How far the shell is displaced, and where most."""
    if found is None:
        return ""
    row, column = found.displacement.panel
    return f"{said.displacement(found.displacement.size)} at panel {row},{column}"
