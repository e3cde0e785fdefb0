"""Triangles that are moved far and strained little: forces and tangent stiffness.

Every triangle is seen from a frame E that goes with it, and what it does there is linear, whatever
triangle it is: the element-independent corotational formulation. C. C. Rankin and F. A. Brogan, "An
element independent corotational procedure for the treatment of large rotations", Journal of
Pressure Vessel Technology 108 (1986); C. A. Felippa and B. Haugen, "A unified formulation of
small-strain corotational finite elements", Computer Methods in Applied Mechanics and Engineering
194 (2005), whose names are used here. With corners x_a about their middle and rotations R_a, and
X_a, E_0 of the triangle as designed,

    d_a = E x_a - X_a,    t_a = log(E R_a E_0^T),    f = K (d, t),    p = E^T P^T H^T f.

H takes turns to changes of rotation vectors (``mesh/rotations``), and P = 1 - S G takes off what
the frame goes along with: its turn G by displacements, and what that turn moves, S. The frame has
the plane of the three corners and the turn in it that fits all of them best, so that no corner is
preferred. The tangent is complete: also what G changes is in it.
"""

from __future__ import annotations

from typing import Self

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.rotations import (
    change_derivatives,
    change_matrices,
    cross_matrices,
    logarithms,
)
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.triangle import Facets

AT_ONCE = 512
"""Triangles whose tangents are made together: more take memory, and are not faster."""


@record
class Moved:
    """Where nodes are."""

    displacements: Array  # of all dofs (D,): those of translations count (length)
    rotations: Array  # of every corner that turns (n, 3, 3)


@record
class Change:
    """Forces of elements, and how they change with displacements and turns."""

    forces: Array  # forces (T, k)
    matrices: Array  # their change (T, k, k)
    borne: Array | None = None  # forces f (T, m) in the elements' own frames
    slope: Array | None = None  # by how much these change (T, m, k)
    # by what forces are others than those where displacements are (norm of forces)
    other: float = 0.0

    def expected(self, step: Array) -> Array | None:
        """Forces f (T, m) that are expected after a step (T, k)."""
        if self.borne is None or self.slope is None:
            return None
        return np.asarray(self.borne + np.einsum("tij,tj->ti", self.slope, step))


class Elastic:
    """What keeps no memory of the way."""

    __slots__ = ()

    def settled(self, moved: Moved) -> Self:
        """The elements themselves, after a step that ends here."""
        return self

    def taken_over(self, moved: Moved) -> Self:
        """The elements themselves: none of them gives though it should not."""
        return self

    def grown(self, ratio: float) -> Self:
        """The elements themselves, under loads that have grown by a ratio."""
        return self

    def missing(self, moved: Moved) -> float:
        """Norm of the forces by which what should not give does: none."""
        return 0.0


