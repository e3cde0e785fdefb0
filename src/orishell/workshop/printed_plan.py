"""The plan of the ground on one page of paper."""

from __future__ import annotations

from dataclasses import replace

from orishell.conventions.quantities import MILLIMETRES
from orishell.conventions.record import record
from orishell.document import Document
from orishell.workshop.ground_plan import draw_ground
from orishell.workshop.palettes import Drawing
from orishell.workshop.settings import Paper
from orishell.workshop.tiling import BORDER_MM, PAPERS_MM

SCALES = (1, 2, 5, 10, 20, 25, 50, 100, 200, 250, 500, 1000)
"""The plan is printed at one over one of these, or over ten, a hundred ... times one."""


@record
class PrintedPlan:
    """The plan on a page (mm)."""

    drawing: Drawing  # in mm on paper
    scale: int  # one over this is its scale
    # of the page, upright or not
    width: float
    height: float


def print_ground(document: Document, paper: Paper) -> PrintedPlan | None:
    """The plan on one page of paper, as large as it gets; None for a shell that has no feet."""
    drawing = draw_ground(document)
    if drawing is None:
        return None
    short, long = sorted(PAPERS_MM[paper])
    wide = drawing.width > drawing.height
    page = (long, short) if wide else (short, long)
    true = MILLIMETRES[drawing.unit]
    room = [side - 2 * BORDER_MM for side in page]
    least = max(drawing.width * true / room[0], drawing.height * true / room[1])
    powers = (each * 1000**k for k in range(12) for each in SCALES)
    scale = next(each for each in powers if each >= least)
    named = draw_ground(document, f"1:{scale} ON {paper}")
    assert named is not None
    return PrintedPlan(_in_millimetres(named, true / scale), scale, *page)


def _in_millimetres(drawing: Drawing, factor: float) -> Drawing:
    return Drawing(
        drawing.title,
        "mm",
        drawing.width * factor,
        drawing.height * factor,
        tuple(replace(line, points=line.points * factor) for line in drawing.lines),
        tuple(
            replace(each, x=each.x * factor, y=each.y * factor, radius=each.radius * factor)
            for each in drawing.circles
        ),
        tuple(
            replace(each, x=each.x * factor, y=each.y * factor, height=each.height * factor)
            for each in drawing.texts
        ),
    )
