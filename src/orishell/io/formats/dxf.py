"""DXF for the workshop: a layer for each kind of work, 1:1, the unit declared.

AutoCAD 2000's version (AC1015): old enough for every machine's program, and it knows units.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Final

import numpy as np

from orishell.document import Document
from orishell.io.settings import Settings
from orishell.units import MILLIMETRES
from orishell.workshop.drawing import LAYERS, ORDER, Drawing, Layer, Text
from orishell.workshop.palettes import Palette, load_palette
from orishell.workshop.sheets import draw_sheets

if TYPE_CHECKING:
    from ezdxf.document import Drawing as DxfDocument
    from ezdxf.layouts.layout import Modelspace

INSUNITS: Final[dict[str, int]] = {"mm": 4, "cm": 5, "m": 6, "in": 1, "ft": 2}
"""How ``$INSUNITS`` numbers units."""

IMPERIAL = ("in", "ft")

_LINEWEIGHTS = (0, 5, 9, 13, 15, 18, 20, 25, 30, 35, 40, 50, 53, 60, 70, 80, 90, 100, 106, 120)
"""Line widths that DXF has (hundredths of a millimetre), up to 1.2 mm."""


def write_dxf(path: Path, document: Document, settings: Settings) -> None:
    """Write the flat sheet; where it is split, the assembly map, and ``-1``, ``-2``, ... beside it.

    Parameters
    ----------
    path
        The file.
    document
        What is written.
    settings
        How it is drawn and cut.

    Raises
    ------
    InputError
        If there is no flat sheet or unit, or the sheet cannot be drawn as asked.
    """
    palette = load_palette(settings.workshop.palette)
    for number, drawing in enumerate(draw_sheets(document, settings.workshop)):
        place = path.with_stem(f"{path.stem}-{number}") if number else path
        dump_dxf(place, drawing, palette)


def dump_dxf(path: Path, drawing: Drawing, palette: Palette) -> None:
    """Write one drawing. Layers that the palette leaves out are there, and empty.

    Parameters
    ----------
    path
        The file.
    drawing
        What is drawn.
    palette
        Colours and line widths of the layers; what is on layers without a pen is left out.
    """
    from ezdxf.filemanagement import new

    with _without_clock():
        file = new("R2000")
        _declare(file, drawing)
        for layer in LAYERS:
            pen = palette.pens.get(layer)
            width = 100 * pen.width_mm if pen else 0.0
            file.layers.add(
                layer,
                color=pen.aci if pen else 7,
                lineweight=min(_LINEWEIGHTS, key=lambda known: abs(known - width)),
            )
        _draw(file.modelspace(), drawing, palette)
        file.saveas(path)


@contextlib.contextmanager
def _without_clock() -> Iterator[None]:
    """Let ezdxf write constants for times and random identifiers: the same file every time."""
    import ezdxf

    options = ezdxf.options  # type: ignore[attr-defined] # ezdxf does not list what it exports
    before = options.write_fixed_meta_data_for_testing
    options.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        options.write_fixed_meta_data_for_testing = before


def _declare(file: DxfDocument, drawing: Drawing) -> None:
    """Say what the unit is, how large the page (its limits) and what is drawn on it (extents)."""
    file.header["$INSUNITS"] = INSUNITS[drawing.unit]
    file.header["$MEASUREMENT"] = int(drawing.unit not in IMPERIAL)
    file.header["$LUNITS"] = 2
    file.header["$TEXTSIZE"] = 2.5 / MILLIMETRES[drawing.unit]
    page = drawing.width, drawing.height
    points = np.concatenate([line.points for line in drawing.lines])
    low, high = ((*map(float, corner), 0.0) for corner in (points.min(axis=0), points.max(axis=0)))
    file.header["$EXTMIN"], file.header["$EXTMAX"] = low, high
    file.modelspace().reset_extents(low, high)
    file.modelspace().reset_limits((0.0, 0.0), page)
    file.set_modelspace_vport(height=1.05 * max(page), center=(0.5 * page[0], 0.5 * page[1]))


def _draw(space: Modelspace, drawing: Drawing, palette: Palette) -> None:
    """Entities in the order of work: what is only said first, the outer cut last."""
    for layer in ORDER:
        if layer in palette.pens:
            _draw_layer(space, drawing, layer)


def _draw_layer(space: Modelspace, drawing: Drawing, layer: Layer) -> None:
    attributes = {"layer": layer}
    for text in drawing.texts:
        if text.layer == layer:
            _add_text(space, text)
    for circle in drawing.circles:
        if circle.layer == layer:
            space.add_circle((circle.x, circle.y), circle.radius, dxfattribs=attributes)
    for line in drawing.lines:
        if line.layer == layer:
            points = line.points.tolist()
            if len(points) == 2 and not line.closed:
                space.add_line(points[0], points[1], dxfattribs=attributes)
            else:
                space.add_lwpolyline(points, close=line.closed, dxfattribs=attributes)


def _add_text(space: Modelspace, text: Text) -> None:
    from ezdxf.enums import TextEntityAlignment

    align = {
        "start": TextEntityAlignment.MIDDLE_LEFT,
        "middle": TextEntityAlignment.MIDDLE_CENTER,
        "end": TextEntityAlignment.MIDDLE_RIGHT,
    }[text.anchor]
    entity = space.add_text(
        _plain(text.words),
        height=text.height,
        rotation=math.degrees(text.angle),
        dxfattribs={"layer": text.layer},
    )
    entity.set_placement((text.x, text.y), align=align)


def _plain(words: str) -> str:
    r"""Words without what DXF takes for codes: control characters, ``^``, ``%%``; others as \U+."""
    letters = [letter if letter.isprintable() else " " for letter in words]
    known = "".join(letters).replace("^", "^ ").replace("%%", "% %").replace("\\U+", "\\ U+")
    return "".join(
        letter
        if letter.encode("cp1252", "ignore")
        else f"\\U+{ord(letter):04X}"
        if ord(letter) < 0x10000
        else "?"
        for letter in known
    )
