"""The lines about which boards turn: the creases of the sheet themselves, or lines beside them.

Whoever moves, measures or draws boards asks these questions of either kind. Here they are answered
for hinges in the creases: what is on a panel stays where its panel has it. Lines beside the creases
(:mod:`orishell.motion.hinges`) shift it.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from orishell.motion.grid import Positions
from orishell.numerics.arrays import Array


class HingeLines:
    """Hinges in the creases."""

    __slots__ = ()

    @property
    def beside(self) -> bool:
        """Whether they lie beside the creases, so that boards are shifted from their panels."""
        return False

    @property
    def joint_rows(self) -> tuple[int, ...]:
        """Numbers of the row creases along which pieces are joined at the target."""
        return ()

    def pieces_of(self, rows: int) -> list[slice]:
        """Rows of panels of every piece of a sheet with so many."""
        cuts = [0, *(row + 1 for row in self.joint_rows), rows]
        return [slice(*each) for each in pairwise(cuts)]

    @property
    def longest_arm(self) -> float:
        """The farthest that a hinge stands off a board (length)."""
        return 0.0

    @property
    def cut_back(self) -> Array | float:
        """How far boards stand back from the sides of their panels at joints (F, 4) (length)."""
        return 0.0

    def shifts(self, normals: Array) -> Array:
        """Shifts (..., F, 3) of all panels in states with these unit normals (..., F, 3)."""
        return np.zeros_like(normals)

    def drawn(self, corners: Array, normals: Array) -> Array:
        """The shifts (F, 3) with which a state is drawn, of corners (F, 4, 3) and normals."""
        del corners
        return np.zeros_like(normals)

    def accelerations(self, normals: Array, swings: Array) -> Array | float:
        """Bounds (S,) of what shifts add to vectors from the feet to what is on panels.

        In ranges with bounds (S, F) of accelerations of their normals, and of the swing (S,) of
        what is on them.
        """
        del normals, swings
        return 0.0

    def vertices(self, positions: Positions) -> Array:
        """Where boards or panels meet at the vertices (..., rows, columns, 3) of states."""
        return positions

    def lowest(self, positions: Positions) -> Array:
        """Heights (rows, columns) of what is lowest at the vertices of a state."""
        return positions[..., 2]


IN_CREASES = HingeLines()
