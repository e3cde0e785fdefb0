"""PDF of a paper model: the flat sheet to scale over as many pages as it takes, to print and fold.

Mountains are dash-dotted and valleys dashed, as folders draw them, so that a printer without
colours will do; where creases are cut in dashes, mountains are thicker. Nothing is compressed, and
nothing tells when or where the file was written.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from orishell.document import Document
from orishell.io.format import Format, Settings
from orishell.io.pdf_lines import add_line
from orishell.numerics.arrays import Array, Booleans
from orishell.workshop.ground_plan import ground_beside
from orishell.workshop.palettes import ORDER, Anchor, Layer, Text, load_palette
from orishell.workshop.paper_model import PaperModel, make_board_models, make_paper_model
from orishell.workshop.printed_plan import PrintedPlan, print_ground
from orishell.workshop.tiling import BORDER_MM, FOOT_MM, OVERLAP_MM, Page

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas

Box = tuple[Array, Array]

MM = 72 / 25.4
"""Points in a millimetre."""
BESIDE_MM = 3.0
"""Room between a title and the bar beside it (mm)."""
ARM_MM = 2.5
"""Length of the arms of register marks (mm)."""
CAPITALS = 0.718
"""Height of Helvetica's capitals, in font sizes."""
INK, PALE = "#000000", "#b4b4b4"

STYLES: dict[Layer, tuple[float, tuple[float, ...]]] = {
    "ENGRAVE": (0.2, (0.3, 1.1)),
    "MOUNTAIN": (0.3, (3.6, 1.1, 0.4, 1.1)),
    "VALLEY": (0.3, (2.2, 1.3)),
    "CUT": (0.4, ()),
}
"""Width of lines, and lengths of dashes and gaps (mm); in the order in which they are drawn."""
CUT_STYLES = STYLES | {"MOUNTAIN": (0.55, ()), "VALLEY": (0.2, ())}
"""Of creases that are cut as they are drawn: mountains are thicker."""
MEANINGS: dict[Layer, str] = {
    "CUT": "cut",
    "MOUNTAIN": "mountain: fold so that the crease comes towards you",
    "VALLEY": "valley: fold so that the crease goes away from you",
    "ENGRAVE": "not folded",
}


def write_pdf(path: Path, document: Document, settings: Settings) -> None:
    """Write the flat sheet at ``paper_scale`` over pages of ``paper``.

    Neighbouring pages share a strip of 10 mm; register marks stand at its corners, at the same
    places of the sheet on both. Pages that the sheet does not touch are left out. If there are
    several, a page with their order comes first. Where panels have a thickness, the back of the
    membrane and the boards of each layer follow at the same scale, in files of their own:
    ``-back``, ``-top``, ``-bottom``, or ``-panels``. Of the palette only colours count.

    The plan of the feet of a shell that can stand is ``ground.pdf``, if it is asked for, at the
    largest usual scale at which it fits the first page, above a table of the feet.
    """
    model = make_paper_model(document, settings.workshop)
    _write_model(path, model)
    scale = model.tiling.scale
    for ending, layer in make_board_models(document, settings.workshop, scale):
        _write_model(path.with_stem(path.stem + ending), layer)
    plan = print_ground(document, settings.workshop.paper) if settings.ground else None
    if plan is not None:
        _write_plan(ground_beside(path), plan)


def _write_plan(path: Path, plan: PrintedPlan) -> None:
    """The plan of the ground, with the table of its feet."""
    from reportlab.pdfgen.canvas import Canvas

    first, palette = plan.pages[0], load_palette("plain")
    size = (first.width * MM, first.height * MM)
    canvas = Canvas(str(path), pagesize=size, invariant=1, pageCompression=0)
    canvas.setTitle(first.title.encode("cp1252", "replace").decode("cp1252"))
    canvas.setCreator("orishell")
    for page in plan.pages:
        for layer in ORDER:
            pen, (texts, circles, lines) = palette.pens[layer], page.of_layer(layer)
            _pen(canvas, pen.colour, pen.width_mm, ())
            canvas.setFillColor(pen.colour)
            for line in lines:
                drawn = canvas.beginPath()
                add_line(drawn, line.points * MM, closed=line.closed)
                canvas.drawPath(drawn)
            for circle in circles:
                canvas.circle(circle.x * MM, circle.y * MM, circle.radius * MM)
            for text in texts:
                _draw_text(canvas, text, np.zeros(2))
        canvas.showPage()
    canvas.save()


def _write_model(path: Path, model: PaperModel) -> None:
    from reportlab.pdfgen.canvas import Canvas

    tiling = model.tiling
    size = (tiling.page_width * MM, tiling.page_height * MM)
    canvas = Canvas(str(path), pagesize=size, invariant=1, pageCompression=0)
    canvas.setTitle(model.title)
    canvas.setCreator("orishell")
    if len(tiling.pages) > 1:
        _draw_order(canvas, model)
    for number, page in enumerate(tiling.pages, 1):
        _draw_page(canvas, model, page, number)
    canvas.save()


