"""The lines of a crease pattern in an SVG file, by any drawing program."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from orishell.conventions.errors import InputError
from orishell.curves.svg.shapes import draw_shape, line_ends
from orishell.curves.svg.styles import UNPAINTED, inherited, read_styled
from orishell.curves.svg.tree import NUMBER, Element
from orishell.curves.svg.walk import Context, Walk, has_physical_size, name_of
from orishell.io.fold_content import LETTERS
from orishell.io.patterns.line_styles import (
    IGNORED,
    letter_of_colour,
    letter_of_layer,
    parse_colour,
)
from orishell.io.patterns.lines import Lines
from orishell.io.patterns.strokes import Stroke, lines_of, straight_ends
from orishell.motion.crease_pattern import SENSE
from orishell.numerics.arrays import Array

MOST_ELEMENTS = 1_000_000
_SHARE = re.compile(rf"({NUMBER})(%?)")
ASSIGNMENT = "data-assignment"
"""The letter itself, as Rabbit Ear writes it."""
LOOKS = (
    "stroke",
    "style",
    "class",
    "id",
    "label",
    "opacity",
    "stroke-opacity",
    "color",
    ASSIGNMENT,
)
"""Attributes that the look of an element depends on."""
Look = tuple[str | None, float]
"""Letter, or None for a look of no known meaning, and fold angle (radians)."""
DOWNWARDS = np.array([1.0, -1.0])


def read_svg_lines(path: Path, *, whole: bool) -> tuple[Lines, str, list[str]]:
    """What an SVG file draws, y upwards, its unit, and what was assumed.

    Lengths are millimetres where the page has a physical size, else user units ("unit"). Letters
    are those of the layer (the name of a group or a class) or else of the stroke. Opacity is a fold
    angle, in half turns, as Origami Simulator has it, if a line has any.

    Parameters
    ----------
    whole
        Whether coordinates are to stay as in the file, whatever its page's size.

    Raises
    ------
    InputError
        If the file cannot be read, or draws a curve.
    """
    root = read_styled(path, MOST_ELEMENTS)
    physical = not whole and has_physical_size(root)
    looks = _Looks()
    strokes, circles, unseen = [], 0, 0
    for number, (element, context) in enumerate(
        Walk(root, None, MOST_ELEMENTS).shapes(whole=not physical), start=1
    ):
        look = looks.of(element, context)
        if look is None:
            unseen += 1
            continue
        letter, angle = look
        if letter == IGNORED:
            continue
        if element.tag in {"circle", "ellipse"}:
            circles += 1
            continue
        name = f"{name_of(element)} number {number}"
        try:
            ends = _straight(element, context)
        except InputError as error:
            raise error.located(name) from None
        strokes.append(Stroke(name, ends * DOWNWARDS, letter, angle))
    lines, notes = lines_of(strokes, downwards=True)
    for count, what in ((unseen, "shapes without a stroke"), (circles, "circles")):
        if count:
            notes.append(f"{what} are no creases: {count} left out")
    return lines, "mm" if physical else "unit", notes


def _straight(element: Element, context: Context) -> Array:
    """Both ends (N, 2, 2) of the lines of a shape, on the page."""
    if element.tag == "line":
        ends = np.array([line_ends(element, context.view)])
    else:
        ends = straight_ends(draw_shape(element, context.view))
    return ends @ context.affine.matrix + context.affine.offset


class _Looks:
    """How elements look: by their attributes, style sheets, and what they are in."""

    def __init__(self) -> None:
        self.known: dict[tuple[object, ...], Look | None] = {}
        self.kept: list[object] = []  # so that no id is used twice

    def of(self, element: Element, context: Context) -> Look | None:
        """Letter and fold angle of an element; None if it draws no line."""
        key = (id(context.parents), id(element.sheet), *map(element.attributes.get, LOOKS))
        if key not in self.known:
            self.kept += [context.parents, element.sheet]
            self.known[key] = self._look((*context.parents, element))
        return self.known[key]

    def _look(self, line: tuple[Element, ...]) -> Look | None:
        stroke = inherited("stroke", line)
        if stroke.lower() == "currentcolor":
            stroke = inherited("color", line) or "black"
        if stroke in UNPAINTED:
            return None
        given = line[-1].attributes.get(ASSIGNMENT, "").strip().upper()
        letter = given if given in LETTERS else None
        letter = letter or next(filter(None, map(_layer, reversed(line))), None)
        if letter is None:
            colour = parse_colour(stroke)
            letter = None if colour is None else letter_of_colour(colour)
        return letter, _angle(letter, line)


def _angle(letter: str | None, line: tuple[Element, ...]) -> float:
    """The fold angle that the opacity stands for (radians); NaN if none is given."""
    sign = SENSE.get(letter or "", 0.0)
    given = (inherited(each, line) for each in ("opacity", "stroke-opacity"))
    share = _SHARE.fullmatch(next(filter(None, given), ""))
    if not sign or share is None:
        return np.nan
    value = float(share[1]) / (100 if share[2] else 1)
    return float(sign * np.pi * min(max(value, 0.0), 1.0))


def _layer(element: Element) -> str | None:
    """The letter of an element's name, as a layer has one."""
    attributes = element.attributes
    if not ("id" in attributes or "class" in attributes or "label" in attributes):
        return None
    names = (attributes.get(each, "") for each in ("label", "id", "class"))
    return next(filter(None, map(letter_of_layer, names)), None)
