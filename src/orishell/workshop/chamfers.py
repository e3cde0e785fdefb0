"""Marks on solid panels: the outlines on both faces, and the angles of the chamfers between."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.document import Document
from orishell.motion.boards import Boards
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.boards import seen_from_outside
from orishell.workshop.creases import mean_edge
from orishell.workshop.drawing import Line, Text
from orishell.workshop.fitted_words import label_edges, label_middles, ways_across

FLUSH = 1e-9
"""Chamfers narrower than this share of the mean edge are none."""
LARGEST = 0.25
"""Height of part numbers at most, as a share of the mean edge."""
LARGEST_ANGLE, SMALLEST_ANGLE = 0.06, 0.02
"""Height of angles at most and at least, as shares of the mean edge; smaller ones are left out."""
ROOM = 1.5
"""Heights of an angle that must fit on the panel's face."""
PLACE = 0.2
"""Where an angle stands on its edge, from its first end: opposite ones do not meet."""


@record
class _Chamfers:
    """Chamfers (C,) and the faces that they leave.

    Parameters
    ----------
    boards
        The boards that have them, as places among the solid ones.
    ends
        Ends (C, 2, 2) of the edge on the face, the panel to the left.
    angles_deg
        How far they lean from square (degrees).
    sides
        The face: 1 top, -1 bottom.
    """

    boards: Integers
    ends: Array
    angles_deg: Array
    sides: Integers


def solid_marks(document: Document) -> tuple[list[list[Line]], list[list[Text]]]:
    """Lines and words on every solid panel, in the sheet's own coordinates.

    Engraved are the edges of both faces where they are chamfered, the angle of the chamfer against
    a square cut with T or B for the face that it takes from, where there is room for it, and the
    part number.
    """
    solids = seen_from_outside(document, 0)
    size = mean_edge(document)
    chamfers = _find_chamfers(_solid_levels(document), FLUSH * size)
    lines: list[list[Line]] = [[] for _ in solids.names]
    texts: list[list[Text]] = [[] for _ in solids.names]
    for board, ends in zip(chamfers.boards.tolist(), chamfers.ends, strict=True):
        lines[board].append(Line("ENGRAVE", ends))

    inner = _common_faces(document)
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
    across, most = ways_across(corners), LARGEST * size
    numbers = label_middles(solids.names, inner, across, most)
    taken = np.zeros(len(inner))
    meets = shown & numbers.at(at).meet(angles)
    np.maximum.at(taken, at, np.where(meets, 1.5 * angles.heights, 0.0))
    numbers = label_middles(solids.names, inner, across, most, [(inner, taken)])
    for board, text in zip(at[shown].tolist(), angles.of(shown), strict=True):
        texts[board].append(text)
    for board, text in enumerate(numbers.of(np.ones(len(inner), np.bool_))):
        texts[board].append(text)
    return lines, texts


def chamfer_angles(boards: Boards) -> Array:
    """How far all chamfers (C,) of solid panels lean from a square cut (degrees).

    Parameters
    ----------
    boards
        The panels; boards of a sandwich are cut square.
    """
    levels = boards.outlines[boards.sides == 0]
    if not len(levels):
        return np.zeros(0)
    sides = np.diff(levels[:, 1, :, :2], axis=1, append=levels[:, 1, :1, :2])
    return _find_chamfers(levels, FLUSH * float(np.hypot(*sides.T).mean())).angles_deg


def _find_chamfers(levels: Array, flush: float) -> _Chamfers:
    """The chamfers of both faces, that at the top before that at the bottom.

    Parameters
    ----------
    levels
        Outlines (S, 3, K, 3) of solid panels.
    flush
        Chamfers narrower than this are none.
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


def _common_faces(document: Document) -> Array:
    """Corners (S, K, 2) of what both faces of every solid panel have in common, seen from above.

    Where that is nothing, those of its outline on the hinge plane.
    """
    import shapely

    levels = _solid_levels(document)[..., :2]
    bottom, middle, top = (np.asarray(shapely.polygons(levels[:, k])) for k in range(3))
    common = np.asarray(shapely.intersection(bottom, top))
    empty = shapely.area(common) <= FLUSH * shapely.area(middle)
    rings = shapely.normalize(np.where(empty, middle, common))
    points, owner = shapely.get_coordinates(rings, return_index=True)
    counts = np.bincount(owner, minlength=len(levels))
    place = np.minimum(np.arange(counts.max(initial=1) - 1), counts[:, None] - 2)
    clockwise = points[place + (np.cumsum(counts) - counts)[:, None]]
    return np.asarray(clockwise[:, ::-1])


def _solid_levels(document: Document) -> Array:
    assert document.boards is not None
    return np.asarray(document.boards.outlines[document.boards.sides == 0])
