"""Hinges: springs about creases.

A rigid crease is a spring much stiffer than a cell beside it. It joins rotations about the crease
only: those across it follow from the displacements that both panels have in common, and sharing
them as well would couple the bending of one panel to the plane of the other, which coarse cells
answer far too stiffly.

Where it is turned far, a hinge turns by the part along the crease of log(R_1^T R_2), R_1 and R_2
being the rotations on its sides; from both sides that is the same.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.corotational import Change, Elastic, Moved
from orishell.structure.mesh.elements import Elements
from orishell.structure.mesh.rotations import (
    change_derivatives,
    change_matrices,
    cross_matrices,
    logarithms,
)
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import SheetMesh, crease_places

RIGID = 1e3
"""Stiffness of a rigid crease by that of a cell in bending."""


def rigid_stiffness(mesh: SheetMesh, section: Section) -> float:
    """Moment per length and angle of creases that are rigid (force per radian)."""
    corners = mesh.facets.points[mesh.facets.triangles]
    shortest = np.linalg.norm(np.roll(corners, 1, axis=1) - corners, axis=-1).min()
    return float(RIGID * np.max(section.bending) / shortest)


def hinge_elements(mesh: SheetMesh, grid: Grid, stiffness: Array | float) -> Elements:
    """Springs about all creases.

    grid: The grid of the sheet.
    stiffness: Moment per length of crease and per angle, of every edge (E,) or of all; border edges
    have no spring (force per radian).
    """
    springs, along, dofs, _ = crease_springs(mesh, grid, stiffness)
    turn = np.concatenate([along, -along], axis=1)
    elements = springs[:, None, None] * (turn[:, :, None] * turn[:, None])
    return Elements(elements, dofs, None, mesh.count)


def crease_springs(
    mesh: SheetMesh, grid: Grid, stiffness: Array | float
) -> tuple[Array, Array, Integers, Integers]:
    """Springs (m,) at nodes along creases, directions (m, 3), dofs (m, 6) and places (m, 2) there.

    stiffness: As of :func:`hinge_elements`.
    """
    edge, *beside, nodes = beside_creases(mesh, grid)
    points = mesh.facets.points[nodes]  # (C, cells+1, 3)
    if mesh.offsets is None:
        step = np.linalg.norm(np.diff(points, axis=1), axis=-1)
        share = 0.5 * (np.pad(step, ((0, 0), (1, 0))) + np.pad(step, ((0, 0), (0, 1))))
    else:
        share = np.where(mesh.offsets.on_fins[:, None], 0.0, mesh.offsets.lengths)
    along = points[:, -1] - points[:, 0]
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    k = np.broadcast_to(np.asarray(stiffness, np.float64), len(grid.edges_vertices()))[edge]
    places = np.stack(beside, axis=-1).reshape(-1, 2)
    dofs = mesh.rotations().reshape(-1, 3)[places].reshape(-1, 6)
    return (k[:, None] * share).ravel(), np.repeat(along, nodes.shape[1], axis=0), dofs, places


def beside_creases(mesh: SheetMesh, grid: Grid) -> tuple[Integers, Integers, Integers, Integers]:
    """Edges (C,) that are creases, places (C, cells+1) beside them on both sides, and nodes there.

    Nodes are those of the first side. Places are those of
    :class:`~orishell.structure.mesh.sheet.SheetMesh`.
    """
    edge, first, second = crease_places(grid, mesh.nodes.shape[1] - 1)
    return edge, first, second, mesh.nodes.ravel()[first]


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
