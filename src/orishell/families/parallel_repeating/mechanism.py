"""Parallel repeating: rows of parallel creases, straight columns (the paper's section 2).

The motion in closed form:

At the target column j is a zigzag of angle xi_j in the vertical plane through t_j. With
tau_j = tan(xi_j/2) and delta the angles between row segments and t, equation (2) says that the
*slope* of the panels between two columns,

    nu = tau_j sin delta_{2j-1} = tau_{j+1} sin delta_{2j},

is the same seen from both; a flap has nu = tan(stop), 0 in the paper. The paper's motion, from
kappa = 0 in the flat sheet to kappa = 1 at the target, goes on beyond it: with q^2 = 1 - kappa^2,
in units of cos(xi_j/2),

    cos(psi_j/2) = kappa,   sin(psi_j/2) = sqrt(tau_j^2 + q^2),
    cos eps sin(psi_j/2) = tau_j cos delta,   sin eps sin(psi_j/2) = w = sqrt(nu^2 + q^2),

until a w is 0: the row creases between these two columns are folded flat. The panel columns with
the smallest slope, the *rest*, are the tightest. The drive rho is the fold angle of their row
creases,

    kappa = hypot(1, rest) sin(rho/2),   w of the tightest = hypot(1, rest) cos(rho/2),

and all squares are sums of w^2 of the tightest and of what is beyond the rest, nu^2 - rest^2 or
tau^2 - rest^2. So no digits are lost near the target, which is at tan(rho/2) = 1/rest, or near the
end. With flaps that fold flat the rest is 0 and the target the end, as in the paper.
"""

from __future__ import annotations

from dataclasses import field, replace

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.design import FlapSide
from orishell.families.parallel_repeating.columns import (
    Columns,
    bound_edges,
    interleaved,
    squared_distances,
    turned,
)
from orishell.families.shared.sheets import (
    FlapSheet,
    column_fold_angle,
    row_fold_angle,
    running_products,
    running_sums,
)
from orishell.motion import mechanism_in_one_line
from orishell.motion.grid import CreaseValues
from orishell.motion.lattice import Lattice
from orishell.numerics import Enclosure
from orishell.numerics.arrays import Array, Complex, Integers


@record
class ParallelRepeating(FlapSheet):
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
        object.__setattr__(self, "_columns", self._solved())

    def with_flaps(self, width: float) -> ParallelRepeating:
        """The sheet with flaps of this width (in its unit), measured square to their column.

        A flap's crease leaves its column at the sector angle alpha_3 or alpha_4n. With 0 there are
        none: columns 1 and n are the border.
        """
        sectors = self.sector_angles()
        left, right = width / np.sin(sectors[0, 2]), width / np.sin(sectors[-1, 3])
        return replace(self, flaps=(float(left), float(right)))

    def column_arcs(self) -> Array:
        """Arc length (m+2,) along the first column from its middle vertex."""
        return running_sums(self.lengths, len(self.lengths) // 2)

    def lattice(self) -> Lattice:
        """Coordinates of its rows along the two directions of every column."""
        return Lattice.of_staircase(self.lengths, self._rising() > 0)

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

    def column_scales(self) -> Array:
        """How many times (n,) as long as in column 1 f is along each column's t, at lock."""
        tau = self._columns.tau
        return np.asarray(tau / tau[0])

    def row_lengths(self, row: int) -> Array:
        """Lengths (n-1,) of the creases between inner columns in a row: affine in its arc.

        Not positive where neighbouring columns meet before they reach the row.
        """
        columns = self._columns
        # Motion leaves it alone, so take it at lock: reach along t is h tau, h = arc cos(xi/2).
        closing = (columns.tau * columns.cos_right)[:-1] + (columns.tau * columns.cos_left)[1:]
        lengths: Array = (
            np.abs(np.diff(self.points)) - self.column_arcs()[row] * np.cos(self.xi / 2) * closing
        )
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
        reach = self.column_arcs() * np.cos(self.xi / 2)
        height = running_sums(self._rises(), len(self.lengths) // 2)

        grid = self.grid
        out = np.empty((*drive.shape, grid.rows, grid.columns, 3))
        flat = out.reshape(*drive.shape, grid.rows, grid.columns * 3)
        np.multiply(reach[:, None], interleaved(spread)[..., None, :], out=flat)
        flat += interleaved(middle)[..., None, :]
        out[..., 2] = (height * kappa[..., None])[..., None]
        return out

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of all creases at drive angles (...), section 2(b) (radians)."""
        columns = self._columns
        kappa, tight = columns.phase(np.asarray(drive, dtype=np.float64))
        c = kappa[..., None]
        w = np.hypot(columns.slope_beyond, tight[..., None])
        row = row_fold_angle(c, w)
        column = column_fold_angle(
            c * np.cos(np.arctan(columns.tau)),
            columns.tau * columns.cos_left,
            w[..., :-1],
            columns.tau * columns.cos_right,
            w[..., 1:],
        )
        rising, there = self._rising(), self._existing
        return CreaseValues(
            row=-rising[:-1, None] * row[..., None, there],
            column=-rising[:, None] * column[..., None, there],
        )

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the acceleration of edge vectors, see :class:`~orishell.motion.Mechanism`."""
        middle = np.abs(np.diff(self.points))
        longest = np.maximum(self.row_lengths(0), self.row_lengths(len(self.lengths)))
        along, down = bound_edges(
            self._columns,
            middle,
            np.concatenate([self.flaps[:1], longest, self.flaps[1:]]),
            self.lengths * np.cos(self.xi / 2),
            (start, stop),
        )
        return along[..., self._existing], down

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

    def _solved(self) -> Columns:
        """Equation (2): tau and the cosines of delta per column, the slope per panel column."""
        segment = np.diff(self.points)
        segment = segment / np.abs(segment)
        right = segment * self.axes[:-1].conj()  # exp(i delta_{2j-1})
        left = segment * self.axes[1:].conj()  # -exp(-i delta_{2j})
        ratio = right.imag / left.imag
        tau = np.tan(self.xi / 2) * np.concatenate([[1.0], np.cumprod(ratio)])
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

    def _stopped(self, stop: float) -> ParallelRepeating:
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
