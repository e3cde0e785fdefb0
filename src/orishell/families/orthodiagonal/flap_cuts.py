"""Flaps that would reach beyond the ends of f: cut off where the columns end, if they still lock.

At lock a flap lies in the plane of its column, moved along the bisectors of the column's zigzag.
Towards the end of f to which it folds these run outwards, below the feet of an arch. A corner that
is moved back along its row crease stays in its panels' planes, so a cut changes nothing in the
motion but the flap's outline.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from orishell.families.orthodiagonal.mechanism import Orthodiagonal
from orishell.numerics.arrays import Array, Complex

SMALLEST_KEPT = 0.1
"""A cut flap keeps this share of every row crease: panels that meet along less lock nothing."""
SHORTEST = 0.2
"""Its end edges keep this share of the column's."""
KEPT = 32
"""Mechanisms whose flaps are remembered: each is asked about several times."""
BEYOND = 1e-9
"""Flaps that reach below the feet by less than this share of the height count as level."""


def cut_flaps(mechanism: Orthodiagonal, planes: Sequence[complex | None]) -> Orthodiagonal | None:
    """The sheet with its flaps cut where its columns end; None if too little of them is left.

    Parameters
    ----------
    planes
        For both ends of f a normal to the plane in which columns end, in complex numbers of f's
        plane, or None if they end in none.
    """
    kept = np.ones((2, mechanism.grid.rows))
    for flap, column, whole in _in_plane(mechanism):
        for end, normal in zip((0, -1), planes, strict=True):
            if normal is None:
                continue
            share = _share(column, whole, normal, end)
            if share is None:
                return None
            kept[flap] = np.minimum(kept[flap], share)
    return replace(mechanism, kept=kept) if (kept < 1).any() else mechanism


def depth_below_feet(mechanism: Orthodiagonal) -> float:
    """How far the flaps reach below the first and the last column at lock (length)."""
    if not any(mechanism.flaps):
        return 0.0
    height = _ends(mechanism)[..., 2]
    inner = height[:, 1:-1]
    below = float(inner.min() - height.min())
    return below if below > BEYOND * np.ptp(inner) else 0.0


@lru_cache(KEPT)
def _ends(mechanism: Orthodiagonal) -> Array:
    """Vertices (m+2, 4, 3) of the first and the last column and their flaps at lock."""
    sheet = replace(mechanism, points=mechanism.points[[0, -1]])
    return sheet.positions(sheet.target_drive)


def _in_plane(mechanism: Orthodiagonal) -> list[tuple[int, Complex, Complex]]:
    """Every flap's number, and the vertices (m+2,) in f's plane of its column and of its edge."""
    t = np.exp(-1j * mechanism.heading)
    locked = _ends(mechanism)
    across = ((locked[..., 0] + 1j * locked[..., 1]) * t.conjugate()).real
    plane = across + 1j * locked[..., 2]
    return [
        (flap, plane[:, near], plane[:, edge])
        for flap, (near, edge) in enumerate(((1, 0), (-2, -1)))
        if mechanism.flaps[flap]
    ]


def _share(column: Complex, whole: Complex, normal: complex, end: int) -> Array | None:
    """Shares (m+2,) of its width that a flap cut by a plane keeps at every row; None if too small.

    The plane goes through the column's vertex ``end`` (0 or -1).
    """
    rows = len(column)
    side = np.arange(rows) < rows // 2 if end == 0 else np.arange(rows) > rows // 2
    beside = 1 if end == 0 else -2
    inwards = ((column[rows // 2] - column[end]) * normal.conjugate()).real
    normal = -normal / abs(normal) * np.sign(inwards)  # outwards
    room = ((column[end] - column) * normal.conjugate()).real
    reach = ((whole - column) * normal.conjugate()).real
    inner = side.copy()
    inner[end] = False
    beyond = inner & (reach > room)
    share = np.ones(rows)
    if (room[beyond] <= 0).any():
        return None
    share[beyond] = room[beyond] / reach[beyond]
    # The end's own corner lies in the plane; beside a crease that ends there, half as far out.
    if beyond[beside]:
        share[end] = 0.5 * share[beside]
        return share if (share[beyond] >= SMALLEST_KEPT).all() else None
    edge = (whole[end] - whole[beside]) / (column[end] - column[beside])
    return share if edge.real >= SHORTEST and (share[inner] >= SMALLEST_KEPT).all() else None
