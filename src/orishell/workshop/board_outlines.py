"""Outlines of boards as a machine cuts them, seen from outside, and their part numbers."""

from __future__ import annotations

from typing import Final, Literal

import numpy as np

from orishell.conventions.record import record
from orishell.document import Document
from orishell.numerics.arrays import Array, Integers

Side = Literal[1, -1, 0]

SIDES: Final[tuple[Side, ...]] = (1, -1, 0)
"""In the order in which boards are drawn: top, bottom, solid panels."""

SIDE_LETTERS: Final[dict[int, str]] = {1: "T", -1: "B", 0: ""}
"""What the part number of a board ends with: top, bottom, or nothing for a solid panel."""

MIRRORED = np.array([-1.0, 1.0])
"""Turns what is seen from above to what is seen from below."""


@record
class SeenBoards:
    """The boards of one side as they are seen from there.

    Parameters
    ----------
    numbers
        Their numbers (B,) among all boards.
    names
        Their part numbers, as in "3,12T".
    panels
        Numbers (B,) of the panels that carry them.
    outlines
        Corners (B, K, 2) of what is cut, counter-clockwise; neighbours may coincide. Solid panels
        are cut on their hinge plane.
    """

    numbers: Integers
    names: tuple[str, ...]
    panels: Integers
    outlines: Array


def part_name(document: Document, board: int) -> str:
    """The part number of a board, the same on the board and where it is glued: "3,12T"."""
    assert document.boards is not None
    letter = SIDE_LETTERS[int(document.boards.sides[board])]
    return document.panel_name(int(document.boards.panels[board])) + letter


def seen_from_outside(document: Document, side: Side) -> SeenBoards:
    """The boards of a side; those at the bottom are seen from below, mirrored about the y axis.

    Parameters
    ----------
    side
        1 top, -1 bottom, 0 solid panels (seen from above).
    """
    assert document.boards is not None
    numbers = np.flatnonzero(document.boards.sides == side)
    levels = document.boards.outlines[numbers]
    outlines = levels[:, levels.shape[1] // 2, :, :2]
    if side < 0:
        outlines = outlines[:, ::-1] * MIRRORED
    return SeenBoards(
        numbers,
        tuple(part_name(document, board) for board in numbers.tolist()),
        document.boards.panels[numbers],
        outlines,
    )


def distinct_corners(outline: Array) -> Array:
    """The corners (k, 2) of a closed outline (K, 2), those that coincide taken once."""
    return np.asarray(outline[(outline != np.roll(outline, 1, axis=0)).any(axis=1)])
