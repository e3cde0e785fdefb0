"""Hinges that are turned far: moments and tangent stiffness.

A hinge turns by the part along the crease of log(R_1^T R_2), R_1 and R_2 being the rotations on its
sides; from both sides that is the same.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.corotational import Change, Elastic, Moved
from orishell.structure.mesh.rotations import (
    change_derivatives,
    change_matrices,
    cross_matrices,
    logarithms,
)


@record
class Folds(Elastic):
    """Springs about creases that may be turned far."""

    stiffness: Array  # moment by angle (m,)
    along: Array  # direction e (m, 3) of the crease as designed
    dofs: Integers  # dofs (m, 6) of the rotations on both sides
    turns: Integers  # which of all rotations they are (m, 2)

    @property
    def rounding(self) -> Array:
        """What moments (m, 6) are uncertain by, where displacements are by a length: not at all."""
        return np.zeros(self.dofs.shape)

    def angles(self, moved: Moved) -> Array:
        """By how much they are turned (m,) (radians)."""
        return np.asarray(np.sum(self.along * self._relative(moved)[1], axis=1))

    def forces(self, moved: Moved) -> Array:
        """Moments (m, 6) on both sides."""
        first, vectors = self._relative(moved)
        lever = np.einsum("tji,tj->ti", change_matrices(vectors), self.along)
        moment = self.stiffness * np.sum(self.along * vectors, axis=1)
        pull = moment[:, None] * np.einsum("tij,tj->ti", first, lever)
        return np.concatenate([-pull, pull], axis=1)

    def tangent(self, moved: Moved, expected: Array | None = None) -> Change:
        """Moments (m, 6), and how they change.

        expected: Moments (m, 1) with which creases turn; None for those that they have.
        """
        first, vectors = self._relative(moved)
        change = change_matrices(vectors)
        moment = self.stiffness * np.sum(self.along * vectors, axis=1)
        lever = np.einsum("tij,tj->ti", first, np.einsum("tji,tj->ti", change, self.along))
        both = np.concatenate([-lever, lever], axis=1)
        tangent = self.stiffness[:, None, None] * both[:, :, None] * both[:, None]
        turned = first @ change_derivatives(vectors, self.along) @ change @ first.swapaxes(1, 2)
        turning = (moment if expected is None else expected[:, 0])[:, None, None]
        turned *= turning
        spun = turning * cross_matrices(lever)
        # The lever changes by -[lever] psi_1 + turned (psi_2 - psi_1).
        tangent[:, 3:, :3] += -spun - turned
        tangent[:, 3:, 3:] += turned
        tangent[:, :3, :3] += spun + turned
        tangent[:, :3, 3:] += -turned
        slope = self.stiffness[:, None] * both
        return Change(moment[:, None] * both, tangent, moment[:, None], slope[:, None])

    def _relative(self, moved: Moved) -> tuple[Array, Array]:
        """The rotations R_1 (m, 3, 3), and the vectors (m, 3) of R_1^T R_2."""
        first, second = np.moveaxis(moved.rotations[self.turns], 1, 0)
        return first, logarithms(first.swapaxes(1, 2) @ second)
