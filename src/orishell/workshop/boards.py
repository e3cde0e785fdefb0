"""Boards as they are seen from outside, and their part numbers."""

from __future__ import annotations

from dataclasses import replace
from typing import Final, Literal

import numpy as np

from orishell.conventions.record import record
from orishell.document import Document, Part
from orishell.motion.boards import Boards
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.creases import mean_edge
from orishell.workshop.fitted_words import label_edges, label_middles, ways_across
from orishell.workshop.hung_lines import Hung
from orishell.workshop.palettes import Line, Text
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
    """The boards of one side as they are seen from there."""

    numbers: Integers  # their numbers (B,) among all boards
    names: tuple[str, ...]  # their part numbers, as in "3,12T"
    panels: Integers  # the panels (B,) that carry them
    # corners (B, K, 2) of what is cut, counter-clockwise; neighbours may coincide; solid panels are
    # cut on their hinge plane
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
    before = np.concatenate([outline[-1:], outline[:-1]])
    return np.asarray(outline[(outline != before).any(axis=1)])


LARGEST_NUMBER = 0.25
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
    hung = hung_on(document, boards, side)
    labels = label_middles(
        boards.names,
        hung.clear,
        ways_across(corners),
        LARGEST_NUMBER * mean_edge(document),
        [
            (boards.outlines, _taken_by_holes(document, boards, side)),
            (corners, beside),
            (hung.clear, hung.taken),
        ],
    )
    return labels.of(None if panels is None else np.isin(boards.panels, panels))


def hung_on(document: Document, boards: SeenBoards, side: Side) -> Hung:
    """Where other parts hang on the boards of a side; on solid ones, on both of their faces."""
    return Hung.on(document, boards.outlines, boards.panels, side or None)


def has_sheet(document: Part) -> bool:
    """Whether the flat sheet is built: not where panels are solid, on hinges of their own."""
    build = document.panel
    return document.boards is None or build is None or not build.is_solid


def cut_of_sheet(document: Document) -> Document:
    """The document with those parts only that are cut from the flat sheet, or from its membrane."""
    document = document.as_cut()
    parts = tuple(part for part in document.attached if has_sheet(part))
    return document if len(parts) == len(document.attached) else replace(document, attached=parts)


def has_membrane(document: Document) -> bool:
    """Whether boards are glued on the sheet, on one face or on both."""
    return document.boards is not None and bool(document.boards.sides.any())


def sheet_title(document: Document) -> str:
    """The document's title, with a word that the sheet is a membrane if boards are glued on it."""
    return document.title + (", membrane" if has_membrane(document) else "")


FLUSH = 1e-9
"""Chamfers narrower than this share of the mean edge are none."""
LARGEST_ANGLE, SMALLEST_ANGLE = 0.06, 0.02
"""Height of angles at most and at least, as shares of the mean edge; smaller ones are left out."""
ROOM = 1.5
"""Heights of an angle that must fit on the panel's face."""
PLACE = 0.2
"""Where an angle stands on its edge, from its first end: opposite ones do not meet."""


@record
class _Chamfers:
    """Chamfers (C,) and the faces that they leave."""

    boards: Integers  # The boards that have them, as places among the solid ones
    ends: Array  # Ends (C, 2, 2) of the edge on the face, the panel to the left
    angles_deg: Array  # How far they lean from square (degrees)
    sides: Integers  # The face: 1 top, -1 bottom


def solid_marks(document: Document) -> list[Content]:
    """Lines and words on every solid panel, in the sheet's own coordinates.

    Edges of both faces where they are chamfered, the chamfer's angle against a square cut with T or
    B for the face that it takes from, where there is room for it, lines along which other parts
    hang, and the part number.
    """
    assert document.boards is not None
    solids = seen_from_outside(document, 0)
    size = mean_edge(document)
    chamfers = _find_chamfers(_solid_levels(document.boards), FLUSH * size)
    inner = _common_faces(document.boards)
    words = tuple(
        f"{angle:.1f}°{'T' if side > 0 else 'B'}"
        for angle, side in zip(chamfers.angles_deg, chamfers.sides, strict=True)
    )
    at = chamfers.boards
    most = LARGEST_ANGLE * size
    angles = label_edges(
        words, inner[at], chamfers.ends, tall=ROOM, most=most, share=PLACE, usual=100
    )
    shown = angles.heights >= SMALLEST_ANGLE * size
    corners = document.require_flat()[document.mesh.faces[solids.panels]]
    across, most = ways_across(corners), LARGEST_NUMBER * size
    hung = Hung.on(document, solids.outlines, solids.panels, words=inner)
    numbers = label_middles(solids.names, hung.clear, across, most)
    taken = np.maximum(_taken_by_holes(document, solids, 0), hung.taken)
    meets = shown & numbers.at(at).meet(angles)
    np.maximum.at(taken, at, np.where(meets, 1.5 * angles.heights, 0.0))
    numbers = label_middles(solids.names, hung.clear, across, most, [(hung.clear, taken)])
    texts: list[list[Text]] = [[*each] for each in hung.texts]
    for board, text in zip(at[shown].tolist(), angles.of(shown), strict=True):
        texts[board].append(text)
    for board, text in enumerate(numbers.of()):
        texts[board].append(text)
    lines: list[list[Line]] = [[*each] for each in hung.lines]
    for board, ends in zip(at.tolist(), chamfers.ends, strict=True):
        lines[board].append(Line("ENGRAVE", ends))
    return [((*drawn,), (), (*words,)) for drawn, words in zip(lines, texts, strict=True)]


