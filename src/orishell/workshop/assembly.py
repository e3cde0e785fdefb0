"""How parts go together: those beside the sheet, their numbers, and a map of the whole."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from orishell.document import Document, Part
from orishell.document.joined import AnyPart, joined
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.creases import CREASE_LETTERS, mean_edge
from orishell.workshop.cut_parts import LETTER_WIDTH, CutPart, Joint, find_outlines, whole_sheet
from orishell.workshop.draw import panel_labels
from orishell.workshop.palettes import Drawing, Line, Text
from orishell.workshop.placing import shifted
from orishell.workshop.settings import Workshop
from orishell.workshop.tabs import choose_joint_width

if TYPE_CHECKING:
    from shapely import Polygon

GAP = 0.25
"""Boards are moved by multiples of this share of the mean edge of the sheet's panels."""
CLOSE = 0.5
"""They stop where the gap around them is at least this share of such a step."""


def laid_flat(document: AnyPart) -> AnyPart:
    """All parts as they are cut, as one document: those beside the flat sheet hang not together.

    Their vertices, edges, panels and boards come after the sheet's. Each part lies beside the edge
    that it goes to, with a gap, or in rows below all others. A document of the sheet alone is
    returned as it is.
    """
    document = document.as_cut()
    if len(document.parts) == 1:
        return document
    return joined(document.sheet, document.parts[1:], list(parts_lying(document)))


OVER = 0.01
"""A part more than this share of which lies over the sheet goes to none of its edges."""


def parts_lying(document: Part) -> Iterator[Array]:
    """The flat vertices (V, 2) of all parts, all but the sheet moved to have a gap around them.

    Parts beside an edge of the sheet go outwards, those over it into rows below all others.
    """
    from shapely import MultiPolygon, Polygon, intersection
    from shapely.affinity import translate

    def rim(piece: Part) -> Polygon | MultiPolygon:
        flat = piece.require_flat()
        found = [Polygon(flat[each]) for each in find_outlines(piece.mesh.loops, flat)]
        return found[0] if len(found) == 1 else MultiPolygon(found)

    document = document.as_cut()
    yield document.require_flat()
    if len(document.parts) == 1:
        return
    placed, gap = [rim(document)], GAP * mean_edge(document)
    middle = np.array(placed[0].centroid.coords[0])
    others = [rim(part) for part in document.parts[1:]]
    over = [intersection(placed[0], own).area > OVER * own.area for own in others]
    moves = np.zeros((len(others), 2))
    for number in np.flatnonzero(np.logical_not(over)).tolist():
        own = others[number]
        away = np.array(own.centroid.coords[0]) - middle
        step = gap * away / np.hypot(*away)
        count = 1
        while min(map(translate(own, *(count * step)).distance, placed)) < CLOSE * gap:
            count += 1
        placed.append(translate(own, *(count * step)))
        moves[number] = count * step
    if any(over):
        boxes = np.array([own.bounds for own in others]).reshape(-1, 2, 2)[over]
        around = np.array([each.bounds for each in placed]).reshape(-1, 2, 2)
        low, high = around[:, 0].min(axis=0), around[:, 1].max(axis=0)
        moves[over] = _in_rows(boxes, low, float((high - low).max()), gap)
    for part, move in zip(document.parts[1:], moves, strict=True):
        yield part.require_flat() + move


def _in_rows(boxes: Array, corner: Array, length: float, gap: float) -> Array:
    """Moves (P, 2) of boxes (P, 2, 2) into rows of a length below a corner.

    boxes: Their least and largest coordinates.
    """
    moves = np.zeros((len(boxes), 2))
    x, y, deepest = float(corner[0]), float(corner[1]), 0.0
    for number, (low, high) in enumerate(boxes):
        width, height = (high - low).tolist()
        if x > corner[0] and x + width > corner[0] + length:
            x, y, deepest = float(corner[0]), y - deepest - gap, 0.0
        moves[number] = np.array([x, y - gap]) - np.array([low[0], high[1]])
        x, deepest = x + width + gap, max(deepest, height)
    return moves


TRIED = 8
"""Panels of a part, the largest, where room is looked for."""
NUMBER_SHARE = 0.5
"""Height of a part's number as a share of the diameter of the free circle around it."""
LARGEST_NUMBER = 1 / 12
"""Height of a part's number at most, as a share of the part's size."""
TRIMMED = 0.12
"""Share of a crease that is left out at either end on the map, so that cuts stand out."""
BELOW = 1 / 45
"""Height of the words below the map, as a share of its width."""


