"""A line of straight bars in space, joined stiffly where they meet, that bears on its joints only.

A bar between two joints has E A/l along it, G J/l about it, and in either plane of bending the
matrix of a beam without shear (Euler and Bernoulli). Nothing turns the joints from outside, so
their turns t follow from their displacements u, and a stiffness of these is left:

    t = -K_tt^+ K_tu u,        K = K_uu - K_ut K_tt^+ K_tu.

What is left of K_tt without stiffness is a straight line that spins about itself.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Vertex
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.corotational import Change, Elastic, Moved
from orishell.structure.mesh.elements import Elements

FREE = 1e-9
"""Turns of less stiffness than this share of the largest are free."""
UPRIGHT = 1e-6
"""A bar is upright if less than this share of it is level: then it has no side that looks up."""


@record
class Bar:
    """The section of a bar: rectangular, hollow or not."""

    modulus: float  # Young's modulus (force per area)
    shear: float  # shear modulus (force per area)
    width: float  # across, level (length)
    height: float  # (length)
    wall: float  # thickness of its walls; half the smaller side if it is solid (length)

    @property
    def _inside(self) -> tuple[float, float]:
        return self.width - 2 * self.wall, self.height - 2 * self.wall

    @property
    def area(self) -> float:
        """Area of the section."""
        width, height = self._inside
        return self.width * self.height - width * height

    @property
    def inertia(self) -> tuple[float, float]:
        """Second moments of area, for bending up and down, and for bending sideways."""
        width, height = self._inside
        return (
            (self.width * self.height**3 - width * height**3) / 12,
            (self.height * self.width**3 - height * width**3) / 12,
        )

    @property
    def torsion(self) -> float:
        """Torsion constant: of thin walls Bredt's 4 A^2 s/u; solid Roark's, within 4 %."""
        short, long = sorted((self.width, self.height))
        if 2 * self.wall >= short:
            ratio = short / long
            return long * short**3 * (1 / 3 - 0.21 * ratio * (1 - ratio**4 / 12))
        sides = self.width - self.wall, self.height - self.wall
        return 4 * (sides[0] * sides[1]) ** 2 * self.wall / (2 * sum(sides))


@record
class Frame:
    """A line of bars."""

    nodes: Integers  # nodes (m,) of the mesh at its joints, from end to end
    points: Array  # where they are (m, 3)
    bar: Bar  # the section of all
    vertices: tuple[Vertex, ...] = ()  # the vertices of the folding sheet (m) at its joints

    @property
    def lengths(self) -> Array:
        """Lengths (m-1,) of its bars."""
        return np.asarray(np.linalg.norm(np.diff(self.points, axis=0), axis=1))

    def axes(self) -> Array:
        """Axes (m-1, 3, 3) of bars, as rows: along, to the side, and up."""
        along = np.diff(self.points, axis=0) / self.lengths[:, None]
        side = np.cross([0.0, 0.0, 1.0], along)
        side[np.linalg.norm(side, axis=1) < UPRIGHT] = [0.0, 1.0, 0.0]
        side /= np.linalg.norm(side, axis=1, keepdims=True)
        return np.stack([along, side, np.cross(along, side)], axis=1)

    @cached_property
    def bars(self) -> Array:
        """Stiffness (m-1, 12, 12) of bars in their axes: displacements and turns of both ends."""
        length, bar = self.lengths, self.bar
        found = np.zeros((len(length), 12, 12))
        straight = np.array([[1.0, -1.0], [-1.0, 1.0]])
        pull, twist = bar.modulus * bar.area / length, bar.shear * bar.torsion / length
        for stiffness, first in ((pull, 0), (twist, 3)):
            dofs = np.array([first, first + 6])
            found[:, dofs[:, None], dofs] = stiffness[:, None, None] * straight
        up, sideways = bar.inertia
        # Up, turns about the side are downwards; sideways, turns about what is up go with it.
        for inertia, shift, turn, sign in ((up, 2, 4, -1.0), (sideways, 1, 5, 1.0)):
            bent = np.array([shift, turn, shift + 6, turn + 6])
            lever = sign * length
            one = np.ones_like(length)
            beam = np.array(
                [
                    [12 * one, 6 * lever, -12 * one, 6 * lever],
                    [6 * lever, 4 * length**2, -6 * lever, 2 * length**2],
                    [-12 * one, -6 * lever, 12 * one, -6 * lever],
                    [6 * lever, 2 * length**2, -6 * lever, 4 * length**2],
                ]
            )
            scale = bar.modulus * inertia / length**3
            found[:, bent[:, None], bent] = np.moveaxis(scale * beam, -1, 0)
        return found

    @cached_property
    def _split(self) -> tuple[Array, Array, Array]:
        """K_uu, K_tu and the pseudo-inverse of K_tt of all joints, in the axes of the world."""
        count = len(self.nodes)
        whole, turn = np.zeros((6 * count, 6 * count)), _blocks(self.axes())
        in_world = turn.swapaxes(1, 2) @ self.bars @ turn
        for number, matrix in enumerate(in_world):
            own = slice(6 * number, 6 * number + 12)
            whole[own, own] += matrix
        kinds = np.arange(6 * count).reshape(count, 2, 3)
        shifts, turns = kinds[:, 0].ravel(), kinds[:, 1].ravel()
        inverse = np.linalg.pinv(whole[np.ix_(turns, turns)], rcond=FREE, hermitian=True)
        return whole[np.ix_(shifts, shifts)], whole[np.ix_(turns, shifts)], np.asarray(inverse)

    @cached_property
    def stiffness(self) -> Array:
        """The stiffness K (3m, 3m) of its joints' displacements."""
        direct, across, inverse = self._split
        return np.asarray(direct - across.T @ inverse @ across)

    def elements(self, count: int) -> Elements:
        """It as one element of a mesh with so many dofs."""
        dofs = (3 * self.nodes[:, None] + np.arange(3)).reshape(1, -1)
        return Elements(self.stiffness[None], dofs, None, count)

    def moving(self) -> SlightlyMoved:
        """It as a part of a shell that is moved far, while its joints move a little."""
        dofs = (3 * self.nodes[:, None] + np.arange(3)).reshape(1, -1)
        return SlightlyMoved(self.stiffness[None], dofs)

    def end_forces(self, moved: Array) -> Array:
        """Forces and moments (m-1, 12) on the ends of bars, in their axes, by joints moved (m, 3).

        Along, to the side, up, and about these.
        """
        _, across, inverse = self._split
        turned = -(inverse @ (across @ moved.ravel())).reshape(-1, 3)
        both = np.concatenate([moved, turned], axis=1)
        ends = np.concatenate([both[:-1], both[1:]], axis=1)
        own = np.einsum("tij,tj->ti", _blocks(self.axes()), ends)
        return np.asarray(np.einsum("tij,tj->ti", self.bars, own))

    def stresses(self, moved: Array) -> Array:
        """The largest stress (m-1,) along bars, abs(N)/A + abs(M_up)/W_up + abs(M_side)/W_side."""
        forces, bar = np.abs(self.end_forces(moved)).reshape(-1, 2, 6), self.bar
        up, sideways = bar.inertia
        moments = forces[..., 4] * bar.height / (2 * up) + forces[..., 5] * bar.width / (
            2 * sideways
        )
        return np.asarray((forces[..., 0] / bar.area + moments).max(axis=1))


@record
class SlightlyMoved(Elastic):
    """Elements whose forces are linear in displacements, while others are moved far."""

    matrices: Array  # stiffness (T, k, k)
    dofs: Integers  # dofs (T, k)

    @property
    def rounding(self) -> Array:
        """What forces (T, k) are uncertain by, where displacements are by a length."""
        return np.asarray(np.abs(self.matrices).sum(axis=2))

    def forces(self, moved: Moved) -> Array:
        """Forces (T, k) that move them."""
        return np.asarray(np.einsum("tij,tj->ti", self.matrices, moved.displacements[self.dofs]))

    def tangent(self, moved: Moved, expected: Array | None = None) -> Change:
        """Forces (T, k), and how they change."""
        return Change(self.forces(moved), self.matrices)


def _blocks(axes: Array) -> Array:
    """Axes (t, 3, 3) four times on the diagonal (t, 12, 12)."""
    found = np.zeros((len(axes), 12, 12))
    for first in range(0, 12, 3):
        found[:, first : first + 3, first : first + 3] = axes
    return found
