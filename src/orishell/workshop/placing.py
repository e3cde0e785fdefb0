"""Where parts lie on sheets of stock, and what is drawn of such a sheet."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import chain
from typing import TypeVar

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.workshop.palettes import ORDER, Anchor, Circle, Drawing, Line, Text
from orishell.workshop.settings import Workshop

Content = tuple[tuple[Line, ...], tuple[Circle, ...], tuple[Text, ...]]

Mark = TypeVar("Mark", Circle, Text)


@record
class Placement:
    """Where a part lies: turned about the origin, then shifted."""

    sheet: int  # Number of the sheet of stock, from 0
    angle: float  # Turn (radians, counter-clockwise)
    shift: Array  # Shift (2,)

    def move(self, points: Array) -> Array:
        """Points (k, 2) where the part lies."""
        return turned(points, self.angle) + self.shift

    def move_all(self, content: Content) -> Content:
        """What is drawn where the part lies; no text is upside down."""
        lines, circles, texts = content
        return (
            tuple(replace(line, points=self.move(line.points)) for line in lines),
            tuple(self._moved(circle) for circle in circles),
            tuple(self._move_text(text) for text in texts),
        )

    def turned_over(self, width: float) -> Placement:
        """Where the part, mirrored about the y axis, lies when its sheet is turned over.

        ``width`` is that of the sheet within its margins.
        """
        x, y = self.shift.tolist()
        return Placement(self.sheet, -self.angle, np.array([width - x, y]))

    def _moved(self, drawn: Mark) -> Mark:
        ((x, y),) = self.move(np.array([[drawn.x, drawn.y]])).tolist()
        return replace(drawn, x=x, y=y)

    def _move_text(self, text: Text) -> Text:
        angle = float(np.remainder(text.angle + self.angle + np.pi, 2 * np.pi) - np.pi)
        anchor = text.anchor
        if not -np.pi / 2 - 1e-9 < angle <= np.pi / 2 + 1e-9:
            angle -= float(np.copysign(np.pi, angle))
            other: dict[Anchor, Anchor] = {"start": "end", "end": "start"}
            anchor = other.get(anchor, anchor)
        return replace(self._moved(text), angle=angle, anchor=anchor)


def gathered(contents: Iterable[Content]) -> Content:
    """All that is drawn, lines in the order of work."""
    lines, circles, texts = (
        tuple(chain.from_iterable(kind)) for kind in zip(((), (), ()), *contents, strict=True)
    )
    return tuple(sorted(lines, key=lambda line: ORDER.index(line.layer))), circles, texts


def shifted(content: Content, x: float, y: float) -> Content:
    """Lines, circles and texts moved right by ``x`` and up by ``y``."""
    lines, circles, texts = content
    return (
        tuple(replace(line, points=line.points + np.array([x, y])) for line in lines),
        tuple(replace(circle, x=circle.x + x, y=circle.y + y) for circle in circles),
        tuple(replace(text, x=text.x + x, y=text.y + y) for text in texts),
    )


def turned(points: Array, angle: float) -> Array:
    """Points (k, 2) turned about the origin (radians, counter-clockwise)."""
    cosine, sine = np.cos(angle), np.sin(angle)
    return np.asarray(points @ np.array([[cosine, sine], [-sine, cosine]]))


LETTERS = 0.4
"""Height of the words in the margin, as a share of its width."""


def draw_stock_sheets(
    parts: Sequence[tuple[Content, Placement]],
    title: str,
    unit: str,
    workshop: Workshop,
    numbers: range | None = None,
) -> Iterator[Drawing]:
    """Drawings exactly of the stock's size, in the order of work: marks, creases, holes, cuts.

    Parts are in their own coordinates, placements within the margins. The title stands in the
    margin, if there is one, with the sheet's number, if there are several. If ``numbers`` are given
    only these sheets are drawn, numbered even if there is one.
    """
    if workshop.stock is None:
        raise AssertionError("only stock is drawn sheet by sheet")
    (wide, high), margin = workshop.stock, workshop.margin
    on_sheets: defaultdict[int, list[tuple[Content, Placement]]] = defaultdict(list)
    for content, placement in parts:
        on_sheets[placement.sheet].append((content, placement))
    count = 1 + max(on_sheets, default=-1)
    for number in range(count) if numbers is None else numbers:
        several = numbers is not None or count > 1
        called = f"{title}, sheet {number + 1} of {count}" if several else title
        lines, circles, texts = gathered(
            replace(placement, shift=placement.shift + margin).move_all(content)
            for content, placement in on_sheets[number]
        )
        if workshop.title_block and margin > 0:
            words = f"{called}, 1:1 on {wide:g} x {high:g} {unit}"
            height = min(LETTERS * margin, (wide - 2 * margin) / len(words))
            texts += (Text("LABEL", margin, margin / 2, height, words, anchor="start"),)
        yield Drawing(called, unit, wide, high, lines, circles, texts)
