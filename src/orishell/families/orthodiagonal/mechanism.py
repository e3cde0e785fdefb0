"""Orthodiagonal: straight parallel columns, rows in planes square to them (the paper's section 3).

The motion in closed form:

Kappa is 0 in the flat sheet and 1 at the target; q^2 = 1 - kappa^2 is negative beyond it. With
beta_i the zigzag's angles at the target write T_i = tan(beta_i/2), c_i = cot(beta_i/2). All
columns lie in parallel planes of common normal n. Their edges between two rows are parallel, in
every state, with the directions v_i of column 1, which turns at vertex i by twice
arctan(kappa c_i). Row creases leave vertex i in the plane of n and the bisector t_i; along the
bisector they go by ``K_j |a_i|``, where

    a_i = t_i hypot(T_i, kappa) = v_{i-1} (T_i + i s_i kappa) = v_i (T_i - i s_i kappa),

s_i the sign of the turn, in complex numbers of f's plane. So a_{i+1} - a_i is a multiple of v_i
that motion leaves alone. With k_j and N_j what panel column j takes along K and n,

    k_j = l_j cos eps_j cos(beta_mid/2),     N_j^2 = (l_j sin eps_j)^2 + q^2 k_j^2,

for a flap k = +-width cos eta and N(target) = width sin eta, and K, M their running sums from
column 1,

    X_ij = P_i + K_j a_i + M_j n,            cot alpha_{i,4j} = T_i k_j/N_j(flat),

P being column 1. This is equation (3): sums of products of one factor per row and one per column.

The motion ends where an N is 0. The *tightest* panel column is that of the least share of N in the
flat sheet left at the target, the *rest* r (0 for a flap). The drive rho has

    tan(rho/2) = kappa N(flat)/N of the tightest,   so   kappa = sin(rho/2)/omega,
    omega = hypot(sqrt(1 - r^2), r cos(rho/2)),
    (omega N_j)^2 = (N_j(target)^2 - r^2 N_j(flat)^2) + (r^2 N_j(flat)^2 + k_j^2) cos(rho/2)^2:

sums of squares, so that no digits are lost near the target, at tan(rho/2) = 1/r, or near the end.
With flaps that fold flat r = 0 and kappa = sin(rho/2), as in the paper; where all rows are straight
r = 1 and kappa = tan(rho/2), and the zigzags of the columns close. Flaps stop short of folding flat
by the stop at the sharpest vertex: sin eta = sin(stop)/sin(beta_min/2).
"""

from __future__ import annotations

from dataclasses import field, replace

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.design import FlapSide
from orishell.families.orthodiagonal.columns import (
    Columns,
    bound_edges,
    column_and_spread,
    squared_distances,
)
from orishell.families.shared.sheets import (
    FlapSheet,
    row_fold_angle,
    running_sums,
    target_drive,
)
from orishell.motion import mechanism_in_one_line
from orishell.motion.grid import CreaseValues
from orishell.numerics import Enclosure
from orishell.numerics.arrays import Array, Complex, Integers
from orishell.polylines import alternating

ALIKE = 1e-9
"""Directions of a row's edges that differ by no more are those of a zigzag (radians)."""


