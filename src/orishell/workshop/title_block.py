"""The title block below a drawing: title, scale, and a legend of layers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from orishell.conventions.errors import printable
from orishell.conventions.quantities import MILLIMETRES
from orishell.conventions.version import __version__
from orishell.document import Document
from orishell.numerics.arrays import Array
from orishell.workshop.creases import dash_length
from orishell.workshop.cut_parts import CutPart
from orishell.workshop.palettes import LAYERS, Anchor, Drawing, Layer, Line, Palette, Text
from orishell.workshop.settings import Workshop

SMALLEST_MM = 2.0
"""Height of the smallest letters (mm)."""
LETTERS = 130
"""Heights of letters that make up the width of a wide sheet."""
TITLE, SCALE, LEGEND = 50.0, 30.0, 36.0
"""Least widths of the three cells, in letters."""

_WIDTH, _ROW, _PADDING = 0.9, 2.0, 1.5
"""Width of a character, from line to line, from a cell's frame to what is in it (in letters)."""

_DECIMALS = {"mm": 1, "cm": 2, "m": 3, "in": 2, "ft": 3}


def letter_height(width: float, unit: str) -> float:
    """Height of the letters below a sheet of a width (both in the unit)."""
    return max(SMALLEST_MM / MILLIMETRES[unit], width / LETTERS)


def draw_title_block(
    facts: Sequence[str],
    palette: Palette,
    *,
    drawn: Drawing,
    letter: float,
    scale: str = "1:1",
    legend: Sequence[tuple[str, str, str]] = (),
) -> Drawing:
    """The title block of what is drawn, with its lower left corner at (0, 0).

    Its cells stand side by side where the sheet is wide enough, otherwise the title above. Below
    the title it says ``facts``, line by line. ``legend`` takes the place of that of the layers.
    """
    rows = list(legend) or _legend_rows(drawn, palette)
    high = 2 * _PADDING + len(rows) * _ROW - 1.0
    width = max(drawn.width / letter, SCALE + LEGEND)
    if width >= TITLE + SCALE + LEGEND:
        top = high
        first = _Cell(letter, 0.0, 0.0, width - SCALE - LEGEND, high)
    else:
        top = high + 2 * _PADDING + (len(facts) + 1) * _ROW + 0.5
        first = _Cell(letter, 0.0, high, width, top - high)
    left = width - LEGEND
    bar = _Cell(letter, first.width % width, 0.0, left - first.width % width, high)
    cells = [first, bar, _Cell(letter, left, 0.0, LEGEND, high)]
    for cell in cells:
        cell.box(0.0, 0.0, cell.width, cell.height)
    _title(cells[0], drawn.title, facts)
    _scale(cells[1], drawn.unit, scale)
    _legend(cells[2], rows)
    lines = tuple(line for cell in cells for line in cell.lines)
    texts = tuple(text for cell in cells for text in cell.texts)
    return Drawing(drawn.title, drawn.unit, width * letter, top * letter, lines, (), texts)


def round_length(most: float) -> float:
    """The largest of 1, 2 and 5 times a power of ten that is no more than ``most``."""
    power = 10.0 ** math.floor(math.log10(most))
    digit = max(d for d in (1, 2, 5) if d * power <= most * (1 + 1e-9))
    return float(f"{digit * power:.3g}")


@dataclass(slots=True)
class _Cell:
    """A cell of the title block; draws from its lower left corner, in heights of letters."""

    letter: float
    x: float
    y: float
    width: float
    height: float
    lines: list[Line] = field(default_factory=list)
    texts: list[Text] = field(default_factory=list)

    def line(self, *points: tuple[float, float], closed: bool = False) -> None:
        placed = self.letter * (np.array(points) + np.array([self.x, self.y]))
        self.lines.append(Line("LABEL", placed, closed))

    def box(self, x: float, y: float, width: float, height: float) -> None:
        right, top = x + width, y + height
        self.line((x, y), (right, y), (right, top), (x, top), closed=True)

    def write(
        self, x: float, y: float, words: str, *, anchor: Anchor = "start", height: float = 1.0
    ) -> None:
        place = (x + self.x) * self.letter, (y + self.y) * self.letter
        self.texts.append(Text("LABEL", *place, height * self.letter, words, 0.0, anchor))


