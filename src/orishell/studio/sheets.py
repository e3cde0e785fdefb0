"""The drawings that a workshop gets, as the page shows them before they are exported."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.progress import Progress
from orishell.design_file import DesignFile
from orishell.design_file.constructions import FROM_PACK
from orishell.document import Document
from orishell.io.formats.svg import dump_svg
from orishell.io.output import scratch
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from orishell.studio.api import DrawnSheet, LayerPen, PaperPages, Sheets
from orishell.studio.labels import LAYERS
from orishell.workshop import Workshop
from orishell.workshop.boards import has_sheet
from orishell.workshop.palettes import ORDER, Drawing, Line, Palette, Text, load_palette
from orishell.workshop.paper_model import make_paper_model
from orishell.workshop.sheets import draw_sheet_files, measure_waste

SEEN, PAGE_MM = "plain", 160.0
"""The palette whose lines can be seen at any size, and the page on which they are that wide: a
picture of the drawings is small."""
NUMBER = 0.12
"""Height of the numbers of pages, as a share of a page's frame."""


def preview_sheets(file: DesignFile, name: str, progress: Progress) -> Sheets:
    """The drawings of a design's flat sheet, and what they come to; files are called ``name``."""
    # The proof may make flaps narrower, and cut boards off.
    proved = file.pattern.flap == "auto" or file.panel is not None
    shell = make_shell(
        file.changed({"motion.frames": FROM_PACK}),
        progress,
        clash="allowed" if proved else "unexamined",
        skip=(*MEASURES, "structure"),
    )
    document, workshop = shell.document, file.workshop
    palette = load_palette(workshop.palette)
    sheets: list[DrawnSheet] = []
    drawn: set[str] = set()
    with scratch() as directory:
        place = directory / f"{name}.svg"
        for path, drawing in draw_sheet_files(place, document, workshop):
            dump_svg(path, drawing, _visible(palette))
            text = path.read_text(encoding="utf-8")
            sheets.append({"file": path.stem, "title": drawing.title, "svg": text})
            drawn.update(line.layer for line in drawing.lines)
            drawn.update(circle.layer for circle in drawing.circles)
            drawn.update(text.layer for text in drawing.texts)
        paper = _paper_pages(directory / "paper.svg", document, workshop, _visible(palette))
    layers: list[LayerPen] = [
        {"layer": layer, "label": LAYERS[layer], "colour": palette.pens[layer].colour}
        for layer in ORDER
        if layer in drawn and layer in palette.pens
    ]
    built = shell.report.quantities.built
    return {
        "sheets": sheets,
        "unit": document.unit,
        "layers": layers,
        "palette": palette.note,
        "stock": measure_waste(document, workshop),
        "boards": built.stock_sheets if built is not None and has_sheet(document) else None,
        "paper": paper,
    }


def _visible(palette: Palette) -> Palette:
    """A palette of the same colours, with lines that are seen where a machine wants hairlines."""
    seen = load_palette(SEEN)
    pens = {
        layer: replace(pen, width_mm=seen.pens[layer].width_mm)
        for layer, pen in palette.pens.items()
    }
    return replace(palette, pens=pens, page_mm=PAGE_MM)


def _paper_pages(
    path: Path, document: Document, workshop: Workshop, palette: Palette
) -> PaperPages:
    """The paper model with its pages; ``path`` is where its picture may be written."""
    try:
        model = make_paper_model(document, workshop)
    except InputError as error:
        return {"says": str(error), "svg": ""}
    tiling = model.tiling
    frame = np.array([tiling.frame_width, tiling.frame_height])
    corners = np.array([(page.left, page.bottom) for page in tiling.pages])
    low = np.minimum(corners.min(axis=0), 0.0)
    width, height = (np.maximum((corners + frame).max(axis=0), model.size) - low).tolist()
    around = (corners - low)[:, None] + frame * ((0, 0), (1, 0), (1, 1), (0, 1))
    frames = (Line("ENGRAVE", each, closed=True) for each in around)
    numbers = (
        Text("ENGRAVE", x, y, NUMBER * float(frame.min()), str(number))
        for number, (x, y) in enumerate(around.mean(axis=1).tolist(), 1)
    )
    sheet = (replace(line, points=line.points - low) for line in model.lines)
    pages = len(tiling.pages)
    drawing = Drawing(model.title, "mm", width, height, (*frames, *sheet), texts=tuple(numbers))
    dump_svg(path, drawing, palette)
    says = f"{model.says}, {pages} {'page' if pages == 1 else 'pages'} of {workshop.paper}"
    return {"says": says, "svg": path.read_text(encoding="utf-8")}
