"""Parallel repeating: rows of parallel creases, straight columns (the paper's section 2).

A T-hedron whose edges are all as steep as one another, so that it is flat at drive 0. Its motion is
derived in :mod:`orishell.families.shared.t_hedron`.
"""

from __future__ import annotations

from dataclasses import field

import numpy as np

from orishell.conventions.record import record
from orishell.design import FlapSide
from orishell.families.shared.columns import Columns, squared_distances
from orishell.families.shared.sheets import running_sums
from orishell.families.shared.t_hedron import THedron
from orishell.motion import mechanism_in_one_line
from orishell.motion.lattice import Lattice
from orishell.motion.skins import Skin
from orishell.numerics import Enclosure
from orishell.numerics.arrays import Array, Complex, Integers


@record
class ParallelRepeating(THedron):
    """A folding sheet of the parallel repeating type.

    Directions and points in the horizontal plane are complex numbers x + iy.
    """

    xi: float  # angle of the first column's zigzag at lock (radians)
    lengths: Array  # edge lengths of the first column (m+1,), m odd, in the unit of the curves
    first: int  # +1 if the first edge rises at lock, -1 if it falls
    points: Complex  # the middle row at lock (n,), n at least 2: vertices of g's polyline
    # unit direction t of every column's plane (n,), to the right of the row: every row segment must
    # lie counter-clockwise of the axes at both its ends by an angle in (0, pi)
    axes: Complex
    # lengths of the row creases across the left and the right flap; 0 where there is none
    flaps: tuple[float, float]
    # to which end of f each flap folds: "end" is along +t, "start" along -t
    flap_sides: tuple[FlapSide, FlapSide] = ("end", "end")
    stop: float = 0.0  # by how much flaps stop short of folding flat at the target (radians)
    _columns: Columns = field(init=False, repr=False)

    __repr__ = mechanism_in_one_line

    def __post_init__(self) -> None:
        self._freeze("lengths", "points", "axes")
        object.__setattr__(self, "_columns", self._solved(np.tan(self.xi / 2)))

    def column_arcs(self) -> Array:
        """Arc length (m+2,) along the first column from its middle vertex."""
        return running_sums(self.lengths, len(self.lengths) // 2)

    def lattice(self) -> Lattice:
        """Coordinates of its rows along the two directions of every column."""
        return Lattice.of_staircase(self.lengths, self._rising() > 0)

    def second_skin(self, columns: slice, gap: float | None) -> Skin:
        """Its staircase, moved down along both directions, over columns of vertices.

        At the target it is nowhere nearer than a gap (length).
        """
        return Skin.under(self, columns, gap)

    def sector_angles(self) -> Array:
        """The paper's alpha_1 ... alpha_4n (n, 4) of the middle row, equation (2) (radians).

        In the paper's order RU, LU, LD, RD; every row has the same. Those at a flap are given even
        if it is left out.
        """
        columns = self._columns
        w = np.hypot(columns.slope, 1.0)
        right = np.arctan2(w[1:], columns.tau * columns.cos_right)
        left = np.arctan2(w[:-1], columns.tau * columns.cos_left)
        return np.stack([np.pi - right, np.pi - left, left, right], axis=-1)

    def column_distances(
        self, rows: Integers, columns: Integers, start: Array, stop: Array
    ) -> Enclosure:
        """Squared distances of vertices, see :class:`~orishell.deployment.ColumnDistances`."""
        inner = columns - self.inner_columns.start
        return squared_distances(self._columns, self._rises(), rows, inner, (start, stop))

    def _rising(self) -> Array:
        """+1 for edges (m+1,) of the first column that rise at lock, -1 for those that fall."""
        return self.first * np.where(np.arange(len(self.lengths)) % 2 == 0, 1.0, -1.0)

    def _rises(self) -> Array:
        """By how much the edges (m+1,) of all columns rise at lock."""
        return np.asarray(self._rising() * self.lengths * np.cos(self.xi / 2))

    def _reaches(self) -> Array:
        return np.asarray(self.column_arcs() * np.cos(self.xi / 2))

    def _beyond(self) -> Array:
        return np.zeros(len(self.lengths))

    def _heights(self, kappa: Array) -> Array:
        return running_sums(self._rises(), self.middle) * kappa[..., None]
