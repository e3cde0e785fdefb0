"""Quadrilateral panels as triangles, for formats that know no others."""

from __future__ import annotations

from typing import Final

import numpy as np

from orishell.motion.quads import reflex_corners
from orishell.numerics.arrays import Array, Integers

TRIANGLES: Final[Integers] = np.array([[[0, 1, 2], [0, 2, 3]], [[1, 2, 3], [1, 3, 0]]])
"""Corners of a panel's two triangles (2, 2, 3), which go round as the panel does: split from
corner 0 to corner 2, or from corner 1 to corner 3."""
TRIANGLES.flags.writeable = False


def find_splits(corners: Array) -> Integers:
    """The diagonal (F,) that splits each panel (F, 4, 3): 1 where the first runs outside, else 0.

    All panels are split from corner 0 to corner 2, except those with a corner 1 or 3 that points
    into the panel: there that diagonal runs outside, and the other one inside.
    """
    return np.asarray(reflex_corners(corners)[:, [1, 3]].any(axis=1), dtype=np.int64)


def split_panels(corners: Array) -> Array:
    """The triangles (2F, 3, 3) of panels (F, 4, 3), the two of a panel one after the other."""
    picked = TRIANGLES[find_splits(corners)].reshape(len(corners), 6, 1)
    return np.asarray(np.take_along_axis(corners, picked, axis=1).reshape(-1, 3, 3))
