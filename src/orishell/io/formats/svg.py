"""SVG for the workshop: a group for each kind of work, physical size, coordinates in the unit."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from html import escape
from pathlib import Path
from typing import Final

from orishell.conventions.quantities import MILLIMETRES
from orishell.document import Document
from orishell.io.format import Format, Settings, plain_line
from orishell.workshop.ground_plan import draw_ground, ground_beside
from orishell.workshop.palettes import (
    ORDER,
    Circle,
    Drawing,
    Layer,
    Line,
    Palette,
    Text,
    load_palette,
)
from orishell.workshop.sheets import draw_sheet_files

EXACT_MM = 1e-6
"""Coordinates are rounded to this or less (mm)."""

CAPITALS: Final = 0.716
"""Height of capitals of Arial and Helvetica, in font sizes."""

_PHYSICAL = ("mm", "cm", "in")
"""Units that SVG knows; sizes in others are given in millimetres."""

Number = Callable[[float], str]


def write_svg(path: Path, document: Document, settings: Settings) -> None:
    """Write the flat sheet or, where it is split, its map, and ``-1``, ``-2``, ... beside it.

    The plan of the feet of a shell that can stand is ``ground.svg``, if it is asked for.
    """
    palette = load_palette(settings.workshop.palette)
    for place, drawing in draw_sheet_files(path, document, settings.workshop):
        dump_svg(place, drawing, palette)
    ground = draw_ground(document) if settings.ground else None
    if ground is not None:
        dump_svg(ground_beside(path), ground, load_palette("plain"))


def dump_svg(path: Path, drawing: Drawing, palette: Palette) -> None:
    """Write one drawing. Groups come in the order of work, the outer cut last.

    Parameters
    ----------
    palette
        Colours and line widths of the layers; layers without a pen are left out.
    """
    number, mm = _rounding(drawing.unit), MILLIMETRES[drawing.unit]
    size = number(drawing.width), number(drawing.height)
    if drawing.unit in _PHYSICAL:
        physical = tuple(f"{side}{drawing.unit}" for side in size)
    else:
        physical = tuple(f"{_rounding('mm')(float(side) * mm)}mm" for side in size)
    with path.open("w", encoding="utf-8", newline="\n") as file:
        file.write(
            '<?xml version="1.0" encoding="UTF-8"?>\n'
            '<svg xmlns="http://www.w3.org/2000/svg"'
            ' xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
            f' version="1.1" width="{physical[0]}" height="{physical[1]}"'
            f' viewBox="0 0 {size[0]} {size[1]}">\n'
            f"<title>{escape(plain_line(drawing.title), quote=False)}</title>\n"
        )
        for layer in ORDER:
            pen = palette.pens.get(layer)
            if pen:
                width = palette.width_mm(layer, max(drawing.width, drawing.height) * mm) / mm
                rows = _layer(drawing, layer, pen.colour, width, number)
                file.writelines(f"{row}\n" for row in rows)
        file.write("</svg>\n")


def _layer(
    drawing: Drawing, layer: Layer, colour: str, width: float, number: Number
) -> Iterator[str]:
    yield (
        f'<g id="{layer}" inkscape:groupmode="layer" inkscape:label="{layer}" fill="none"'
        f' stroke="{colour}" stroke-width="{width:.6g}" stroke-linecap="round"'
        ' stroke-linejoin="round">'
    )
    texts, circles, lines = drawing.of_layer(layer)
    yield from (_text(text, colour, drawing.height, number) for text in texts)
    yield from (_circle(circle, drawing.height, number) for circle in circles)
    yield from (_line(line, drawing.height, number) for line in lines)
    yield "</g>"


def _line(line: Line, height: float, number: Number) -> str:
    points = [(number(x), number(height - y)) for x, y in line.points.tolist()]
    if line.closed:
        return '<path d="M' + "L".join(f"{x} {y}" for x, y in points) + 'Z"/>'
    if len(points) == 2:
        (x1, y1), (x2, y2) = points
        return f'<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}"/>'
    return '<polyline points="' + " ".join(f"{x},{y}" for x, y in points) + '"/>'


def _circle(circle: Circle, height: float, number: Number) -> str:
    return (
        f'<circle cx="{number(circle.x)}" cy="{number(height - circle.y)}"'
        f' r="{number(circle.radius)}"/>'
    )


def _text(text: Text, colour: str, height: float, number: Number) -> str:
    """Words whose baseline starts half the capitals' height below the anchor."""
    x = number(text.x + 0.5 * text.height * math.sin(text.angle))
    y = number(height - text.y + 0.5 * text.height * math.cos(text.angle))
    turn = _rounding("mm")(-math.degrees(text.angle))
    words = escape(plain_line(text.words), quote=False)
    turned = "" if turn == "0" else f' transform="rotate({turn} {x} {y})"'
    return (
        f'<text x="{x}" y="{y}" font-size="{number(text.height / CAPITALS)}"'
        f' font-family="Arial, Helvetica, sans-serif" text-anchor="{text.anchor}"'
        f' fill="{colour}" stroke="none"{turned}>{words}</text>'
    )


def _rounding(unit: str) -> Number:
    """Turns a length in a unit into digits, as few as keep :data:`EXACT_MM`."""
    decimals = math.ceil(math.log10(MILLIMETRES[unit] / EXACT_MM) - 1e-9)

    def number(value: float) -> str:
        digits = f"{value:.{decimals}f}".rstrip("0").rstrip(".")
        return "0" if digits == "-0" else digits

    return number


FORMAT = Format(
    "svg", "pattern.svg", (".svg",), "flat pattern for the workshop", write_svg, task="cut"
)
