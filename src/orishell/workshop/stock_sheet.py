"""One sheet of stock with the parts that are cut from it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from orishell.workshop.drawing import ORDER, Circle, Drawing, Line, Text
from orishell.workshop.placing import Content, Placement
from orishell.workshop.settings import Workshop

LETTERS = 0.4
"""Height of the words in the margin, as a share of its width."""


def draw_stock_sheet(
    parts: Iterable[tuple[Content, Placement]], title: str, unit: str, workshop: Workshop
) -> Drawing:
    """A drawing exactly of the stock's size, in the order of work: marks, creases, holes, cuts.

    Parameters
    ----------
    parts
        What is drawn of every part, in its own coordinates, and where it lies within the margins.
    title
        What stands in the margin, if there is one.
    unit
        Unit of length.
    """
    if workshop.stock is None:
        raise AssertionError("only stock is drawn sheet by sheet")
    lines: list[Line] = []
    circles: list[Circle] = []
    texts: list[Text] = []
    for content, placement in parts:
        place = replace(placement, shift=placement.shift + workshop.margin)
        placed = place.move_all(content)
        lines += placed[0]
        circles += placed[1]
        texts += placed[2]
    if workshop.title_block and workshop.margin > 0:
        wide, high = workshop.stock
        says = f"{title}, 1:1 on {wide:g} x {high:g} {unit}"
        texts.append(_margin_words(says, wide, workshop.margin))
    lines.sort(key=lambda line: ORDER.index(line.layer))
    return Drawing(title, unit, *workshop.stock, tuple(lines), tuple(circles), tuple(texts))


def _margin_words(words: str, width: float, margin: float) -> Text:
    height = min(LETTERS * margin, (width - 2 * margin) / len(words))
    return Text("LABEL", margin, margin / 2, height, words, anchor="start")
