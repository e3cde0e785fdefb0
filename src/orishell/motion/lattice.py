"""Sheets whose columns are staircases of two directions: a lattice that all columns share.

In column j every vertex is o_j + alpha_i U_j + beta_i V_j, with coordinates (alpha_i, beta_i) that
are the same in all columns and states; U_j and V_j are the directions of its edges that rise and
that fall at the target. So whatever else is joined along these two directions follows each state of
the sheet.
"""

from __future__ import annotations

from typing import Protocol, runtime_checkable

import numpy as np

from orishell.conventions.record import record
from orishell.motion.carried import Lines
from orishell.motion.grid import Positions
from orishell.numerics.arrays import Array, Booleans, Integers

RISING, FALLING = 0, 1
"""Coordinates of a place: along edges that rise at the target, and along those that fall."""


@record
class Lattice:
    """Coordinates that vertices of all columns have along the edges of column 1."""

    places: Array  # (R, 2) of the rows, both never less than in the row before (length)

    @classmethod
    def of_staircase(cls, lengths: Array, rising: Booleans) -> Lattice:
        """That of a staircase of edges (R-1,) that rise and fall in turn, at least two of them."""
        steps = lengths[:, None] * np.stack([rising, ~rising], axis=-1)
        return cls(np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)]))

    @property
    def lengths(self) -> Array:
        """Lengths (R-1,) of the edges of column 1."""
        return np.asarray(np.diff(self.places, axis=0).sum(axis=1))

    @property
    def kinds(self) -> Integers:
        """Along which coordinate each edge (R-1,) goes."""
        return np.asarray(np.diff(self.places, axis=0).argmax(axis=1))

    def lines(self, columns: slice, places: Array) -> Lines:
        """Lines of vertices at places (K, 2), each from the row of vertices that is nearest."""
        away = np.abs(places[:, None] - self.places).sum(axis=-1)
        rows = away.argmin(axis=1)
        first = np.clip(rows - 1, 0, len(self.lengths) - 2)
        edges = np.stack([first, first + 1])
        along = np.take_along_axis((places - self.places[rows]).T, self.kinds[edges], axis=0)
        shares = along / self.lengths[edges]
        count = columns.stop - columns.start
        return Lines(columns, rows, edges, np.repeat(shares[..., None], count, axis=-1))

    def between(self, places: Array) -> Integers:
        """Rows (K-1, 2) from which and up to which a sheet reaches between places (K, 2) in turn.

        Neither coordinate is less than in the first of these rows, nor larger than in the last.
        """
        low = np.minimum(places[:-1], places[1:])
        high = np.maximum(places[:-1], places[1:])
        rows = [
            (
                np.searchsorted(each, low[:, k], side="right") - 1,
                np.searchsorted(each, high[:, k], side="left"),
            )
            for k, each in enumerate(self.places.T)
        ]
        first = np.min([each for each, _ in rows], axis=0)
        last = np.max([each for _, each in rows], axis=0)
        return np.asarray(np.clip(np.stack([first, last], axis=-1), 0, len(self.places) - 1))

    def distances(self, points: Positions) -> Array:
        """Distances (n-1, 2) of parallel panels between columns (R, n, 3), by what is between them.

        By the length along edges that rise of panels that fall, and the other way.
        """
        edges = np.diff(points, axis=0) / self.lengths[:, None, None]
        rising, falling = (edges[self.kinds == k][0, :-1] for k in (RISING, FALLING))
        along = np.diff(points[0], axis=0)
        volume = np.abs((np.cross(rising, falling) * along).sum(axis=-1))
        areas = [np.linalg.norm(np.cross(each, along), axis=-1) for each in (falling, rising)]
        return np.stack([volume / each for each in areas], axis=-1)


@record
class InnerStaircase:
    """A staircase that follows a curve of its own, on the lattice of a sheet."""

    places: Array  # of its vertices (K, 2) (length)
    distance: float  # from the curve (length)


@runtime_checkable
class OnLattice(Protocol):
    """A sheet whose columns share a lattice, and whose row creases between two are parallel.

    Its bounds of accelerations of edges down columns are in proportion to their lengths.
    """

    def lattice(self) -> Lattice:
        """Coordinates of its rows."""
