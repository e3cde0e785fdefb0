"""Panels of a sheet as the proof of contact sees them: those of its grid, and flaps beside it.

Flaps that are slit from each other are no columns of the grid. Their panels follow those of the
grid, their vertices too, and they have places beside it, over which accelerations are summed up.
"""

from __future__ import annotations

from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.motion.mechanism import Mechanism
from orishell.numerics.arrays import Array, Booleans, Integers


@record
class Layout:
    """All panels of a sheet (F,)."""

    faces: Integers  # (F, 4), vertices, counter-clockwise seen from +z in the flat sheet
    # Rows and columns (F, 2) of vertices from which and up to which a panel reaches. A vector
    # between vertices of two panels is a sum of edges over all rows and columns from the first to
    # the last of both.
    first: Integers
    last: Integers
    # (F, 2), row and column that a panel is called by: -1 is the column left of the sheet
    names: Integers
    flaps: Booleans  # (F,), which are flaps
    # numbers (K, 2) of panels about the row creases of flaps that are no columns of the grid
    pairs: Integers

    @classmethod
    def of(cls, mechanism: Mechanism) -> Layout:
        """That of a mechanism: its own, or that of its grid."""
        if isinstance(mechanism, LaidOut):
            return mechanism.layout
        return cls.of_grid(mechanism.grid, mechanism.flap_columns)

    @classmethod
    def of_grid(cls, grid: Grid, flap_columns: tuple[int, ...] = ()) -> Layout:
        """That of a grid whose columns of panels with these numbers are flaps."""
        names = np.indices((grid.rows - 1, grid.columns - 1)).reshape(2, -1).T
        flaps = np.isin(names[:, 1], flap_columns)
        none = np.zeros((0, 2), np.int64)
        return cls(grid.faces_vertices(), names, names + 1, names, flaps, none)


@runtime_checkable
class LaidOut(Protocol):
    """A mechanism with panels beside its grid.

    Its bounds of accelerations have further columns for them (see
    :meth:`~orishell.motion.Mechanism.edge_accelerations`), and its positions are those of its grid.
    """

    @property
    def layout(self) -> Layout:
        """All its panels."""

    def points(self, drive: ArrayLike) -> Array:
        """Positions (..., V, 3) of all vertices, those of the grid first."""

    def flap_folds(self, drive: ArrayLike) -> Array:
        """Fold angles (..., K) between the pairs of panels of its layout (radians)."""


def require_grid(mechanism: Mechanism, what: str) -> None:
    """Refuse flaps that are no columns of the grid, where they would be left out.

    what: What they cannot be.

    Raises
    ------
    DesignError
        If the mechanism has such flaps.
    """
    if isinstance(mechanism, LaidOut):
        raise DesignError(
            f"flaps that are slit from row to row cannot be {what} yet",
            keys=("pattern.flap",),
            candidates=[Remedy({"pattern.flap": 0.0})],
        )


def points_of(mechanism: Mechanism, drive: float) -> Array:
    """Positions (V, 3) of all vertices of a mechanism in one state."""
    if isinstance(mechanism, LaidOut):
        return mechanism.points(drive)
    return mechanism.positions(drive).reshape(-1, 3)
