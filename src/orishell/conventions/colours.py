"""What colour means what, in every picture, file and page.

Mountains are red and valleys blue, as in textbooks. On dark pages the same hues are lighter
(:data:`DARK`). The palettes of machines say something else by their colours: what is cut, scored
and engraved (``workshop/palettes.toml``); the one to look at takes these.
"""

from __future__ import annotations

from collections.abc import Mapping

LIGHT: Mapping[str, str] = {
    "mountain": "#d62728",
    "valley": "#1f5fbf",
    "unfolded": "#858a92",
    "border-crease": "#000000",
    "panel-front": "#f4efe4",
    "panel-back": "#b8c7db",
    "curve-f": "#0a8f3c",
    "curve-g": "#b5179e",
    "target": "#14868f",
    "contact": "#ff7f0e",
    "flap": "#7a4fb3",
    "tie": "#7b4a12",
    "foot": "#20242a",
    "load": "#44526b",
    "fails": "#a8281e",
    "warns": "#8a5a00",
    "holds": "#14656d",
}
"""Colour of every meaning on light ground, as "#rrggbb"."""

DARK: Mapping[str, str] = {
    "mountain": "#ff6a5b",
    "valley": "#6ea6ff",
    "unfolded": "#8f96a0",
    "border-crease": "#f1ede4",
    "panel-front": "#d9cfbd",
    "panel-back": "#8fa3b5",
    "curve-f": "#6fd98f",
    "curve-g": "#f08fd0",
    "target": "#58c9cf",
    "contact": "#ffb03b",
    "flap": "#bfa2f0",
    "tie": "#e0b070",
    "foot": "#f4f1ea",
    "load": "#b4c2da",
    "fails": "#ff8e82",
    "warns": "#f2c063",
    "holds": "#6fc7c3",
}
"""Colour of every meaning on dark ground, as "#rrggbb"."""

DISTANCE_MAP = (
    "#0b4f6c",
    "#2f7f9a",
    "#7db3c0",
    "#c9dde0",
    "#f6f1e6",
    "#ecd0a6",
    "#d79a55",
    "#ad6320",
    "#6d370c",
)
"""Distances from the surface: below it, the surface itself in the middle, above it."""

AMOUNT_MAP = ("#f7f1dc", "#f3d9a4", "#e9b06f", "#d6815a", "#b4565b", "#803a63", "#45285a")
"""None to the most, light and calm to deep: fold angles, displacements, stresses."""

MEANINGS = {
    "M": "mountain",
    "V": "valley",
    "F": "unfolded",
    "U": "unfolded",
    "J": "unfolded",
    "B": "border-crease",
    "C": "border-crease",
}
"""What an assignment of FOLD means."""


def rgb(meaning: str) -> tuple[float, float, float]:
    """Red, green and blue (0 ... 1) of a meaning on light ground, as screens take them.

    Parameters
    ----------
    meaning
        A key of :data:`LIGHT`.
    """
    number = int(LIGHT[meaning][1:], 16)
    return (number >> 16) / 255, (number >> 8 & 255) / 255, (number & 255) / 255


def linear_rgb(meaning: str) -> tuple[float, float, float]:
    """Red, green and blue of a meaning as amounts of light, by the curve of sRGB (IEC 61966-2-1).

    Parameters
    ----------
    meaning
        A key of :data:`LIGHT`.
    """
    red, green, blue = (
        each / 12.92 if each <= 0.04045 else ((each + 0.055) / 1.055) ** 2.4
        for each in rgb(meaning)
    )
    return red, green, blue