def number_text(document: Document, part: CutPart, texts: Sequence[Text]) -> Text:
    """A part's number, as large as a panel has room for beside the texts on it."""
    import shapely

    corners = document.require_flat()[document.mesh.faces[part.panels]]
    panels = [shapely.Polygon(quad) for quad in corners]
    largest = np.argsort(-np.round(shapely.area(panels), 12), kind="stable")[:TRIED]
    low, high = corners[largest].min(axis=(0, 1)), corners[largest].max(axis=(0, 1))
    reach = [(len(text.words) + 2) * text.height for text in texts]
    places = np.array([(text.x, text.y) for text in texts]).reshape(-1, 2)
    outside = np.maximum(low - places, places - high).max(axis=1)
    near = np.flatnonzero(outside < reach)
    taken = shapely.union_all([_text_box(texts[k]) for k in near.tolist()])
    words = str(part.number)
    best = (0.0, np.zeros(2))
    for k in largest.tolist():
        free = shapely.difference(panels[k], taken)
        circle = shapely.maximum_inscribed_circle(free, tolerance=free.length / 500)
        if circle.length > best[0] * (1 + 1e-6):
            best = (circle.length, shapely.get_coordinates(circle)[0])
    height = 2 * NUMBER_SHARE * best[0] / max(1.0, 0.6 * len(words))
    size = float(np.ptp(corners.reshape(-1, 2), axis=0).max())
    x, y = best[1].tolist()
    return Text("ENGRAVE", x, y, min(height, LARGEST_NUMBER * size), words)


def draw_map(
    document: Document,
    parts: Sequence[CutPart],
    joints: Sequence[Joint],
    workshop: Workshop,
    sheets: int,
) -> Drawing:
    """The assembly map: the sheet with its parts numbered and its joints named, not to be cut.

    Creases are drawn short, tabs where they lie under the neighbouring panels. Boards that are
    clipped on stand beside the panels that they belong to. Where panels have a thickness they are
    named: their boards' part numbers begin so.
    """
    own, document = len(document.mesh.faces), laid_flat(document)
    flat, edges = document.require_flat(), document.mesh.edges
    rims = whole_sheet(document).outlines
    around = np.concatenate(rims)
    low, high = around.min(axis=0), around.max(axis=0)
    letter = BELOW * float(high[0] - low[0])
    shift = 2 * letter - low + np.array([0.0, 4 * letter])

    cut = {joint.edge for joint in joints}
    inner = np.array(sorted(set(np.flatnonzero(document.mesh.crease).tolist()) - cut), dtype=int)
    lines = (
        *(Line("ENGRAVE", tab[[1, 2, 3, 0]]) for joint in joints for tab in joint.tabs),
        *short_creases(document, inner),
        *(Line("CUT", seam) for seam in flat[edges[sorted(cut)]]),
        *(Line("CUT", rim, closed=True) for rim in rims),
    )

    names = [mark for joint in joints for mark in joint.marks()[:1]]
    if document.boards is not None:
        panels = np.arange(len(document.mesh.faces))
        taken = np.zeros(len(panels))
        taken[document.mesh.edge_faces[sorted(cut)]] = choose_joint_width(document, workshop)
        names += panel_labels(document, panels, taken)
    numbered = [part for part in parts if part.number]
    texts = (*names, *(number_text(document, part, names) for part in numbered))
    lines, circles, placed = shifted((lines, (), texts), *shift.tolist())
    stock = workshop.stock or (0.0, 0.0)
    words = [
        f"Assembly map, not to be cut: {len(numbered)} parts, {len(joints)} joints",
        f"{sheets} sheets of {stock[0]:g} x {stock[1]:g} {document.unit}. " + _HOW[workshop.joint],
    ]
    boards = [part.number for part in numbered if part.panels[0] >= own]
    if boards:
        words[1] += f" Clipped on at the target: parts {boards[0]} to {boards[-1]}."
    size = min(letter, (high[0] - low[0]) / (0.8 * max(map(len, words))))
    placed += tuple(
        Text("ENGRAVE", 2 * letter, (3.5 - 1.8 * k) * letter, float(size), line, anchor="start")
        for k, line in enumerate(words)
    )
    width, height = (high - low + np.array([4, 8]) * letter).tolist()
    title = f"{document.title}, assembly map"
    return Drawing(title, document.unit, width, height, lines, circles, placed)


def short_creases(document: Document, creases: Integers) -> tuple[Line, ...]:
    """Creases of a map, by their numbers, shorter than they are, mountains and valleys apart."""
    letters = np.array(document.assignment)[creases]
    ends = document.require_flat()[document.mesh.edges[creases]]
    trim = TRIMMED * (ends[:, 1] - ends[:, 0])
    short = np.stack([ends[:, 0] + trim, ends[:, 1] - trim], axis=1)
    return tuple(
        Line(layer, line)
        for layer, marks in CREASE_LETTERS.items()
        for line in short[np.isin(letters, list(marks))]
    )


_HOW = {
    "tabs": "Glue each tab to the back of the panel of the same name.",
    "strips": "Glue each strip to the backs of the panels of the same name.",
}


def _text_box(text: Text) -> Polygon:
    """The room that a text takes with a border of a third of its height."""
    import shapely

    along = np.array([np.cos(text.angle), np.sin(text.angle)])
    above = np.array([-along[1], along[0]])
    half = (0.5 * LETTER_WIDTH * len(text.words) + 0.3) * text.height
    centre = np.array([text.x, text.y])
    corners = [
        centre + a * half * along + b * 0.8 * text.height * above
        for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    return shapely.Polygon(corners)
