"""A drawing for a machine in layers, and the palettes by which machines tell layers apart.

Every format for the workshop draws the same :class:`Drawing`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any, Literal, get_args

from orishell.conventions.colours import LIGHT
from orishell.conventions.errors import InputError
from orishell.conventions.meant import no_such
from orishell.conventions.record import record
from orishell.conventions.toml_file import parse_toml, read_toml
from orishell.numerics.arrays import Array

Layer = Literal["CUT", "MOUNTAIN", "VALLEY", "ENGRAVE", "LABEL"]
LAYERS: tuple[Layer, ...] = get_args(Layer)
"""Outer cut and holes; creases; what is marked on the work (labels); what is not on the work at
all (title block, scale bar)."""

ORDER: tuple[Layer, ...] = ("LABEL", "ENGRAVE", "MOUNTAIN", "VALLEY", "CUT")
"""The layers in the order of work: what is cut comes last, so that nothing moves before."""

Anchor = Literal["middle", "start", "end"]


@record
class Line:
    """A polyline in a layer."""

    layer: Layer  # its layer
    points: Array  # points (k, 2), x to the right, y up
    closed: bool = False  # whether the last point is joined to the first


@dataclass(frozen=True, slots=True)
class Circle:
    """A circle in a layer."""

    layer: Layer  # its layer
    # its middle and radius, in the unit of the drawing
    x: float
    y: float
    radius: float


@dataclass(frozen=True, slots=True)
class Text:
    """Words in a layer."""

    layer: Layer  # its layer
    # where its anchor lies, half the height above the baseline
    x: float
    y: float
    height: float  # height of its capitals, in the unit of the drawing
    words: str  # one line of text
    angle: float = 0.0  # direction of the baseline, counter-clockwise from x (radians)
    anchor: Anchor = "middle"  # which point of the line of text lies at (x, y)


@record
class Drawing:
    """One sheet for a machine."""

    title: str  # one line that says what it is
    unit: str  # unit of length: mm, cm, m, in or ft
    # size of the page in that unit; everything lies between (0, 0) and it
    width: float
    height: float
    # what is drawn, in the order in which a machine should do it: marks and creases first, holes
    # then, the outer cut last
    lines: tuple[Line, ...]
    circles: tuple[Circle, ...] = ()
    texts: tuple[Text, ...] = ()

    def of_layer(self, layer: Layer) -> tuple[list[Text], list[Circle], list[Line]]:
        """What is drawn on a ``layer``."""
        return (
            [text for text in self.texts if text.layer == layer],
            [circle for circle in self.circles if circle.layer == layer],
            [line for line in self.lines if line.layer == layer],
        )


_COLOUR = re.compile("#[0-9a-f]{6}")


@dataclass(frozen=True, slots=True)
class Pen:
    """How the lines of a layer look."""

    colour: str  # "#rrggbb", in small letters
    aci: int  # AutoCAD colour index, 1 ... 255
    width_mm: float  # width of the lines (mm)


@record
class Palette:
    """The pens of all layers, as one shop or machine expects them."""

    name: str  # its name
    note: str  # what it is for, in one line
    pens: Mapping[Layer, Pen]  # pen of every layer that is drawn; the others are left out of files
    # Longer side of the page for which the pens' widths are meant: on larger ones they grow with
    # it, so that a picture of it looks the same (mm). None if machines read the widths.
    page_mm: float | None = None

    def width_mm(self, layer: Layer, page_mm: float) -> float:
        """Width of a layer's lines on a page whose longer side is ``page_mm`` (mm)."""
        grown = 1.0 if self.page_mm is None else max(1.0, page_mm / self.page_mm)
        return grown * self.pens[layer].width_mm


def palette_names() -> tuple[str, ...]:
    """Names of the palettes that come with the program."""
    return tuple(_known())


def load_palette(name: str) -> Palette:
    """A palette by its name, or from a TOML file of one table like those of ``palettes.toml``.

    Raises InputError if there is no such palette or file, or the file is not a palette.
    """
    if name.endswith(".toml"):
        return _read_palette(Path(name))
    if name not in _known():
        expected = ", ".join(_known()) + ", or the path of a .toml file"
        place = ("workshop.palette",)
        raise no_such("there is no such palette", name, _known(), keys=place, expected=expected)
    return _known()[name]


@cache
def _known() -> dict[str, Palette]:
    text = (files("orishell.workshop") / "palettes.toml").read_text(encoding="utf-8")
    return {name: _parse(name, table) for name, table in parse_toml(text).items()}


def _read_palette(path: Path) -> Palette:
    tables = read_toml(path, "palette")
    if len(tables) != 1:
        raise InputError(
            "a palette file has one table, the palette",
            where=str(path),
            got=f"{len(tables)} keys or tables",
        )
    ((name, table),) = tables.items()
    try:
        return _parse(name, table)
    except InputError as error:
        raise error.located(f"{path}:") from None


def _parse(name: str, table: Any) -> Palette:
    if not isinstance(table, dict) or set(table) - {"note", "page_mm"} != set(LAYERS):
        found = ", ".join(table) if isinstance(table, dict) else repr(table)
        raise InputError(
            "a palette names each layer once",
            where=f"[{name}]",
            got=found,
            expected=", ".join(LAYERS) + ", and note or page_mm if you like",
        )
    pens: dict[Layer, Pen] = {
        layer: _pen(f"[{name}] {layer}", table[layer])
        for layer in LAYERS
        if table[layer] is not False
    }
    page = table.get("page_mm")
    if page is not None:
        page = _size(f"[{name}] page_mm", page, 1e6)
    return Palette(name, str(table.get("note", "")), pens, page)


def _pen(where: str, value: Any) -> Pen:
    if not isinstance(value, dict) or set(value) != {"colour", "aci", "width_mm"}:
        raise InputError(
            "a layer has a colour, an aci and a width_mm, or is false", where=where, got=repr(value)
        )
    colour, aci, width = value["colour"], value["aci"], value["width_mm"]
    colour = LIGHT.get(colour, colour) if isinstance(colour, str) else colour
    if not isinstance(colour, str) or not _COLOUR.fullmatch(colour.lower()):
        raise InputError(
            "no colour", where=f"{where} colour", got=repr(colour), expected='as in "#ff0000"'
        )
    if type(aci) is not int or not 1 <= aci <= 255:
        raise InputError(
            "no AutoCAD colour", where=f"{where} aci", got=repr(aci), expected="1 to 255"
        )
    return Pen(colour.lower(), aci, _size(f"{where} width_mm", width, 10.0))


def _size(where: str, value: Any, most: float) -> float:
    if type(value) not in (int, float) or not 0 < value <= most:
        raise InputError(
            "no length", where=where, got=repr(value), expected=f"above 0, at most {most:g} mm"
        )
    return float(value)
