"""How small a shell packs, and how many panels then lie on top of each other."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.deployment.box import Box, smallest_box
from orishell.deployment.layers import count_layers
from orishell.motion import Mechanism, diagonal, panel_normals
from orishell.motion.quads import grid_corners
from orishell.numerics.arrays import Array

THIN = 1e-3
"""A bundle counts as at least this thick, relative to the diagonal of the flat sheet."""


@record
class Pack:
    """The state of a motion that fits into the smallest box.

    Parameters
    ----------
    drive
        Its drive angle (radians).
    box
        Its smallest box, of panels with their thickness.
    layers
        How many panels lie on top of each other there, see :func:`count_layers`.
    """

    drive: float
    box: Box
    layers: int


def find_pack(mechanism: Mechanism, limit: float, states: int = 25, thickness: float = 0.0) -> Pack:
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
    """
    floor = THIN * diagonal(mechanism.positions(0.0))
    best: tuple[float, float, Box] | None = None
    for drive in np.linspace(limit, mechanism.target_drive, states).tolist():
        box = smallest_box(_surfaces(mechanism.positions(drive), thickness))
        size = box.length * box.width * max(box.height, floor)
        if best is None or size < best[0]:
            best = size, drive, box
    assert best is not None
    _, drive, box = best
    points = mechanism.positions(drive).reshape(-1, 3)
    return Pack(drive, box, count_layers(points, mechanism.grid.faces_vertices(), box.axes))


def _surfaces(positions: Array, thickness: float) -> Array:
    """Vertices (V, 3) of panels, or of their upper and lower faces if they have a thickness."""
    if not thickness:
        return positions.reshape(-1, 3)
    corners, normals = grid_corners(positions), panel_normals(positions)
    over = 0.5 * thickness * normals[..., None, :]
    return np.concatenate([corners + over, corners - over]).reshape(-1, 3)
