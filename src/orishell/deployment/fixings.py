"""Where ties are fixed and feet stand: at vertices of the sheet, or on whole boards beside it.

Both join two rows at one column. At whole boards they are at corners, half way up, of the two
boards between these rows that are to the right of the column, or to the left of the last one.
"""

from __future__ import annotations

import numpy as np

from orishell.clash.acceleration_bounds import NormalBounds
from orishell.conventions.record import record
from orishell.motion import Mechanism
from orishell.motion.hinge_lines import IN_CREASES, HingeLines
from orishell.motion.hinges import Hinges
from orishell.motion.layout import Layout, points_of
from orishell.numerics.arrays import Array, Integers


@record
class Fixings:
    """Pairs of places, each pair at one column."""

    mechanism: Mechanism
    rows: Integers  # (P, 2), two different rows of the whole grid each
    columns: Integers  # (P,)
    hinges: HingeLines = IN_CREASES  # beside them, those of whole boards

    def at(self, drives: Array | float) -> Array:
        """The places (..., P, 2, 3) at drives (...) (radians)."""
        positions = self.mechanism.positions(drives)
        if not isinstance(self.hinges, Hinges):
            return np.asarray(positions[..., self.rows, self.columns[:, None], :])
        panels, beside = self._boards()
        corners = np.where(self.rows == self.rows.min(axis=1, keepdims=True), [0], [1])
        # Corners of a panel: left above, left below, right below, right above.
        corners = np.where((beside < self.columns)[:, None], 3 - corners, corners)
        boards = self.hinges.boards(positions)
        return np.asarray(boards[..., panels, beside[:, None], corners, :])

    def _boards(self) -> tuple[Integers, Integers]:
        """Rows (P, 2) and columns (P,) of the panels of the boards that they are on."""
        lower = self.rows == self.rows.max(axis=1, keepdims=True)
        return self.rows - lower, np.minimum(self.columns, self.mechanism.grid.columns - 2)

    def accelerations(self, start: Array, stop: Array) -> Array:
        """Bounds (S, P) of those of vectors from the first to the second of every pair.

        In ranges of the drive (S,): the sum of those of the edges between. With hinges at the
        heights h_i and the middle of the boards at z, the shifts add

            (h_1 - z) n_1 + (h_2 - h_1) n_2 + ... + (z' - h_k) n_(k+1)

        with the normals of the panels between.
        """
        along, down = self.mechanism.edge_accelerations(start, stop)
        sums = np.pad(np.cumsum(down, axis=1), ((0, 0), (1, 0)))
        found = sums[:, self.rows.max(axis=1)] - sums[:, self.rows.min(axis=1)]
        if not isinstance(self.hinges, Hinges):
            return np.asarray(found)
        bounds = NormalBounds(Layout.of(self.mechanism), points_of(self.mechanism, 0.0))
        normals = bounds.within(along, down).reshape(len(start), *self.hinges.levels.shape)
        beside = self._boards()[1]
        return np.asarray(
            found + np.einsum("pi,sip->sp", self._levers(self.hinges), normals[:, :, beside])
        )

    def _levers(self, hinges: Hinges) -> Array:
        """Lengths (P, rows-1) by which normals of the panels in their column count."""
        panels, beside = self._boards()
        first, last = panels.min(axis=1)[:, None], panels.max(axis=1)[:, None]
        middle = (hinges.levels + 0.5 * hinges.thickness)[:, beside].T
        row = np.arange(middle.shape[1])
        # Heights over and under each board of the column: hinges, or the places themselves.
        heights = hinges.heights.row[:, beside].T
        above, below = middle.copy(), middle.copy()
        above[:, 1:] = np.where(row[1:] > first, heights, middle[:, 1:])
        below[:, :-1] = np.where(row[:-1] < last, heights, middle[:, :-1])
        return np.where((row >= first) & (row <= last), np.abs(below - above), 0.0)
