"""The elements of an SVG file, and its lengths and transforms."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, Final, NamedTuple

import numpy as np

from orishell.conventions.errors import InputError
from orishell.curves.pieces import Affine

Declarations = Mapping[str, "Declared"]
"""By property."""


class Declared(NamedTuple):
    """What a property is declared to be."""

    important: bool
    value: str


@lru_cache(maxsize=4096)
def inline(text: str) -> Declarations:
    """What an attribute ``style`` declares."""
    return declarations(text)


def declarations(content: str | Iterable[Any]) -> Declarations:
    """What the content of a rule declares, as text or parsed.

    Raises InputError: If brackets are nested too deeply.
    """
    import tinycss2

    try:
        return cascaded(
            {each.lower_name: Declared(each.important, tinycss2.serialize(each.value).strip())}
            for each in tinycss2.parse_blocks_contents(content, True, True)
            if each.type == "declaration"
        )
    except RecursionError:
        raise nested() from None


def nested() -> InputError:
    """The error for brackets within each other that are too many to be read."""
    return InputError(
        "brackets of a style are nested too deeply",
        remedy="save it with presentation attributes in place of styles",
    )


def cascaded(ascending: Iterable[Declarations]) -> Declarations:
    """What counts of several, of which the last one counts most."""
    found: dict[str, Declared] = {}
    for each in ascending:
        for name, declared in each.items():
            if name not in found or declared.important >= found[name].important:
                found[name] = declared
    return found


NUMBER: Final = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
PER_INCH: Final = {
    "": 96, "px": 96, "in": 1, "cm": 2.54, "mm": 25.4, "q": 101.6, "pt": 72, "pc": 6,
}  # fmt: skip
PIXELS: Final = {unit: 96 / count for unit, count in PER_INCH.items()}
"""User units in each unit of length: CSS has 96 pixels in an inch."""
MILLIMETRES: Final = {unit: 25.4 / count for unit, count in PER_INCH.items()}
PIXEL_MM: Final = MILLIMETRES["px"]

IDENTITY: Final = Affine(np.eye(2), np.zeros(2))

# No two repetitions that match the same stand side by side, so that each takes linear time.
VALUE: Final = re.compile(rf"\s*(?:,\s*)?({NUMBER})")
_LENGTH = re.compile(rf"({NUMBER})\s*([A-Za-z]+|%)?")
_TRANSFORM = re.compile(r"\s*(?:,\s*)?([A-Za-z]+)\s*\(([^()]*)\)")
_COUNTS = {
    "matrix": (6,),
    "translate": (1, 2),
    "scale": (1, 2),
    "rotate": (1, 3),
    "skewX": (1,),
    "skewY": (1,),
}


@dataclass(frozen=True, slots=True)
class View:
    """What percentages refer to: the size of the viewport, in user units."""

    width: float
    height: float

    def along(self, axis: str) -> float:
        """The length that 100 % stands for, along "x", "y", or neither."""
        if axis == "x":
            return self.width
        if axis == "y":
            return self.height
        return float(np.hypot(self.width, self.height) / np.sqrt(2))


def parse_length(text: str, hundred: float, scales: Mapping[str, float] = PIXELS) -> float:
    """A length in user units (or what ``scales`` leads to); 100 % is ``hundred``."""
    found = _LENGTH.fullmatch(text.strip())
    unit = (found[2] or "").lower() if found else ""
    if found is None or (unit != "%" and unit not in scales):
        raise InputError(
            "this is no length",
            got=repr(text[:40]),
            expected="a number, with one of " + ", ".join(filter(None, scales)) + " or without",
        )
    value = float(found[1])
    return value * hundred / 100 if unit == "%" else value * scales[unit]


def parse_numbers(text: str) -> list[float]:
    """Numbers that are separated by commas or blanks."""
    text = text.rstrip()
    numbers, at = [], 0
    while at < len(text):
        found = VALUE.match(text, at)
        if found is None:
            raise InputError(
                "this is no list of numbers",
                where=f"character {at + 1}",
                got=repr(text[at:][:40]),
            )
        numbers.append(float(found[1]))
        at = found.end()
    return numbers


def parse_transform(text: str) -> Affine:
    """The map that an attribute ``transform`` asks for."""
    text = text.rstrip()
    result, at = IDENTITY, 0
    while at < len(text):
        found = _TRANSFORM.match(text, at)
        numbers = parse_numbers(found[2]) if found else []
        if found is None or len(numbers) not in _COUNTS.get(found[1], ()):
            raise InputError(
                "this is no transform",
                got=repr(text[at : at + 60]),
                expected="matrix, translate, scale, rotate, skewX or skewY, with their numbers",
            )
        result = result.after(_step(found[1], numbers))
        at = found.end()
    return result


def _step(name: str, numbers: list[float]) -> Affine:
    match name, numbers:
        case "matrix", [a, b, c, d, e, f]:
            return Affine.of(a, b, c, d, e, f)
        case "translate", [x, *rest]:
            return Affine.of(1, 0, 0, 1, x, rest[0] if rest else 0.0)
        case "scale", [x, *rest]:
            return Affine.of(x, 0, 0, rest[0] if rest else x, 0, 0)
        case "rotate", [degrees, *centre]:
            quarters = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))
            angle = np.deg2rad(degrees)
            exact = quarters[int(degrees / 90 % 4)] if degrees % 90 == 0 else None
            cos, sin = exact or (float(np.cos(angle)), float(np.sin(angle)))
            x, y = centre or (0.0, 0.0)
            return Affine.of(cos, sin, -sin, cos, x - cos * x + sin * y, y - sin * x - cos * y)
        case "skewX", [degrees]:
            return Affine.of(1, 0, float(np.tan(np.deg2rad(degrees))), 1, 0, 0)
        case _:
            return Affine.of(1, float(np.tan(np.deg2rad(numbers[0]))), 0, 1, 0, 0)


def parse_view_box(text: str) -> tuple[float, float, float, float] | None:
    """The attribute ``viewBox``; None if it is absent."""
    if not text.strip():
        return None
    numbers = parse_numbers(text)
    if len(numbers) != 4 or not (numbers[2] > 0 and numbers[3] > 0):
        raise InputError(
            "this is no viewBox",
            got=repr(text[:60]),
            expected="x, y, and a width and a height above 0",
        )
    x, y, width, height = numbers
    return x, y, width, height


def fit_view_box(
    box: tuple[float, float, float, float], width: float, height: float, fit: str
) -> Affine:
    """The map from a viewBox to a viewport of a size, as ``preserveAspectRatio`` says."""
    x, y, box_width, box_height = box
    words = fit.split() or ["xMidYMid"]
    wide, high = width / box_width, height / box_height
    if words[0] == "none":
        return Affine.of(wide, 0, 0, high, -x * wide, -y * high)
    scale = max(wide, high) if words[1:] == ["slice"] else min(wide, high)
    shares = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}
    if re.fullmatch("x(Min|Mid|Max)Y(Min|Mid|Max)", words[0]) is None:
        raise InputError("this is no preserveAspectRatio", got=repr(fit[:40]))
    e = shares[words[0][1:4]] * (width - box_width * scale) - x * scale
    f = shares[words[0][5:8]] * (height - box_height * scale) - y * scale
    return Affine.of(scale, 0, 0, scale, e, f)


MAX_ELEMENTS = 200_000


@dataclass(slots=True, eq=False)
class Element:
    """An element."""

    tag: str  # empty if it is not of SVG's namespace
    # those without a namespace, and the :data:`LINKED` ones if there is no other of that name
    attributes: dict[str, str]
    children: list[Element] = field(default_factory=list)
    text: str = ""  # of a style sheet
    sheet: Declarations = field(default_factory=dict)  # what style sheets say of it

    def style(self, name: str) -> str:
        """A property: of ``style``, of style sheets or of the attribute; empty if it is unset."""
        own = self.attributes.get("style")
        if own is not None or self.sheet:
            both = self.sheet.get(name), inline(own or "").get(name)
            found = [(each.important, k, each.value) for k, each in enumerate(both) if each]
            if found:
                return max(found)[2]
        return self.attributes.get(name, "").strip()

    def all(self) -> Iterator[Element]:
        """Itself and all that it has, in the order of the file."""
        stack = [self]
        while stack:
            element = stack.pop()
            yield element
            stack += element.children[::-1]