@record
class Orthodiagonal(FlapSheet):
    """A folding sheet of the orthodiagonal type.

    Points and directions in g's plane are complex numbers x + iy.
    """

    lengths: Array  # edge lengths d of the first column (m+1,), m odd, in the unit of the curves
    angles: Array  # angles beta (m,) at its inner vertices at lock, in (0, pi) (radians)
    first: int  # +1 if it turns right at vertex 1 at lock, seen with n pointing away, -1 if left
    tilt: float  # angle by which the middle row's plane rises along t at lock (radians)
    points: Complex  # the middle row at lock (n,), n at least 2: vertices of g's polyline
    # angle from f's plane to the x axis of the points, eps of a segment along x (radians)
    heading: float
    # widths of the left and the right flap in the flat sheet; 0 where there is none
    flaps: tuple[float, float]
    # to which end of f each flap folds: "end" is along +t, "start" along -t
    flap_sides: tuple[FlapSide, FlapSide] = ("end", "end")
    # growth by K of the first and of the last edge of a column
    trims: tuple[float, float] = (0.0, 0.0)
    # share (2, m+2) of its width that the left and the right flap keep at every row, in (0, 1]:
    # less than 1 where a flap is cut off at an end of f
    kept: Array = field(default_factory=lambda: np.ones((2, 1)))
    stop: float = 0.0  # by how much flaps stop short of folding flat at the target (radians)
    _columns: Columns = field(init=False, repr=False)

    __repr__ = mechanism_in_one_line

    def __post_init__(self) -> None:
        self._freeze("lengths", "angles", "points", "kept")
        object.__setattr__(self, "_columns", self._steps())

    def straightened(self) -> Orthodiagonal:
        """The sheet with a row that is a zigzag to the last digit, if it nearly is one.

        Then all columns are straight in the flat sheet, and the sheet folds flat. Chords between
        crests and troughs of a wave are as exact as these are traced.
        """
        edges = np.diff(self.points) * np.exp(1j * self.heading)  # l exp(i eps)
        size = np.arctan2(np.abs(edges.imag), np.abs(edges.real))
        by_turns = np.sign(edges.real[0]) * alternating(len(edges))
        if np.abs(size - size.mean()).max() > ALIKE or (np.sign(edges.real) != by_turns).any():
            return self
        steps = by_turns * np.cos(size.mean()) + 1j * np.sign(edges.imag) * np.sin(size.mean())
        steps = np.abs(edges) * steps * np.exp(-1j * self.heading)
        return replace(self, points=self.points[0] + np.append(0.0, np.cumsum(steps)))

    def shifts(self) -> Array:
        """Shifts K (n+2,) of every column, 0 at column 1; (n,) without flaps."""
        return running_sums(self._columns.k, 1)[self._existing]

    def column_lengths(self) -> Array:
        """Lengths (m+1, columns of the grid) of all columns' edges: they never change.

        Those of creases are affine in K, and not positive where neighbouring rows meet before they
        reach the column.
        """
        lengths = self._whole_lengths()
        for _, edge, _ in self._cuts():
            outline = self.positions(0.0)[:, edge]
            lengths[:, edge] = np.linalg.norm(np.diff(outline, axis=0), axis=-1)
        return lengths

    def sector_angles(self) -> Array:
        """The paper's alpha_{i,1} ... alpha_{i,4n} (m, n, 4), equation (3) (radians).

        In the paper's order RU, LU, LD, RD. Those at a flap are given even if it is left out.
        """
        columns = self._columns
        right = np.arctan2(columns.step, columns.k * self._tangents()[:, None])  # RD of every panel
        left = np.pi - right[:, :-1]
        right = right[:, 1:]
        return np.stack([np.pi - right, np.pi - left, left, right], axis=-1)

    def positions(self, drive: ArrayLike) -> Array:
        """Positions (..., m+2, n+2, 3) at drive angles rho (...), in [0, end_drive] (radians).

        At the target f is upright (its y axis is +z) and the middle row lies on the points, in
        their plane z = 0 turned about n by the tilt, through the first point. Elsewhere n and the
        length-weighted centroid of the middle row stay, and the plane of t and n is level at
        drive 0 and turns evenly with the drive. Without flaps: (..., m+2, n, 3).
        """
        drive = np.asarray(drive, dtype=np.float64)
        columns = self._columns
        kappa, advance = columns.phase(drive)
        level = np.exp(1j * self.tilt * (drive / target_drive(columns.rest)))
        row = self._middle_row(columns, kappa, advance, level)[..., self._existing, :]
        column, spread = column_and_spread(
            kappa, self._tangents(), self._turning(), self.lengths, self.trims
        )

        # Real numbers of f's plane go along t, imaginary ones upwards.
        t = np.exp(-1j * self.heading)
        column, spread = column * level[..., None], spread * level[..., None]
        factors = (
            (spread.real * t.real, column.real * t.real),
            (spread.real * t.imag, column.real * t.imag),
            (spread.imag, column.imag),
        )
        shift = running_sums(columns.k, 1)[self._existing]
        shape = (*drive.shape, self.grid.rows, self.grid.columns)
        out, plane = np.empty((*shape, 3)), np.empty(shape)
        for axis, (growth, start) in enumerate(factors):
            np.multiply(growth[..., None], shift, out=plane)
            plane += start[..., None]
            np.add(plane, row[..., None, :, axis], out=out[..., axis])
        for kept, edge, near in self._cuts():
            base = out[..., near, :]
            out[..., edge, :] = base + kept[:, None] * (out[..., edge, :] - base)
        return out

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of all creases at drive angles (...), section 2(b) (radians)."""
        columns = self._columns
        kappa, advance = columns.phase(np.asarray(drive, dtype=np.float64))
        gamma, nu = columns.k / columns.step, advance / columns.step
        c = 1 / self._tangents()
        row = row_fold_angle(kappa[..., None, None] * np.hypot(c[:, None], gamma), nu[..., None, :])
        # The panels beside a column make the angle arctan(kappa gamma/nu) with its normal n.
        lean = np.arctan2(kappa[..., None] * gamma, nu)
        column = -self.first * np.diff(lean, axis=-1)
        side = alternating(len(self.lengths))
        row, column = row[..., self._existing], column[..., None, self._existing]
        return CreaseValues(row=self._turning()[:, None] * row, column=side[:, None] * column)

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the acceleration of edge vectors, see :class:`~orishell.motion.Mechanism`."""
        columns = self._columns
        along, down = bound_edges(
            (start, stop),
            tangents=self._tangents(),
            turning=self._turning(),
            trims=self.trims,
            tilt_rate=self.tilt / self.target_drive,
            lengths=np.abs(self._whole_lengths()).max(axis=-1),
            columns=columns,
        )
        # An edge of a cut flap is a mean of the edges beside it and, as much as it is cut more at
        # one end than at the other, a part of the row's.
        slanted = [np.abs(np.diff(kept)) * along[:, edge, None] for kept, edge, _ in self._cuts()]
        return along, down + np.max(slanted, axis=0) if slanted else down

    def column_distances(
        self, rows: Integers, columns: Integers, start: Array, stop: Array
    ) -> Enclosure:
        """Squared distances of vertices, see :class:`~orishell.deployment.ColumnDistances`."""
        whole = self._columns.whole_angle(start[:, None], stop[:, None])
        lengths = self._whole_lengths()[:, columns].T
        return squared_distances(whole, self._tangents(), self._turning(), lengths, rows)

    def _sharpest_angle(self) -> float:
        return float(self.angles.min())

    def _cuts(self) -> list[tuple[Array, int, int]]:
        """For each flap that is cut: the shares (m+2,) it keeps, its column, the one beside it."""
        flaps = ((self.flaps[0], 0, 1), (self.flaps[1], -1, -2))
        return [
            (kept, edge, near)
            for kept, (width, edge, near) in zip(self.kept, flaps, strict=True)
            if width and (kept < 1).any()
        ]

    def _whole_lengths(self) -> Array:
        """Lengths (m+1, columns of the grid) of all columns' edges, flaps not cut."""
        growth = np.concatenate([self.trims[:1], np.diff(self._tangents()), self.trims[1:]])
        return np.asarray(self.lengths[:, None] + growth[:, None] * self.shifts())

    def _tangents(self) -> Array:
        """T = tan(beta/2), (m,)."""
        return np.asarray(np.tan(self.angles / 2))

    def _turning(self) -> Array:
        """The signs s of the turns (m,)."""
        return -self.first * alternating(len(self.angles))

    def _steps(self) -> Columns:
        segment = np.diff(self.points) * np.exp(1j * self.heading)  # l exp(i eps)
        side = [1.0 if side == "end" else -1.0 for side in self.flap_sides]
        inner = segment.real * np.cos(self.angles[len(self.angles) // 2] / 2)
        # A missing flap has any width here: what it gives is left out of the sheet.
        left, right = (width or 1.0 for width in self.flaps)
        sine = np.sin(self.stop) / np.sin(self.angles.min() / 2)
        cosine = np.sqrt(1 - sine**2)
        return Columns(
            k=np.concatenate([[-side[0] * left * cosine], inner, [side[1] * right * cosine]]),
            locked=np.concatenate([[left * sine], segment.imag, [right * sine]]),
            existing=self._existing,
        )

    def _middle_row(self, columns: Columns, kappa: Array, advance: Array, level: Complex) -> Array:
        """The middle row (..., n+2, 3): on the points at the target, if there is no tilt."""
        shift = running_sums(columns.k, 1)
        tangent = self._tangents()[len(self.angles) // 2]
        t = np.exp(-1j * self.heading)
        lock = np.exp(1j * self.tilt)

        along = np.hypot(tangent, 1.0) * shift
        points = np.concatenate(
            [
                [self.points[0] + (along[0] - along[1] - 1j * columns.locked[0]) * t],
                self.points,
                [self.points[-1] + (along[-1] - along[-2] + 1j * columns.locked[-1]) * t],
            ]
        )
        locked = np.stack([points + along * (lock.real - 1) * t, along * lock.imag])

        now = np.hypot(tangent, kappa[..., None]) * shift
        advanced = running_sums(advance, 1) - running_sums(columns.locked, 1)
        level = level[..., None]
        moved = (now * level.real - along * lock.real + 1j * advanced) * t
        risen = now * level.imag - along * lock.imag

        length = np.abs(np.diff(self.points))
        weight = 0.5 * (np.append(length, 0) + np.append(0, length)) / length.sum()
        moved = moved - (weight * moved[..., 1:-1]).sum(axis=-1, keepdims=True)
        risen = risen - (weight * risen[..., 1:-1]).sum(axis=-1, keepdims=True)
        plan = locked[0] + moved
        return np.stack([plan.real, plan.imag, locked[1].real + risen], axis=-1)
