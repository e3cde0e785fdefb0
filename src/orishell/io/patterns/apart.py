"""Whether panels lie beside each other in the flat sheet, and none on another."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.io.patterns.crossings import cross, near_pairs
from orishell.motion.crease_pattern import CreasePattern
from orishell.numerics.arrays import Integers
from orishell.numerics.components import find_components

INSIDE = 1e-9
"""Border edges cross if they do so farther than this share from their ends."""


def require_apart(pattern: CreasePattern) -> None:
    """Refuse panels that cross themselves or lie on others, and sheets of several pieces.

    Panels all go counter-clockwise. If none crosses itself, sectors go round every inner vertex
    once and the border crosses nowhere, then no point of the plane has two of them.

    Raises InputError: Naming one of these places.
    """
    _require_simple(pattern)
    require_one_piece(pattern.edge_faces[pattern.crease], len(pattern.faces))
    sums = np.nansum(pattern.sectors, axis=1)
    if (sums > 3 * np.pi).any():
        vertex = int(pattern.inner[np.argmax(sums)])
        raise InputError(f"panels lie on each other around vertex {vertex}")
    border = pattern.edges[~pattern.crease & (pattern.edge_faces >= 0).any(axis=1)]
    ends = pattern.vertices[border]
    start, way = ends[:, 0], ends[:, 1] - ends[:, 0]
    length = np.hypot(*way.T)
    for one, two in near_pairs(ends, 0.0):
        turn = cross(way[one], way[two])
        between = start[two] - start[one]
        with np.errstate(divide="ignore", invalid="ignore"):
            shares = (cross(between, way[two]) / turn, cross(between, way[one]) / turn)
        hit = np.abs(turn) > INSIDE * length[one] * length[two]
        for share in shares:
            hit &= (share > INSIDE) & (share < 1 - INSIDE)
        if hit.any():
            a, b = (border[each[np.argmax(hit)]] for each in (one, two))
            raise InputError(
                "panels lie on each other: the border crosses itself",
                got=f"edges {a[0]}-{a[1]} and {b[0]}-{b[1]}",
            )


class PiecesError(InputError):
    """Panels that do not hang together."""


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


def _require_simple(pattern: CreasePattern) -> None:
    import shapely

    sizes = (pattern.faces >= 0).sum(axis=1)
    for size in np.unique(sizes[sizes > 3]).tolist():
        which = np.flatnonzero(sizes == size)
        corners = pattern.vertices[pattern.faces[which, :size]]
        good = shapely.is_valid(shapely.polygons(corners))
        if not np.all(good):
            panel = int(which[np.argmin(good)])
            raise InputError(
                f"panel {panel} crosses itself",
                got="vertices " + ", ".join(map(str, pattern.faces[panel, :size])),
            )