def _draw_page(canvas: Canvas, model: PaperModel, page: Page, number: int) -> None:
    """The part of the model that lies on a page, clipped to its frame, and what is around it."""
    tiling = model.tiling
    origin = np.array([BORDER_MM - page.left, BORDER_MM + FOOT_MM - page.bottom])
    low = np.array([page.left, page.bottom])
    high = low + np.array([tiling.frame_width, tiling.frame_height])
    left, bottom, width, height = (
        MM * mm for mm in (BORDER_MM, BORDER_MM + FOOT_MM, tiling.frame_width, tiling.frame_height)
    )
    canvas.saveState()
    clip = canvas.beginPath()
    clip.rect(left, bottom, width, height)
    canvas.clipPath(clip, stroke=0, fill=0)
    _draw_sheet(canvas, model, origin, 1.0, (low, high))
    canvas.restoreState()
    marks = tiling.marks(page)
    _draw_marks(canvas, marks + origin)
    if len(marks):
        _pen(canvas, PALE, 0.1, (1.0, 1.0))
        canvas.rect(left, bottom, width, height)
    _draw_foot(canvas, model, page, number)
    canvas.showPage()


def _draw_sheet(
    canvas: Canvas, model: PaperModel, origin: Array, size: float, shown: Box | None = None
) -> None:
    """The lines near a box of the model (mm), enlarged by ``size`` about the box's corner."""
    near = _near(model.lows, model.highs, shown)
    middles = np.array([(each.x, each.y) for each in model.circles]).reshape(-1, 2)
    reach = np.array([each.radius for each in model.circles])[:, None]
    holes = np.flatnonzero(_near(middles - reach, middles + reach, shown))
    for layer, (width, dashes) in _styles(model).items():
        _pen(canvas, model.colours[layer], width, dashes if size == 1 else ())
        path = canvas.beginPath()
        for k in np.flatnonzero(near):
            line = model.lines[k]
            if line.layer == layer:
                add_line(path, (line.points * size + origin) * MM, closed=line.closed)
        canvas.drawPath(path)
        for k in holes:
            if model.circles[k].layer == layer:
                x, y = ((middles[k] * size + origin) * MM).tolist()
                canvas.circle(x, y, float(reach[k, 0]) * size * MM)
    if size == 1 and model.texts:
        canvas.setFillColor(model.colours["ENGRAVE"])
        # No letter is wider than it is high, or its descender deeper.
        reach = np.array([(len(text.words) + 1) * text.height for text in model.texts])[:, None]
        middles = np.array([(text.x, text.y) for text in model.texts])
        for k in np.flatnonzero(_near(middles - reach, middles + reach, shown)):
            _draw_text(canvas, model.texts[k], origin)


def _near(lows: Array, highs: Array, shown: Box | None) -> Booleans:
    """Which boxes (N,) come within a millimetre of a box; all if there is none."""
    if shown is None:
        return np.ones(len(lows), dtype=np.bool_)
    return np.asarray(((highs >= shown[0] - 1) & (lows <= shown[1] + 1)).all(axis=1))


def _draw_text(canvas: Canvas, text: Text, origin: Array) -> None:
    words = text.words.encode("cp1252", "replace").decode("cp1252")
    canvas.saveState()
    canvas.setFont("Helvetica", text.height / CAPITALS * MM)
    canvas.translate((text.x + origin[0]) * MM, (text.y + origin[1]) * MM)
    canvas.rotate(float(np.rad2deg(text.angle)))
    _write(canvas, text.anchor, 0, -0.5 * text.height * MM, words)
    canvas.restoreState()


def _write(canvas: Canvas, anchor: Anchor, x: float, y: float, words: str) -> None:
    draw = {"start": canvas.drawString, "end": canvas.drawRightString}
    draw.get(anchor, canvas.drawCentredString)(x, y, words)


def _draw_marks(canvas: Canvas, places: Array) -> None:
    """Crosses at places (k, 2) of the page."""
    _pen(canvas, INK, 0.15, ())
    for x, y in (places * MM).tolist():
        arm = ARM_MM * MM
        canvas.line(x - arm, y, x + arm, y)
        canvas.line(x, y - arm, x, y + arm)


def _draw_foot(canvas: Canvas, model: PaperModel, page: Page, number: int) -> None:
    tiling = model.tiling
    top, right = BORDER_MM + FOOT_MM - 6.5, tiling.page_width - BORDER_MM
    bar = 0.5 * (tiling.page_width - model.bar_mm)
    _say(canvas, BORDER_MM, top, _cut(model.title, bar - BORDER_MM - BESIDE_MM, 9), 9)
    _say(canvas, BORDER_MM, top - 4, f"{model.says}. Print at 100 %", 8)
    _draw_bar(canvas, model, bar, top)
    if len(tiling.pages) > 1:
        _say(canvas, right, top, f"Page {number} of {len(tiling.pages)}", 9, anchor="end")
        place = f"row {page.row}, column {page.column}"
        _say(canvas, right, top - 4, place, 8, anchor="end")
    else:
        drawn = {line.layer for line in model.lines}
        folds: dict[Layer, str] = {"MOUNTAIN": "mountain", "VALLEY": "valley"}
        if drawn & folds.keys() and "ENGRAVE" in drawn:
            folds["ENGRAVE"] = MEANINGS["ENGRAVE"]
        lows = np.linspace(top, top - 5.5, len(folds)).tolist()
        for y, (layer, meaning) in zip(lows, folds.items(), strict=True):
            _sample(canvas, model, layer, (right - 32, right - 17), y + 0.9)
            _say(canvas, right - 15, y, meaning, 8)


