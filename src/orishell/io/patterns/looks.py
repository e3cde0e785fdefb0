"""What the look of a line stands for: the name of its layer, or else its colour."""

from __future__ import annotations

import re
from colorsys import rgb_to_hsv
from typing import Final

IGNORED: Final = "-"
"""Stands for a line that is no part of the pattern."""

_WORDS: Final = {
    "M": ("mountain", "mountains"),
    "V": ("valley", "valleys"),
    "B": ("border", "borders", "boundary", "outline"),
    "C": ("cut", "cuts"),
    "F": ("flat", "facet", "facets", "engrave", "unfolded"),
    "U": ("unassigned", "hinge", "hinges", "undriven"),
    IGNORED: ("label", "labels", "text", "title"),
}
_LETTERS: Final = {word: letter for letter, words in _WORDS.items() for word in words}
_WORD = re.compile("[A-Z]?[a-z]+|[A-Z]+")

HUES: Final = {0: "M", 60: "F", 120: "C", 240: "V", 300: "U", 360: "M"}
"""Red, yellow, green, blue and magenta (degrees), as in Origami Simulator's "File Import Tips"."""
NEAR_HUE = 25.0
DARK, GREY = 0.35, 0.25
"""Below this value a colour is black, below this saturation it is no hue."""

_NAMED: Final = {
    "black": "#000000", "red": "#ff0000", "blue": "#0000ff", "lime": "#00ff00",
    "green": "#008000", "yellow": "#ffff00", "magenta": "#ff00ff", "fuchsia": "#ff00ff",
    "cyan": "#00ffff", "aqua": "#00ffff", "gray": "#808080", "grey": "#808080",
    "navy": "#000080", "maroon": "#800000", "white": "#ffffff",
}  # fmt: skip
_HEX = re.compile("#([0-9a-f]{3,4}|[0-9a-f]{6}|[0-9a-f]{8})")
_RGB = re.compile(r"rgba?\(\s*(\d{1,3}(?:\.\d{1,9})?%?)[\s,]+(\d{1,3}(?:\.\d{1,9})?%?)[\s,]+"
                  r"(\d{1,3}(?:\.\d{1,9})?%?)[^()]*\)")  # fmt: skip

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
    near = min(HUES, key=lambda known: abs(known - 360 * hue))
    return HUES[near] if abs(near - 360 * hue) <= NEAR_HUE else None


def parse_colour(text: str) -> Colour | None:
    """A colour as SVG writes it; None if it is none that is known."""
    text = text.strip().lower()[:60]
    found = _HEX.fullmatch(_NAMED.get(text, text))
    if found:
        digits = found[1] if len(found[1]) > 4 else "".join(2 * digit for digit in found[1])
        red, green, blue = (int(digits[k : k + 2], 16) / 255 for k in (0, 2, 4))
        return red, green, blue
    parts = _RGB.fullmatch(text)
    if parts is None:
        return None
    red, green, blue = (
        min(float(part.rstrip("%")) / (100 if part.endswith("%") else 255), 1.0)
        for part in parts.groups()
    )
    return red, green, blue
