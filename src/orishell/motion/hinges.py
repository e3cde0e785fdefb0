"""Hinges beside the creases of a sheet: whole boards fold as its panels do, and are shifted.

Panels fold as without a thickness, by the same angles, about hinges that stand at heights h over
the flat sheet, parallel to their creases. A point of a hinge is one of its crease and h n, as seen
from either panel beside it, n being the panel's unit normal. So a panel q beyond a hinge from a
panel p is shifted, from where its crease would have it, by

    s_q = s_p + h (n_p - n_q).

Around a vertex these steps sum up to nothing in all states if the heights fulfil two conditions
(:mod:`~orishell.solids.hinged.conditions`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Any, Protocol, runtime_checkable

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import CreaseValues, Grid, Positions
from orishell.motion.mechanism import Mechanism, panel_normals
from orishell.motion.quads import grid_corners
from orishell.numerics.arrays import Array


@runtime_checkable
class Straightened(Protocol):
    """A mechanism whose columns may be straight but for the digits of the curves it follows."""

    def straightened(self) -> Mechanism:
        """The same with columns that are straight to the last digit, where they nearly are."""


@runtime_checkable
class FreeLengths(Protocol):
    """A mechanism whose edges may have other lengths while all its angles stay, in all states.

    Those of a row and of a column are free, and the others follow. Vertices at the target are
    affine in them.
    """

    def free_lengths(self) -> Mapping[str, Array]:
        """The lengths that are free, by name."""

    def with_lengths(self, lengths: Mapping[str, Array]) -> Mechanism:
        """The same with other lengths of the same names."""

    def described_lengths(self) -> Mapping[str, Any]:
        """What the report of a design says of them, beside what does not change with them."""


@record
class Hinges:
    """Where the hinges of whole boards are, and where the boards lie in the flat sheet."""

    signs: CreaseValues  # of all creases: +1 valley, -1 mountain, 0 where one does not fold
    heights: CreaseValues  # of the hinges of all creases over the flat sheet (length)
    levels: Array  # heights (rows-1, columns-1) of the undersides of boards over it (length)
    thickness: float  # of the boards (length)
    # how far each hinge stands off the faces of the two boards that it joins (length): off the
    # board above and the one below (2, rows-2, columns-1), left and right (2, rows-1, columns-2)
    arms: tuple[Array, Array]
    # radius of knuckles, by which axes stand off what carries them: the boards' faces, or arms that
    # end there (length)
    knuckle: float = 0.0
    # by how much all boards are moved together (3,), so that they meet the target (length)
    place: Array = field(default_factory=lambda: np.zeros(3))

    @property
    def grid(self) -> Grid:
        """The grid of the sheet."""
        rows, columns = self.levels.shape
        return Grid(rows + 1, columns + 1)

    @property
    def longest_arm(self) -> float:
        """The farthest that a hinge stands off a board (length)."""
        return float(max(each.max(initial=0.0) for each in self.arms))

    def shifts(self, normals: Array) -> Array:
        """Shifts (..., F, 3) of all panels in states with these unit normals (..., F, 3).

        But for ``place`` they leave the panels' mean where it is.
        """
        n = normals.reshape(*normals.shape[:-2], *self.levels.shape, 3)
        down, across = self._steps(n)
        shifts = np.zeros_like(n)
        np.cumsum(down[..., 0, :], axis=-2, out=shifts[..., 1:, 0, :])
        shifts[..., 1:, :] = shifts[..., :1, :] + np.cumsum(across, axis=-2)
        shifts += self.place - shifts.mean(axis=(-3, -2), keepdims=True)
        return shifts.reshape(normals.shape)

    def middles(self, normals: Array) -> Array:
        """How far (..., rows-1, columns-1, 3) boards are, half way up, from their panels.

        In states with these unit normals (..., rows-1, columns-1, 3).
        """
        listed = normals.reshape(*normals.shape[:-3], -1, 3)
        over = (self.levels + 0.5 * self.thickness)[..., None] * normals
        return np.asarray(self.shifts(listed).reshape(normals.shape) + over)

    def boards(self, positions: Positions) -> Array:
        """Corners (..., rows-1, columns-1, 4, 3) of all boards, half way up, in states (...)."""
        middles = self.middles(panel_normals(positions))
        return np.asarray(grid_corners(positions) + middles[..., None, :])

    def _steps(self, n: Array) -> tuple[Array, Array]:
        """Steps of the shift from panels to those below and to their right, by normals."""
        down = self.heights.row[..., None] * (n[..., :-1, :, :] - n[..., 1:, :, :])
        across = self.heights.column[..., None] * (n[..., :-1, :] - n[..., 1:, :])
        return down, across

    def gap(self, positions: Positions) -> float:
        """How far the loop around any inner vertex is from closing in a state (length)."""
        down, across = self._steps(panel_normals(positions))
        around = across[:-1] + down[:, 1:] - down[:, :-1] - across[1:]
        return float(np.sqrt((around**2).sum(axis=-1)).max(initial=0.0))
