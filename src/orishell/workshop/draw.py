"""Words on the work: rows and columns of panels, fold angles of creases."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.errors import InputError
from orishell.document import Document
from orishell.motion.quads import signed_areas
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.boards import board_labels, has_membrane
from orishell.workshop.creases import crease_lines, mean_edge, relief_holes
from orishell.workshop.cut_parts import CutPart, without_straight
from orishell.workshop.fitted_words import (
    BESIDE,
    Labels,
    centroids,
    label_edges,
    label_middles,
    readable,
    ways_across,
)
from orishell.workshop.hung_lines import said_of_lines
from orishell.workshop.palettes import Drawing, Line, Text, load_palette
from orishell.workshop.placing import Content, shifted
from orishell.workshop.settings import Workshop
from orishell.workshop.title_block import (
    draw_title_block,
    letter_height,
    program_and_palette,
    sheet_facts,
)

WITH_PANELS = 2.5
"""Heights of a crease's label that must fit where panels are labelled too."""


def part_labels(document: Document, part: CutPart, workshop: Workshop) -> tuple[Text, ...]:
    """What is engraved on a part, in the sheet's own coordinates; never upside down.

    Where boards are glued on, their part numbers take the place of rows and columns.
    """
    texts: tuple[Text, ...] = ()
    if not len(part.panels):
        return texts
    taken = np.zeros(len(document.mesh.faces))
    glued = has_membrane(document)
    if workshop.labels in ("creases", "both"):
        tall = 1.0 if workshop.labels == "creases" and not glued else WITH_PANELS
        creases, panels = _crease_labels(document, part, tall)
        texts = creases.of(panels >= 0)
        np.maximum.at(taken, panels[panels >= 0], (BESIDE + 0.5) * creases.heights[panels >= 0])
    if glued:
        texts = board_labels(document, 1, part.panels, taken) + texts
    elif workshop.labels in ("panels", "both"):
        texts = panel_labels(document, part.panels, taken) + texts
    return texts


def panel_labels(document: Document, panels: Integers, taken: Array) -> tuple[Text, ...]:
    """Row and column in the middle of panels, along their longer direction.

    Other labels take a width ``taken`` (F,) along the edges of all panels.
    """
    corners = _convex_panels(document)
    words = tuple(document.panel_name(panel) for panel in range(len(corners)))
    most = 0.25 * mean_edge(document)
    labels = label_middles(words, corners, ways_across(corners), most, [(corners, taken)])
    return labels.of(np.isin(np.arange(len(corners)), panels))


def _crease_labels(document: Document, part: CutPart, tall: float) -> tuple[Labels, Integers]:
    """The fold angle beside the middle of every crease that folds, and the panel it stands on.

    It stands above the crease, below only where the panel above belongs to another part. The
    panel is -1 for creases that are not on the part. As many heights of the label as ``tall`` says
    must fit into the panel.
    """
    flat, mesh = document.require_flat(), document.mesh
    angles = np.round(document.fold_angles_deg, 1)
    folding = np.flatnonzero(mesh.crease & np.isfinite(angles) & (angles != 0))
    words = tuple(f"{angle:+.1f}°" for angle in angles[folding])
    ends = flat[mesh.edges[folding]]
    along = readable(ends[:, 1] - ends[:, 0])
    middles, above = ends.mean(axis=1), np.column_stack([-along[:, 1], along[:, 0]])
    panels = _convex_panels(document)
    beside = mesh.edge_faces[folding]
    side = ((centroids(panels)[beside] - middles[:, None]) * above[:, None]).sum(axis=2)
    here = np.isin(beside, part.panels)
    chosen = np.argmax(np.where(here, 2.0, 0.0) + (side > 0), axis=1)
    rows = np.arange(len(folding))
    panel = beside[rows, chosen]
    labels = label_edges(words, panels[panel], ends, tall=tall, most=0.1 * mean_edge(document))
    on_part = here.any(axis=1) & np.isin(folding, part.creases)
    return labels, np.where(on_part, panel, -1)


def _convex_panels(document: Document) -> Array:
    """Corners (F, 4, 2) of every panel, counter-clockwise; of one with a reflex corner a half.

    That half is the larger triangle beside the diagonal from the reflex corner, with its last
    corner twice.
    """
    corners = document.require_flat()[document.mesh.faces]
    clockwise = signed_areas(corners) < 0
    corners = np.where(clockwise[:, None, None], corners[:, ::-1], corners)
    before, after = corners - np.roll(corners, 1, axis=1), np.roll(corners, -1, axis=1) - corners
    turn = before[..., 0] * after[..., 1] - before[..., 1] * after[..., 0]
    reflex = np.flatnonzero((turn < 0).any(axis=1))
    first = np.argmin(turn[reflex], axis=1)
    numbers = (first[:, None] + np.array([[0, 1, 2, 2]])) % 4
    others = (first[:, None] + np.array([[0, 2, 3, 3]])) % 4
    one = np.take_along_axis(corners[reflex], numbers[..., None], axis=1)
    two = np.take_along_axis(corners[reflex], others[..., None], axis=1)
    larger = signed_areas(one) >= signed_areas(two)
    corners[reflex] = np.where(larger[:, None, None], one, two)
    return corners


