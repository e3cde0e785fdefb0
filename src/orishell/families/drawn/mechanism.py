"""A drawn sheet as a mechanism: closed form from its flat vertices and the signs of its creases.

Not in the paper: docs/theory/vertex.md.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.families.drawn.drive import Drive
from orishell.families.drawn.rates import fold_rates
from orishell.families.shared import folding
from orishell.families.shared.chains import Chains
from orishell.motion.flap_free import FlapFree
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.mechanism import mechanism_in_one_line
from orishell.numerics.arrays import Array

BLOCK = 2_000_000
"""Panels times ranges whose bounds are found at once."""


@record
class DrawnSheet(FlapFree):
    """A sheet with one degree of freedom and the state in which it is to be a shell.

    The drive is the fold angle of the crease that closes first; at pi the motion ends. The crease
    to the right of the middle vertex keeps its place but for the pose: the sheet turns as a whole
    at an even rate, from the flat sheet, which lies level, to the target.
    """

    flat: Array  # vertices (2, rows, columns, 1) about the middle one
    drive: Drive  # which crease drives it, and how all others follow
    fold: float  # fold angle of that crease at the target, in (0, pi] (radians)
    # how the shell is turned at the target from where its middle crease would be level and the
    # panels beside it equally steep: a rotation vector (3,) (radians)
    turn: Array
    place: Array  # of the middle vertex (3,)
    # how far its closed form goes: pi, where the crease that drives it is folded flat, or short of
    # it where another one would be folded beyond, or lose its digits (radians)
    end: float = np.pi

    __repr__ = mechanism_in_one_line

    @property
    def grid(self) -> Grid:
        """The grid of vertices."""
        return Grid(*self.flat.shape[1:3])

    @property
    def least_turning(self) -> DrawnSheet:
        """The sheet whose middle crease stays where it is."""
        return replace(self, turn=np.zeros(3))

    @property
    def target_drive(self) -> float:
        """The fold angle of the driving crease at the target."""
        return self.fold

    @property
    def end_drive(self) -> float:
        """180 degrees, where a crease is folded flat; or as far as its closed form goes."""
        return self.end

    @property
    def _middle(self) -> tuple[int, int]:
        """Row and column of the middle inner vertex."""
        return (self.grid.rows - 3) // 2, (self.grid.columns - 3) // 2

    def positions(self, drive: ArrayLike) -> Array:
        """Positions (..., rows, columns, 3) of all vertices at drive angles (...) (radians)."""
        drives = np.asarray(drive, dtype=np.float64)
        theta = drives.ravel()
        places = folding.fold(self.flat, self.drive.folds(theta), self._middle)
        if self.turn.any():
            places = folding.turned(places, self.turn[:, None] * (theta / self.target_drive))
        found = np.moveaxis(places, (0, 3), (3, 0)) + self.place
        return found.reshape(*drives.shape, *found.shape[1:])

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of all creases at drive angles (...), in closed form (radians)."""
        drives = np.asarray(drive, dtype=np.float64)
        folds = self.drive.folds(drives.ravel())
        row, column = (
            np.moveaxis(2 * np.arctan2(s, c), -1, 0).reshape(*drives.shape, *c.shape[:-1])
            for c, s in (folds.row, folds.column)
        )
        return CreaseValues(row=row, column=column)

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the accelerations of edges: see the modules ``rates`` and ``chains``."""
        block = max(1, BLOCK // self.grid.panel_count)
        found = [
            self._accelerations(start[k : k + block], stop[k : k + block])
            for k in range(0, len(start), block)
        ]
        along, down = (np.concatenate(each) for each in zip(*found, strict=True))
        return along, down

    def _accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        which = self._middle[1] + 1, slice(None)
        across = self.drive.across
        found = fold_rates(self.drive, start, stop, which[::-1] if across else which)
        rows, columns = found[::-1] if across else found
        spin = float(np.linalg.norm(self.turn)) / self.target_drive
        return self._chains.bounds(rows, columns, spin)

    @cached_property
    def _chains(self) -> Chains:
        angles = self.fold_angles(0.5 * self.target_drive)
        return Chains.of(self.flat[..., 0], angles.row, angles.column, self._middle)
