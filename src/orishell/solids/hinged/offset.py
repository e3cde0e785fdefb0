"""How far whole boards lie at the target from what they are to meet."""

from __future__ import annotations

import numpy as np

from orishell.motion import Mechanism
from orishell.motion.hinges import Hinges
from orishell.motion.quads import grid_corners, lengths
from orishell.numerics.arrays import Array


def board_offsets(hinges: Hinges, mechanism: Mechanism, meant: Array | None = None) -> Array:
    """Distances (4 F,) of corners of boards at the target, half way up, from those of panels.

    Parameters
    ----------
    meant
        Vertices (rows, columns, 3) of the panels that boards are to meet. If None they are those
        of the sheet itself, after the motion of all boards together that brings them nearest
        (W. Kabsch, Acta Crystallographica A 32 (1976) 922).
    """
    shell = mechanism.positions(mechanism.target_drive)
    boards = hinges.boards(shell).reshape(-1, 3)
    panels = grid_corners(shell if meant is None else meant).reshape(-1, 3)
    if meant is not None:
        return lengths(boards - panels)
    start, end = boards - boards.mean(axis=0), panels - panels.mean(axis=0)
    left, _, right = np.linalg.svd(start.T @ end)
    turn = left @ np.diag([1.0, 1.0, np.linalg.det(left @ right)]) @ right
    return lengths(start @ turn - end)
