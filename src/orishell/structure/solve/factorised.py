"""A structure factorised once, whatever its one-sided conditions turn out to do.

The matrix K of panels and hinges alone may be singular: a shell is a mechanism until something
holds it. So springs S are put on all conditions B, and on a few vertices more, and

    A = K + B^T S B

is factorised. With p = S g - lambda, where g = B u and the conditions' forces lambda act as
-B^T lambda,

    u = A^-1 (f + B^T p),        g = g_f + C p,        C = B A^-1 B^T,

which leaves as many equations as there are conditions: p = S g where one is open, g = 0 or
p = (S - 1/c) g where it acts. With the open rows O, of which those that act without compliance are
eliminated from C, the shell is free to move where

    1 - S^1/2 C_OO S^1/2

is singular.
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.structure.mesh.elements import Elements
from orishell.structure.solve.conditions import Conditions

if TYPE_CHECKING:
    from scipy.sparse import csr_array

FREE = 1e-9
"""A motion that takes less than this share of the springs' energy is one that nothing resists."""
STEPS = 3
"""Each takes what those before left of the loads."""
GIVE = 1e-7
"""What does not give at all gives by this share of the springs, so that of several which hold the
same each bears its part."""


@record
class Factorised:
    """A supported structure, factorised.

    Rows are those of the conditions, then two of friction for each foot on rough ground (along
    x, and along y), then those of vertices that nothing holds in truth.
    """

    elements: tuple[Elements, ...]  # panels and hinges, whose matrix is K (D, D)
    free: Integers  # dofs (n,) that are not supported
    conditions: Conditions  # the one-sided conditions (m)
    nodes: int  # number of nodes, whose displacements are the first dofs
    by_dofs: csr_array  # displacements (3 N, D) of all points, nodes first
    every_row: csr_array  # all rows (M, D)
    rows: csr_array  # their part (M, n) of free dofs
    springs: Array  # their springs (M,)
    spread: Array  # A^-1 B^T (n, M)
    flexibility: Array  # C (M, M)
    rigid: Array  # motions of the whole (n, r) that supports leave; orthonormal
    _inner: csr_array
    _factors: Any

    @cached_property
    def softness(self) -> tuple[Array, Array]:
        """Eigenvalues (M,) and -vectors (M, M) of C, rows by their springs alike."""
        root = np.sqrt(self.springs)
        return np.linalg.eigh(root[:, None] * self.flexibility * root)

    @property
    def sliding(self) -> Integers:
        """The foot on the ground (2G,) that every row of friction belongs to."""
        return np.repeat(self.conditions.rough, 2)

    def pulls(self, forces: Array) -> Array:
        """What rows with forces (M,) take from all dofs (D,): B^T lambda."""
        return np.asarray(self.every_row.T @ forces)

    def ground_forces(self, forces: Array) -> Array:
        """Forces (N, 3) of the ground on points, from the forces (M,) of all rows."""
        which = np.zeros(len(self.springs), dtype=bool)
        which[: len(self.conditions)] = self.conditions.grounded
        which[len(self.conditions) :][: len(self.sliding)] = True
        taken = self.every_row.T @ np.where(which, forces, 0.0)
        found = np.zeros((self.by_dofs.shape[0] // 3, 3))
        found[: self.nodes] = -taken[: 3 * self.nodes].reshape(-1, 3)
        return found

    def slipped(self, parted: Array) -> float:
        """How far a foot slips at most, by what rows part (M,)."""
        rubs = parted[len(self.conditions) :][: len(self.sliding)].reshape(-1, 2)
        return float(np.max(np.linalg.norm(rubs, axis=1), initial=0.0))

    def free_loads(self, forces: Array) -> Array:
        """Loads on free dofs (n,) of forces on points (N, 3)."""
        return np.asarray((self.by_dofs.T @ forces.ravel())[self.free])

    def moved(self, displacements: Array) -> Array:
        """Displacements and rotations (D,), by displacements of free dofs (n,)."""
        moved = np.zeros(self.every_row.shape[1])
        moved[self.free] = displacements
        return moved

    def shape(self, displacements: Array) -> Array:
        """Displacements (N, 3) of points, by displacements of free dofs (n,)."""
        return np.asarray((self.by_dofs @ self.moved(displacements)).reshape(-1, 3))

    def furthest(self, displacements: Array) -> float:
        """The largest displacement of a point, by displacements of free dofs (n,)."""
        return float(np.linalg.norm(self.shape(displacements), axis=1).max())

    def spring_solve(self, loads: Array) -> Array:
        """A^-1 f (n, ...) of loads (n, ...), refined once."""
        found = self._factors.solve(loads)
        return np.asarray(found + self._factors.solve(loads - self._inner @ found))

    def quick_solve(self, loads: Array) -> Array:
        """A^-1 f (n, p) of loads (n, p), not refined."""
        return np.asarray(self._factors.solve(loads))

    def soft_stiffness(self, moved: Array, active: Booleans) -> Array:
        """Forces (n, p) of panels, hinges and those rows that are active (M,) and give.

        The structure is moved (n, p).
        """
        taken = np.where(active & ~self._hard, 0.0, self.springs)[:, None]
        return np.asarray(self._inner @ moved - self.rows.T @ (taken * (self.rows @ moved)))

    def motions(self, active: Booleans) -> Array:
        """What nothing resists (n, k) while some rows are active (M,); orthonormal."""
        hard = active & self._hard
        loose = ~active
        root = np.sqrt(self.springs[loose])
        across = self.flexibility[np.ix_(hard, loose)]
        release = np.linalg.lstsq(self.flexibility[np.ix_(hard, hard)], across, rcond=FREE)[0]
        flexible = self.flexibility[np.ix_(loose, loose)] - across.T @ release
        values, modes = np.linalg.eigh(np.eye(len(root)) - root[:, None] * flexible * root)
        forces = np.zeros((len(active), int((values < FREE).sum())))
        forces[loose] = root[:, None] * modes[:, values < FREE]
        forces[hard] = -release @ forces[loose]
        return np.linalg.qr(self.spread @ forces)[0]

    @cached_property
    def free_motions(self) -> Array:
        """What nothing resists (n, k) but rows; orthonormal, motions of the whole first.

        Those are known exactly; by their eigenvalues they are mixed with folding, which costs thin
        panels next to nothing, by up to 1e-5.
        """
        found = self.motions(np.zeros(len(self.springs), dtype=bool))
        rest = found - self.rigid @ (self.rigid.T @ found)
        own = np.linalg.svd(rest, full_matrices=False)[0]
        return np.hstack([self.rigid, own[:, : found.shape[1] - self.rigid.shape[1]]])

    @property
    def _hard(self) -> Booleans:
        """Rows (M,) that do not give while they act; the others' springs are their own."""
        hard = np.ones(len(self.springs), dtype=bool)
        hard[: len(self.conditions)] = self.conditions.compliance == 0
        return hard

    def resisting(self, moved: Array) -> Array:
        """Forces (D,) that panels and hinges take, of free dofs moved (n,): K u."""
        every = self.moved(moved)
        return np.asarray(np.sum([each.total(every) for each in self.elements], axis=0))

    def respond(self, loads: Array, active: Booleans) -> tuple[Array, Array, Array, Array]:
        """What loads do while some rows act.

        loads: Loads on free dofs (n,).
        active: Which rows act (M,).

        Returns
        -------
        tuple
            Displacements (n,), gaps (M,) and forces (M,) of the rows, and what panels and hinges
            take (D,): that of all steps one by one, as displacements of all together are rounded.
        """
        law, rest = self.reaction_operator(active), loads
        moved, gaps, forces = np.zeros(len(loads)), *np.zeros((2, len(active)))
        taken = np.zeros(self.every_row.shape[1])
        for _ in range(STEPS):
            direct = self.spring_solve(rest)
            p = law @ (self.rows @ direct)
            opened = self.rows @ direct + self.flexibility @ p
            step = direct + self.spread @ p
            moved, gaps, taken = moved + step, gaps + opened, taken + self.resisting(step)
            forces = forces + np.where(active, self.springs * opened - p, 0.0)
            rest = loads - (taken + self.pulls(forces))[self.free]
        return moved, gaps, forces, taken

    def reaction_operator(self, active: Booleans) -> Array:
        """The matrix (M, M) from gaps g_f that loads would open to p, while some rows act.

        active: Which rows act (M,).
        """
        # g - C p = g_f; open rows: p - S g = 0; active ones: p = 0, or next to no g if hard.
        count = len(self.springs)
        hard, spring = active & self._hard, np.diag(self.springs)
        by_gap, by_p = -spring, np.eye(count)
        by_gap[active], by_p[hard] = 0.0, GIVE * by_p[hard]
        by_gap[hard] = (1 - GIVE) * spring[hard]
        root = np.sqrt(self.springs)
        # p = s q and g = h/s with s^2 = S: forces and gaps by springs count alike.
        flexible = root[:, None] * self.flexibility * root
        gap, force = (each / root[:, None] for each in (by_gap / root, by_p * root))
        both = gap @ flexible + force
        return np.asarray(-root[:, None] * (np.linalg.pinv(both, rcond=FREE) @ gap) * root)
