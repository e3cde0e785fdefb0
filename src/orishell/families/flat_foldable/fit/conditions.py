"""What a sheet must keep at every step of a fit: panels that can be made, folds that can open.

Panels are convex in the flat sheet, the border's too, with no corner sharper than ``corner``; no
edge is longer than ``ratio`` times the shortest; no crease folds by more than ``fold``. A step that
leaves this is not taken. Residuals that begin a little earlier push away from it, so that a fit
does not run into it and stick.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers

EARLY = 0.84
"""The share of the allowed edges, by logarithms, from which on they are pushed back."""
CENTRED = 30
"""Steps of Newton's method for the middle of edges, at most: about five are needed."""
BLUNTER = 1.5
"""Corners are pushed back from this many times the least angle on."""
NARROWER = np.deg2rad(10)
"""Fold angles are pushed back from so much before the largest on (radians)."""


@record
class Conditions:
    """Limits of edges, corners and fold angles."""

    ratio: float  # of the longest edge to the shortest, at most
    corner: float = np.deg2rad(8)  # the least angle of a panel's corner (radians)
    fold: float = np.deg2rad(165)  # the largest fold angle at the target (radians)

    def hold(self, flat: Array, tangents: Array) -> bool:
        """Whether a flat sheet (2, R+2, C+2) keeps them, and its log tan of half folds (F,)."""
        if not np.isfinite(flat).all():
            return False
        points = flat.reshape(2, -1)
        at, after, before = corner_numbers(*flat.shape[1:])
        p, q = points[:, after] - points[:, at], points[:, before] - points[:, at]
        scale = np.sqrt((p * p).sum(axis=0) * (q * q).sum(axis=0))
        convex = p[0] * q[1] - p[1] * q[0] >= np.sin(self.corner) * scale
        spans = np.sqrt((p * p).sum(axis=0))
        return bool(
            convex.all()
            and spans.max() <= self.ratio * spans.min()
            and tangents.max() <= np.log(np.tan(0.5 * self.fold))
        )

    def beyond(self, logs: Array) -> Array:
        """By how much logarithms of edges (E,) are too long or too short.

        About the middle that makes the sum of squares least: its derivatives are then those of a
        middle that stays.
        """
        reach = 0.5 * EARLY * np.log(self.ratio)
        off = logs - 0.5 * (logs.max() + logs.min())
        found = off - np.clip(off, -reach, reach)
        for _ in range(CENTRED):
            outside = found != 0
            shift = float(found[outside].mean()) if outside.any() else 0.0
            if abs(shift) < np.finfo(float).eps:
                break
            off = off - shift
            found = off - np.clip(off, -reach, reach)
        return np.asarray(found)

    @property
    def early_sine(self) -> float:
        """The sine from which on corners are pushed back."""
        return float(np.sin(BLUNTER * self.corner))

    @property
    def early_tangent(self) -> float:
        """The log tan of half a fold angle from which on it is pushed back."""
        return float(np.log(np.tan(0.5 * (self.fold - NARROWER))))


@lru_cache(maxsize=16)
def corner_numbers(rows: int, columns: int) -> tuple[Integers, Integers, Integers]:
    """Numbers of vertices at all corners of panels (N,), and of those after and before them.

    Counter-clockwise in the flat sheet.
    """
    number = np.arange(rows * columns).reshape(rows, columns)
    ring = [number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]]
    around = np.stack(ring, axis=-1).reshape(-1, 4)
    after, before = (np.roll(around, shift, axis=1).ravel() for shift in (-1, 1))
    return around.ravel(), after, before


@lru_cache(maxsize=16)
def edge_numbers(rows: int, columns: int) -> tuple[Integers, Integers]:
    """Numbers of the vertices at both ends of all edges (E,): those along rows, then the others."""
    number = np.arange(rows * columns).reshape(rows, columns)
    starts = number[:, :-1].ravel(), number[:-1].ravel()
    stops = number[:, 1:].ravel(), number[1:].ravel()
    return np.concatenate(starts), np.concatenate(stops)
