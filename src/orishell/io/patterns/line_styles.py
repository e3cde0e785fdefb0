"""What the look of a line stands for: the name of its layer, or else its colour."""

from __future__ import annotations

import re
from colorsys import rgb_to_hsv
from typing import Final

IGNORED: Final = "-"
"""Stands for a line that is no part of the pattern."""
AUXILIARY: Final = "+"
"""Stands for a line that helped to draw it: left out, and counted."""

_WORDS: Final = {
    "M": ("mountain", "mountains"),
    "V": ("valley", "valleys"),
    "B": ("border", "borders", "boundary", "outline"),
    "C": ("cut", "cuts"),
    "F": ("flat", "facet", "facets", "engrave", "unfolded"),
    "U": ("unassigned", "hinge", "hinges", "undriven"),
    IGNORED: ("label", "labels", "text", "title"),
    AUXILIARY: ("aux", "auxiliary", "construction", "guide", "guides", "noname"),
}
_LETTERS: Final = {word: letter for letter, words in _WORDS.items() for word in words}
"""ORIPA calls the layer of auxiliary lines "noname"."""
_WORD = re.compile("[A-Z]?[a-z]+|[A-Z]+")

HUES: Final = {"M": (335, 385), "F": (40, 85), "C": (90, 160), "V": (195, 270), "U": (275, 330)}
"""Hues (degrees, from and to) of red, yellow, green, blue and magenta, as in Origami Simulator's
"File Import Tips", and of what people call so."""
DARK, GREY = 0.35, 0.25
"""Below this value a colour is black, below this saturation it is no hue."""

Colour = tuple[float, float, float]
"""Red, green and blue from 0 to 1."""


def letter_of_layer(name: str) -> str | None:
    """The letter that a layer's name stands for; None if it stands for none."""
    words = [word.lower() for word in _WORD.findall(name[:200])]  # those of MountainLine, too
    return next((_LETTERS[word] for word in words if word in _LETTERS), None)


def letter_of_colour(colour: Colour) -> str | None:
    """The letter that a colour stands for; None if it stands for none."""
    hue, saturation, value = rgb_to_hsv(*colour)
    if value < DARK and not (saturation > 0.9 and value > 0.3):
        return "B"
    if saturation < GREY:
        return None
    degrees = 360 * hue + (360 if 360 * hue < HUES["M"][1] - 360 else 0)
    return next((each for each, (low, high) in HUES.items() if low <= degrees <= high), None)


def parse_colour(text: str) -> Colour | None:
    """A colour as SVG writes it; None if it is none that is known, or nothing is seen of it."""
    from tinycss2.color3 import parse_color

    found = parse_color(text[:200])
    if found is None or isinstance(found, str) or not found.alpha:
        return None
    red, green, blue = (min(max(float(each), 0.0), 1.0) for each in found[:3])
    return red, green, blue
