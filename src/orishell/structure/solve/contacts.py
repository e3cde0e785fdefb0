"""Ties, flaps and feet of a structure that may be moved far: forces in one direction only.

A condition has a gap g at the current places of its nodes, how far it would have to give, and the
force

    lambda = max(0, lambda_0 + k g).

A tie of finite stiffness has k of its own and no lambda_0. Where nothing gives, k is a penalty, and
lambda_0 is what was borne before: it is taken over step by step until gaps vanish, the augmented
Lagrangian method (M. R. Hestenes and M. J. D. Powell, 1969). A foot on rough ground sticks by a
spring to where it was after the last step, and slides where that would pull more than Coulomb's
mu lambda: the return mapping of plasticity (P. Wriggers, "Computational Contact Mechanics", 2006).
"""

from __future__ import annotations

from dataclasses import replace
from typing import Self

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.structure.mesh.corotational import Change, Moved


@record
class Links:
    """Ties, which only pull, and flaps, which only push, between two nodes each."""

    points: Array  # nodes (m, 2, 3) as designed
    dofs: Integers  # dofs (m, 6) of their displacements
    sign: Array  # 1 for ties and -1 for flaps (m,)
    stiffness: Array  # k (m,) (force per length)
    hard: Booleans  # which of them (m,) do not give
    borne: Array  # lambda_0 (m,)

    @property
    def rounding(self) -> Array:
        """What forces (m, 6) are uncertain by, where displacements are by a length."""
        return np.repeat(self.stiffness[:, None], 6, axis=1)

    def gaps(self, moved: Moved) -> Array:
        """How far they would have to give (m,)."""
        return self._seen(moved)[1]

    def bears(self, moved: Moved) -> Array:
        """Forces lambda (m,)."""
        return np.maximum(0.0, self.borne + self.stiffness * self.gaps(moved))

    def settled(self, moved: Moved) -> Self:
        """The same after a step that ends here."""
        return self.taken_over(moved)

    def taken_over(self, moved: Moved) -> Self:
        """The same with lambda_0 as borne now."""
        return replace(self, borne=np.where(self.hard, self.bears(moved), 0.0))

    def missing(self, moved: Moved) -> float:
        """Norm of the forces by which what should not give does."""
        return float(np.linalg.norm((self.bears(moved) - self.borne)[self.hard]))

    def forces(self, moved: Moved) -> Array:
        """Forces (m, 6) that move their nodes."""
        return self.tangent(moved).forces

    def tangent(self, moved: Moved, expected: Array | None = None) -> Change:
        """Forces (m, 6), and how they change."""
        along, gap, length = self._seen(moved)
        force = np.maximum(0.0, self.borne + self.stiffness * gap)
        pull = (self.sign * force)[:, None] * along
        outer = along[:, :, None] * along[:, None]
        stiff = np.where(force > 0, self.stiffness, 0.0)[:, None, None] * outer
        stiff += (self.sign * force / length)[:, None, None] * (np.eye(3) - outer)
        upper = np.concatenate([stiff, -stiff], axis=2)
        return Change(
            np.concatenate([-pull, pull], axis=1), np.concatenate([upper, -upper], axis=1)
        )

    def _seen(self, moved: Moved) -> tuple[Array, Array, Array]:
        """Directions (m, 3), gaps (m,) and lengths (m,)."""
        before = self.points[:, 1] - self.points[:, 0]
        ends = moved.displacements[self.dofs.reshape(-1, 2, 3)]
        shift = ends[:, 1] - ends[:, 0]
        apart = before + shift
        length, first = (np.linalg.norm(each, axis=1) for each in (apart, before))
        # |a|^2 - |b|^2 = s (a + b), which rounds less.
        longer = np.sum(shift * (apart + before), axis=1) / (length + first)
        return apart / length[:, None], self.sign * longer, length


@record
class Feet:
    """Feet on the ground, which pushes them up and rubs."""

    dofs: Integers  # dofs (m, 3) of their displacements
    stiffness: float  # k (force per length)
    friction: Array  # coefficients of friction mu (m,)
    borne: Array  # lambda_0 (m,)
    rubbed: Array  # friction (m, 2) after the last step
    stood: Array  # displacements (m, 2) after it

    @property
    def rounding(self) -> Array:
        """What forces (m, 3) are uncertain by, where displacements are by a length."""
        return np.full(self.dofs.shape, self.stiffness)

    def gaps(self, moved: Moved) -> Array:
        """How deep they are in the ground (m,)."""
        return np.asarray(-moved.displacements[self.dofs[:, 2]])

    def bears(self, moved: Moved) -> Array:
        """Forces lambda (m,) of the ground, upwards."""
        return np.maximum(0.0, self.borne + self.stiffness * self.gaps(moved))

    def pushes(self, moved: Moved) -> Array:
        """Forces (m, 3) of the ground on them."""
        return -self.forces(moved)

    def used(self, moved: Moved) -> float:
        """The largest share of its friction that one of them uses."""
        _, size, most = self._tried(moved)
        return float(np.max(np.minimum(size[most > 0] / most[most > 0], 1.0), initial=0.0))

    def settled(self, moved: Moved) -> Self:
        """The same after a step that ends here."""
        now, rubbed = moved.displacements[self.dofs[:, :2]], self.forces(moved)[:, :2]
        return replace(self, borne=self.bears(moved), rubbed=rubbed, stood=now)

    def taken_over(self, moved: Moved) -> Self:
        """The same with lambda_0 as borne now."""
        return replace(self, borne=self.bears(moved))

    def missing(self, moved: Moved) -> float:
        """Norm of the forces by which what should not give does."""
        return float(np.linalg.norm(self.bears(moved) - self.borne))

    def forces(self, moved: Moved) -> Array:
        """Forces (m, 3) that move them."""
        return self.tangent(moved).forces

    def tangent(self, moved: Moved, expected: Array | None = None) -> Change:
        """Forces (m, 3), and how they change."""
        tried, size, most = self._tried(moved)
        presses, sticks = self.bears(moved), (size <= most)[:, None]
        active = np.where(presses > 0, self.stiffness, 0.0)
        size = np.where(size > 0, size, 1.0)[:, None]
        way = tried / size
        rubs = np.where(sticks, tried, most[:, None] * way)
        across = (most[:, None] / size)[..., None] * (np.eye(2) - way[:, :, None] * way[:, None])
        change = np.zeros((len(self.dofs), 3, 3))
        change[:, :2, :2] = active[:, None, None] * np.where(sticks[..., None], np.eye(2), across)
        change[:, :2, 2] = np.where(sticks, 0.0, -(self.friction * active)[:, None] * way)
        change[:, 2, 2] = active
        return Change(np.concatenate([rubs, -presses[:, None]], axis=1), change)

    def _tried(self, moved: Moved) -> tuple[Array, Array, Array]:
        """Friction (m, 2) if none slid, its size (m,), and how much there is (m,)."""
        went = moved.displacements[self.dofs[:, :2]] - self.stood
        tried = self.rubbed + self.stiffness * went
        return tried, np.linalg.norm(tried, axis=1), self.friction * self.bears(moved)
