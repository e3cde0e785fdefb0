"""The plan of assembly of solid panels, which are no parts of a sheet that is cut."""

from __future__ import annotations

import numpy as np

from orishell.document import Document
from orishell.workshop.assembly import short_creases
from orishell.workshop.board_labels import board_labels
from orishell.workshop.board_outlines import distinct_corners, seen_from_outside
from orishell.workshop.clipped import with_clipped
from orishell.workshop.draw import draw_page, drawn_box, require_drawable
from orishell.workshop.drawing import Drawing, Line
from orishell.workshop.settings import Workshop
from orishell.workshop.title_block import program_and_palette, quoted_size


def draw_plan(document: Document, workshop: Workshop) -> Drawing:
    """Solid panels in their places, with part numbers, and the creases between them.

    It is seen from above, and nothing of it is cut. What is clipped on at the target lies beside
    the edge that it is clipped on.

    Raises
    ------
    InputError
        If there is no flat sheet or no unit.
    """
    document = with_clipped(document)
    require_drawable(document)
    seen = seen_from_outside(document, 0)
    panels = (Line("ENGRAVE", distinct_corners(outline), closed=True) for outline in seen.outlines)
    creases = short_creases(document, np.flatnonzero(document.mesh.crease))
    lines = (*panels, *creases)
    texts = board_labels(document, 0)
    content = lines, (), texts
    facts = (
        f"{len(seen.numbers)} panels, {quoted_size(drawn_box(content)[1], document.unit)}",
        "Plan of assembly, seen from above; nothing is cut",
        program_and_palette(workshop),
    )
    return draw_page(content, f"{document.title}, plan", document.unit, facts, workshop)
