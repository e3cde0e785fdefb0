"""Where the vertices of an even sheet would be on a piece: between its four sides."""

from __future__ import annotations

import numpy as np

from orishell.design.piece import Piece
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array


def homes(piece: Piece, shape: tuple[int, int]) -> Array:
    """Points (R+2, C+2, 3) for a shape R+2, C+2: Coons' patch of the sides, evenly divided.

    S. A. Coons, Surfaces for computer-aided design of space forms, MIT MAC-TR-41 (1967).
    """
    rows, columns = shape
    top, right, bottom, left = (
        _evenly(piece.vertices[side], count)
        for side, count in zip(piece.sides, (columns, rows, columns, rows), strict=True)
    )
    bottom, left = bottom[::-1], left[::-1]
    u, v = np.linspace(0, 1, columns)[:, None], np.linspace(0, 1, rows)[:, None, None]
    between = (1 - v) * top + v * bottom + (1 - u) * left[:, None] + u * right[:, None]
    above = (1 - u) * top[0] + u * top[-1]
    below = (1 - u) * bottom[0] + u * bottom[-1]
    return np.asarray(between - (1 - v) * above - v * below)


def _evenly(line: Array, count: int) -> Array:
    """Points (count, 3) that divide a polyline (K, 3) into equal lengths."""
    arc = np.concatenate([[0.0], np.cumsum(lengths(np.diff(line, axis=0)))])
    wanted = np.linspace(0.0, arc[-1], count)
    return np.stack([np.interp(wanted, arc, line[:, axis]) for axis in range(3)], axis=-1)
