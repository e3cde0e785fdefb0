"""Longitudinal linear repeating: the motion in closed form (the paper's section 4).

Write t = tan(v_1/2). Below vertex (i, j) the column crease has tan(v/2) = s_i mu_j t with the
columns' multipliers mu and signs s_i = +-1: an S vertex turns the sign over, an F vertex does so in
the cosine version. In deviations of the sectors from pi/2 (see ``sectors``) the row creases are ::

    F, cosine:  tan(u/2) = s mu t cos((alpha-beta)/2) / sin((alpha+beta)/2), left as right,
    F, sine:    tan(u/2) = -s mu t sin((alpha-beta)/2) / cos((alpha+beta)/2), left opposite,
    S:          tan(u/2) = -2 s mu t cos delta / (-sin(gamma+delta) + sin(gamma-delta) (mu t)^2),
                left with gamma and delta exchanged,

so they depend on the column and on the kind of row only. The motion ends where the first S crease
reaches pi, that is, where its denominator vanishes.

Panels are turned by the product of the rotations about the creases that a path to them crosses:
along the middle row of panels by running products, from there to the other rows. Rotations are
unit quaternions A + B i, with complex A = w + z k and B = x + y k.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.families.longitudinal_linear_repeating.motion.rates import Sheet, bound_edges
from orishell.families.longitudinal_linear_repeating.motion.rotations import (
    Rotations,
    multiply_on,
    running_products,
)
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Columns,
    Directions,
    RowKind,
    flat_foldable_rows,
)
from orishell.families.longitudinal_linear_repeating.tessellation.lengths import EdgeLengths
from orishell.motion import mechanism_in_one_line
from orishell.motion.grid import CreaseValues, Grid
from orishell.numerics.arrays import Array, Booleans


@record
class Pose:
    """Where a sheet stands: the middle row's centroid, and a turn that grows with the drive."""

    # centroid of the middle row's inner vertices, in every state (3,)
    centroid: tuple[float, float, float] = (0.0, 0.0, 0.0)
    # rotation vector (3,) of the sheet's middle panel at the target (radians); in the flat sheet it
    # is not turned, elsewhere in proportion to the drive
    turn: tuple[float, float, float] = (0.0, 0.0, 0.0)


