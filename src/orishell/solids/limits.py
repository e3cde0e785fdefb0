"""How thick boards may be for a motion, and how far boards of a thickness let it go.

Between opposite edges of a panel its boards stand back by s from one and by s' from the other. Of
the way across, its shortest width between them, a share must remain. As s = b tan(phi/2), this
limits the height b of boards for given fold angles, and fold angles for given boards.
"""

from __future__ import annotations

import numpy as np

from orishell.motion import Mechanism
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.bisection import bisect
from orishell.sheet.grid import CreaseValues, Grid
from orishell.solids.setbacks import find_set_backs

SHARE = 0.5
"""Share of the way across a panel that remains, where nothing else is said."""
STATES = 65
"""States among which the first one that leaves too little is looked for."""
FINE = 1e-12
"""Accuracy of the drive at which boards stop the motion (relative)."""


def largest_height(flat: Array, grid: Grid, folds: CreaseValues, share: float = SHARE) -> float:
    """How high boards may stand over the membrane (length); infinite where no crease folds.

    Parameters
    ----------
    flat
        Vertices (rows, columns, 3) of the flat sheet.
    grid
        Its grid.
    folds
        The largest fold angles, in (-pi, pi), valley positive (radians).
    share
        Share of the way across every panel that must remain.
    """
    return _height(_ways_across(flat, grid), grid.faces_edges(), folds, share)


def drive_for_height(
    mechanism: Mechanism, height: float, end: float | None = None, share: float = SHARE
) -> float:
    """The drive up to which boards of a height leave enough of every panel (radians).

    Parameters
    ----------
    height
        How high boards stand over the membrane on one face (length).
    end
        The drive up to which the motion is known to be free; None for its end (radians).
    share
        Share of the way across every panel that must remain.
    """
    edges = mechanism.grid.faces_edges()
    across = _ways_across(mechanism.positions(0.0), mechanism.grid)
    end = mechanism.end_drive if end is None else end

    def works(drive: float) -> bool:
        return _height(across, edges, mechanism.fold_angles(drive), share) >= height

    good = 0.0
    for drive in np.linspace(0.0, end, STATES)[1:].tolist():
        if not works(drive):
            return bisect(works, good, drive, relative=FINE)
        good = drive
    return end


def _height(across: Array, edges: Integers, folds: CreaseValues, share: float) -> float:
    """The largest height, from widths (F, 2) and the edges (F, 4) of panels."""
    unit = find_set_backs(folds, 1.0)
    back = np.stack([unit.top, unit.bottom])[:, edges]  # (2 faces, F, 4 edges)
    most = float(((back[..., :2] + back[..., 2:]) / across).max())
    return (1 - share) / most if most else np.inf


def _ways_across(flat: Array, grid: Grid) -> Array:
    """Shortest width (F, 2) of panels from left to right and from top to bottom."""
    corners = flat.reshape(-1, 3)[grid.faces_vertices(), :2]
    along = np.roll(corners, -1, axis=1) - corners
    inward = np.stack([-along[..., 1], along[..., 0]], axis=-1)
    inward /= np.hypot(inward[..., 0], inward[..., 1])[..., None]
    # Distances (F, 4 edges, 2 ends) of the ends of the opposite edge from every edge's line.
    opposite = np.stack([np.roll(corners, -2, axis=1), np.roll(corners, -3, axis=1)], axis=2)
    away = ((opposite - corners[:, :, None]) * inward[:, :, None]).sum(axis=-1).min(axis=-1)
    return np.asarray(np.minimum(away[:, :2], away[:, 2:]))
