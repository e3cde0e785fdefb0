"""A structure that may be moved far: its forces, its tangent, and Newton's steps.

Rotations are matrices that a step turns by its exponential map. Tangents are complete, so that
Newton's steps converge quadratically; on the way they are not symmetric. In equilibrium they are
(B. Nour-Omid and C. C. Rankin, "Finite rotation analysis and consistent linearization using
projectors", Computer Methods in Applied Mechanics and Engineering 93 (1991)), and the signs of
their pivots tell how many motions release energy.

What forces of elements have by turning is taken of forces that the last step led to expect, not of
those that displacements have at once, which in thin plates are far too large on the way: D.
Magisano, L. Leonetti and G. Garcea, "How to improve efficiency and robustness of the Newton method
in geometrically non-linear structural problem discretized via displacement-based finite elements",
Computer Methods in Applied Mechanics and Engineering 313 (2017). In balance both are the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Protocol, Self

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.corotational import Change, Moved
from orishell.structure.mesh.rotations import exponentials
from orishell.structure.solve.sparsity import Sparsity

SEED, SOFTENING = 0, 8
"""Of the shape from which the softest motion is sought, in so many inverse iterations."""


class OutOfWorkError(Exception):
    """More tangents are asked for than there may be."""


@dataclass
class Work:
    """How many tangents may still be found: no clock decides where it ends."""

    left: float  # number of tangents

    def take(self) -> None:
        """One more tangent.

        Raises OutOfWorkError: If there may be no more.
        """
        if self.left < 1:
            raise OutOfWorkError
        self.left -= 1


class Part(Protocol):
    """Elements that may be moved far."""

    @property
    def dofs(self) -> Integers:
        """Their dofs (T, k)."""

    @property
    def rounding(self) -> Array:
        """What forces (T, k) are uncertain by, where displacements are by a length."""

    def forces(self, moved: Moved) -> Array:
        """Forces (T, k) that move them."""

    def settled(self, moved: Moved) -> Self:
        """The elements after a step that ends here."""

    def taken_over(self, moved: Moved) -> Self:
        """The elements, what gives though it should not being taken over."""

    def grown(self, ratio: float) -> Self:
        """The elements under loads that have grown by a ratio: a guess of what they bear then."""

    def missing(self, moved: Moved) -> float:
        """Norm of the forces by which what should not give does."""

    def tangent(self, moved: Moved, expected: Array | None = None) -> Change:
        """These forces, and how they change, with the forces that are expected to turn."""


@record
class Tangent:
    """How forces change with displacements and turns; factorised once it has to be."""

    structure: Moving  # what it is of
    changes: tuple[Change, ...]  # of its parts

    @cached_property
    def negative(self) -> int:
        """Number of its motions that release energy."""
        factors = self._factors
        return 0 if factors is None else int((factors.U.diagonal() < 0).sum())

    @property
    def other(self) -> float:
        """By what forces are others than those where displacements are (norm of forces)."""
        return float(np.linalg.norm([each.other for each in self.changes]))

    def solve(self, loads: Array) -> Array:
        """Steps (n, ...) by loads (n, ...); not numbers if the tangent is singular."""
        if self._factors is None:
            return np.full(loads.shape, np.nan)
        return np.asarray(self._factors.solve(loads))

    def unfactorised(self) -> Tangent:
        """The tangent without its factors, which take memory."""
        return replace(self)

    @cached_property
    def _factors(self) -> Any:
        """Its factors; None if it is singular."""
        structure = self.structure
        matrix = structure.sparsity.matrix([each.matrices for each in self.changes])
        return _factorised(matrix, np.where(structure.straight, structure.steady, 0.0))

    def softest(self) -> Array:
        """About the motion (n,) that takes the least force, the largest displacement 1."""
        shape = np.random.default_rng(SEED).standard_normal(len(self.structure.free))
        for _ in range(SOFTENING):
            shape = self.solve(shape)
            shape /= np.abs(shape[self.structure.straight]).max()
        return shape

    def expected(self, step: Array) -> list[Array | None]:
        """Forces of all parts that are expected after a step (n,)."""
        every = self.structure.every(step)
        both = zip(self.structure.parts, self.changes, strict=True)
        return [change.expected(every[part.dofs]) for part, change in both]


@record
class Moving:
    """A supported structure that may be moved far."""

    parts: tuple[Part, ...]  # what it is made of
    free: Integers  # dofs (n,) that are not restrained
    spins: Integers  # dofs (r, 3) of every rotation
    straight: Array  # which free dofs (n,) are displacements
    lever: float  # moments over this length count like forces (length)
    count: int  # number of all dofs
    uncertain: float  # norm of what forces are uncertain by, where displacements are by a length
    # stiffness that the tangent has beyond its own on displacements, so that motions which nothing
    # resists and nothing drives have one (force per length): balance is without it
    steady: float
    sparsity: Sparsity  # where the entries of its tangent are
    work: Work | None = None  # how many tangents there may be; None for as many as it takes

    @classmethod
    def of(
        cls,
        parts: Sequence[Part],
        restrained: Integers,
        spins: Integers,
        lever: float,
        *,
        steady: float = 0.0,
    ) -> Moving:
        """A structure of parts.

        restrained: Dofs (H,) that supports restrain.
        spins: Dofs (r, 3) of every rotation; all others are displacements.
        lever: Moments over this length count like forces.
        steady: Stiffness that the tangent has beyond its own on displacements.
        """
        count = 1 + max(int(each.dofs.max(initial=0)) for each in parts)
        free = np.setdiff1d(np.arange(count), restrained)
        straight = np.ones(count, dtype=bool)
        straight[spins] = False
        sparsity = Sparsity.of([each.dofs for each in parts], free, count)
        square = np.zeros(count)
        for part in parts:
            square += np.bincount(part.dofs.ravel(), part.rounding.ravel() ** 2, count)
        square[spins] /= lever**2
        uncertain = float(np.sqrt(square[free].sum()))
        return cls(
            tuple(parts), free, spins, straight[free], lever, count, uncertain, steady, sparsity
        )

    def start(self) -> Moved:
        """As designed."""
        return Moved(np.zeros(self.count), np.tile(np.eye(3), (len(self.spins), 1, 1)))

    def every(self, step: Array) -> Array:
        """Steps of all dofs (D,) by those of free ones (n,)."""
        every = np.zeros(self.count)
        every[self.free] = step
        return every

    def after(self, moved: Moved, step: Array) -> Moved:
        """After one more step of free dofs (n,)."""
        every = self.every(step)
        turns = exponentials(every[self.spins])
        every[self.spins] = 0.0
        return Moved(moved.displacements + every, turns @ moved.rotations)

    def settled(self, moved: Moved) -> Moving:
        """The structure after a step that ends here."""
        return replace(self, parts=tuple(part.settled(moved) for part in self.parts))

    def taken_over(self, moved: Moved) -> Moving:
        """The structure, what gives though it should not being taken over."""
        return replace(self, parts=tuple(part.taken_over(moved) for part in self.parts))

    def grown(self, ratio: float) -> Moving:
        """The structure under loads that have grown by a ratio: a guess of what it bears then."""
        return replace(self, parts=tuple(part.grown(ratio) for part in self.parts))

    def missing(self, moved: Moved) -> float:
        """Norm of the forces by which what should not give does."""
        return float(np.linalg.norm([part.missing(moved) for part in self.parts]))

    def forces(self, moved: Moved) -> Array:
        """Forces (D,) of all parts."""
        total = np.zeros(self.count)
        for part in self.parts:
            total += np.bincount(part.dofs.ravel(), part.forces(moved).ravel(), self.count)
        return total

    def tangent(
        self, moved: Moved, expected: Sequence[Array | None] | None = None
    ) -> tuple[Array, Tangent]:
        """Forces (D,) of all parts, and their tangent.

        expected: Forces that each part is expected to have.
        Raises OutOfWorkError: If there may be no more of them.
        """
        if self.work is not None:
            self.work.take()
        known = expected or [None] * len(self.parts)
        both = zip(self.parts, known, strict=True)
        changes = tuple(part.tangent(moved, each) for part, each in both)
        total = np.zeros(self.count)
        for part, each in zip(self.parts, changes, strict=True):
            total += np.bincount(part.dofs.ravel(), each.forces.ravel(), self.count)
        return total, Tangent(self, changes)

    def noise(self, moved: Moved) -> float:
        """Norm of forces that are but rounding errors of displacements."""
        far = self.lever + float(np.abs(moved.displacements).max())
        return float(np.finfo(np.float64).eps) * far * self.uncertain

    def size(self, forces: Array) -> float:
        """Norm of forces (n,) on free dofs, moments over the lever."""
        return float(np.linalg.norm(np.where(self.straight, forces, forces / self.lever)))


def _factorised(matrix: Any, steady: Array) -> Any:
    """The factors of a matrix with more on its diagonal (n,); None if it is singular."""
    from scipy.sparse import diags_array
    from scipy.sparse.linalg import splu

    if steady.any():
        matrix = (matrix + diags_array(steady)).tocsc()
    try:
        return splu(
            matrix,
            permc_spec="MMD_AT_PLUS_A",
            diag_pivot_thresh=0.0,
            options={"SymmetricMode": True},
        )
    except RuntimeError:  # "Factor is exactly singular"
        return None