def _draw_bar(canvas: Canvas, model: PaperModel, left: float, bottom: float) -> None:
    """A bar of exactly the length that is written below it."""
    _pen(canvas, INK, 0.25, ())
    y = (bottom + 1.2) * MM
    canvas.line(left * MM, y, (left + model.bar_mm) * MM, y)
    for share in (0.0, 0.5, 1.0):
        x = (left + share * model.bar_mm) * MM
        canvas.line(x, y, x, y + (2.0 if share != 0.5 else 1.2) * MM)
    _say(canvas, left + 0.5 * model.bar_mm, bottom - 3, model.bar_says, 8, anchor="middle")


def _draw_order(canvas: Canvas, model: PaperModel) -> None:
    """The first page: how the others lie, what the lines mean, what to do."""
    tiling = model.tiling
    left, right = BORDER_MM, tiling.page_width - BORDER_MM
    y = tiling.page_height - BORDER_MM - 6
    _say(canvas, left, y, _cut(model.title, right - left, 16), 16)
    wide, high = model.size.tolist()
    pages = f"{len(tiling.pages)} pages"
    _say(canvas, left, y - 8, f"{model.says}, {wide:.0f} x {high:.0f} mm on {pages}", 11)
    words = [
        "Print at 100 % (no fitting to the page) and measure the bar.",
        f"Neighbouring pages share a strip of {OVERLAP_MM:g} mm: cut one of them along its dashed "
        "frame,",
        "lay it on the other so that the crosses meet, and glue. Then score, cut and fold.",
    ]
    for k, line in enumerate(words):
        _say(canvas, left, y - 16 - 5 * k, line, 9)
    for k, (layer, meaning) in enumerate(MEANINGS.items()):
        low = y - 36 - 5.5 * k
        _sample(canvas, model, layer, (left, left + 30), low + 1.1)
        _say(canvas, left + 34, low, meaning, 9)
    _draw_bar(canvas, model, left, BORDER_MM + 5)

    frames = np.array([[page.left, page.bottom] for page in tiling.pages])
    frame = np.array([tiling.frame_width, tiling.frame_height])
    low = frames.min(axis=0)
    extent = frames.max(axis=0) + frame - low
    room = np.array([right - left, y - 64 - (BORDER_MM + 16)])
    size = float((room / extent).min())
    origin = np.array([left, BORDER_MM + 16]) + 0.5 * (room - size * extent) - size * low
    _draw_sheet(canvas, model, origin, size)
    for number, corner in enumerate(frames, 1):
        x, base = (corner * size + origin).tolist()
        _pen(canvas, PALE, 0.2, ())
        canvas.rect(x * MM, base * MM, *(frame * size * MM).tolist())
        _say(canvas, x + 1.5, base + size * frame[1] - 6, str(number), 14)
    canvas.showPage()


def _styles(model: PaperModel) -> dict[Layer, tuple[float, tuple[float, ...]]]:
    return STYLES if model.scored else CUT_STYLES


def _sample(
    canvas: Canvas, model: PaperModel, layer: Layer, ends: tuple[float, float], y: float
) -> None:
    width, dashes = _styles(model)[layer]
    _pen(canvas, model.colours[layer], width, dashes)
    canvas.line(ends[0] * MM, y * MM, ends[1] * MM, y * MM)


def _pen(canvas: Canvas, colour: str, width: float, dashes: Sequence[float]) -> None:
    canvas.setStrokeColor(colour)
    canvas.setLineWidth(width * MM)
    canvas.setLineJoin(1)
    canvas.setDash([length * MM for length in dashes])


def _say(
    canvas: Canvas, x: float, y: float, words: str, points: float, *, anchor: Anchor = "start"
) -> None:
    """Words on the page, their baseline at (x, y) in mm."""
    canvas.setFillColor(INK)
    canvas.setFont("Helvetica", points)
    _write(canvas, anchor, x * MM, y * MM, words)


def _cut(words: str, room: float, points: float) -> str:
    """Words that are no wider than the room (mm) in Helvetica of so many points."""
    from reportlab.pdfbase.pdfmetrics import stringWidth

    def wide(text: str) -> float:
        return float(stringWidth(text, "Helvetica", points)) / MM

    shown = words
    while shown and wide(words if shown == words else shown + "...") > room:
        shown = shown[:-1]
    return words if shown == words else shown + "..."


FORMAT = Format(
    "pdf", "pattern.pdf", (".pdf",), "paper model, tiled over pages", write_pdf, task="paper"
)