def _title(cell: _Cell, title: str, facts: Sequence[str]) -> None:
    room = cell.width - 2 * _PADDING
    size = min(1.8, room / (_WIDTH * max(len(title), 1)))
    cell.write(_PADDING, cell.height - _PADDING - 0.9, title, height=size)
    for number, fact in enumerate(reversed(facts)):
        size = min(1.0, room / (_WIDTH * len(fact)))
        cell.write(_PADDING, _PADDING + 0.5 + number * _ROW, fact, height=size)


def _scale(cell: _Cell, unit: str, scale: str) -> None:
    top, right = cell.height - _PADDING - 0.5, cell.width - _PADDING
    cell.write(_PADDING, top, f"SCALE {scale}")
    cell.write(right, top, f"UNIT {unit}", anchor="end")
    length = round_length(cell.letter * (SCALE - 4 * _PADDING))
    parts = 4 if f"{length:e}"[0] == "2" else 5
    bar, low, thick = length / cell.letter, 0.4 * cell.height, 1.0
    left, step = 0.5 * (cell.width - bar), bar / parts
    cell.box(left, low, bar, thick)
    for number in range(parts):
        at = left + number * step
        if number:
            cell.line((at, low - 0.4), (at, low + thick))
        if number % 2 == 0:
            cell.line((at, low + 0.5 * thick), (at + step, low + 0.5 * thick))
    for at, words in ((left, "0"), (left + bar, f"{length:g} {unit}")):
        cell.line((at, low - 0.8), (at, low))
        cell.write(at, low - 2.0, words, anchor="middle")


def _legend(cell: _Cell, rows: list[tuple[str, str, str]]) -> None:
    right = cell.width - _PADDING
    places = _PADDING, _PADDING + 10.5, right
    anchors: tuple[Anchor, ...] = ("start", "start", "end")
    for number, row in enumerate(rows):
        y = cell.height - _PADDING - 0.5 - number * _ROW
        for x, anchor, words in zip(places, anchors, row, strict=True):
            cell.write(x, y, words, anchor=anchor)


def _legend_rows(drawn: Drawing, palette: Palette) -> list[tuple[str, str, str]]:
    """Headings; then name, colour and length of every layer."""
    rows = [("LAYER", "COLOUR", "LENGTH")]
    for layer in LAYERS:
        pen = palette.pens.get(layer)
        length = _quoted(_drawn_length(drawn, layer), drawn.unit)
        where = "not on the work" if layer == "LABEL" else length
        rows.append((layer, pen.colour if pen else "left out", where))
    return rows


def _drawn_length(drawn: Drawing, layer: Layer) -> float:
    _, circles, lines = drawn.of_layer(layer)
    total = sum(2 * math.pi * circle.radius for circle in circles)
    for line in lines:
        points = np.concatenate([line.points, line.points[: int(line.closed)]])
        total += float(np.hypot(*np.diff(points, axis=0).T).sum())
    return total


def sheet_facts(
    document: Document, part: CutPart, size: Array, workshop: Workshop
) -> tuple[str, ...]:
    """What the title block says of a part of the sheet, drawn in a size (2,)."""
    folding = sum(document.assignment[edge] in "MV" for edge in part.creases.tolist())
    made = "scored"
    if workshop.creases != "score":
        how = {"dashes": "cut in dashes of", "perforation": "perforated every"}[workshop.creases]
        dash = f"{dash_length(document, workshop):.3g} {document.unit}"
        made = f"{how} {dash}, {workshop.duty:.0%} cut"
    if workshop.relief_hole:
        made += f"; holes of {workshop.relief_hole:g} {document.unit}"
    return (
        f"{len(part.panels)} panels, {folding} creases that fold, "
        f"{quoted_size(size, document.unit)}",
        f"Creases {made}",
        "Mountains rise towards this side of the sheet",
    )


def quoted_size(size: Array, unit: str) -> str:
    """Width and height (2,) in words."""
    return f"{decimal(float(size[0]), unit)} × {_quoted(float(size[1]), unit)}"


def program_and_palette(workshop: Workshop) -> str:
    """By what a drawing was made, and for which machine."""
    return f"orishell {__version__}, palette {printable(Path(workshop.palette).stem)}"


def decimal(length: float, unit: str) -> str:
    """A length as drawings have it, without its unit."""
    return f"{round(length, _DECIMALS[unit]) + 0.0:.{_DECIMALS[unit]}f}"


def _quoted(length: float, unit: str) -> str:
    return f"{decimal(length, unit)} {unit}"
