"""T-hedral: columns whose vertices lie on f, so edges are as steep as f is (not in the paper).

A T-hedron whose motion is derived in :mod:`orishell.families.shared.t_hedron`. It is not flat at
drive 0, where its flattest edges are level and the others are not: its sheet is made of strips,
the panels between two columns, each of which can be laid flat.

Limit: T-hedral shells are made in strips that are joined along their long sides. Their boards stand
back from creases: whole boards on hinges are refused, as no state is flat. What errors of cutting
do to them is not measured.
"""

from __future__ import annotations

from dataclasses import field

import numpy as np

from orishell.conventions.record import record
from orishell.design import FlapSide
from orishell.families.shared.columns import Columns
from orishell.families.shared.sheets import other_side, running_sums
from orishell.families.shared.t_hedron import THedron
from orishell.motion import mechanism_in_one_line
from orishell.motion.level_skins import LevelSkin
from orishell.numerics.arrays import Array, Complex


@record
class THedral(THedron):
    """A sheet whose first column is any polyline that goes on along its axis.

    Directions and points in the horizontal plane are complex numbers x + iy.
    """

    lengths: Array  # edge lengths of the first column (m+1,), m odd, in the unit of the curves
    slopes: Array  # by how much these rise for each unit along the axis at lock (m+1,), none 0
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
        self._freeze("lengths", "slopes", "points", "axes")
        object.__setattr__(self, "_columns", self._solved(1 / self._flattest()))

    def second_skin(self, columns: slice, gap: float | None) -> LevelSkin:
        """Its image straight below it, over columns of vertices.

        At the target it is nowhere nearer than a gap (length).
        """
        return LevelSkin.under(self, columns, gap)

    def _flattest(self) -> float:
        return float(np.abs(self.slopes).min())

    def _reaches(self) -> Array:
        runs = self.lengths / np.hypot(1.0, self.slopes)
        return running_sums(runs * self._flattest(), self.middle)

    def _beyond(self) -> Array:
        flattest = self._flattest()
        return other_side(np.abs(self.slopes), flattest) / flattest

    def _rising(self) -> Array:
        return np.sign(self.slopes)
