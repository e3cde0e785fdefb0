"""How thick boards may be for a motion, and how far boards of a thickness let it go.

Between opposite edges of a panel its boards stand back by s from one and by s' from the other. Of
the way across, its shortest width between them, both together may take a share, and neither may be
longer than is allowed. A set-back is b tan(phi/2) or half the gap, whichever is more: so this
limits the height b of boards for given fold angles, and fold angles for given boards.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.motion import Mechanism
from orishell.motion.grid import CreaseValues, Grid
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.bisection import bisect
from orishell.solids.setbacks import find_set_backs

SHARE = 0.5
"""Share of the way across a panel that set-backs may take, where nothing else is said."""
STATES = 65
"""States among which the first one that leaves too little is looked for."""
FINE = 1e-12
"""Accuracy of the drive at which boards stop the motion (relative)."""


def largest_height(
    flat: Array,
    grid: Grid,
    folds: CreaseValues,
    share: float = SHARE,
    setback: float = np.inf,
    *,
    gap: float = 0.0,
) -> float:
    """How high boards may stand over the hinge plane (length); infinite where no crease folds.

    Parameters
    ----------
    flat
        Vertices (rows, columns, 3) of the flat sheet.
    grid
        Its grid.
    folds
        The largest fold angles, in [-pi, pi], valley positive (radians).
    share
        Share of the way across every panel that set-backs may take.
    setback
        Longest set-back (length).
    gap
        What is cut away between two panels where they open (length).
    """
    heights = allowed_heights(flat, grid, folds, share=share, setback=setback, gap=gap)
    return float(heights.min())


def drive_for_height(
    mechanism: Mechanism,
    height: float,
    end: float | None = None,
    share: float = SHARE,
    setback: float = np.inf,
    *,
    gap: float = 0.0,
) -> float:
    """The drive up to which boards of a height leave enough of every panel (radians).

    Parameters
    ----------
    height
        How high boards stand over the hinge plane on one face (length).
    end
        The drive up to which the motion is known to be free; None for its end (radians).
    share
        Share of the way across every panel that set-backs may take.
    setback
        Longest set-back (length).
    gap
        What is cut away between two panels where they open (length).
    """
    grid, edges = mechanism.grid, mechanism.grid.faces_edges()
    room = share * _ways_across(mechanism.positions(0.0), grid)
    end = mechanism.end_drive if end is None else end
    bare = bare_faces(mechanism.fold_angles(mechanism.target_drive), grid, mechanism.flap_columns)

    def works(drive: float) -> bool:
        heights = _heights(room, edges, mechanism.fold_angles(drive), setback, gap)
        return bool((heights[~bare] >= height).all())

    good = 0.0
    for drive in np.linspace(0.0, end, STATES)[1:].tolist():
        if not works(drive):
            return bisect(works, good, drive, relative=FINE)
        good = drive
    return end


def allowed_heights(
    flat: Array,
    grid: Grid,
    folds: CreaseValues,
    *,
    share: float = SHARE,
    setback: float = np.inf,
    gap: float = 0.0,
) -> Array:
    """How high boards may stand (2, F, 2): faces, upper one first; panels; ways across.

    The first way is from left to right, the second from bottom to top. 0 where even the gap takes
    too much. Parameters are those of :func:`largest_height`.
    """
    room = share * _ways_across(flat, grid)
    return _heights(room, grid.faces_edges(), folds, setback, gap)


def bare_faces(folds: CreaseValues, grid: Grid, columns: Sequence[int]) -> Booleans:
    """Faces of panels (2, F) in some columns that carry no board: a crease folds flat on them.

    Parameters
    ----------
    folds
        The largest fold angles, in [-pi, pi], valley positive (radians).
    grid
        The grid of the sheet.
    columns
        Columns of panels that may go without boards: flaps.
    """
    unit = find_set_backs(folds, 1.0)
    shut = np.isinf(np.stack([unit.top, unit.bottom])[:, grid.faces_edges()]).any(axis=-1)
    column = np.arange(grid.panel_count) % (grid.columns - 1)
    return np.asarray(shut & np.isin(column, columns))


def _heights(
    room: Array, edges: Integers, folds: CreaseValues, setback: float, gap: float
) -> Array:
    """The heights (2, F, 2), from what set-backs may take (F, 2) and the edges (F, 4) of panels."""
    unit, open_ = find_set_backs(folds, 1.0), find_set_backs(folds, 0.0, gap)
    # Both of them, from opposite edges: what a height of 1 takes, and half the gap.
    near, far = np.split(np.stack([unit.top, unit.bottom])[:, edges], 2, axis=-1)
    near_gap, far_gap = np.split(open_.top[edges], 2, axis=-1)
    heights = np.minimum.reduce(
        [
            _over(room, near + far),
            _over(room - far_gap, near),
            _over(room - near_gap, far),
            _over(setback, np.maximum(near, far)),
        ]
    )
    fits = (near_gap + far_gap <= room) & (np.maximum(near_gap, far_gap) <= setback)
    return np.where(fits, heights, 0.0)


def _over(length: Array | float, share: Array) -> Array:
    """Lengths by what a height of 1 takes of them; infinite where it takes nothing."""
    taken = np.broadcast_to(length, share.shape)
    some = (share > 0) & (share < np.inf)
    bound = np.where(share > 0, 0.0, np.inf)
    with np.errstate(over="ignore"):  # a crease that hardly folds leaves room for any height
        return np.asarray(np.divide(taken, share, out=bound, where=some))


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
