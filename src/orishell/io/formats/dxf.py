"""DXF for the workshop: a layer for each kind of work, 1:1, the unit declared.

AutoCAD 2000's version (AC1015): old enough for every machine's program, and it knows units.
"""

from __future__ import annotations

import contextlib
import io
import math
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Final

import numpy as np

from orishell.conventions.quantities import MILLIMETRES
from orishell.document import Document
from orishell.io.format import Format, Settings, plain_line
from orishell.workshop.ground_plan import draw_ground, ground_beside
from orishell.workshop.palettes import (
    LAYERS,
    ORDER,
    Circle,
    Drawing,
    Line,
    Palette,
    Text,
    load_palette,
)
from orishell.workshop.sheets import draw_sheet_files

if TYPE_CHECKING:
    from ezdxf.document import Drawing as DxfDocument

INSUNITS: Final[dict[str, int]] = {"mm": 4, "cm": 5, "m": 6, "in": 1, "ft": 2}
"""How ``$INSUNITS`` numbers units."""

_ENTITIES = "  2\nENTITIES\n"
"""Where the section of entities begins."""

_LINEWEIGHTS = (0, 5, 9, 13, 15, 18, 20, 25, 30, 35, 40, 50, 53, 60, 70, 80, 90, 100, 106, 120)
"""Line widths that DXF has (hundredths of a millimetre), up to 1.2 mm."""


def write_dxf(path: Path, document: Document, settings: Settings) -> None:
    """Write the flat sheet or, where it is split, its map, and ``-1``, ``-2``, ... beside it.

    The plan of the feet of a shell that can stand is ``ground.dxf``, if it is asked for.
    """
    palette = load_palette(settings.workshop.palette)
    for place, drawing in draw_sheet_files(path, document, settings.workshop):
        dump_dxf(place, drawing, palette)
    ground = draw_ground(document) if settings.ground else None
    if ground is not None:
        dump_dxf(ground_beside(path), ground, load_palette("plain"))


def dump_dxf(path: Path, drawing: Drawing, palette: Palette) -> None:
    """Write one drawing. Layers that the palette leaves out are present but empty.

    Parameters
    ----------
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
        entities = "".join(_entities(file, drawing, palette))
        frame = io.StringIO()
        file.write(frame)
    head, begin, tail = frame.getvalue().partition(_ENTITIES)
    path.write_text(f"{head}{begin}{entities}{tail}", encoding=file.output_encoding, newline="\n")


@contextlib.contextmanager
def _without_clock() -> Iterator[None]:
    """Let ezdxf write constants for times and random identifiers: the same file every time."""
    import ezdxf

    options = ezdxf.options
    before = options.write_fixed_meta_data_for_testing
    options.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        options.write_fixed_meta_data_for_testing = before


def _declare(file: DxfDocument, drawing: Drawing) -> None:
    """Say what the unit is, how large the page (its limits) and what is drawn on it (extents)."""
    file.header["$INSUNITS"] = INSUNITS[drawing.unit]
    file.header["$MEASUREMENT"] = int(drawing.unit not in ("in", "ft"))
    file.header["$LUNITS"] = 2
    file.header["$TEXTSIZE"] = 2.5 / MILLIMETRES[drawing.unit]
    page = drawing.width, drawing.height
    points = np.concatenate([line.points for line in drawing.lines])
    low, high = ((*map(float, corner), 0.0) for corner in (points.min(axis=0), points.max(axis=0)))
    file.header["$EXTMIN"], file.header["$EXTMAX"] = low, high
    file.modelspace().reset_extents(low, high)
    file.modelspace().reset_limits((0.0, 0.0), page)
    file.set_modelspace_vport(height=1.05 * max(page), center=(0.5 * page[0], 0.5 * page[1]))


def _entities(file: DxfDocument, drawing: Drawing, palette: Palette) -> Iterator[str]:
    """Entities in the order of work: words first, the outer cut last.

    They are what ezdxf would write, to the byte: its own entities take a minute for a million.
    """
    owner, handles = file.modelspace().layout_key, file.entitydb.handles
    for layer in ORDER:
        if layer not in palette.pens:
            continue
        texts, circles, lines = drawing.of_layer(layer)
        for kind, tags in chain(map(_text, texts), map(_circle, circles), map(_line, lines)):
            yield (
                f"  0\n{kind}\n  5\n{handles.next()}\n330\n{owner}\n100\nAcDbEntity\n"
                f"  8\n{layer}\n{tags}"
            )


def _point(code: int, x: float, y: float) -> str:
    return f" {code}\n{x}\n {code + 10}\n{y}\n {code + 20}\n0.0\n"


def _line(line: Line) -> tuple[str, str]:
    points = line.points.tolist()
    if len(points) == 2 and not line.closed:
        return "LINE", f"100\nAcDbLine\n{_point(10, *points[0])}{_point(11, *points[1])}"
    corners = "".join(f" 10\n{x}\n 20\n{y}\n" for x, y in points)
    head = f"100\nAcDbPolyline\n 90\n{len(points)}\n 70\n{int(line.closed)}\n"
    return "LWPOLYLINE", head + corners


def _circle(circle: Circle) -> tuple[str, str]:
    radius = float(circle.radius)
    return "CIRCLE", f"100\nAcDbCircle\n{_point(10, circle.x, circle.y)} 40\n{radius}\n"


def _text(text: Text) -> tuple[str, str]:
    """Words whose anchor lies at half their height."""
    x, y = float(text.x), float(text.y)
    angle = math.degrees(text.angle)
    anchor = {"start": "", "middle": " 72\n1\n", "end": " 72\n2\n"}[text.anchor]
    return "TEXT", (
        f"100\nAcDbText\n{_point(10, x, y)} 40\n{float(text.height)}\n  1\n{_plain(text.words)}\n"
        + (f" 50\n{angle}\n" if angle else "")
        + f"{anchor}{_point(11, x, y)}100\nAcDbText\n 73\n2\n"
    )


def _plain(words: str) -> str:
    r"""Words without what DXF takes for codes: control characters, ``^``, ``%%``; others as \U+."""
    known = plain_line(words).replace("^", "^ ").replace("%%", "% %").replace("\\U+", "\\ U+")
    return "".join(
        letter
        if letter.encode("cp1252", "ignore")
        else f"\\U+{ord(letter):04X}"
        if ord(letter) < 0x10000
        else "?"
        for letter in known
    )


FORMAT = Format(
    "dxf", "pattern.dxf", (".dxf",), "flat pattern for the workshop", write_dxf, task="cut"
)
