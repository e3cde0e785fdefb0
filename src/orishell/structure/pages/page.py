"""The page on a shell as a structure, which an engineer checks by hand."""

from __future__ import annotations

from orishell.io.html_pages import static_page
from orishell.io.sections import Bullets, Paragraph, Picture, Section, sections_html
from orishell.structure.pages.details import sentence
from orishell.structure.pages.sections import answer, structure_sections
from orishell.structure.results import Analysis

SHOWN = "The shell under its loads, coloured by displacement."


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
