"""Sizes of a sheet in one state, how far its creases fold, and how small its panels may be."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.quantities import plain
from orishell.motion.grid import Positions
from orishell.motion.layout import Layout, SlitFlaps, points_of
from orishell.motion.mechanism import Mechanism
from orishell.motion.quads import area_vectors, grid_corners, lengths
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import bisect
from orishell.numerics.equals import first_smallest, smallest_of

CONTACT_TOLERANCE = 1e-9
"""Distance at which panels touch, relative to the diagonal of the flat sheet."""
COINCIDENT = 1e-13
"""Points nearer to each other than this share of an edge are one point but for rounding."""


def diagonal(flat: Positions) -> float:
    """Diagonal of the flat sheet's bounding box, the length that residuals are relative to."""
    return float(np.hypot(*extents(flat)[:2]))


def extents(positions: Positions) -> tuple[float, float, float]:
    """Size of the bounding box along x, y and z."""
    size = np.ptp(positions.reshape(-1, 3), axis=0)
    return float(size[0]), float(size[1]), float(size[2])


def sheet_area(positions: Positions) -> float:
    """Area of all panels of a grid."""
    return float(np.linalg.norm(area_vectors(grid_corners(positions)), axis=-1).sum())


def area_of(mechanism: Mechanism) -> float:
    """Area of all panels of a mechanism, with its flaps."""
    corners = points_of(mechanism, 0.0)[Layout.of(mechanism).faces]
    return float(np.linalg.norm(area_vectors(corners), axis=-1).sum())


def corrugation_depth(positions: Positions) -> float:
    """Mean distance of inner vertices from the line between those above and below (length).

    Where these two lie on each other, the distance from them.
    """
    inner = positions[:, 1:-1] if positions.shape[1] > 2 else positions
    base = inner[2:] - inner[:-2]
    arm = inner[1:-1] - inner[:-2]
    across = np.linalg.norm(np.cross(arm, base), axis=-1)
    apart, depth = np.linalg.norm(base, axis=-1), np.linalg.norm(arm, axis=-1)
    return float(np.divide(across, apart, out=depth, where=apart > COINCIDENT * depth).mean())


STATES = 257
"""States among which the first one beyond a fold angle is looked for."""
FINE = 1e-14
"""Accuracy of the drive at which a fold angle is reached (relative)."""


def largest_fold(mechanism: Mechanism, drive: Array) -> Array:
    """Return the largest fold angle (S,) of any crease, without its sign (radians).

    Parameters
    ----------
    drive
        Drive angles (S,) of the states (radians).
    """
    angles = mechanism.fold_angles(drive)
    row, column = (
        np.abs(each).reshape(len(drive), -1).max(axis=1, initial=0.0)
        for each in (angles.row, angles.column)
    )
    found = np.asarray(np.maximum(row, column))
    if isinstance(mechanism, SlitFlaps):
        found = np.maximum(found, np.abs(mechanism.flap_folds(drive)).max(axis=-1))
    return found


def drive_at_fold(mechanism: Mechanism, fold: float) -> float:
    """The drive at which a crease is first folded as far as this, or the end of the motion.

    Parameters
    ----------
    fold
        A fold angle, in (0, pi] (radians).
    """
    end = mechanism.end_drive
    if fold >= np.pi:
        return end
    drives = np.linspace(0.0, end, STATES)
    beyond = np.flatnonzero(largest_fold(mechanism, drives) > fold)
    if not len(beyond):
        return end

    def open_enough(drive: float) -> bool:
        return bool(largest_fold(mechanism, np.array([drive]))[0] <= fold)

    first = int(beyond[0])
    return bisect(open_enough, float(drives[first - 1]), float(drives[first]), relative=FINE)


RESOLUTION = 1e-8
"""An edge must be at least this long relative to the diagonal of the flat sheet."""


def require_resolution(mechanism: Mechanism, candidates: Iterable[Remedy]) -> None:
    """Refuse panels so small that the rounding of coordinates would bend them.

    Parameters
    ----------
    candidates
        What may give larger panels.

    Raises
    ------
    DesignError
        If an edge is shorter than :data:`RESOLUTION` of the sheet's diagonal.
    """
    flat = mechanism.positions(0.0)
    size = float(np.linalg.norm(np.ptp(flat.reshape(-1, 3), axis=0)))
    edges = {"a row": lengths(np.diff(flat, axis=1)), "a column": lengths(np.diff(flat, axis=0))}
    name = smallest_of(edges, lambda each: float(edges[each].min()))
    shortest = float(edges[name].min())
    if shortest < RESOLUTION * size:
        row, column = np.unravel_index(first_smallest(edges[name]), edges[name].shape)
        raise DesignError(
            "a panel is so small that the rounding of coordinates would bend it",
            place=f"at row {row}, column {column}",
            size=f"an edge of {name} is {plain(shortest)} long, and must be at least "
            f"{RESOLUTION:g} of the sheet's diagonal, which is {plain(size)}",
            candidates=candidates,
            excess=1 - shortest / (RESOLUTION * size),
        )
