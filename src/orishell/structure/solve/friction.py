"""Coulomb's law of rough ground, with ties and flaps that hold one way, as one equation.

With S^1/2 = W, gaps h = W g and forces l = W^-1 lambda by springs alike, A = W C W and H = 1 - A,

    H h + A l = W g_f,        h = h' + e l,

where e l is what a row gives, and h' what it parts or slips. With l^ = (mu l_n, l_t) forces are in
the cone abs(l^_t) <= l^_n, which is its own dual. Coulomb's law is complementary in it once a foot
is said to part by mu times its slip more than it does (De Saxce and Feng 1998): v is in the cone
and l^ v = 0 for

    v_t = -h'_t,        mu v_n = mu abs(h'_t) - h'_n.

All of that holds for one number by row, y = r l^ - v with any r > 0: with the projection P onto the
cone,

    r l^ = P(y),        v = P(y) - y,        h'_n = mu (theta abs(v_t) - v_n),

where theta = 1. A tie, a flap or smooth ground has P(y) = max(y, 0). So cone and complementarity
hold exactly whatever y is, and what is left is equilibrium, F(y) = H h + A l - W g_f = 0. F is what
forces miss of balance, by springs. P of a smoother cone, y_+ rounded off to
(y + (y^2 + 4 s^2)^1/2)/2 of both of its spectral values (Fukushima, Luo and Tseng 2002), has a
derivative everywhere.

With theta = 0 feet part as they slip. That is a convex problem, of the forces of least energy.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.structure.solve.factorised import GIVE, Factorised

SOFT = 1e-11
"""H is at least so stiff: so motions that nothing resists, and loads do not drive, have an end."""


@record
class Point:
    """What holds at y; derivatives of F are found where they are asked for."""

    contact: Contact
    missing: Array  # F (M,)
    dilates: Array  # the derivative of h by theta (M,)
    forces: Array  # l (M,)
    by_force: Array  # the derivative of l (M, M)
    parted: Array  # h (M,)
    by_parted: Array  # the derivative of h (M, M)

    @property
    def slope(self) -> Array:
        """The derivative of F (M, M)."""
        contact = self.contact
        return np.asarray(contact.stiff @ self.by_parted + contact.soft @ self.by_force)

    @property
    def by_dilation(self) -> Array:
        """The derivative of F by theta (M,)."""
        return np.asarray(self.contact.stiff @ self.dilates)


@record
class Contact:
    """The rows of a structure under loads, by springs alike."""

    soft: Array  # A (M, M)
    stiff: Array  # H (M, M)
    opened: Array  # W g_f (M,)
    give: Array  # e (M,)
    conditions: int  # number of conditions m, which are the first rows
    rough: Integers  # those that have friction (G,), whose rows follow, two by two
    friction: Array  # its coefficient (G,)
    augment: float  # r
    bonded: bool = False  # whether feet do not slip, whatever they need, nor when they lift

    @classmethod
    def of(cls, structure: Factorised, direct: Array, augment: float = 1.0) -> Contact:
        """That of a structure which loads would move by ``direct`` (n,) on its springs alone."""
        conditions, root = structure.conditions, np.sqrt(structure.springs)
        values, modes = structure.softness
        values = np.clip(values, 0.0, 1.0 - SOFT)
        give = np.full(len(root), GIVE)
        own = np.flatnonzero(conditions.compliance)
        give[own] = conditions.compliance[own] * structure.springs[own]
        return cls(
            (modes * values) @ modes.T,
            (modes * (1 - values)) @ modes.T,
            root * (structure.rows @ direct),
            give,
            len(conditions),
            conditions.rough,
            conditions.friction[conditions.rough],
            augment,
        )

    @property
    def rubs(self) -> Integers:
        """Rows (G, 2) of friction."""
        return self.conditions + np.arange(2 * len(self.rough)).reshape(-1, 2)

    def at(self, y: Array, theta: float, smooth: float = 0.0) -> Point:
        """What holds at y (M,)."""
        rough, rubs = self.rough, self.rubs
        mu = np.ones(len(rough)) if self.bonded else self.friction
        held, by_held = self._projected(y, smooth)
        by_away = np.eye(len(y)) - by_held
        away = y - held
        size = np.sqrt((away[rubs] ** 2).sum(axis=1) + smooth**2)
        way = away[rubs] / np.where(size > 0, size, 1.0)[:, None]
        dilates, by_size = (
            np.zeros_like(y),
            np.einsum("gi,gim->gm", mu[:, None] * way, by_away[rubs]),
        )
        dilates[rough] = mu * size
        forces, by_force, parted, by_parted = held, by_held, away, by_away
        forces[rough] /= mu
        by_force[rough] /= mu[:, None]
        forces, by_force = forces / self.augment, by_force / self.augment
        parted[rough] *= mu
        by_parted[rough] *= mu[:, None]
        parted = parted + theta * dilates + self.give * forces
        by_parted[rough] += theta * by_size
        by_parted = by_parted + self.give[:, None] * by_force
        return Point(
            self,
            self.stiff @ parted + self.soft @ forces - self.opened,
            dilates,
            forces,
            by_force,
            parted,
            by_parted,
        )

    def _projected(self, y: Array, smooth: float) -> tuple[Array, Array]:
        """P(y) (M,) and its derivative (M, M)."""
        count, rough, rubs = self.conditions, self.rough, self.rubs
        held, by_held = np.zeros_like(y), np.zeros((len(y), len(y)))
        plain = np.arange(count)
        held[:count], by_held[plain, plain] = _positive(y[:count], smooth)
        if self.bonded:
            held[rubs], by_held[rubs, rubs] = y[rubs], 1.0
            return held, by_held
        size = np.linalg.norm(y[rubs], axis=1)
        way = y[rubs] / np.where(size > 0, size, 1.0)[:, None]
        (less, by_less), (more, by_more) = (
            _positive(y[rough] + sign * size, smooth) for sign in (-1.0, 1.0)
        )
        half, across = 0.5 * (by_more + by_less), 0.5 * (by_more - by_less)[:, None] * way
        turned = np.where(size > 0, (more - less) / np.where(size > 0, 2 * size, 1.0), half)
        held[rough], held[rubs] = 0.5 * (more + less), 0.5 * (more - less)[:, None] * way
        by_held[rough, rough] = half
        by_held[rough[:, None], rubs] = across
        by_held[rubs, rough[:, None]] = across
        both = way[:, :, None] * way[:, None]
        by_held[rubs[:, :, None], rubs[:, None]] = half[:, None, None] * both + turned[
            :, None, None
        ] * (np.eye(2) - both)
        return held, by_held


def _positive(value: Array, smooth: float) -> tuple[Array, Array]:
    """The positive part, rounded off by ``smooth``, and its derivative."""
    if not smooth:
        return np.maximum(value, 0.0), (value > 0).astype(float)
    root = np.sqrt(value**2 + 4 * smooth**2)
    above = np.where(
        value > 0, 0.5 * (value + root), 2 * smooth**2 / np.where(value > 0, 1.0, root - value)
    )
    return above, above / root
