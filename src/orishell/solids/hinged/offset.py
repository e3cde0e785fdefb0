"""How far whole boards lie from the sheet without a thickness, or from what they are to meet."""

from __future__ import annotations

import numpy as np

from orishell.motion.hinges import Hinges
from orishell.motion.quads import grid_corners, lengths
from orishell.numerics.arrays import Array


def board_offsets(hinges: Hinges, positions: Array, meant: Array | None = None) -> Array:
    """Distances (4 F,) of corners of boards, half way up, from those of panels.

    Parameters
    ----------
    positions
        Vertices (rows, columns, 3) of the sheet in a state.
    meant
        Vertices (rows, columns, 3) of the panels that boards are to meet. If None they are those
        of the sheet itself, after the motion of all boards together that brings them nearest
        (W. Kabsch, Acta Crystallographica A 32 (1976) 922).
    """
    boards = hinges.boards(positions).reshape(-1, 3)
    panels = grid_corners(positions if meant is None else meant).reshape(-1, 3)
    if meant is not None:
        return lengths(boards - panels)
    start, end = boards - boards.mean(axis=0), panels - panels.mean(axis=0)
    left, _, right = np.linalg.svd(start.T @ end)
    turn = left @ np.diag([1.0, 1.0, np.linalg.det(left @ right)]) @ right
    return lengths(start @ turn - end)
