"""One part of the flat sheet as a drawing, 1:1."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.errors import InputError
from orishell.document import Document
from orishell.motion.quads import signed_areas
from orishell.numerics.arrays import Array
from orishell.workshop.creases import crease_lines, relief_holes
from orishell.workshop.cut_parts import CutPart, without_straight
from orishell.workshop.drawing import Drawing, Line, Text
from orishell.workshop.labels import part_labels
from orishell.workshop.palettes import load_palette
from orishell.workshop.placing import Content, shifted
from orishell.workshop.settings import Workshop
from orishell.workshop.title_block import draw_title_block, letter_height, sheet_facts

NOTHING = 1e-12
"""A panel is a line if its area is below this share of the sheet's size squared."""

MARGIN = 3.0
"""Width of the page around what is drawn, in letters of the title block."""


def require_drawable(document: Document) -> None:
    """Refuse a document that no workshop can make. Call it once, before parts are drawn.

    Raises
    ------
    InputError
        If there is no flat sheet or no unit, a panel of it is a line, or an edge between panels
        is called border, so that it would neither be scored nor cut.
    """
    document.require_unit()
    _require_areas(document)
    _require_borders(document)


def part_lines(document: Document, part: CutPart, workshop: Workshop) -> Content:
    """What is drawn of a part, in the sheet's own coordinates.

    Parameters
    ----------
    document
        The sheet, which :func:`require_drawable` has nothing against.
    part
        The part of it.

    Returns
    -------
    lines, circles, texts
        In the order of work: marks, creases, cuts within the part, holes, the outer outline.

    Raises
    ------
    InputError
        If there is no flat sheet, or holes or gaps are too large.
    """
    flat, mesh = document.require_flat(), document.mesh
    inside = np.flatnonzero(~mesh.crease & (mesh.edge_faces >= 0).all(axis=1))
    inside = inside[np.isin(mesh.edge_faces[inside], part.panels).all(axis=1)]
    lines = (
        *(mark for mark in part.marks if isinstance(mark, Line)),
        *crease_lines(document, part, workshop),
        *(Line("CUT", ends) for ends in flat[mesh.edges[inside]]),
        *(Line("CUT", without_straight(rim), closed=True) for rim in part.outlines[::-1]),
    )
    texts = (mark for mark in part.marks if isinstance(mark, Text))
    return (
        lines,
        relief_holes(document, part, workshop),
        (*texts, *part_labels(document, part, workshop)),
    )


def draw_part(
    document: Document,
    part: CutPart,
    workshop: Workshop,
    *,
    title: str = "",
    title_block: bool = True,
) -> Drawing:
    """A part on a page that is just large enough, 1:1, in the document's unit.

    Parameters
    ----------
    part
        The part of it.
    title
        What the title block says; the document's title if empty.
    title_block
        Whether a title and a scale bar stand below the part, unless ``workshop`` or its palette
        leave them out.

    Raises
    ------
    InputError
        As :func:`require_drawable` and :func:`part_lines` do, or if there is no such palette.
    """
    require_drawable(document)
    content = part_lines(document, part, workshop)
    facts = sheet_facts(document, part, drawn_box(content)[1], workshop)
    return draw_page(
        content, title or document.title, document.unit, facts if title_block else [], workshop
    )


def draw_page(
    content: Content, title: str, unit: str, facts: Sequence[str], workshop: Workshop
) -> Drawing:
    """What is drawn on a page that is just large enough, 1:1.

    Parameters
    ----------
    content
        What is drawn.
    title
        What the title block says first.
    unit
        Unit of length.
    facts
        What it says below; without any there is none, nor where ``workshop`` or its palette leave
        it out.
    """
    palette = load_palette(workshop.palette)
    lines, circles, _ = content
    low, size = drawn_box(content)
    letter = letter_height(float(size[0]), unit)
    margin = MARGIN * letter
    width, below = float(size[0]), 0.0
    block: Content = ((), (), ())
    if facts and workshop.title_block and "LABEL" in palette.pens:
        wide, high = size.tolist()
        drawn = Drawing(title, unit, wide, high, lines, circles)
        made = draw_title_block(facts, palette, drawn=drawn, letter=letter)
        block = shifted((made.lines, (), made.texts), margin, margin)
        width, below = max(width, made.width), made.height + margin
    left = margin + 0.5 * (width - float(size[0]))
    up = margin + below - float(low[1])
    sheet = shifted(content, left - float(low[0]), up)
    return Drawing(
        title,
        unit,
        width + 2 * margin,
        float(size[1]) + below + 2 * margin,
        block[0] + sheet[0],
        sheet[1],
        block[2] + sheet[2],
    )


def drawn_box(content: Content) -> tuple[Array, Array]:
    """Lower left corner (2,) and size (2,) of the box around all lines.

    Parameters
    ----------
    content
        What is drawn.
    """
    points = np.concatenate([line.points for line in content[0]])
    return points.min(axis=0), np.ptp(points, axis=0)


def _require_areas(document: Document) -> None:
    corners = document.require_flat()[document.mesh.faces]
    sides = np.roll(corners, -1, axis=1) - corners
    size = float(np.ptp(corners.reshape(-1, 2), axis=0).max())
    lines = np.abs(signed_areas(corners)) <= NOTHING * size**2
    lines |= (np.hypot(sides[..., 0], sides[..., 1]) <= NOTHING * size).any(axis=1)
    if lines.any():
        raise InputError(
            f"panel {document.panel_name(int(np.argmax(lines)))} has no area in the flat sheet"
        )


def _require_borders(document: Document) -> None:
    """Refuse creases that are called border: they would neither be scored nor cut."""
    wrong = np.flatnonzero(document.mesh.crease & (np.array(document.assignment) == "B"))
    if len(wrong):
        first, second = document.mesh.edge_faces[wrong[0]].tolist()
        raise InputError(
            f"edge {wrong[0]} is no border: it lies between panels "
            f"{document.panel_name(first)} and {document.panel_name(second)}",
            got='the assignment "B"',
            expected="M, V, F, U or J for a crease, C for a cut",
        )
