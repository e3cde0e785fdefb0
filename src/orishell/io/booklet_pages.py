"""The pages of the booklet: what is drawn on each, and where."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from orishell.conventions.quantities import box, plain
from orishell.conventions.record import record
from orishell.document import SHELL, Document
from orishell.io.booklet_drawing import (
    SMALLEST_LETTERS,
    Drawn,
    Said,
    fitted,
    named_corners,
    outlines,
    picture,
    set_lines,
)
from orishell.workshop import Workshop
from orishell.workshop.kit.facts import KitFacts, corner_panels, find_facts
from orishell.workshop.kit.line_drawing import draw_lines, drawn_state
from orishell.workshop.kit.parts import KitPart, kit_parts, kit_tools
from orishell.workshop.kit.step import Step
from orishell.workshop.kit.steps import carried, kit_steps, pack_boxes
from orishell.workshop.kit.words import Words, load_words

WIDE, HIGH = 595.28, 841.89
"""An upright page of A4, in points, as all lengths here."""
SIDE, TOP, FOOT = 56.0, 60.0, 60.0
"""What is left white."""
BODY, HEAD, TITLE = 10.0, 13.0, 24.0
"""Sizes of letters."""
PICTURE = 210.0
"""Width of the picture of a step."""
STEP = (HIGH - TOP - FOOT) / 3
"""Height of a step with a picture, at least."""
BELOW, WIDER = 150.0, 1.6
"""Height of a picture below its words, at least, and from which width of a sheet, in heights."""
NAMES = 26.0
"""Room beside a plan for names of panels."""
PART = 56.0
"""Height of a part in the list."""
LOOSE = ("flap", "end_wall")
"""Parts that are carried beside the packs."""
THIN, TIE = 0.45, 1.1
"""Widths of lines, and of those that are dashed."""


@record
class BookletPage:
    """What is on a page, in the order in which it is drawn, words last."""

    drawn: tuple[Drawn, ...]
    said: tuple[Said, ...]


def booklet_pages(
    document: Document, workshop: Workshop, *, ground: bool = True
) -> tuple[BookletPage, ...]:
    """All pages: cover, parts with tools, steps, and how it is packed.

    Where feet are marked out is said unless ``ground`` is False.
    """
    document = document.as_cut()
    if not ground:
        document = replace(document, ground=None)
    words, facts = load_words(workshop.language), find_facts(document)
    parts = kit_parts(document, workshop, facts)
    steps = kit_steps(document, workshop, facts, parts)
    book = _Book(document, facts, words)
    pages = [book.cover(parts, steps), book.parts(parts), *book.steps(steps)]
    if facts.packs and facts.starts_packed and not facts.model:
        pages.append(book.packing(parts, steps))
    count = len(pages)
    return tuple(
        replace(page, said=(*page.said, _number(words, number, count)))
        for number, page in enumerate(pages, 1)
    )


def _number(words: Words, number: int, count: int) -> Said:
    said = words.say("titles.page", number=number, count=count)
    return Said(WIDE - SIDE, FOOT - 24, said, SMALLEST_LETTERS, anchor="end")


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
        key = "cover.opened_clipped" if facts.attached else "cover.opened"
        lines += ["", say(key, size=box(facts.whole, self.unit))]
        lines += carried(facts, self.unit, self.words)
        lines.append(say("cover.panels", count=len(self.document.mesh.faces) + facts.flap_panels))
        boards = sum(part.count for part in parts if part.name in ("top", "bottom", "solid"))
        if boards:
            lines.append(say("cover.parts", count=boards))
        lines.append(say("cover.steps", count=len(steps)))
        if boards:
            lines.append(say("cover.thin"))
        if drawing.every > 1:
            lines.append(say("cover.coarse", every=drawing.every))
        title = [*set_lines(SIDE, HIGH - TOP - TITLE, [name], TITLE, WIDE - 2 * SIDE, bold=True)]
        top = title[-1].y - 30
        said = [*title, *set_lines(SIDE, top, lines, BODY + 1, WIDE - 2 * SIDE)]
        room = said[-1].y - 24 - FOOT
        seen = picture(drawing, (SIDE, FOOT), (WIDE - 2 * SIDE, room))
        return BookletPage(tuple(seen), tuple(said))

    def parts(self, parts: tuple[KitPart, ...]) -> BookletPage:
        """The parts with their counts, and the tools."""
        say, y = self.words.say, HIGH - TOP - TITLE
        said = [Said(SIDE, y, say("titles.parts"), TITLE - 6, bold=True)]
        drawn: list[Drawn] = []
        y -= 16
        for part in parts:
            corner = (SIDE, y - PART + 8)
            drawn += outlines(part.picture, corner, (70, PART - 16))
            left = SIDE + 92
            middle = y - 0.5 * PART
            said += [
                Said(left, middle, say("times", count=part.count), HEAD, bold=True),
                Said(left + 64, middle + 4, say(f"parts.{part.name}"), BODY + 1, bold=True),
                *set_lines(
                    left + 64, middle - 10, [self._note(part)], BODY, WIDE - SIDE - left - 64
                ),
            ]
            y -= PART
        y -= 40
        said.append(Said(SIDE, y, say("titles.tools"), TITLE - 6, bold=True))
        tools = [
            f"- {say(f'tools.{name}', **values)}"
            for name, values in kit_tools(self.document, self.facts, parts)
        ]
        said += set_lines(SIDE, y - 22, tools, BODY + 1, WIDE - 2 * SIDE)
        return BookletPage(tuple(drawn), tuple(said))

    def _note(self, part: KitPart) -> str:
        """What is said of a part beside its count."""
        return self.words.say(f"parts.{part.note or f'{part.name}_note'}", **part.values)

    def steps(self, steps: tuple[Step, ...]) -> Iterator[BookletPage]:
        """Steps one below the other, as many on a page as it has room for."""
        drawn: list[Drawn] = []
        said: list[Said] = []
        top = HIGH - TOP
        for number, step in enumerate(steps, 1):
            words = [*self._step(step, number, 0.0)]
            high = 28 - words[-1].y if step.state is None else max(STEP, 28 - words[-1].y)
            if self._below(step):
                high = max(STEP, 28 - words[-1].y + BELOW)
            if said and top - high < FOOT:
                yield BookletPage(tuple(drawn), tuple(said))
                drawn, said, top = [], [], HIGH - TOP
            if said:
                rule = np.array([[SIDE, top], [WIDE - SIDE, top]])
                drawn.append(Drawn(rule, closed=False))
            said += self._step(step, number, top)
            if step.state is not None:
                corner, room = (WIDE - SIDE - PICTURE, top - high + 12), (PICTURE, high - 24)
                if self._below(step):
                    corner, room = (SIDE, corner[1]), (WIDE - 2 * SIDE, high - 40 + words[-1].y)
                seen, names = self._picture(step, corner, room)
                drawn, said = [*drawn, *seen], [*said, *names]
            top -= high
        yield BookletPage(tuple(drawn), tuple(said))

    def _below(self, step: Step) -> bool:
        """Whether its picture stands below its words: that of a wide sheet of card."""
        wide, high = self.facts.sheet
        return self.facts.model and step.plan and wide > WIDER * high

    def _picture(
        self, step: Step, corner: tuple[float, float], room: tuple[float, float]
    ) -> tuple[list[Drawn], list[Said]]:
        """What a step shows, and the names of the panels at the corners of a plan."""
        assert step.state is not None
        drawing = draw_lines(
            self.document,
            step.state,
            step.panels,
            step.joined,
            step.marked,
            thick=step.thick,
            plan=step.plan,
        )
        if not step.plan:
            return [*picture(drawing, corner, room)], []
        corner, room = (corner[0] + NAMES, corner[1] + 12), (room[0] - 2 * NAMES, room[1] - 24)
        seen = [*picture(drawing, corner, room)]
        flat = drawn_state(self.document, step.state).positions[:, :2]
        move, scale = fitted(drawing.box, corner, room)
        faces = self.document.mesh.faces
        corners = (
            (self.document.panel_name(panel), flat[faces[panel, which]] * scale + move)
            for panel, which in corner_panels(self.document, step.panels)
        )
        return seen, [*named_corners(corners, seen)]

    def _step(self, step: Step, number: int, top: float) -> Iterator[Said]:
        say, table = self.words.say, f"steps.{step.name}"
        beside = step.state is not None and not self._below(step)
        wide = WIDE - 2 * SIDE - (PICTURE + 20 if beside else 0)
        yield Said(SIDE, top - 22, f"{number}  {say(f'{table}.title')}", HEAD, bold=True)
        keys = (f"{table}.text", *(f"more.{key}" for key in step.more))
        if step.panels is not None:
            keys += ("more.first_piece",)
        words = " ".join(say(key, **step.values) for key in keys)
        text = [*set_lines(SIDE, top - 44, [words], BODY, wide)]
        yield from text
        if step.check:
            said = f"{say('check')}: {say(f'checks.{step.check}', **step.values)}"
            yield from set_lines(SIDE, text[-1].y - 20, [said], BODY, wide, bold=True)

    def packing(self, parts: tuple[KitPart, ...], steps: tuple[Step, ...]) -> BookletPage:
        """How it is taken down, the boxes that packs need, and the mass."""
        say, facts = self.words.say, self.facts
        y = HIGH - TOP - TITLE
        text = "packing.text" if facts.construction else "packing.text_bare"
        load = next(k for k, step in enumerate(steps, 1) if step.name.startswith("load"))
        back = say("packing.back", last=len(steps), first=load)
        lines = [back, "", say(text, layers=facts.layers), ""]
        lines += [
            say("packing.one", number=number, size=sides)
            for number, sides in enumerate(pack_boxes(facts, self.unit), 1)
        ]
        loose = [
            f"{say('times', count=part.count)} {say(f'parts.{part.name}')}"
            for part in parts
            if part.name in LOOSE or (part.name == "tie" and not facts.ties_early)
        ]
        if loose:
            lines.append(say("packing.beside", what=", ".join(loose)))
        if facts.mass is not None:
            lines += ["", say("packing.mass", mass=f"{plain(facts.mass, 3)} kg")]
        title = Said(SIDE, y, say("titles.packing"), TITLE - 6, bold=True)
        said = [title, *set_lines(SIDE, y - 26, lines, BODY + 1, WIDE - 2 * SIDE)]
        piece = facts.pieces[0] if len(facts.pieces) > 1 else None
        drawing = draw_lines(self.document, "pack", piece)
        room = said[-1].y - 30 - FOOT
        seen = picture(drawing, (SIDE, FOOT), (WIDE - 2 * SIDE, room))
        return BookletPage(tuple(seen), tuple(said))
