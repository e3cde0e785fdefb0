"""How small a shell packs, and how many panels then lie on top of each other."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import Angle, record
from orishell.deployment.box import Box, smallest_box
from orishell.motion import Mechanism, diagonal
from orishell.motion.boards import Boards
from orishell.motion.layout import Layout, points_of
from orishell.motion.quads import area_vectors, lengths, unit_normals
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import NEAR
from orishell.solids.hinged.pieces import pieces_of

THIN = 1e-3
"""A bundle counts as at least this thick, relative to the diagonal of the flat sheet."""
PACKS = 9
"""States from the target on that are compared to find the one that packs smallest."""


@record
class Pack:
    """The state of a motion that fits into the smallest box, panels with their thickness."""

    REPORTED = ("drive", "length", "width", "height", "layers")

    drive: Angle  # its drive angle
    box: Box  # turned as it may be
    layers: int  # how many panels lie on top of each other: boards make it that many times as thick

    @property
    def length(self) -> float:
        """The longest side of its box."""
        return self.box.length

    @property
    def width(self) -> float:
        """The side between."""
        return self.box.width

    @property
    def height(self) -> float:
        """The shortest side."""
        return self.box.height


def find_pack(
    mechanism: Mechanism,
    limit: float,
    states: int = 25,
    thickness: float = 0.0,
    *,
    boards: Boards | None = None,
) -> Pack:
    """Return the state from the target to a limit that packs smallest.

    That is where length times width times height of the smallest box is least, a height below
    :data:`THIN` of the flat sheet's diagonal counting as that: otherwise a plane bundle of any size
    would be nothing. Of equals it is the last.

    Parameters
    ----------
    limit
        Drive angle up to which the motion is known to be free (radians), at least the target's.
    states
        Number of states that are compared, at equal steps of the drive.
    thickness
        Thickness of the panels (length): the box holds them as if they stood back from nothing.
    boards
        Whole boards with their arms, which the box holds instead; None for others.
    """
    faces = Layout.of(mechanism).faces
    floor, flat = THIN * diagonal(mechanism.positions(0.0)), points_of(mechanism, 0.0)[:, :2]

    def surfaces(points: Array) -> Array:
        if boards is None:
            return _surfaces(points, faces, thickness)
        return boards.carried(faces, flat, points).reshape(-1, 3)

    best: tuple[float, float, Box] | None = None
    for drive in np.linspace(limit, mechanism.target_drive, states).tolist():
        box = smallest_box(surfaces(points_of(mechanism, drive)))
        size = box.length * box.width * max(box.height, floor)
        if best is None or size < (1 - NEAR) * best[0]:
            best = size, drive, box
    assert best is not None
    _, drive, box = best
    # Whole boards may be stacked along any side of their box.
    axes = box.axes if boards is None else None
    return Pack(drive, box, count_layers(points_of(mechanism, drive), faces, axes))


def find_packs(
    mechanism: Mechanism, limit: float, boards: Boards, states: int = PACKS
) -> tuple[Pack, ...]:
    """Return the pack of every piece of whole boards, from its first row on.

    See :func:`find_pack`.
    """
    return tuple(
        find_pack(piece.sheet, limit, states, boards=piece.boards)
        for piece in pieces_of(mechanism, boards)
    )


def _surfaces(points: Array, faces: Integers, thickness: float) -> Array:
    """Vertices (V, 3) of panels (F, 4), or of their faces if they have a thickness."""
    if not thickness:
        return points
    corners = points[faces]
    over = 0.5 * thickness * unit_normals(corners)[:, None]
    return np.concatenate([corners + over, corners - over]).reshape(-1, 3)


SHRUNK = 1e-6
"""Panels are made smaller by this share, so that those beside each other do not overlap."""
SAME = 1e-3
"""Edges that leave each other by less than this share of that lie on each other."""
MOST_PAIRS, MOST_EACH = 20_000_000, 40
"""Pairs of panels that are looked at, at most; or so many for each panel, if that is more."""
SOME = 1000
"""Panels by which the number of pairs is judged."""
AT_ONCE, CACHED = 2**18, 2**12
"""Pairs that are looked at before layers are counted, and in one piece: memory grows with them."""


def count_layers(points: Array, faces: Integers, axes: Array | None = None) -> int:
    """Return how many panels lie on top of each other at most, seen along the box's shortest side.

    Panels of a thickness t make a bundle at least that many times t thick. Those seen edge-on do
    not count.

    Parameters
    ----------
    points
        Vertices (V, 3).
    faces
        Corners (F, 4) of the panels, in order around each.
    axes
        Directions (3, 3) of the box's sides, the shortest last; None for the smallest box.

    Notes
    -----
    Exact for convex panels: what the most of them have in common reaches to an edge of one of them,
    and each of the others covers one stretch of that edge. In a bundle where more than
    :data:`MOST_PAIRS` pairs may overlap, and more than :data:`MOST_EACH` for each panel, only the
    edges of some panels are looked at, spread evenly over the sheet: so many layers there are, and
    there may be more.
    """
    import shapely

    axes = smallest_box(points).axes if axes is None else axes
    corners = points[faces]
    centre = corners.mean(axis=1, keepdims=True)
    corners = (centre + (1 - SHRUNK) * (corners - centre)) @ axes.T
    normal = area_vectors(corners)
    seen = np.abs(normal[:, 2]) > SHRUNK * lengths(normal)
    if not seen.any():
        return 1
    outlines, area = corners[seen][..., :2], normal[seen, 2]
    outlines[area < 0] = outlines[area < 0, ::-1]
    planes = _half_planes(outlines, np.abs(area))
    frames = shapely.box(*outlines.min(axis=1).T, *outlines.max(axis=1).T)
    tree = shapely.STRtree(frames)

    count = len(outlines)
    some = frames[:: count // SOME + 1]
    each = tree.query(some).shape[1] / len(some)
    step = int(np.ceil(each * count / max(MOST_PAIRS, MOST_EACH * count)))
    examined, together = np.arange(0, count, step), max(int(AT_ONCE / each), 1)
    most = 1
    for part in np.split(examined, np.arange(together, len(examined), together)):
        first, second = tree.query(frames[part])
        stretches = [
            _stretches(outlines[part[first[k : k + CACHED]]], planes[second[k : k + CACHED]])
            for k in range(0, len(first), CACHED)
        ]
        start, stop = np.concatenate(stretches, axis=1)
        most = max(most, _most_at_once(first, start, stop, most))
    return most


def _half_planes(outlines: Array, area: Array) -> Array:
    """What outlines (F, 4, 2) of areas (F,), counter-clockwise, have in common: (F, 4, 3).

    The numbers a, b, c of every edge; a place (x, y) is inside it where ax + by + c is not
    negative. They stand a little outside the edges, which coincide but for rounding.
    """
    x, y = np.moveaxis(outlines, -1, 0)
    right, up = np.roll(x, -1, axis=1) - x, np.roll(y, -1, axis=1) - y
    length = np.hypot(right, up)
    width = (area / length.max(axis=1))[:, None]
    unit = np.where(length > 0, length, 1.0)
    a, b = -up / unit, right / unit
    return np.stack([a, b, SAME * SHRUNK * width - a * x - b * y], axis=-1)


def _stretches(outlines: Array, planes: Array) -> Array:
    """Where the edges of outlines (P, 4, 2) enter and leave others: shares (2, P, 4) of the edges.

    The others (P, 4, 3) are given by their half planes. Edges that do not meet them leave them
    before they enter.
    """
    inside = outlines @ planes[..., :2].swapaxes(-1, -2) + planes[:, None, :, 2]
    begin, end = inside, np.roll(inside, -1, axis=1)
    rise = end - begin
    at = np.divide(-begin, rise, out=np.zeros_like(begin), where=(begin < 0) != (end < 0))
    enter = np.where(begin < 0, np.where(end < 0, 2.0, at), 0.0).max(axis=-1)
    leave = np.where(end < 0, at, 1.0).min(axis=-1)
    return np.stack([enter, leave])


def _most_at_once(panels: Integers, start: Array, stop: Array, least: int) -> int:
    """How many stretches (P, 4) of one edge of panels (P,) have a place in common, at most.

    Edges with no more than ``least`` stretches are passed over.
    """
    edges = 4 * panels[:, None] + np.arange(4)
    covers = start <= stop
    edges, start, stop = edges[covers], start[covers], stop[covers]
    many = (np.bincount(edges) > least)[edges]
    if not many.any():
        return least
    edges, start, stop = edges[many], start[many], stop[many]
    # Along an edge stretches begin before others end where both are in one place.
    ends = np.repeat([1, -1], len(edges))
    order = np.lexsort([-ends, np.concatenate([start, stop]), np.tile(edges, 2)])
    return int(np.cumsum(ends[order]).max())