@record
class Corotational(Elastic):
    """Triangles that may be moved far."""

    corners: Array  # corners (T, 3, 3) as designed
    axes: Array  # their axes E_0 (T, 3, 3) then, as rows
    flat: Array  # corners X (T, 3, 3) in these axes about their middle; no third coordinate
    stiffness: Array  # K (T, 18, 18) in these axes
    dofs: Integers  # dofs (T, 18): displacements, then rotations, of each corner
    turns: Integers  # which of all rotations each corner (T, 3) has

    @classmethod
    def of(cls, facets: Facets, section: Section, dofs: Integers, turns: Integers) -> Corotational:
        """Triangles with a section.

        dofs: Dofs (T, 18): displacements, then rotations, of each corner.
        turns: Which of all rotations each corner (T, 3) has.
        """
        axes, corners = facets.axes(), facets.points[facets.triangles]
        flat = np.einsum("tij,tkj->tki", axes, corners - corners.mean(axis=1, keepdims=True))
        flat[..., 2] = 0.0
        turned = _blocks(axes)
        local = turned @ facets.element_stiffness(section) @ turned.swapaxes(1, 2)
        return cls(corners, axes, flat, local, dofs, turns)

    def seen(self, moved: Moved) -> tuple[Array, Array, Array]:
        """Frames E (T, 3, 3), corners (T, 3, 3) in them, and what is strained, (d, t) (T, 18)."""
        places = moved.displacements[self.dofs.reshape(-1, 3, 6)[..., :3]]
        shifted = (
            places - places[:, :1]
        )  # displacements first: those of a whole panel are taken off
        away = self.corners - self.corners[:, :1] + shifted
        away -= away.mean(axis=1, keepdims=True)
        x = away[:, 1] - away[:, 0]
        z = np.cross(x, away[:, 2] - away[:, 0])
        x, z = (each / np.linalg.norm(each, axis=1, keepdims=True) for each in (x, z))
        y = np.cross(z, x)
        across, along = (np.einsum("tkj,tj->tk", away, each) for each in (y, x))
        first, second = self.flat[..., 0], self.flat[..., 1]
        sine = np.sum(first * across - second * along, axis=1)
        cosine = np.sum(first * along + second * across, axis=1)
        size = np.hypot(sine, cosine)
        c, s = (each[:, None] for each in (cosine / size, sine / size))
        frame = np.stack([c * x + s * y, c * y - s * x, z], axis=1)
        corners = np.einsum("tij,tkj->tki", frame, away)
        corners[..., 2] = 0.0
        relative = frame[:, None] @ moved.rotations[self.turns] @ self.axes[:, None].swapaxes(2, 3)
        strained = np.concatenate([corners - self.flat, logarithms(relative)], axis=-1)
        return frame, corners, strained.reshape(-1, 18)

    @property
    def rounding(self) -> Array:
        """What forces (T, 18) are uncertain by, where displacements are by a length."""
        straight = self.stiffness.reshape(-1, 18, 3, 6)[..., :3]
        return np.asarray(np.sqrt(np.sum(straight**2, axis=(2, 3))))

    def forces(self, moved: Moved) -> Array:
        """Forces p (T, 18)."""
        frame, corners, strained = self.seen(moved)
        _, borne, turning = self._borne(corners, strained)
        return _turned(frame, borne - np.einsum("tki,tk->ti", self._frame_turns(corners), turning))

    def tangent(self, moved: Moved, expected: Array | None = None) -> Change:
        """Forces p (T, 18), and how they change.

        expected: Forces f (T, 18) with which triangles turn; None for those that they have.
        """
        count = len(self.dofs)
        forces, borne = np.empty((2, count, 18))
        matrices, slope = np.empty((2, count, 18, 18))
        for first in range(0, count, AT_ONCE):
            some = slice(first, first + AT_ONCE)
            found = self.chosen(some)._tangent(moved, None if expected is None else expected[some])
            forces[some], borne[some] = found[0], found[2]
            matrices[some], slope[some] = found[1], found[3]
        return Change(forces, matrices, borne, slope)

    def chosen(self, some: slice) -> Corotational:
        """Some of them."""
        return Corotational(
            self.corners[some],
            self.axes[some],
            self.flat[some],
            self.stiffness[some],
            self.dofs[some],
            self.turns[some],
        )

    def _tangent(self, moved: Moved, expected: Array | None) -> tuple[Array, Array, Array, Array]:
        """Forces p (T, 18), their change, forces f (T, 18) and their change."""
        frame, corners, strained = self.seen(moved)
        change, borne, turning = self._borne(corners, strained)
        turns = self._frame_turns(corners)  # G (T, 3, 18)
        local = borne - np.einsum("tki,tk->ti", turns, turning)
        moves = np.zeros((len(corners), 3, 6, 3))  # S
        moves[:, :, :3] = -cross_matrices(corners)
        moves[:, :, 3:] = np.eye(3)
        project = np.eye(18) - moves.reshape(-1, 18, 3) @ turns  # P
        by_corner = project.reshape(-1, 3, 6, 18)
        strains = project.copy()  # H P
        strains.reshape(-1, 3, 6, 18)[:, :, 3:] = change @ by_corner[:, :, 3:]
        slope = self.stiffness @ strains
        forces = np.einsum("tij,tj->ti", self.stiffness, strained)
        tangent = strains.swapaxes(1, 2) @ slope
        tangent += self._turning(
            corners, strained, project, forces if expected is None else expected
        )
        whole = _blocks(frame)
        return (
            _turned(frame, local), whole.swapaxes(1, 2) @ tangent @ whole, forces, slope @ whole,
        )  # fmt: skip

    def _turning(self, corners: Array, strained: Array, project: Array, forces: Array) -> Array:
        """The part of the tangent (T, 18, 18) that forces f (T, 18) have by turning."""
        vectors = strained.reshape(-1, 3, 6)[..., 3:]
        turns, by_corner = self._frame_turns(corners), project.reshape(-1, 3, 6, 18)
        change, borne, turning = self._borne(corners, strained, forces)
        local = borne - np.einsum("tki,tk->ti", turns, turning)
        own = forces.reshape(-1, 3, 6)
        inner = np.zeros_like(by_corner)
        inner[:, :, 3:] = change_derivatives(vectors, own[..., 3:]) @ change @ by_corner[:, :, 3:]
        pushes = cross_matrices(own[..., :3])
        weighed = np.zeros((len(corners), 3, 3, 6))
        weighed[..., :3] = pushes.swapaxes(1, 2)
        tangent = project.swapaxes(1, 2) @ inner.reshape(-1, 18, 18)
        tangent += turns.swapaxes(1, 2) @ (weighed.reshape(-1, 3, 18) @ project)
        tangent -= cross_matrices(local.reshape(-1, 6, 3)).reshape(-1, 18, 3) @ turns
        return np.asarray(tangent - self._frame_changes(corners, turning) @ project)

    def _borne(
        self, corners: Array, strained: Array, forces: Array | None = None
    ) -> tuple[Array, Array, Array]:
        """H (T, 3, 3, 3), H^T f (T, 18), and its moment (T, 3) about the middle."""
        change = change_matrices(strained.reshape(-1, 3, 6)[..., 3:])
        if forces is None:
            forces = np.einsum("tij,tj->ti", self.stiffness, strained)
        forces = forces.reshape(-1, 3, 6)
        moments = np.einsum("tkji,tkj->tki", change, forces[..., 3:])
        turning = (np.cross(corners, forces[..., :3]) + moments).sum(axis=1)
        return change, np.concatenate([forces[..., :3], moments], -1).reshape(-1, 18), turning

    def _frame_turns(self, corners: Array) -> Array:
        """G (T, 3, 18): turns of the frame, in itself, by displacements there."""
        by_x, by_y = _slopes(corners)
        turns = np.zeros((len(corners), 3, 3, 6))
        turns[:, 0, :, 2], turns[:, 1, :, 2] = by_y, -by_x
        span = np.sum(self.flat * corners, axis=(1, 2))[:, None]
        turns[:, 2, :, 0], turns[:, 2, :, 1] = -self.flat[..., 1] / span, self.flat[..., 0] / span
        return turns.reshape(-1, 3, 18)

    def _frame_changes(self, corners: Array, turning: Array) -> Array:
        """How G^T M changes (T, 18, 18) with corners in the frame, for fixed moments M (T, 3)."""
        by_x, by_y = _slopes(corners)
        slopes = np.stack([by_x, by_y], axis=-1)  # (T, 3, 2)
        first, second, third = (each[:, None, None] for each in turning.T)
        change = np.zeros((len(corners), 3, 6, 3, 6))
        # A slope N_a,i changes by -N_a,j N_b,i du_bj.
        about_x = -slopes[:, :, None] * by_y[:, None, :, None]  # (T, a, b, j)
        about_y = slopes[:, :, None] * by_x[:, None, :, None]
        change[:, :, 2, :, :2] = first[..., None] * about_x + second[..., None] * about_y
        span = np.sum(self.flat * corners, axis=(1, 2))[:, None, None]
        across = np.stack([-self.flat[..., 1], self.flat[..., 0]], axis=-1)
        less = -(third / span**2)[..., None, None] * (
            across[:, :, :, None, None] * self.flat[:, None, None, :, :2]
        )
        change[:, :, :2, :, :2] = less
        return change.reshape(-1, 18, 18)


def _slopes(corners: Array) -> tuple[Array, Array]:
    """Slopes (T, 3) along x and y of what is 1 at a corner and 0 at the others."""
    ahead, behind = np.roll(corners, -1, axis=1), np.roll(corners, 1, axis=1)
    side = ahead - behind
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    twice = (first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])[:, None]
    return side[..., 1] / twice, -side[..., 0] / twice


def _blocks(axes: Array) -> Array:
    """Matrices (T, 18, 18) that take six vectors into axes (T, 3, 3)."""
    turned = np.zeros((len(axes), 18, 18))
    for k in range(6):
        turned[:, 3 * k : 3 * k + 3, 3 * k : 3 * k + 3] = axes
    return turned


def _turned(frame: Array, local: Array) -> Array:
    """Vectors (T, 18) in frames, in the world's axes."""
    return np.asarray(np.einsum("tji,tkj->tki", frame, local.reshape(-1, 6, 3)).reshape(-1, 18))
