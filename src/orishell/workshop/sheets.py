"""The drawings that a workshop cuts: one as large as the sheet, or as many as the stock asks for.

A sheet larger than the stock is laid out on it in parts (:mod:`~orishell.workshop.layout`); a map
says how they go together (:mod:`~orishell.workshop.assembly`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from orishell.document import Document
from orishell.workshop.assembly import draw_map, number_text
from orishell.workshop.clipped import with_clipped
from orishell.workshop.draw import draw_part, part_lines, require_drawable
from orishell.workshop.drawing import ORDER, Circle, Drawing, Line, Text
from orishell.workshop.layout import Layout, lay_out
from orishell.workshop.outline import signed_areas, whole_sheet
from orishell.workshop.settings import Workshop

LETTERS = 0.4
"""Height of the words in the margin, as a share of its width."""


@dataclass(frozen=True, slots=True)
class Waste:
    """How much stock is used, and the length of cuts and creases, in the document's unit.

    Parameters
    ----------
    sheets
        Number of sheets of stock.
    stock_area
        Their area; without stock, that of the sheet's bounding rectangle along the axes.
    used_area
        Area of all parts, with tabs and strips.
    waste
        Share of the stock that is not used.
    cut_length
        Length of all outlines that are cut.
    crease_length
        Length of all creases, those of tabs and strips too.
    """

    sheets: int
    stock_area: float
    used_area: float
    waste: float
    cut_length: float
    crease_length: float


def draw_sheets(document: Document, workshop: Workshop) -> tuple[Drawing, ...]:
    """The drawings to be cut, one for each sheet of stock.

    Without stock, or if the sheet fits it as it is, there is one drawing. Otherwise the first
    one is a map of the whole sheet with the numbers of parts and the names of joints, and not
    to be cut; it is followed by a drawing for every sheet of stock, exactly of its size.

    Parameters
    ----------
    workshop
        The stock, its margin, and how creases and joints are made.

    Raises
    ------
    InputError
        If there is no flat sheet or no unit, or a panel does not fit the stock.
    """
    everything = with_clipped(document)
    if workshop.stock is None:
        return (draw_part(everything, whole_sheet(everything), workshop),)
    require_drawable(everything)
    layout = lay_out(document, workshop)
    drawings = tuple(
        _draw_sheet(everything, workshop, layout, number) for number in range(layout.sheets)
    )
    if len(layout.parts) == 1:
        return drawings
    return (draw_map(document, layout.parts, layout.joints, workshop, layout.sheets), *drawings)


def draw_sheet_files(
    path: Path, document: Document, workshop: Workshop
) -> Iterator[tuple[Path, Drawing]]:
    """The drawings of :func:`draw_sheets` and their files: ``path``, then ``-1``, ``-2``, ..."""
    for number, drawing in enumerate(draw_sheets(document, workshop)):
        yield (path.with_stem(f"{path.stem}-{number}") if number else path), drawing


def measure_waste(document: Document, workshop: Workshop) -> Waste:
    """How much stock the sheet needs and wastes, and the length of cuts and creases.

    Raises
    ------
    InputError
        If there is no flat sheet, or a panel does not fit the stock.
    """
    layout = lay_out(document, workshop)
    everything = with_clipped(document)
    flat, edges = everything.require_flat(), everything.mesh.edges
    outlines = [outline for part in layout.parts for outline in part.outlines]
    if workshop.stock is None:
        stock = float(np.prod(np.ptp(np.concatenate(outlines), axis=0)))
    else:
        stock = layout.sheets * workshop.stock[0] * workshop.stock[1]
    used = sum(float(signed_areas(outline)) for outline in outlines)
    around = [outline - np.roll(outline, 1, axis=0) for outline in outlines]
    ends = flat[edges[np.concatenate([part.creases for part in layout.parts])]]
    return Waste(
        sheets=layout.sheets,
        stock_area=stock,
        used_area=used,
        waste=1 - used / stock,
        cut_length=float(sum(np.hypot(*sides.T).sum() for sides in around)),
        crease_length=float(np.hypot(*(ends[:, 1] - ends[:, 0]).T).sum()),
    )


def _draw_sheet(document: Document, workshop: Workshop, layout: Layout, number: int) -> Drawing:
    """One sheet of stock, in the order of work: marks, creases, holes, cuts."""
    if workshop.stock is None or layout.placements is None:
        raise AssertionError("only stock is drawn sheet by sheet")
    lines: list[Line] = []
    circles: list[Circle] = []
    texts: list[Text] = []
    for part, placement in zip(layout.parts, layout.placements, strict=True):
        if placement.sheet != number:
            continue
        drawn_lines, drawn_circles, drawn_texts = part_lines(document, part, workshop)
        if part.number:
            words = number_text(document, part, drawn_texts)
            drawn_texts += (replace(words, angle=-placement.angle),)
        place = replace(placement, shift=placement.shift + workshop.margin)
        placed = place.move_all((drawn_lines, drawn_circles, drawn_texts))
        lines += placed[0]
        circles += placed[1]
        texts += placed[2]
    title = document.title
    if layout.sheets > 1:
        title += f", sheet {number + 1} of {layout.sheets}"
    if workshop.title_block and workshop.margin > 0:
        wide, high = workshop.stock
        says = f"{title}, 1:1 on {wide:g} x {high:g} {document.unit}"
        texts.append(_margin_words(says, wide, workshop.margin))
    lines.sort(key=lambda line: ORDER.index(line.layer))
    return Drawing(
        title, document.unit, *workshop.stock, tuple(lines), tuple(circles), tuple(texts)
    )


def _margin_words(words: str, width: float, margin: float) -> Text:
    height = min(LETTERS * margin, (width - 2 * margin) / len(words))
    return Text("LABEL", margin, margin / 2, height, words, anchor="start")
