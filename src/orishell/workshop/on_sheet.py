"""What is marked on the sheet: where boards are glued on it, and where other parts hang on it."""

from __future__ import annotations

from dataclasses import replace
from itertools import chain

import numpy as np

from orishell.document import Document
from orishell.motion.quads import signed_areas
from orishell.workshop.boards import (
    MIRRORED,
    Side,
    board_labels,
    distinct_corners,
    has_membrane,
    hung_on,
    seen_from_outside,
)
from orishell.workshop.cut_parts import CutPart
from orishell.workshop.hung_lines import Hung, hung_lines
from orishell.workshop.palettes import Line, Text
from orishell.workshop.placing import Content


def with_places(document: Document, part: CutPart) -> CutPart:
    """A part of the sheet with what is on it: places of the upper boards, without their names.

    So are lines along which other parts hang, with what hangs there: of a membrane those on its
    upper face, else all.
    """
    if has_membrane(document):
        return replace(part, marks=(*part.marks, *_glue_lines(document, part, 1)))
    corners = document.require_flat()[document.mesh.faces[part.panels]]
    clockwise = (signed_areas(corners) < 0)[:, None, None]
    hung = Hung.on(document, np.where(clockwise, corners[:, ::-1], corners), part.panels)
    lines, texts = chain.from_iterable(hung.lines), chain.from_iterable(hung.texts)
    return replace(part, marks=(*part.marks, *lines, *texts))


def back_of(document: Document, part: CutPart) -> Content:
    """The back of a part, mirrored about the y axis: its rim and the places of the lower boards.

    Lines along which other parts hang there are drawn as well.
    """
    rims = (
        Line("ENGRAVE", distinct_corners(rim)[::-1] * MIRRORED, closed=True)
        for rim in part.outlines
    )
    marks = _glue_lines(document, part, -1)
    lines = (*(mark for mark in marks if isinstance(mark, Line)), *rims)
    named = (mark for mark in marks if isinstance(mark, Text))
    return lines, (), (*named, *board_labels(document, -1, part.panels))


def _glue_lines(document: Document, part: CutPart, side: Side) -> tuple[Line | Text, ...]:
    """Places of the boards of a side of a membrane, and from edge to edge what hangs there."""
    seen = seen_from_outside(document, side)
    here = np.isin(seen.panels, part.panels)
    names = hung_on(document, seen, side).texts
    return (
        *(Line("ENGRAVE", distinct_corners(each), closed=True) for each in seen.outlines[here]),
        *hung_lines(document, part.panels, side),
        *(text for board in np.flatnonzero(here).tolist() for text in names[board]),
    )
