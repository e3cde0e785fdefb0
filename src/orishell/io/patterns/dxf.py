"""The lines of a crease pattern in the modelspace of a DXF file."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from orishell.conventions.errors import InputError
from orishell.curves.dxf.entities import draw_entity, require_one_plane
from orishell.curves.dxf.read import read_entities
from orishell.curves.dxf.selection import visible_curves
from orishell.io.patterns.line_styles import IGNORED, letter_of_colour, letter_of_layer
from orishell.io.patterns.lines import Lines
from orishell.io.patterns.strokes import Stroke, lines_of, straight_ends

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.entities.dxfentity import DXFEntity

MOST_ENTITIES = 500_000
MOST_BYTES = 200_000_000
BY_BLOCK, BY_LAYER, WHITE = 0, 256, 7
"""AutoCAD colour indices; white is drawn black on paper."""


def read_dxf_lines(path: Path) -> tuple[Lines, tuple[str, float] | None, list[str]]:
    """What a DXF file draws, the name and millimetres of its unit, and what was assumed.

    Letters are those of the layer's name, or else of the colour. The unit is None if the file
    states none.

    Raises InputError: If the file cannot be read, draws a curve, or leaves the plane.
    """
    unit, (strokes, circles) = read_entities(path, _strokes, MOST_BYTES)
    lines, notes = lines_of(strokes)
    if circles:
        notes.append(f"circles are no creases: {circles} left out")
    return lines, unit, notes


def _strokes(document: Drawing) -> tuple[list[Stroke], int]:
    """Lines of the modelspace, and how many circles were left out."""
    colour_of = partial(_letter_of_colour, document)
    strokes, drawn, circles = [], [], 0
    for entity, layer in visible_curves(document, MOST_ENTITIES):
        letter = letter_of_layer(layer) or colour_of(entity, layer)
        if letter == IGNORED:
            continue
        if entity.dxftype() == "CIRCLE":
            circles += 1
            continue
        found = draw_entity(entity)
        try:
            ends = straight_ends(found.pieces)
        except InputError as error:
            raise error.located(found.name) from None
        strokes.append(Stroke(found.name, ends, letter))
        drawn.append(found)
    require_one_plane(drawn)
    return strokes, circles


def _letter_of_colour(document: Drawing, entity: DXFEntity, layer: str) -> str | None:
    from ezdxf import colors

    index = int(entity.dxf.get("color", BY_LAYER))
    true = entity.dxf.get("true_color")
    if true is None and index == BY_LAYER and document.layers.has_entry(layer):
        known = document.layers.get(layer)
        index, true = abs(int(known.dxf.get("color", WHITE))), known.dxf.get("true_color")
    if true is None and not BY_BLOCK < index < BY_LAYER:
        index = WHITE
    if true is None and index == WHITE:
        return "B"
    red, green, blue = colors.aci2rgb(index) if true is None else colors.int2rgb(int(true))
    return letter_of_colour((red / 255, green / 255, blue / 255))
