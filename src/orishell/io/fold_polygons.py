"""Panels of a FOLD file: four corners, and vertices on sides where hinges of others end."""

from __future__ import annotations

from typing import Any

import numpy as np

from orishell.conventions.errors import InputError
from orishell.io.fold_frames import number_table, require_vertices
from orishell.motion.quads import dots, lengths
from orishell.numerics.arrays import Array, Integers

STRAIGHT = 1e-6
"""A side may turn by this sine at a vertex that lies on it."""


def read_loops(value: Any, where: str, vertex_count: int) -> Integers:
    """Vertices (F, K) around every panel, -1 behind the last.

    Raises InputError: Naming the first panel that does not fit.
    """
    longest = max((len(row) for row in value if isinstance(row, list)), default=0) if value else 0
    if longest <= 4 or not all(_is_loop(row) for row in value):
        loops = number_table(value, where, "panel", widths=(4,), whole=True).astype(np.int64)
    else:
        loops = np.array([row + [-1] * (longest - len(row)) for row in value], np.int64)
    require_vertices(loops, vertex_count, where, count=np.array([len(row) for row in value]))
    return loops


def _is_loop(row: Any) -> bool:
    return isinstance(row, list) and len(row) >= 4 and all(type(each) is int for each in row)


def find_corners(loops: Integers, positions: Array, where: str) -> Integers:
    """The four corners (F, 4) of panels (F, K): other vertices lie on their sides.

    Raises InputError: If a panel of more than four vertices has not four corners.
    """
    if loops.shape[1] == 4:
        return loops
    count = (loops >= 0).sum(axis=1)[:, None]
    place = np.arange(loops.shape[1])[None]
    here = positions[loops]
    after, before = (
        positions[np.take_along_axis(loops, (place + step) % count, axis=1)] - here
        for step in (1, -1)
    )
    bent = lengths(np.cross(after, before)) > STRAIGHT * lengths(after) * lengths(before)
    bent |= dots(after, before) >= 0
    corner = (place < count) & (bent | (count == 4))
    wrong = corner.sum(axis=1) != 4
    if wrong.any():
        panel = int(np.argmax(wrong))
        raise InputError(
            f"panel {panel} does not fit",
            where=f"{where}[{panel}]",
            got=f"{int(count[panel, 0])} whole numbers",
            expected="4 whole numbers for each panel, or more where all but 4 lie on its sides",
        )
    order = np.argsort(~corner, axis=1, kind="stable")[:, :4]
    return np.asarray(np.take_along_axis(loops, order, axis=1))
