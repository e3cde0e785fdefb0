"""From the flat sheet to drawings that a workshop can cut."""

from orishell.workshop.palettes import LAYERS, Circle, Drawing, Layer, Line, Text
from orishell.workshop.settings import DEFAULT, Workshop

__all__ = ["DEFAULT", "LAYERS", "Circle", "Drawing", "Layer", "Line", "Text", "Workshop"]
