"""The pages of the booklet: what is drawn on each, and where."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from orishell.conventions.quantities import box, plain
from orishell.conventions.record import record
from orishell.document import SHELL, Document
from orishell.numerics.arrays import Array
from orishell.workshop import Workshop
from orishell.workshop.kit.facts import KitFacts, find_facts
from orishell.workshop.kit.line_drawing import LineDrawing, draw_lines
from orishell.workshop.kit.parts import KitPart, kit_parts, kit_tools
from orishell.workshop.kit.steps import Step, kit_steps, pack_boxes, pack_words
from orishell.workshop.kit.words import Words, load_words

WIDE, HIGH = 595.28, 841.89
"""An upright page of A4, in points, as all lengths here."""
SIDE, TOP, FOOT = 56.0, 60.0, 60.0
"""What is left white."""
BODY, HEAD, TITLE = 10.0, 13.0, 24.0
SMALL = 9.0
"""Sizes of letters."""
LEADING = 1.35
"""From line to line, in sizes of letters."""
BACK = 0.88
"""How light the back of the sheet is."""
PICTURE = 210.0
"""Width and height of the picture of a step."""
STEPS = 3
"""On a page."""
PART = 56.0
"""Height of a part in the list."""


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


@record
class BookletPage:
    """What is on a page, in the order in which it is drawn, words last."""

    drawn: tuple[Drawn, ...]
    said: tuple[Said, ...]


def booklet_pages(document: Document, workshop: Workshop) -> tuple[BookletPage, ...]:
    """All pages: cover, parts with tools, steps, and how it is packed."""
    words, facts = load_words(workshop.language), find_facts(document)
    parts, steps = kit_parts(document, workshop, facts), kit_steps(document, facts)
    book = _Book(document, facts, words)
    pages = [book.cover(parts, steps), book.parts(parts)]
    for first in range(0, len(steps), STEPS):
        pages.append(book.steps(steps[first : first + STEPS], first))
    if facts.packs and facts.starts_packed and not facts.model:
        pages.append(book.packing(parts))
    count = len(pages)
    return tuple(
        replace(page, said=(*page.said, _number(words, number, count)))
        for number, page in enumerate(pages, 1)
    )


def _number(words: Words, number: int, count: int) -> Said:
    said = words.say("titles.page", number=number, count=count)
    return Said(WIDE - SIDE, FOOT - 24, said, SMALL, anchor="end")


class _Book:
    """Makes pages of what is known of a shell."""

    def __init__(self, document: Document, facts: KitFacts, words: Words) -> None:
        self.document, self.facts, self.words = document, facts, words
        self.unit = document.unit

    def cover(self, parts: tuple[KitPart, ...], steps: tuple[Step, ...]) -> BookletPage:
        """The shell at its target, and its sizes."""
        facts, say = self.facts, self.words.say
        name, _, rest = self.document.title.partition(": ")
        drawing = draw_lines(self.document, SHELL)
        lines = [rest] * bool(rest)
        if self.document.model_scale is not None:
            ratio = f"1:{plain(1 / self.document.model_scale)}"
            lines.append(say("cover.model", scale=ratio))
        lines += ["", say("cover.opened", size=box(facts.opened, self.unit))]
        if facts.packs and facts.starts_packed:
            key = "cover.packed" if facts.construction else "cover.packed_bare"
            sizes = pack_words(facts, self.unit)
            lines.append(say(key, size=sizes, layers=facts.layers))
        lines.append(say("cover.sheet", size=box(facts.sheet, self.unit)))
        if facts.mass is not None:
            lines.append(say("cover.mass", mass=f"{plain(facts.mass, 3)} kg"))
        lines.append(
            say("cover.panels", count=len(self.document.mesh.faces) + facts.clipped_panels)
        )
        boards = sum(part.count for part in parts if part.name in ("top", "bottom", "solid"))
        if boards:
            lines.append(say("cover.parts", count=boards))
        lines.append(say("cover.steps", count=len(steps)))
        if boards:
            lines.append(say("cover.thin"))
        if drawing.every > 1:
            lines.append(say("cover.coarse", every=drawing.every))
        title = [*_lines(SIDE, HIGH - TOP - TITLE, [name], TITLE, WIDE - 2 * SIDE, bold=True)]
        top = title[-1].y - 30
        said = [*title, *_lines(SIDE, top, lines, BODY + 1, WIDE - 2 * SIDE)]
        room = said[-1].y - 24 - FOOT
        picture = _picture(drawing, (SIDE, FOOT), (WIDE - 2 * SIDE, room))
        return BookletPage(tuple(picture), tuple(said))

    def parts(self, parts: tuple[KitPart, ...]) -> BookletPage:
        """The parts with their counts, and the tools."""
        say, y = self.words.say, HIGH - TOP - TITLE
        said = [Said(SIDE, y, say("titles.parts"), TITLE - 6, bold=True)]
        drawn: list[Drawn] = []
        y -= 16
        for part in parts:
            corner = (SIDE, y - PART + 8)
            drawn += _outlines(part.picture, corner, (70, PART - 16))
            left = SIDE + 92
            middle = y - 0.5 * PART
            said += [
                Said(left, middle, say("times", count=part.count), HEAD, bold=True),
                Said(left + 64, middle + 4, say(f"parts.{part.name}"), BODY + 1, bold=True),
                *_lines(left + 64, middle - 10, [self._note(part)], BODY, WIDE - SIDE - left - 64),
            ]
            y -= PART
        y -= 24
        said.append(Said(SIDE, y, say("titles.tools"), TITLE - 6, bold=True))
        tools = [
            f"- {say(f'tools.{name}', **values)}"
            for name, values in kit_tools(self.document, self.facts, parts)
        ]
        said += _lines(SIDE, y - 22, tools, BODY + 1, WIDE - 2 * SIDE)
        return BookletPage(tuple(drawn), tuple(said))

    def _note(self, part: KitPart) -> str:
        """What is said of a part beside its count."""
        bare = {"membrane": not self.facts.flaps, "flap": not self.facts.construction}
        key = f"parts.{part.name}_plain_note" if bare.get(part.name) else f"parts.{part.name}_note"
        return self.words.say(key, **part.values)

    def steps(self, steps: tuple[Step, ...], before: int) -> BookletPage:
        """Some steps one below the other, the first of them after so many others."""
        drawn: list[Drawn] = []
        said: list[Said] = []
        high = (HIGH - TOP - FOOT) / STEPS
        for k, step in enumerate(steps):
            top = HIGH - TOP - k * high
            if k:
                rule = np.array([[SIDE, top], [WIDE - SIDE, top]])
                drawn.append(Drawn(rule, closed=False))
            said += self._step(step, before + k + 1, top - 22)
            if step.state is not None:
                corner = (WIDE - SIDE - PICTURE, top - high + 12)
                seen = draw_lines(
                    self.document, step.state, step.panels, step.joined, plan=step.plan
                )
                drawn += _picture(seen, corner, (PICTURE, high - 24))
        return BookletPage(tuple(drawn), tuple(said))

    def _step(self, step: Step, number: int, y: float) -> Iterator[Said]:
        say, table = self.words.say, f"steps.{step.name}"
        wide = WIDE - 2 * SIDE - PICTURE - 20
        yield Said(SIDE, y, f"{number}  {say(f'{table}.title')}", HEAD, bold=True)
        text = [*_lines(SIDE, y - 22, [say(f"{table}.text", **step.values)], BODY, wide)]
        yield from text
        own = (
            step.check in ("", "diagonals", "none")
            and "check" in self.words.tables["steps"][step.name]
        )
        if step.check == "none" and step.name != "lay_out":
            return
        key = f"{table}.check" if own else f"checks.{step.check}"
        said = f"{say('check')}: {say(key, **step.values)}"
        yield from _lines(SIDE, text[-1].y - 20, [said], BODY, wide, bold=True)

    def packing(self, parts: tuple[KitPart, ...]) -> BookletPage:
        """The boxes that packs need, and the mass."""
        say, facts = self.words.say, self.facts
        y = HIGH - TOP - TITLE
        text = "packing.text" if facts.construction else "packing.text_bare"
        lines = [say(text, layers=facts.layers), ""]
        lines += [
            say("packing.one", number=number, size=sides)
            for number, sides in enumerate(pack_boxes(facts, self.unit), 1)
        ]
        loose = [
            f"{say('times', count=part.count)} {say(f'parts.{part.name}')}"
            for part in parts
            if part.name == "flap" or (part.name == "tie" and not facts.ties_early)
        ]
        if loose:
            lines.append(say("packing.beside", what=", ".join(loose)))
        if facts.mass is not None:
            lines += ["", say("packing.mass", mass=f"{plain(facts.mass, 3)} kg")]
        title = Said(SIDE, y, say("titles.packing"), TITLE - 6, bold=True)
        said = [title, *_lines(SIDE, y - 26, lines, BODY + 1, WIDE - 2 * SIDE)]
        piece = facts.pieces[0] if len(facts.pieces) > 1 else None
        drawing = draw_lines(self.document, "pack", piece)
        room = said[-1].y - 30 - FOOT
        picture = _picture(drawing, (SIDE, FOOT), (WIDE - 2 * SIDE, room))
        return BookletPage(tuple(picture), tuple(said))


def width_of(said: Said) -> float:
    """Width of a line of words."""
    from reportlab.pdfbase.pdfmetrics import stringWidth

    font = "Helvetica-Bold" if said.bold else "Helvetica"
    return float(stringWidth(said.words, font, said.size))


def _lines(
    x: float, y: float, texts: Iterable[str], size: float, wide: float, *, bold: bool = False
) -> Iterator[Said]:
    """Texts below each other, broken where they would be wider; an empty one leaves a gap."""
    for text in texts:
        text = text.encode("cp1252", "replace").decode("cp1252")  # noqa: PLW2901
        line = ""
        for word in text.split():
            longer = f"{line} {word}" if line else word
            if line and width_of(Said(x, y, longer, size, bold)) > wide:
                yield Said(x, y, line, size, bold)
                y -= LEADING * size
                line = word
            else:
                line = longer
        if line:
            yield Said(x, y, line, size, bold)
        y -= LEADING * size


def _picture(
    drawing: LineDrawing, corner: tuple[float, float], room: tuple[float, float]
) -> Iterator[Drawn]:
    """Panels in the middle of a room, as large as they fit."""
    move, scale = _fitted(drawing.box, corner, room)
    outlines = np.round(drawing.outlines * scale + move, 2)
    for outline, front in zip(outlines, drawing.fronts.tolist(), strict=True):
        yield Drawn(outline, fill=1.0 if front else BACK)
    for line in np.round(drawing.lines * scale + move, 2):
        yield Drawn(line, closed=False, dashed=True)


def _outlines(
    lines: tuple[Array, ...], corner: tuple[float, float], room: tuple[float, float]
) -> Iterator[Drawn]:
    if not lines:
        return
    points = np.concatenate(lines)
    move, scale = _fitted((points.min(axis=0), points.max(axis=0)), corner, room)
    for line in lines:
        yield Drawn(np.round(line * scale + move, 2), closed=False)


def _fitted(
    around: tuple[Array, Array], corner: tuple[float, float], room: tuple[float, float]
) -> tuple[Array, float]:
    """How far a drawing is moved once it is enlarged, and how much it is."""
    (low, high), space = around, np.array(room)
    size = np.maximum(high - low, 1e-12)
    scale = float((space / size).min())
    return np.array(corner) + 0.5 * (space - scale * (low + high)), scale
