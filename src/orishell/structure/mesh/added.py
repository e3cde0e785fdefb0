"""Dofs of what is joined to a meshed sheet and has nodes of its own."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array


@record
class Added:
    """Nodes of their own, and rotations there and at nodes of the sheet."""

    places: Array  # its nodes (K, 3)
    rotations: int  # number of its rotations, three dofs each

    @property
    def count(self) -> int:
        """Number of its dofs: translations, then rotations."""
        return 3 * (len(self.places) + self.rotations)

    def rigid(self, axis: int, middle: Array, size: float) -> Array:
        """What its dofs (A, 6) do where all is moved along an axis, and turned about it.

        middle: Where the axis is that is turned about (3,).
        size: By how much more that is turned which is moved by it (length).
        """
        found, moved = np.zeros((self.count, 6)), 3 * len(self.places)
        found[axis:moved:3, axis] = 1.0
        found[:moved, 3 + axis] = np.cross(np.eye(3)[axis], self.places - middle).ravel() / size
        found[moved + axis :: 3, 3 + axis] = 1 / size
        return found
