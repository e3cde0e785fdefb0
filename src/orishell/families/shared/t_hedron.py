"""T-hedra: columns are images of one another in vertical planes (Sauer and Graf; the paper).

Sauer and Graf's T-nets, as sheets that fold. An edge i of the first column runs along the axis t
of its plane and rises; in column j the same edge rises as much and runs tau_j/tau_1 times as far.
Edges of rows between two columns are level and parallel. With the *slopes* of edges in units of
that of the flattest all follow from one phase kappa: at the target it is 1, and

    edge i of column j = reach_i (spread_j t_j, +- hypot(kappa, beyond_i)),
    spread_j = sqrt(tau_j^2 + q^2),   q^2 = 1 - kappa^2,   beyond_i = sqrt(slope_i^2 - 1),

so that its length stays: reach_i^2 (tau_j^2 + slope_i^2). At kappa = 0 the flattest edges are
level. If all are alike, as those of a staircase are, the whole sheet is flat there: it is
developable, the
paper's parallel repeating type, in whose words the rest is said. At the target column j is a zigzag
of angle xi_j in the vertical plane through t_j. With tau_j = tan(xi_j/2) and delta the angles
between row segments and t, equation (2) says that the *slope* of the panels between two columns,

    nu = tau_j sin delta_{2j-1} = tau_{j+1} sin delta_{2j},

is the same seen from both; a flap has nu = tan(stop), 0 in the paper. The motion, from kappa = 0 to
the target, goes on beyond it: in units of cos(xi_j/2),

    cos(psi_j/2) = kappa,   sin(psi_j/2) = spread_j,
    cos eps sin(psi_j/2) = tau_j cos delta,   sin eps sin(psi_j/2) = w = sqrt(nu^2 + q^2),

until a w is 0: the panels between these two columns are upright, and row creases between edges that
rise and fall are folded flat. The panel columns with the smallest slope, the *rest*, are the
tightest. The drive rho is the angle by which row creases between flattest edges fold there,

    kappa = hypot(1, rest) sin(rho/2),   w of the tightest = hypot(1, rest) cos(rho/2),

and all squares are sums of w^2 of the tightest and of what is beyond the rest, nu^2 - rest^2 or
tau^2 - rest^2. So no digits are lost near the target, which is at tan(rho/2) = 1/rest, or near the
end. With flaps that fold flat the rest is 0 and the target the end, as in the paper.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from orishell.design import FlapSide
from orishell.families.shared.columns import (
    Columns,
    bound_edges,
    interleaved,
    turned,
)
from orishell.families.shared.sheets import (
    FlapSheet,
    column_fold_angle,
    running_products,
    running_sums,
)
from orishell.motion.grid import CreaseValues
from orishell.numerics.arrays import Array, Complex


class THedron(FlapSheet):
    """A sheet whose columns are images of one; what is said of edges is of the first column's."""

    __slots__ = ()

    # unit direction t of every column's plane (n,), to the right of the row: every row segment must
    # lie counter-clockwise of the axes at both its ends by an angle in (0, pi)
    axes: Complex
    # to which end of f each flap folds: "end" is along +t, "start" along -t
    flap_sides: tuple[FlapSide, FlapSide]
    _columns: Columns

    @property
    def middle(self) -> int:
        """The row of vertices that meets g."""
        return len(self.lengths) // 2

    def with_flaps(self, width: float) -> Self:
        """The sheet with flaps of this width (in its unit), measured square to their column.

        It is that beside the edge below the middle row. With 0 there are none: columns 1 and n are
        the border.
        """
        left, right = width / np.sin(self._flap_sectors())
        return replace(self, flaps=(float(left), float(right)))

    def column_scales(self) -> Array:
        """How many times (n,) as long as in column 1 f is along each column's t, at lock."""
        tau = self._columns.tau
        return np.asarray(tau / tau[0])

    def row_lengths(self, row: int) -> Array:
        """Lengths (n-1,) of the creases between inner columns in a row: affine in its reach.

        Not positive where neighbouring columns meet before they reach the row.
        """
        columns = self._columns
        # Motion leaves it alone, so take it at lock.
        closing = (columns.tau * columns.cos_right)[:-1] + (columns.tau * columns.cos_left)[1:]
        lengths: Array = np.abs(np.diff(self.points)) - self._reaches()[row] * closing
        return lengths

    def positions(self, drive: ArrayLike) -> Array:
        """Positions (..., m+2, n+2, 3) at drive angles rho (...), in [0, end_drive] (radians).

        At the target the middle row lies on the points, in z = 0. Other states are placed so that
        the middle row's centroid stays where it is and its segments turn by nothing on average.
        Without flaps: (..., m+2, n, 3).
        """
        drive = np.asarray(drive, dtype=np.float64)
        kappa, tight = self._columns.phase(drive)
        middle, spread = self._row_and_spread(tight[..., None])

        grid = self.grid
        out = np.empty((*drive.shape, grid.rows, grid.columns, 3))
        flat = out.reshape(*drive.shape, grid.rows, grid.columns * 3)
        np.multiply(self._reaches()[:, None], interleaved(spread)[..., None, :], out=flat)
        flat += interleaved(middle)[..., None, :]
        out[..., 2] = self._heights(kappa)[..., None]
        return out

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of all creases at drive angles (...), section 2(b) (radians).

        Panels are inclined to the rows' plane by arctan(hypot(kappa, beyond)/w).
        """
        columns = self._columns
        kappa, tight = columns.phase(np.asarray(drive, dtype=np.float64))
        slope = np.hypot(kappa[..., None], self._beyond())[..., None]
        w = np.hypot(columns.slope_beyond, tight[..., None])[..., None, :]
        rising, there = self._rising()[:, None], self._existing
        inclined = rising * np.arctan2(slope, w[..., there])
        length = np.hypot(columns.tau, np.hypot(1.0, self._beyond())[:, None])
        column = column_fold_angle(
            slope / length,
            columns.tau * columns.cos_left,
            w[..., :-1],
            columns.tau * columns.cos_right,
            w[..., 1:],
        )
        return CreaseValues(row=np.diff(inclined, axis=-2), column=-rising * column[..., there])

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the acceleration of edge vectors, see :class:`~orishell.motion.Mechanism`."""
        middle = np.abs(np.diff(self.points))
        longest = np.maximum(self.row_lengths(0), self.row_lengths(len(self.lengths)))
        along, down = bound_edges(
            self._columns,
            middle,
            np.concatenate([self.flaps[:1], longest, self.flaps[1:]]),
            (np.diff(self._reaches()), self._beyond()),
            (start, stop),
        )
        return along[..., self._existing], down

    def _reaches(self) -> Array:
        """Where rows (m+2,) lie along t, per unit of spread, from the middle one on."""
        raise NotImplementedError

    def _beyond(self) -> Array:
        """Slopes (m+1,) of edges beyond that of the flattest, which is 1."""
        raise NotImplementedError

    def _heights(self, kappa: Array) -> Array:
        """Heights (..., m+2) of rows over the middle one."""
        rises = (
            self._rising() * np.diff(self._reaches()) * np.hypot(kappa[..., None], self._beyond())
        )
        return running_sums(rises, self.middle)

    def _rising(self) -> Array:
        """+1 for edges (m+1,) of the first column that rise, -1 for those that fall."""
        raise NotImplementedError

    def _flap_sectors(self) -> tuple[float, float]:
        """Angles between the creases of flaps and the edge below the middle row (radians)."""
        columns = self._columns
        steep = np.hypot(1.0, self._beyond()[self.middle])
        w = np.hypot(columns.slope[[0, -1]], steep)
        left = np.arctan2(w[0], columns.tau[0] * columns.cos_left[0])
        right = np.arctan2(w[1], columns.tau[-1] * columns.cos_right[-1])
        return float(left), float(right)

    def _solved(self, widest: float) -> Columns:
        """Equation (2): tau and the cosines of delta per column, the slope per panel column.

        widest: tau of the first column: its flattest edges run so far for each unit that they rise.
        """
        segment = np.diff(self.points)
        segment = segment / np.abs(segment)
        right = segment * self.axes[:-1].conj()  # exp(i delta_{2j-1})
        left = segment * self.axes[1:].conj()  # -exp(-i delta_{2j})
        ratio = right.imag / left.imag
        tau = widest * np.concatenate([[1.0], np.cumprod(ratio)])
        side = np.array([1.0 if side == "end" else -1.0 for side in self.flap_sides])
        stop = np.tan([self.stop])
        flap = side * np.sqrt(1 - (stop / tau[[0, -1]]) ** 2)
        slope = np.concatenate([stop, tau[:-1] * right.imag, stop])
        return Columns(
            tau=tau,
            cos_left=np.concatenate([flap[:1], -left.real]),
            cos_right=np.concatenate([right.real, flap[1:]]),
            slope=slope,
            sines=right.imag,
            sines_next=left.imag,
            existing=self._existing,
        )

    def _sharpest_angle(self) -> float:
        return float(2 * np.arctan(self._columns.tau[[0, -1]].min()))

    def _stopped(self, stop: float) -> Self:
        stopped = replace(self, stop=stop)
        sizes = zip(self.flaps, self.with_flaps(1).flaps, stopped.with_flaps(1).flaps, strict=True)
        left, right = (size * after / before for size, before, after in sizes)
        return replace(stopped, flaps=(left, right))

    def _row_and_spread(self, tight: Array) -> tuple[Complex, Complex]:
        """Middle row and displacement along t per unit of reach (..., columns of the grid).

        tight: The tightest w, (..., 1).
        """
        columns, rest = self._columns, self._columns.rest
        there = tight == rest  # at the target what is known needs no square root
        w = np.where(there, columns.slope, np.hypot(columns.slope_beyond, tight))
        # Turns against the target state, of a segment from the column at its left, and of a
        # column from the segment at its left: exp(i (eps - delta)), exactly 1 at the target.
        inner, slope = w[..., 1:-1], columns.slope[1:-1]
        gain = (tight - rest) * (tight + rest) / (inner + slope)
        turn = turned(columns.tau[:-1], columns.cos_right[:-1], columns.sines, inner, gain)
        turn_next = turned(columns.tau[1:], columns.cos_left[1:], columns.sines_next, inner, gain)
        of_axis = running_products(turn * turn_next)
        of_segment = of_axis[..., :-1] * turn

        edges = np.diff(self.points)
        row = self.points + running_sums(edges * (of_segment - 1), 0)

        # Placement: no turn on average over the row's length, and the centroid kept.
        length = np.abs(edges) / np.abs(edges).sum()
        angle = np.angle(turn)
        before = np.cumsum(angle + np.angle(turn_next), axis=-1)
        mean = ((before - np.angle(turn_next)) * length).sum(axis=-1, keepdims=True)
        back = np.exp(-1j * mean)
        weight = 0.5 * (np.append(length, 0) + np.append(0, length))
        home = (weight * self.points).sum()
        row = row * back + (home - (weight * row).sum(axis=-1, keepdims=True) * back)

        half = np.where(there, columns.tau, np.hypot(columns.tau_beyond, tight))
        axis = of_axis * self.axes * back
        spread = axis * half

        # Flap creases leave columns 1 and n: exp(-i eps_L) to the left, exp(i eps_R) to the right.
        cosines = columns.tau[0] * columns.cos_left[0], columns.tau[-1] * columns.cos_right[-1]
        left = axis[..., :1] * (cosines[0] - 1j * w[..., :1]) / half[..., :1]
        right = axis[..., -1:] * (cosines[1] + 1j * w[..., -1:]) / half[..., -1:]
        row = np.concatenate(
            [row[..., :1] + self.flaps[0] * left, row, row[..., -1:] + self.flaps[1] * right],
            axis=-1,
        )
        spread = np.concatenate([spread[..., :1], spread, spread[..., -1:]], axis=-1)
        return row[..., self._existing], spread[..., self._existing]
