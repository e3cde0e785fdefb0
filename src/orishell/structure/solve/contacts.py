"""Ties, flaps and feet of a structure that may be moved far: forces in one direction only.

A condition has a gap g at the current places of its nodes, how far it would have to give, and the
force

    lambda = max(0, lambda_0 + k g).

A tie of finite stiffness has k of its own and no lambda_0. Where nothing gives, k is a penalty, and
lambda_0 is what was borne before: it is taken over step by step until gaps vanish, the augmented
Lagrangian method (M. R. Hestenes and M. J. D. Powell, 1969). A foot on rough ground sticks by a
spring to where it was after the last step, and slides where that would pull more than Coulomb's
mu lambda: the return mapping of plasticity (P. Wriggers, "Computational Contact Mechanics", 2006).
That spring is taken over, too. Tangents know how friction changes with lambda, and are not
symmetric.

Who bears is told by the lambda that a step led to expect, of either sign: gaps by themselves are
off by what turns make of them, and with a penalty that is a large force.
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
        """The ties and flaps after a step that ends here."""
        return self.taken_over(moved)

    def taken_over(self, moved: Moved) -> Self:
        """The ties and flaps with lambda_0 as borne now."""
        return replace(self, borne=np.where(self.hard, self.bears(moved), 0.0))

    def grown(self, ratio: float) -> Self:
        """The ties and flaps themselves: what they bear follows from where they are."""
        return self

    def missing(self, moved: Moved) -> float:
        """Norm of the forces by which what should not give does."""
        return float(np.linalg.norm((self.bears(moved) - self.borne)[self.hard]))

    def forces(self, moved: Moved) -> Array:
        """Forces (m, 6) that move their nodes."""
        return self.tangent(moved).forces

    def tangent(self, moved: Moved, expected: Array | None = None) -> Change:
        """Forces (m, 6), and how they change.

        expected: Forces lambda (m, 1), of either sign, with which they turn, and that say which of
        them bear; None for those that they have.
        """
        along, gap, length = self._seen(moved)
        force = self.borne + self.stiffness * gap
        turning = force if expected is None else expected[:, 0]
        bears = turning > 0
        pull = (self.sign * np.where(bears, force, 0.0))[:, None] * along
        outer = along[:, :, None] * along[:, None]
        stiff = np.where(bears, self.stiffness, 0.0)[:, None, None] * outer
        turns = self.sign * np.maximum(turning, 0.0) / length
        stiff += turns[:, None, None] * (np.eye(3) - outer)
        upper = np.concatenate([stiff, -stiff], axis=2)
        slope = (self.sign * self.stiffness)[:, None] * along
        other = np.where(bears, np.minimum(force, 0.0), np.maximum(force, 0.0))
        return Change(
            np.concatenate([-pull, pull], axis=1),
            np.concatenate([upper, -upper], axis=1),
            force[:, None],
            np.concatenate([-slope, slope], axis=1)[:, None],
            float(np.linalg.norm(other)),
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
    stood: Array  # displacements (m, 2) where they stick

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
        rubs = np.linalg.norm(self.forces(moved)[:, :2], axis=1)
        most = self.friction * self.bears(moved)
        return float(np.max(rubs[most > 0] / most[most > 0], initial=0.0))

    def settled(self, moved: Moved) -> Self:
        """The feet after a step that ends here: those that slid stand where they are."""
        now, slid = moved.displacements[self.dofs[:, :2]], ~self._seen(moved)[2]
        return replace(self.taken_over(moved), stood=np.where(slid[:, None], now, self.stood))

    def taken_over(self, moved: Moved) -> Self:
        """The feet with lambda_0 and friction by what is borne now."""
        return replace(self, borne=self.bears(moved), rubbed=self.forces(moved)[:, :2])

    def missing(self, moved: Moved) -> float:
        """Norm of the forces by which what should not give does."""
        presses, _, sticks = self._seen(moved)
        creeps = np.where(sticks[:, None], self.forces(moved)[:, :2] - self.rubbed, 0.0)
        parts = (np.maximum(presses, 0.0) - self.borne, creeps.ravel())
        return float(np.linalg.norm(np.concatenate(parts)))

    def grown(self, ratio: float) -> Self:
        """The feet under loads that have grown by a ratio: a guess of what they bear then."""
        return replace(self, borne=ratio * self.borne, rubbed=ratio * self.rubbed)

    def forces(self, moved: Moved) -> Array:
        """Forces (m, 3) that move them."""
        return self.tangent(moved).forces

    def tangent(self, moved: Moved, expected: Array | None = None) -> Change:
        """Forces (m, 3), and how they change."""
        presses, tried, sticks = self._seen(moved)
        bears = presses > 0
        active = np.where(bears, self.stiffness, 0.0)
        most = self.friction * np.maximum(presses, 0.0)
        size = np.linalg.norm(tried, axis=1)
        way = tried / np.where(size > 0, size, 1.0)[:, None]
        share = most / np.where(size > 0, size, 1.0)
        across = share[:, None, None] * (np.eye(2) - way[:, :, None] * way[:, None])
        change = np.zeros((len(self.dofs), 3, 3))
        stuck = sticks[:, None, None]
        change[:, :2, :2] = active[:, None, None] * np.where(stuck, np.eye(2), across)
        change[:, :2, 2] = np.where(sticks, 0.0, -self.friction * active)[:, None] * way
        change[:, 2, 2] = active
        rubs = np.where(sticks[:, None], tried, most[:, None] * way) * bears[:, None]
        return Change(np.concatenate([rubs, -np.maximum(presses, 0.0)[:, None]], axis=1), change)

    def _seen(self, moved: Moved) -> tuple[Array, Array, Booleans]:
        """Forces lambda_0 + k g (m,), friction (m, 2) if none slid, and which of them stick."""
        presses = self.borne + self.stiffness * self.gaps(moved)
        went = moved.displacements[self.dofs[:, :2]] - self.stood
        tried = self.rubbed + self.stiffness * went
        most = self.friction * np.maximum(presses, 0.0)
        return presses, tried, np.linalg.norm(tried, axis=1) <= most
