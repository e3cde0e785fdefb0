"""Boards as parts to be cut: outline, marks and part number, and where they lie on the stock."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np

from orishell.conventions.record import record
from orishell.document import Document
from orishell.numerics.arrays import Array
from orishell.workshop.boards import SIDES, board_labels, distinct_corners, seen_from_outside
from orishell.workshop.chamfers import solid_marks
from orishell.workshop.clipped import with_clipped
from orishell.workshop.drawing import Line, Text
from orishell.workshop.layout import usable_stock
from orishell.workshop.nesting import nest_parts
from orishell.workshop.placing import Content, Placement
from orishell.workshop.settings import Workshop

KEPT = 4
"""Number of layouts that are kept: formats and the bill ask for the same one."""


@record
class BoardPart:
    """A board as it is cut, seen from outside; solid panels are seen from above.

    Parameters
    ----------
    number
        Its number among the boards of the sheet and of what is clipped on.
    name
        Its part number.
    panel
        The panel that carries it.
    side
        1 top, -1 bottom, 0 solid.
    outline
        Corners (k, 2) of what is cut, counter-clockwise.
    lines, texts
        What is engraved.
    """

    number: int
    name: str
    panel: int
    side: int
    outline: Array
    lines: tuple[Line, ...]
    texts: tuple[Text, ...]

    def content(self) -> Content:
        """What is drawn, the cut last."""
        return (*self.lines, Line("CUT", self.outline, closed=True)), (), self.texts


def board_parts(document: Document) -> tuple[BoardPart, ...]:
    """All boards, those of what is clipped on too: the upper ones, the lower ones, the solid ones.

    Panels are numbered as in :func:`~orishell.workshop.clipped.with_clipped`.
    """
    document = with_clipped(document)
    parts: list[BoardPart] = []
    for side in SIDES:
        seen = seen_from_outside(document, side)
        if not len(seen.numbers):
            continue
        if side:
            lines: Sequence[Sequence[Line]] = [()] * len(seen.names)
            texts: Sequence[Sequence[Text]] = [(text,) for text in board_labels(document, side)]
        else:
            lines, texts = solid_marks(document)
        parts += [
            BoardPart(number, name, panel, side, distinct_corners(outline), (*drawn,), (*words,))
            for number, name, panel, outline, drawn, words in zip(
                seen.numbers.tolist(),
                seen.names,
                seen.panels.tolist(),
                seen.outlines,
                lines,
                texts,
                strict=True,
            )
        ]
    return tuple(parts)


def nest_boards(document: Document, workshop: Workshop) -> tuple[Placement, ...]:
    """Where boards lie on the stock, within its margins; one for each of :func:`board_parts`.

    The last layouts are kept, as those of the sheet are.

    Raises
    ------
    InputError
        If a board does not fit the stock.
    """
    document = with_clipped(document)
    outlines = [
        distinct_corners(outline)
        for side in SIDES
        for outline in seen_from_outside(document, side).outlines
    ]
    if not outlines:
        return ()
    return _nest(_Outlines.of(outlines), *usable_stock(workshop), workshop.spacing)


@dataclass(frozen=True, slots=True)
class _Outlines:
    """Outlines, equal to others with the same corners."""

    digest: bytes
    outlines: Sequence[Array] = field(compare=False)

    @classmethod
    def of(cls, outlines: Sequence[Array]) -> _Outlines:
        digest = hashlib.sha256(repr([len(outline) for outline in outlines]).encode())
        digest.update(np.concatenate(outlines).tobytes())
        return cls(digest.digest(), outlines)


@lru_cache(KEPT)
def _nest(boards: _Outlines, width: float, height: float, spacing: float) -> tuple[Placement, ...]:
    return nest_parts(boards.outlines, width, height, spacing)