NOTHING = 1e-12
"""A panel is a line if its area is below this share of the sheet's size squared."""

MARGIN = 3.0
"""Width of the page around what is drawn, in letters of the title block."""


def require_drawable(document: Document) -> None:
    """Refuse a document that no workshop can make. Call it once, before parts are drawn.

    Raises InputError if there is no flat sheet or no unit, a panel of it is a line, or an edge
    between panels is called border, so that it would neither be scored nor cut.
    """
    document.require_unit()
    corners = document.require_flat()[document.mesh.faces]
    sides = np.roll(corners, -1, axis=1) - corners
    size = float(np.ptp(corners.reshape(-1, 2), axis=0).max())
    lines = np.abs(signed_areas(corners)) <= NOTHING * size**2
    lines |= (np.hypot(sides[..., 0], sides[..., 1]) <= NOTHING * size).any(axis=1)
    if lines.any():
        raise InputError(
            f"panel {document.panel_name(int(np.argmax(lines)))} has no area in the flat sheet"
        )
    wrong = np.flatnonzero(document.mesh.crease & (np.array(document.assignment) == "B"))
    if len(wrong):
        first, second = document.mesh.edge_faces[wrong[0]].tolist()
        raise InputError(
            f"edge {wrong[0]} is no border: it lies between panels "
            f"{document.panel_name(first)} and {document.panel_name(second)}",
            got='the assignment "B"',
            expected="M, V, F, U or J for a crease, C for a cut",
        )


def part_lines(document: Document, part: CutPart, workshop: Workshop) -> Content:
    """What is drawn of a part, in the sheet's own coordinates and in the order of work.

    Raises InputError if holes or gaps are too large.
    """
    lines = (
        *(mark for mark in part.marks if isinstance(mark, Line)),
        *crease_lines(document, part, workshop),
        *(Line("CUT", ends) for ends in cuts_within(document, part)),
        *(Line("CUT", without_straight(rim), closed=True) for rim in part.outlines[::-1]),
    )
    texts = (mark for mark in part.marks if isinstance(mark, Text))
    return (
        lines,
        relief_holes(document, part, workshop),
        (*texts, *part_labels(document, part, workshop)),
    )


def cuts_within(document: Document, part: CutPart) -> Array:
    """Ends (C, 2, 2) of the cuts between panels of a part."""
    flat, mesh = document.require_flat(), document.mesh
    inside = np.flatnonzero(~mesh.crease & (mesh.edge_faces >= 0).all(axis=1))
    inside = inside[np.isin(mesh.edge_faces[inside], part.panels).all(axis=1)]
    return flat[mesh.edges[inside]]


def draw_part(document: Document, part: CutPart, workshop: Workshop) -> Drawing:
    """A part on a page that is just large enough, 1:1, in the document's unit."""
    require_drawable(document)
    content = part_lines(document, part, workshop)
    facts = sheet_facts(document, part, drawn_box(content)[1], workshop)
    facts = (*facts, *said_of_lines(document))
    return draw_page(content, document.title, document.unit, facts, workshop)


def draw_page(
    content: Content, title: str, unit: str, facts: Sequence[str], workshop: Workshop
) -> Drawing:
    """What is drawn on a page that is just large enough, 1:1, over its title block.

    That says the title, ``facts`` and the program; ``workshop`` or its palette may leave it out.
    """
    palette = load_palette(workshop.palette)
    lines, circles, _ = content
    low, size = drawn_box(content)
    letter = letter_height(float(size[0]), unit)
    margin = MARGIN * letter
    width, below = float(size[0]), 0.0
    block: Content = ((), (), ())
    if workshop.title_block and "LABEL" in palette.pens:
        wide, high = size.tolist()
        drawn = Drawing(title, unit, wide, high, lines, circles)
        facts = (*facts, program_and_palette(workshop))
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
    """Lower left corner (2,) and size (2,) of the box around all lines."""
    points = np.concatenate([line.points for line in content[0]])
    return points.min(axis=0), np.ptp(points, axis=0)
