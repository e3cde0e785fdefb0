"""The booklet: parts, tools and steps to build a shell, carry it and put it up, as PDF.

Lines and words only, black on white, so that any printer will do. Nothing is compressed, and
nothing tells when or where the file was written.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from orishell.document import Document
from orishell.io.booklet_drawing import Drawn, dashes_of
from orishell.io.booklet_pages import (
    HIGH,
    THIN,
    TIE,
    WIDE,
    BookletPage,
    booklet_pages,
)
from orishell.io.format import Format, Settings
from orishell.io.pdf_lines import add_line

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas


def write_booklet(path: Path, document: Document, settings: Settings) -> None:
    """Write the booklet of a shell, or of a model of it, in ``[workshop] language``.

    Pages are A4. Panels are drawn without their thickness. Of more than 1500 only some rows and
    columns are drawn, as the cover then says. Where feet are marked out is said where the plan of
    the ground is asked for, too.
    """
    from reportlab.pdfgen.canvas import Canvas

    canvas = Canvas(str(path), pagesize=(WIDE, HIGH), invariant=1, pageCompression=0)
    canvas.setTitle(document.title.encode("cp1252", "replace").decode("cp1252"))
    canvas.setCreator("orishell")
    for page in booklet_pages(document, settings.workshop, ground=settings.ground):
        _draw(canvas, page)
        canvas.showPage()
    canvas.save()


def _draw(canvas: Canvas, page: BookletPage) -> None:
    canvas.setLineJoin(1)
    canvas.setStrokeGray(0)
    for each in page.drawn:
        canvas.setLineWidth(TIE if each.dashed or each.thick else THIN)
        canvas.setDash(list(dashes_of(each.points)) if each.dashed else [])
        _draw_line(canvas, each)
    canvas.setFillGray(0)
    for said in page.said:
        canvas.setFont("Helvetica-Bold" if said.bold else "Helvetica", said.size)
        write = canvas.drawRightString if said.anchor == "end" else canvas.drawString
        write(said.x, said.y, said.words)


def _draw_line(canvas: Canvas, each: Drawn) -> None:
    path = canvas.beginPath()
    add_line(path, each.points, closed=each.closed)
    if each.fill is not None:
        canvas.setFillGray(each.fill)
    canvas.drawPath(path, stroke=1, fill=int(each.fill is not None))


FORMAT = Format(
    "booklet",
    "booklet.pdf",
    ("booklet.pdf",),
    "parts, tools and steps to build it",
    write_booklet,
    designed=True,
    task="kit",
)
