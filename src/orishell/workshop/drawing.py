"""A drawing for a machine, in layers: cuts, creases, engravings, and words beside the work.

Every format for the workshop draws the same :class:`Drawing`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from orishell.conventions.record import record
from orishell.numerics.arrays import Array

Layer = Literal["CUT", "MOUNTAIN", "VALLEY", "ENGRAVE", "LABEL"]
LAYERS: tuple[Layer, ...] = ("CUT", "MOUNTAIN", "VALLEY", "ENGRAVE", "LABEL")
"""Outer cut and holes; creases; what is marked on the work (labels); what is not on the work at
all (title block, scale bar)."""

ORDER: tuple[Layer, ...] = ("LABEL", "ENGRAVE", "MOUNTAIN", "VALLEY", "CUT")
"""The layers in the order of work: what is cut comes last, so that nothing moves before."""

Anchor = Literal["middle", "start", "end"]


@record
class Line:
    """A polyline in a layer.

    Parameters
    ----------
    layer
        Its layer.
    points
        Points (k, 2), x to the right, y up.
    closed
        Whether the last point is joined to the first.
    """

    layer: Layer
    points: Array
    closed: bool = False


@dataclass(frozen=True, slots=True)
class Circle:
    """A circle in a layer.

    Parameters
    ----------
    layer
        Its layer.
    x, y, radius
        Its middle and radius, in the unit of the drawing.
    """

    layer: Layer
    x: float
    y: float
    radius: float


@dataclass(frozen=True, slots=True)
class Text:
    """Words in a layer.

    Parameters
    ----------
    layer
        Its layer.
    x, y
        Where its anchor lies, half the height above the baseline.
    height
        Height of its capitals, in the unit of the drawing.
    words
        One line of text.
    angle
        Direction of the baseline, counter-clockwise from x (radians).
    anchor
        Which point of the line of text lies at (x, y).
    """

    layer: Layer
    x: float
    y: float
    height: float
    words: str
    angle: float = 0.0
    anchor: Anchor = "middle"


@record
class Drawing:
    """One sheet for a machine.

    Parameters
    ----------
    title
        One line that says what it is.
    unit
        Unit of length: mm, cm, m, in or ft.
    width, height
        Size of the page; everything lies between (0, 0) and it.
    lines, circles, texts
        What is drawn, in the order in which a machine should do it: marks and creases first,
        holes then, the outer cut last.
    """

    title: str
    unit: str
    width: float
    height: float
    lines: tuple[Line, ...]
    circles: tuple[Circle, ...] = ()
    texts: tuple[Text, ...] = ()
