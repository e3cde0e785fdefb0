"""A flat-foldable sheet as a mechanism: closed form from the flat sheet to the flat stack.

Not in the paper: docs/theory/flat-foldable.md.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.families.flat_foldable.lists import describe
from orishell.families.flat_foldable.net import Sheet
from orishell.families.shared.chains import Chains, Rates
from orishell.families.shared.folding import HalfFolds, fold, turned
from orishell.motion.flap_free import FlapFree
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.mechanism import mechanism_in_one_line
from orishell.numerics.arrays import Array


def tangent_rates(m: Array, start: Array, stop: Array) -> Rates:
    """Rates of creases with shares m (K,) in (0, 1], between drives (S,).

    With m the tangent of half the fold angle by the largest, c and s of half the drive:
    rho' = m/(c^2 + m^2 s^2), which grows with the drive, and rho'' = m (1 - m^2) s c/(...)^2.
    """
    m = m[:, None]
    # rho'' is largest where m^2 u^4 - 3 (1 - m^2) u^2 - 1 = 0, u the tangent of half the drive.
    k = 3 * (1 - m * m)
    top = 2 * np.arctan(np.sqrt((k + np.sqrt(k * k + 4 * m * m)) / (2 * m * m)))
    at = np.clip(top, start, stop)

    def size(drive: Array) -> tuple[Array, Array]:
        c, s = np.cos(0.5 * drive), np.sin(0.5 * drive)
        base = c * c + (m * s) ** 2
        return m / base, m * (1 - m * m) * s * c / base**2

    # It has one maximum, so that it is largest there, or at the end that is nearest to it.
    return Rates(size(start)[0], size(stop)[0], size(at)[1])


LENGTHS = "row_lengths", "column_lengths", "top", "bottom", "left", "right"
"""Lengths of a net that are free."""


@record
class FlatFoldable(FlapFree):
    """A flat-foldable sheet and the state in which it is to be a shell.

    The drive theta is the largest fold angle: t = tan(theta/2)/mu, with mu the largest tangent of
    half a fold angle at the target, t = 1. At pi all creases are folded flat together. The crease
    to the right of the middle vertex keeps its place but for the pose: the sheet turns as a whole
    at an even rate, from the flat sheet, which lies level, to the target.
    """

    sheet: Sheet  # one sheet
    heading: float = 0.0  # of the middle crease in the flat sheet, from x (radians)
    # how the shell is turned at the target from where its middle crease would be level and the
    # panels beside it equally steep: a rotation vector (3,) (radians)
    turn: Array = field(default_factory=lambda: np.zeros(3))
    place: Array = field(default_factory=lambda: np.zeros(3))  # of the middle vertex (3,)

    __repr__ = mechanism_in_one_line

    @property
    def grid(self) -> Grid:
        """The grid of vertices."""
        rows, columns = self.sheet.a.shape[:2]
        return Grid(rows + 2, columns + 2)

    def free_lengths(self) -> Mapping[str, Array]:
        """Lengths (K,) of the middle row and column and of what ends at the border, by name."""
        return {name: getattr(self.sheet.net, name)[:, 0] for name in LENGTHS}

    def with_lengths(self, lengths: Mapping[str, Array]) -> FlatFoldable:
        """The sheet with other lengths (K,) by name, and all angles as they are."""
        columns = {name: each[:, None] for name, each in lengths.items()}
        return replace(self, sheet=replace(self.sheet.net, **columns).march())

    def described_lengths(self) -> Mapping[str, Any]:
        """The lists of the sheet."""
        return describe(self.sheet)

    @property
    def least_turning(self) -> FlatFoldable:
        """The sheet whose middle crease stays where it is."""
        return FlatFoldable(self.sheet, self.heading, place=self.place)

    @cached_property
    def largest_tangent(self) -> float:
        """Tangent of half the largest fold angle at the target."""
        net = self.sheet.net
        return float(max(np.abs(net.x).max(), np.abs(net.y).max()))

    @property
    def target_drive(self) -> float:
        """The largest fold angle at the target."""
        return float(2 * np.arctan(self.largest_tangent))

    @property
    def end_drive(self) -> float:
        """180 degrees: the flat stack."""
        return float(np.pi)

    @cached_property
    def _shares(self) -> tuple[Array, Array]:
        """Tangents of half the fold angles by the largest, (R, C+1, 1) and (R+1, C, 1)."""
        row, column = self.sheet.tangents()
        return row / self.largest_tangent, column / self.largest_tangent

    @cached_property
    def flat(self) -> Array:
        """Vertices (2, rows, columns, 1) of the flat sheet, about the middle vertex."""
        x, y = self.sheet.flat()
        c, s = np.cos(self.heading), np.sin(self.heading)
        return np.stack([c * x - s * y, s * x + c * y])

    def positions(self, drive: ArrayLike) -> Array:
        """Positions (..., rows, columns, 3) of all vertices at drive angles (...) (radians)."""
        drives = np.asarray(drive, dtype=np.float64)
        theta = drives.ravel()
        folds = HalfFolds.of(self._shares, _cosine(theta), np.sin(0.5 * theta))
        places = fold(self.flat, folds, self.sheet.net.middle)
        return self.placed(places, theta / self.target_drive, drives.shape)

    def placed(self, places: Array, shares: Array, states: tuple[int, ...]) -> Array:
        """Vertices (..., rows, columns, 3) where they stand.

        Parameters
        ----------
        places
            Vertices about the middle crease (3, rows, columns, B).
        shares
            Of the turn as a whole (B,).
        states
            Shape (...) of the B states.
        """
        if self.turn.any():
            places = turned(places, self.turn[:, None] * shares)
        found = np.moveaxis(places, (0, 3), (3, 0)) + self.place
        return found.reshape(*states, *found.shape[1:])

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of all creases at drive angles (...), in closed form (radians)."""
        theta = np.asarray(drive, dtype=np.float64)[..., None, None]
        c, s = _cosine(theta), np.sin(0.5 * theta)
        row, column = (2 * np.arctan2(each[..., 0] * s, c) for each in self._shares)
        return CreaseValues(row=row, column=column)

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the accelerations of edges: see the module ``chains``."""
        spin = float(np.linalg.norm(self.turn)) / self.target_drive
        rows, columns = (np.abs(each) for each in (self._shares[0][:, 0], self._shares[1][0]))
        of_rows, of_columns = (tangent_rates(each[:, 0], start, stop) for each in (rows, columns))
        return self._chains.bounds(of_rows, of_columns, spin)

    @cached_property
    def _chains(self) -> Chains:
        row, column = (each[..., 0] for each in self._shares)
        return Chains.of(self.flat[..., 0], row, column, self.sheet.net.middle)


def _cosine(theta: Array) -> Array:
    """Cosine of theta/2, exactly 0 at pi."""
    return np.where(theta == np.pi, 0.0, np.cos(0.5 * theta))
