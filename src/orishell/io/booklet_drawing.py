"""What is drawn and written on a page of the booklet."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.workshop.kit.line_drawing import LineDrawing

SMALLEST_LETTERS = 9.0
"""Size of the smallest letters (points)."""
LEADING = 1.35
"""From line to line, in sizes of letters."""
BACK = 0.88
"""How light the back of the sheet is."""
BESIDE = 0.6
"""How light parts beside the sheet are."""
DOT = 2.2 * np.array([[np.cos(turn), np.sin(turn)] for turn in np.linspace(0, 2 * np.pi, 13)[:-1]])
"""What marks a foot."""


@dataclass(frozen=True, slots=True)
class Said:
    """A line of words, its baseline at (x, y)."""

    x: float
    y: float
    words: str
    size: float
    bold: bool = False
    anchor: Literal["start", "end"] = "start"


@record
class Drawn:
    """A line or a panel."""

    points: Array  # (k, 2)
    closed: bool = True
    fill: float | None = None  # how light it is, from 0 to 1; None where it is not filled
    dashed: bool = False
    thick: bool = False  # whether it is drawn over others, as what is dashed is


DASHES = (4.0, 2.5)
"""Lengths of dashes and gaps (points)."""
SHORTEST = 0.1
"""A line that is shorter is a point (points)."""


def dashes_of(points: Array) -> tuple[float, float]:
    """Lengths of dashes and gaps of a line (k, 2), about :data:`DASHES`.

    It begins and ends with a dash, and has a gap however short it is: else a short one would look
    whole.
    """
    dash, gap = DASHES
    length = max(float(np.hypot(*np.diff(points, axis=0).T).sum()), SHORTEST)
    gaps = max(1, round((length - dash) / (dash + gap)))
    size = length / (gaps * (dash + gap) + dash)
    return round(size * dash, 3), round(size * gap, 3)


def width_of(said: Said) -> float:
    """Width of a line of words."""
    from reportlab.pdfbase.pdfmetrics import stringWidth

    font = "Helvetica-Bold" if said.bold else "Helvetica"
    return float(stringWidth(said.words, font, said.size))


def set_lines(
    x: float, y: float, texts: Iterable[str], size: float, wide: float, *, bold: bool = False
) -> Iterator[Said]:
    """Texts below each other, broken where they would be wider; an empty one leaves a gap."""

    def fits(words: str) -> bool:
        return width_of(Said(x, y, words, size, bold)) <= wide

    for text in texts:
        text = text.encode("cp1252", "replace").decode("cp1252")  # noqa: PLW2901
        line = ""
        for word in _broken(text, fits):
            longer = f"{line} {word}" if line else word
            if line and not fits(longer):
                yield Said(x, y, line, size, bold)
                y -= LEADING * size
                line = word
            else:
                line = longer
        if line:
            yield Said(x, y, line, size, bold)
        y -= LEADING * size


def _broken(text: str, fits: Callable[[str], bool]) -> Iterator[str]:
    """Words, and those that do not fit by themselves in parts that do."""
    for word in text.split():
        part = ""
        for letter in word:
            if part and not fits(part + letter):
                yield part
                part = ""
            part += letter
        yield part


def picture(
    drawing: LineDrawing, corner: tuple[float, float], room: tuple[float, float]
) -> Iterator[Drawn]:
    """Panels in the middle of a room, as large as they fit."""
    move, scale = fitted(drawing.box, corner, room)
    panels = np.round(drawing.outlines * scale + move, 2)
    kinds = zip(panels, drawing.fronts.tolist(), drawing.beside.tolist(), strict=True)
    for outline, front, beside in kinds:
        yield Drawn(outline, fill=BESIDE if beside else 1.0 if front else BACK)
    for line in np.round(drawing.lines * scale + move, 2):
        yield Drawn(line, closed=False, dashed=True)
    for crease in np.round(drawing.mountains * scale + move, 2):
        yield Drawn(crease, closed=False, thick=True)
    for crease in np.round(drawing.valleys * scale + move, 2):
        yield Drawn(crease, closed=False, dashed=True)
    for point in np.round(drawing.points * scale + move, 2):
        yield Drawn(point + DOT, fill=0.0)


def outlines(
    lines: tuple[Array, ...], corner: tuple[float, float], room: tuple[float, float]
) -> Iterator[Drawn]:
    """Polylines (k, 2) in the middle of a room, as large as they fit."""
    if not lines:
        return
    points = np.concatenate(lines)
    move, scale = fitted((points.min(axis=0), points.max(axis=0)), corner, room)
    for line in lines:
        yield Drawn(np.round(line * scale + move, 2), closed=False)


def named_corners(corners: Iterable[tuple[str, Array]], drawn: Sequence[Drawn]) -> Iterator[Said]:
    """Names at corners (2,) of what is drawn, outside of it; one that has no room is left out."""
    import shapely

    lines = shapely.union_all([shapely.LineString(each.points) for each in drawn])
    left, bottom, right, top = lines.bounds
    for name, (x, y) in corners:
        before, below = x < 0.5 * (left + right), y < 0.5 * (bottom + top)
        said = Said(
            x + (-4 if before else 4),
            y + (-8 if below else 3),
            name,
            SMALLEST_LETTERS,
            anchor="end" if before else "start",
        )
        wide = width_of(said)
        start = said.x - wide if before else said.x
        box = shapely.box(start - 1, said.y - 2, start + wide + 1, said.y + SMALLEST_LETTERS)
        if not shapely.intersects(lines, box):
            yield said


def fitted(
    around: tuple[Array, Array], corner: tuple[float, float], room: tuple[float, float]
) -> tuple[Array, float]:
    """How far a drawing is moved once it is enlarged, and how much it is."""
    (low, high), space = around, np.array(room)
    size = np.maximum(high - low, 1e-12)
    scale = float((space / size).min())
    return np.array(corner) + 0.5 * (space - scale * (low + high)), scale
