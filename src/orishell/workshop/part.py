"""What is cut in one piece: the whole sheet, or one of the parts that it is split into."""

from __future__ import annotations

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.drawing import Line, Text


@record
class Part:
    """A piece of the flat sheet, in the sheet's own coordinates.

    Parameters
    ----------
    number
        Its number, from 1; 0 if the sheet is not split.
    panels
        Numbers (P,) of its panels.
    creases
        Numbers (C,) of the edges that fold in it, those at the root of tabs too.
    outlines
        Closed polylines (k, 2) that are cut: the outer one first, counter-clockwise; holes
        clockwise. Tabs are part of the outline.
    marks
        What else is drawn on it, for instance the names of its joints.
    """

    number: int
    panels: Integers
    creases: Integers
    outlines: tuple[Array, ...]
    marks: tuple[Line | Text, ...] = ()
