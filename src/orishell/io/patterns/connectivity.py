"""Whether panels lie beside each other in the flat sheet, and none on another."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.io.patterns.crossings import split_lines
from orishell.io.patterns.lines import Lines
from orishell.motion.crease_pattern import CreasePattern
from orishell.numerics.arrays import Integers
from orishell.numerics.components import find_components

TOUCHING = 1e-10
"""Points of the border nearer to each other than this share of the diagonal are one."""
BESIDE = 1e-6
"""How far beside the border panels are counted, by the length of its part."""


class PiecesError(InputError):
    """Panels that do not hang together."""


def require_apart(pattern: CreasePattern) -> None:
    """Refuse panels that cross themselves or lie on others, and sheets of several pieces.

    Where two panels lie on each other one of them ends somewhere, at the border, within the other
    or beside it. So panels are counted on the inner side of every part of the border.

    Raises InputError: Naming one of these places.
    """
    import shapely

    panels = _polygons(pattern)
    require_one_piece(pattern.edge_faces[pattern.crease], len(pattern.faces))
    # Edges with their panel on the left.
    sides = [pattern.edges[~pattern.crease & (pattern.edge_faces[:, k] >= 0)] for k in (0, 1)]
    ends = pattern.vertices[np.concatenate([sides[0], sides[1][:, ::-1]])]
    touching = TOUCHING * float(np.hypot(*np.ptp(pattern.vertices, axis=0)))
    ends = ends[np.hypot(*(ends[:, 1] - ends[:, 0]).T) > touching]
    none = np.zeros(len(ends))
    lines = Lines(ends, np.full(len(ends), "B"), none, none.astype(np.int64), ("the border",))
    split = split_lines(lines, touching)
    parts = split.points[split.pairs]
    way = parts[:, 1] - parts[:, 0]
    inside = parts.mean(axis=1) + BESIDE * np.stack([-way[:, 1], way[:, 0]], axis=-1)
    point, panel = shapely.STRtree(panels).query(shapely.points(inside), predicate="intersects")
    twice = np.bincount(point, minlength=len(inside)) > 1
    if twice.any():
        place = int(np.argmax(twice))
        first, second = np.sort(panel[point == place])[:2]
        raise InputError(
            f"panels {first} and {second} lie on each other",
            where=f"at ({inside[place, 0]:.6g}, {inside[place, 1]:.6g})",
            remedy="remove what is there twice, or save the flat sheet, not a folded state",
        )


def require_one_piece(joined: Integers, count: int) -> None:
    """Refuse panels that do not hang together; ``joined`` (N, 2) are those beside creases.

    Raises PiecesError: Naming a panel of another piece.
    """
    pieces = find_components(joined, count)
    if pieces.any():
        other = int(np.argmax(pieces > 0))
        raise PiecesError(
            "the pattern is not one piece",
            got=f"{pieces.max() + 1} pieces, panels 0 and {other} in different ones",
            remedy="write each piece to a file of its own",
        )


def _polygons(pattern: CreasePattern) -> np.ndarray:
    """Panels (F,) as polygons, none of which crosses itself."""
    import shapely

    sizes = (pattern.faces >= 0).sum(axis=1)
    panels = np.empty(len(sizes), dtype=np.object_)
    for size in np.unique(sizes).tolist():
        which = sizes == size
        panels[which] = shapely.polygons(pattern.vertices[pattern.faces[which, :size]])
    good = np.asarray(shapely.is_valid(panels))
    if not good.all():
        panel = int(np.argmin(good))
        raise InputError(
            f"panel {panel} crosses itself",
            got="vertices " + ", ".join(map(str, pattern.faces[panel, : sizes[panel]])),
            remedy="list its vertices in their order round it",
        )
    return panels