def _taken_by_holes(document: Document, seen: SeenBoards, side: Side) -> Array:
    """Width (B,) along the edges of boards of a side that holes take."""
    holes, taken = document.holes, np.zeros(len(seen.numbers))
    if holes is None:
        return taken
    number = np.full(len(document.mesh.faces), -1)
    number[seen.panels] = np.arange(len(seen.panels))
    board = number[holes.panels]
    there = board >= 0
    outline = seen.outlines[board[there]]
    middles = holes.middles[there] * (MIRRORED if side < 0 else 1.0)
    away, along = middles[:, None] - outline, np.roll(outline, -1, axis=1) - outline
    size = np.linalg.norm(along, axis=-1)
    across = along[..., 0] * away[..., 1] - along[..., 1] * away[..., 0]
    off = np.divide(across, size, out=np.full_like(size, np.inf), where=size > 0).min(axis=1)
    np.maximum.at(taken, board[there], off + holes.diameters[there])
    return taken


def chamfer_angles(boards: Boards) -> Array:
    """How far all chamfers (C,) of solid panels lean from a square cut (degrees)."""
    levels = _solid_levels(boards)
    if not len(levels):
        return np.zeros(0)
    sides = np.diff(levels[:, 1, :, :2], axis=1, append=levels[:, 1, :1, :2])
    return _find_chamfers(levels, FLUSH * float(np.hypot(*sides.T).mean())).angles_deg


def _find_chamfers(levels: Array, flush: float) -> _Chamfers:
    """The chamfers of solid panels (S, 3, K, 3), at the top and then at the bottom.

    Those narrower than ``flush`` are none.
    """
    middle = levels[:, 1, :, :2]
    found = []
    for side, level in ((1, levels[:, 2]), (-1, levels[:, 0])):
        face = level[..., :2]
        run, along = (np.roll(each, -1, axis=1) - each for each in (middle, face))
        long, there = np.hypot(*np.moveaxis(run, -1, 0)), np.hypot(*np.moveaxis(along, -1, 0))
        away = face - middle
        area = run[..., 0] * away[..., 1] - run[..., 1] * away[..., 0]
        width = np.divide(area, long, out=np.zeros_like(long), where=long > flush)
        height = np.abs(level[..., 2] - levels[:, 1, :, 2])
        board, corner = np.nonzero((width > flush) & (there > flush))
        ends = np.stack([face, np.roll(face, -1, axis=1)], axis=2)
        leaning = np.rad2deg(np.arctan2(width, height))
        found.append(
            (board, ends[board, corner], leaning[board, corner], np.full(len(board), side))
        )
    return _Chamfers(*(np.concatenate(each) for each in zip(*found, strict=True)))


def _common_faces(boards: Boards) -> Array:
    """Corners (S, K, 2) of what both faces of every solid panel have in common, seen from above.

    Where that is nothing, those of its outline on the hinge plane.
    """
    import shapely

    levels = _solid_levels(boards)[..., :2]
    bottom, middle, top = (np.asarray(shapely.polygons(levels[:, k])) for k in range(3))
    common = np.asarray(shapely.intersection(bottom, top))
    empty = shapely.area(common) <= FLUSH * shapely.area(middle)
    rings = shapely.normalize(np.where(empty, middle, common))
    points, owner = shapely.get_coordinates(rings, return_index=True)
    counts = np.bincount(owner, minlength=len(levels))
    place = np.minimum(np.arange(counts.max(initial=1) - 1), counts[:, None] - 2)
    clockwise = points[place + (np.cumsum(counts) - counts)[:, None]]
    return np.asarray(clockwise[:, ::-1])


def _solid_levels(boards: Boards) -> Array:
    """Corners (S, 3, K, 3) of solid boards: lowest, on the hinge plane, highest.

    Those that are cut square have no outline between.
    """
    levels = boards.outlines[boards.sides == 0]
    return np.asarray(levels[:, [0, levels.shape[1] // 2, -1]])