@record
class LongitudinalLinearRepeating:
    """A folding sheet of the longitudinal linear repeating type.

    The drive is v_1, the size of the fold angle of column 1's creases.
    """

    columns: Columns  # sectors and multipliers of the columns (n)
    first_row: RowKind  # kind of row 1; F and S rows alternate
    lengths: EdgeLengths  # lengths of all creases, border included
    side: int = 1  # sign of v_1 below row 1
    # drive at which the target is met, at most :attr:`end_drive`, or None for that
    stop: float | None = None
    pose: Pose = Pose()  # where it stands

    __repr__ = mechanism_in_one_line

    @property
    def grid(self) -> Grid:
        """The grid of vertices, border included."""
        return Grid(self.lengths.row.shape[0] + 2, len(self.columns) + 2)

    @property
    def inner_columns(self) -> slice:
        """Columns 1 ... n among the grid's: the strips beside them stand beyond g's ends."""
        return slice(1, 1 + len(self.columns))

    @property
    def flap_columns(self) -> tuple[int, ...]:
        """None: the strips beside the inner columns do not stop the motion."""
        return ()

    def without_flaps(self) -> LongitudinalLinearRepeating:
        """The sheet itself."""
        return self

    def with_stop(self, stop: float) -> LongitudinalLinearRepeating:
        """The sheet itself."""
        return self

    @property
    def least_turning(self) -> LongitudinalLinearRepeating:
        """The sheet whose middle panel does not turn."""
        return replace(self, pose=Pose())

    @property
    def target_drive(self) -> float:
        """Where the shell meets its target, or, without one, as far as it is folded."""
        return self.end_drive if self.stop is None else self.stop

    @property
    def end_drive(self) -> float:
        """Drive at which the first row crease reaches pi (radians)."""
        return crease_end(self.columns, self.grid.rows - 2, self.first_row)

    def positions(self, drive: ArrayLike) -> Array:
        """Positions (..., m+2, n+2, 3) at drive angles v_1 (...), in [0, end_drive] (radians)."""
        drive = np.asarray(drive, dtype=np.float64)
        panels = self.panels(drive)
        directions = self._directions()
        row_edges = self.lengths.row * np.exp(1j * directions.row)
        column_edges = -1j * self.lengths.column * np.exp(1j * directions.column)
        middle = (self.grid.rows - 2) // 2

        along_middle = panels[..., middle + 1, 1:-1].turned(row_edges[middle, 1:-1])
        down = panels[..., :, 1:].turned(column_edges)
        grid = self.grid
        out = np.empty((*drive.shape, grid.rows, grid.columns, 3))
        inner = out[..., 1:-1, :]
        row = inner[..., middle + 1, :, :]
        row[..., 0, :] = 0.0
        np.cumsum(along_middle, axis=-2, out=row[..., 1:, :])
        row += (np.asarray(self.pose.centroid) - row.mean(axis=-2))[..., None, :]
        start = row[..., None, :, :]
        inner[..., middle + 2 :, :, :] = start + np.cumsum(down[..., middle + 1 :, :, :], axis=-3)
        above = np.cumsum(down[..., middle::-1, :, :], axis=-3)
        inner[..., middle::-1, :, :] = start - above
        left = panels[..., 1:, 0].turned(row_edges[:, 0])
        right = panels[..., 1:, -1].turned(row_edges[:, -1])
        out[..., 1:-1, 0, :] = out[..., 1:-1, 1, :] - left
        out[..., 1:-1, -1, :] = out[..., 1:-1, -2, :] + right
        for i, near in ((0, 1), (-1, -2)):  # corner panels are parallelograms
            for j, beside in ((0, 1), (-1, -2)):
                out[..., i, j, :] = (
                    out[..., i, beside, :] + out[..., near, j, :] - out[..., near, beside, :]
                )
        return out

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of all creases at drive angles (...) (radians)."""
        halves = _HalfAngles.of(self, np.asarray(drive, dtype=np.float64))
        return CreaseValues(
            row=2 * np.arctan2(*halves.row(slice(None))),
            column=2 * np.arctan2(*halves.column(slice(None))),
        )

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the acceleration of edge vectors, see :class:`~orishell.motion.Mechanism`."""
        halves = _HalfAngles.of(self, np.zeros(1))
        sheet = Sheet(
            columns=self.columns,
            directions=self._directions(),
            flat_foldable=halves.flat_foldable,
            signs=halves.signs,
            flat=self.positions(0.0) @ np.array([1, 1j, 0]),
            turn=np.asarray(self.pose.turn) / self.target_drive,
            panels=self.panels,
        )
        return bound_edges(sheet, start, stop)

    def panels(self, drive: Array) -> Rotations:
        """Rotation of every panel (..., m+1, n+1) from the flat sheet, at each drive (radians)."""
        halves = _HalfAngles.of(self, drive)
        directions = self._directions()
        across_row = -np.exp(1j * directions.row)
        across_column = -1j * np.exp(1j * directions.column)
        rows, columns = self.grid.rows - 1, self.grid.columns - 1
        shape = (*drive.shape, rows, columns)
        panels = Rotations(np.empty(shape, np.complex128), np.empty(shape, np.complex128))

        middle = (rows - 1) // 2 + 1
        over_rows = Rotations.about(across_row, *halves.row(slice(None)))
        sine, cosine = halves.column(slice(middle, middle + 1))
        crossed = Rotations.about(across_column[middle], sine[..., 0, :], cosine[..., 0, :])
        along = running_products(crossed)
        anchor = along[..., columns // 2, None]
        turn = Rotations.of_vector(
            np.asarray(self.pose.turn) * (drive / self.target_drive)[..., None, None]
        )
        panels[..., middle, :] = (turn @ anchor.inverse() @ along).normalised()
        multiply_on(panels, over_rows, range(middle, rows - 1))
        multiply_on(panels, over_rows.inverse(), range(middle - 1, -1, -1))
        return panels.normalised()

    def _directions(self) -> Directions:
        return Directions.of(self.columns, self.grid.rows - 2, self.first_row)


def crease_end(columns: Columns, rows: int, first_row: RowKind) -> float:
    """Drive v_1 at which the first crease of a sheet reaches pi (radians)."""
    _, _, gamma, delta = columns.sectors.T
    if flat_foldable_rows(rows, first_row).all():
        return float(2 * np.arctan2(1.0, 0.0))
    # sin(gamma+delta) cos(v/2)^2 = +-sin(gamma-delta) sin(v/2)^2, one sign right, one left.
    half = np.arctan2(
        np.sqrt(np.abs(np.sin(gamma + delta))),
        np.abs(columns.multipliers) * np.sqrt(np.abs(np.sin(gamma - delta))),
    )
    return float(2 * half.min())


@record
class _HalfAngles:
    """Sines and cosines of half the fold angles: per kind of row, and the rows' signs."""

    flat_foldable: Booleans  # (m,)
    signs: Array  # s_i of the column creases (m+1,), from above row 1
    columns: tuple[Array, Array]  # of the column creases for s = 1 (..., n)
    f: tuple[Array, Array]  # of F rows' creases for s = 1 (..., n+1)
    s: tuple[Array, Array]  # of S rows' creases for s = 1 (..., n+1)

    @classmethod
    def of(cls, mechanism: LongitudinalLinearRepeating, drive: Array) -> _HalfAngles:
        columns = mechanism.columns
        alpha, beta, gamma, delta = columns.sectors.T
        cosine = np.cos(drive / 2)[..., None]
        sine = columns.multipliers * np.sin(drive / 2)[..., None]

        half_sum, half_difference = (alpha + beta) / 2, (alpha - beta) / 2
        if columns.version == "cosine":
            f_sine, f_cosine = np.cos(half_difference) * sine, np.sin(half_sum) * cosine
        else:
            f_sine, f_cosine = -np.sin(half_difference) * sine, np.cos(half_sum) * cosine
        f_sign = np.where(f_cosine < 0, -1.0, 1.0)
        f = _unit(f_sign * f_sine, f_sign * f_cosine)
        f_left = f if columns.version == "cosine" else (-f[0], f[1])

        opening = -np.sin(gamma + delta) * cosine**2
        closing = np.sin(gamma - delta) * sine**2
        # The denominator is positive in the flat sheet, so that u is small there.
        s_sign = np.where(np.sin(gamma + delta) < 0, 1.0, -1.0)
        both = -2 * s_sign * sine * cosine
        s_right = _unit(both * np.cos(delta), s_sign * (opening + closing))
        s_left = _unit(both * np.cos(gamma), s_sign * (opening - closing))

        rows = mechanism.grid.rows - 2
        flat_foldable = flat_foldable_rows(rows, mechanism.first_row)
        turns = np.where(flat_foldable & (columns.version == "sine"), 1.0, -1.0)
        signs = mechanism.side * turns[0] * np.concatenate([[1.0], np.cumprod(turns)])
        return cls(
            flat_foldable=flat_foldable,
            signs=signs,
            columns=_unit(sine, cosine),
            f=_with_left(f_left, f),
            s=_with_left(s_left, s_right),
        )

    def row(self, rows: slice) -> tuple[Array, Array]:
        """Sine and cosine for the row creases (..., rows, n+1)."""
        signs = self.signs[1:][rows, None]
        kind = self.flat_foldable[rows, None]
        sine = signs * np.where(kind, self.f[0][..., None, :], self.s[0][..., None, :])
        return sine, np.where(kind, self.f[1][..., None, :], self.s[1][..., None, :])

    def column(self, rows: slice) -> tuple[Array, Array]:
        """Sine and cosine for the column creases (..., rows, n)."""
        signs = self.signs[rows, None]
        sine, cosine = self.columns
        return signs * sine[..., None, :], np.broadcast_to(
            cosine[..., None, :], (*cosine.shape[:-1], len(signs), cosine.shape[-1])
        )


def _unit(sine: Array, cosine: Array) -> tuple[Array, Array]:
    """Sine and cosine of half a fold angle, from its tangent's numerator and denominator."""
    size = np.hypot(sine, cosine)
    return sine / size, cosine / size


def _with_left(left: tuple[Array, Array], right: tuple[Array, Array]) -> tuple[Array, Array]:
    """Values (..., n+1) of a row's creases: left of column 1, then right of every column."""
    first, second = (
        np.concatenate([far[..., :1], near], axis=-1) for far, near in zip(left, right, strict=True)
    )
    return first, second
