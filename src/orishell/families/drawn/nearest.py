"""A sheet nearby that folds exactly, in place of one that does not.

All vertices move. There are more conditions than independent ones, and where a sheet barely fails
them some hardly differ from others: what vertices disagree by at four drives; of sheets that are
nearly flat-foldable at one, and that they be flat-foldable. First steps of least size, damped as
Levenberg and Marquardt do, then steps that leave out directions with small singular values, fewer
and fewer of them as long as the residual does not fall. Derivatives are exact: complex steps
through all formulas. The sheet that is found is near, but not shown to be the nearest.
"""

from __future__ import annotations

import numpy as np

from orishell.families.drawn.drive import Drive
from orishell.families.drawn.vertex import Numbers, crosses, dots, ways
from orishell.numerics.arrays import Array

DRIVES = np.array([0.4, 0.9, 1.4, 2.0])
"""Drives at which vertices are to agree (radians)."""
NEARLY = 0.05
"""Opposite sectors of a nearly flat-foldable sheet miss 180 degrees by less (radians)."""
DAMPING = 1e-2
"""The damping of a step by the residual and the largest singular value."""
UNDAMPED = 1e-6
"""Residuals below this are reduced by steps without damping (radians)."""
CUTS = 1e-5, 1e-7, 1e-3
"""Smaller singular values by the largest are left out at first: one after the other is tried."""
DONE = 2e-13
"""Residuals below this are rounding (radians)."""
FOLDS = 1e-10
"""A sheet folds exactly, as far as can be told, if vertices disagree by less (radians)."""
STEPS = 40
MOST = 1500
"""Coordinates of the largest sheets that are moved: the work grows with their cube."""
BLOCK = 200
"""Coordinates whose derivatives are found together."""
SMALL = 1e-30
"""A complex step: its square is nothing."""


def disagreement(drive: Drive, drives: Array = DRIVES) -> float:
    """The largest disagreement of vertices at some drives (radians), inf where a crease closed."""
    found = np.abs(drive.disagreement(drives)).max(initial=0.0)
    return float(found) if np.isfinite(found) else np.inf


def find_nearby(flat: Array, drive: Drive) -> Array | None:
    """Vertices (rows, columns, 2) of a sheet near another one, that folds; None if none is found.

    Mountains and valleys stay what they are.
    """
    places = np.moveaxis(flat, -1, 0)
    if places.size > MOST:
        return None
    with np.errstate(all="ignore"):
        nearly = bool(np.abs(_kawasaki(places[..., None])).max() < NEARLY)
        for cut in CUTS:
            found = _descended(places, drive, cut, flat_foldable=nearly)
            if found is not None and disagreement(drive.moved(found[..., None])) < FOLDS:
                return np.moveaxis(found, 0, -1)
    return None


def _descended(places: Array, drive: Drive, cut: float, *, flat_foldable: bool) -> Array | None:
    """Vertices (2, rows, columns) where the conditions hold as nearly as they do; None if lost."""
    drives, before = DRIVES[1:2] if flat_foldable else DRIVES, np.inf
    for _ in range(STEPS):
        missing = _conditions(drive, places[..., None], drives, flat_foldable=flat_foldable)[:, 0]
        size = np.abs(missing).max(initial=0.0)
        if not size > DONE:
            break
        slopes = _derivatives(drive, places, drives, flat_foldable=flat_foldable)
        if not np.isfinite(slopes).all():
            return None
        out, sizes, across = np.linalg.svd(slopes, full_matrices=False)
        if size > UNDAMPED:
            gains = sizes / (sizes**2 + (DAMPING * size * sizes[0]) ** 2)
        else:
            cut *= 0.1 if size > 0.5 * before else 1.0
            gains = np.where(sizes > cut * sizes[0], 1 / np.maximum(sizes, SMALL), 0.0)
        before = size
        places = places - (across.T @ (gains * (out.T @ missing))).reshape(places.shape)
    return places


def _conditions(drive: Drive, flat: Numbers, drives: Array, *, flat_foldable: bool) -> Numbers:
    """What is to vanish (K, U), of flat sheets (2, rows, columns, U)."""
    apart = drive.moved(flat[..., None]).disagreement(drives)
    found = np.moveaxis(apart, -1, 0).reshape(-1, flat.shape[-1])
    return np.concatenate([found, _kawasaki(flat)]) if flat_foldable else found


def _kawasaki(flat: Numbers) -> Numbers:
    """Sines (K, U) of what opposite sectors of vertices miss 180 degrees by."""
    right, up, left, down = ways(flat)
    found = crosses(left, down) * dots(right, up) + dots(left, down) * crosses(right, up)
    return np.asarray(found.reshape(-1, flat.shape[-1]))


def _derivatives(drive: Drive, flat: Array, drives: Array, *, flat_foldable: bool) -> Array:
    """Derivatives (K, coordinates) of the conditions of a flat sheet (2, rows, columns)."""
    found = []
    for first in range(0, flat.size, BLOCK):
        which = np.arange(first, min(first + BLOCK, flat.size))
        stepped = np.repeat(flat[..., None].astype(np.complex128), len(which), axis=-1)
        stepped.reshape(flat.size, -1)[which, np.arange(len(which))] += 1j * SMALL
        found.append(_conditions(drive, stepped, drives, flat_foldable=flat_foldable).imag / SMALL)
    return np.concatenate(found, axis=1)
