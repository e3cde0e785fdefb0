"""Where boards are glued on the membrane: their outlines, engraved with their part numbers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.document import Document
from orishell.workshop.board_labels import board_labels
from orishell.workshop.board_outlines import MIRRORED, Side, distinct_corners, seen_from_outside
from orishell.workshop.drawing import Line
from orishell.workshop.part import Part
from orishell.workshop.placing import Content


def has_sheet(document: Document) -> bool:
    """Whether the flat sheet is built: not where panels are solid, on hinges of their own."""
    build = document.panel
    return document.boards is None or build is None or build.construction != "bevel"


def has_membrane(document: Document) -> bool:
    """Whether boards are glued on the sheet, on one face or on both."""
    return document.boards is not None and bool(document.boards.sides.any())


def sheet_title(document: Document) -> str:
    """The document's title, with a word that the sheet is a membrane if boards are glued on it."""
    return document.title + (", membrane" if has_membrane(document) else "")


def with_glue_areas(document: Document, part: Part) -> Part:
    """A part of the sheet with the places of the upper boards marked on it.

    Their part numbers are among the part's labels (:mod:`~orishell.workshop.labels`).
    """
    if not has_membrane(document):
        return part
    return replace(part, marks=(*part.marks, *_glue_lines(document, part, 1)))


def back_of(document: Document, part: Part) -> Content:
    """The back of a part, mirrored about the y axis: its rim and the places of the lower boards.

    Nothing of it is cut: the rim is there to lay the part on.
    """
    rims = (
        Line("ENGRAVE", distinct_corners(rim)[::-1] * MIRRORED, closed=True)
        for rim in part.outlines
    )
    lines = (*_glue_lines(document, part, -1), *rims)
    return lines, (), board_labels(document, -1, part.panels)


def _glue_lines(document: Document, part: Part, side: Side) -> tuple[Line, ...]:
    seen = seen_from_outside(document, side)
    here = np.isin(seen.panels, part.panels)
    return tuple(
        Line("ENGRAVE", distinct_corners(outline), closed=True) for outline in seen.outlines[here]
    )
