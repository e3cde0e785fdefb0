"""Boards as they are seen from outside, their part numbers, and where they are glued on."""

from __future__ import annotations

from dataclasses import replace
from typing import Final, Literal

import numpy as np

from orishell.conventions.record import record
from orishell.document import Document
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.creases import mean_edge
from orishell.workshop.cut_parts import CutPart
from orishell.workshop.drawing import Line, Text
from orishell.workshop.fitted_words import label_middles, ways_across
from orishell.workshop.placing import Content

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
    """The boards of a side: 1 top, -1 bottom, 0 solid panels (seen from above).

    Those at the bottom are seen from below, mirrored about the y axis.
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


LARGEST = 0.25
"""Height of a part number at most, as a share of the mean edge of panels."""


def board_labels(
    document: Document,
    side: Side,
    panels: Integers | None = None,
    taken: Array | float = 0.0,
) -> tuple[Text, ...]:
    """Part numbers in the middle of boards, or of the places where they are glued on.

    Boards at the bottom are seen from below, mirrored about the y axis. ``panels`` leaves out
    boards on others; ``taken`` (F,) is the width of other labels along the panels' edges.
    """
    boards = seen_from_outside(document, side)
    corners = document.require_flat()[document.mesh.faces[boards.panels]]
    if side < 0:
        corners = corners[:, ::-1] * MIRRORED
    beside = np.broadcast_to(taken, len(document.mesh.faces))[boards.panels]
    labels = label_middles(
        boards.names,
        boards.outlines,
        ways_across(corners),
        LARGEST * mean_edge(document),
        [(boards.outlines, 0.0), (corners, beside)],
    )
    everywhere = np.ones(len(boards.names), np.bool_)
    return labels.of(everywhere if panels is None else np.isin(boards.panels, panels))


def has_sheet(document: Document) -> bool:
    """Whether the flat sheet is built: not where panels are solid, on hinges of their own."""
    build = document.panel
    return document.boards is None or build is None or build.construction != "bevel"


def has_membrane(document: Document) -> bool:
    """Whether boards are glued on the sheet, on one face or on both."""
    return document.boards is not None and bool(document.boards.sides.any())


def sheet_title(document: Document) -> str:
    """The document's title, with a word that the sheet is a membrane if boards are glued on it."""
    return document.title + (", membrane" if has_membrane(document) else "")


def with_glue_areas(document: Document, part: CutPart) -> CutPart:
    """A part of the sheet with the places of the upper boards marked on it.

    Their part numbers are among the part's labels (:mod:`~orishell.workshop.labels`).
    """
    if not has_membrane(document):
        return part
    return replace(part, marks=(*part.marks, *_glue_lines(document, part, 1)))


def back_of(document: Document, part: CutPart) -> Content:
    """The back of a part, mirrored about the y axis: its rim and the places of the lower boards.

    Nothing of it is cut: the rim is there to lay the part on.
    """
    rims = (
        Line("ENGRAVE", distinct_corners(rim)[::-1] * MIRRORED, closed=True)
        for rim in part.outlines
    )
    lines = (*_glue_lines(document, part, -1), *rims)
    return lines, (), board_labels(document, -1, part.panels)


def _glue_lines(document: Document, part: CutPart, side: Side) -> tuple[Line, ...]:
    seen = seen_from_outside(document, side)
    here = np.isin(seen.panels, part.panels)
    return tuple(
        Line("ENGRAVE", distinct_corners(outline), closed=True) for outline in seen.outlines[here]
    )
