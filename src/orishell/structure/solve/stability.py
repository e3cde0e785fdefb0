"""Linear buckling, and natural frequencies of small motions about a loaded state.

K mode = omega^2 M mode, with the mass of panels lumped at their nodes.

With K_g the stiffness that forces in the plane of triangles, in ties and in flaps have by turning,

    (K + factor K_g) mode = 0.

Ties, flaps and feet that act under the load are taken to go on active.

Both are largest values of a symmetric matrix relative to a stiffness, found by a block Krylov
method. With K^-1 at hand, the vectors X, K^-1 A X, (K^-1 A)^2 X, ... of a block X are made
orthonormal with regard to K one block after the other, and A is as large as it gets among them:
H = Q^T A Q (G. H. Golub and R. Underwood, "The block Lanczos method for computing eigenvalues",
1977). Where they become too many, the best are kept (thick restart; K. Wu and H. Simon, 2000).

A solution for several loads together costs about as much as for one, as its time is that of reading
the factors. So it finds a few values in a fifth of the time that ARPACK takes for one vector after
the other, and values that lie close together as well as any.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.structure.mesh.elements import assemble
from orishell.structure.solve.factorised import Factorised

if TYPE_CHECKING:
    from scipy.sparse import csr_array

Apply = Callable[[Array], Array]
"""Products of a symmetric matrix with vectors (n, p)."""
VECTORS_KEPT = 64
"""Vectors that are kept at a time."""
ACCURACY = 1e-4
"""Of modes, by energy, relative to the largest value; values are as accurate as the square."""
SEEN = 0.01
"""Of the next mode after those that are asked for, by energy: a start that is right at once would
hide larger values, which random vectors beside it mostly meet before that one."""
DEPENDENT = 1e-12
"""Vectors of a block that others of it hold, but for this share of their energy, are none."""


def largest_values(
    solve: Apply, stiffness: Apply, apply: Apply, start: Array, count: int, *, blocks: int
) -> tuple[Array, Array, Array]:
    """Largest values (k,), their vectors (n, k), and by how much each (k,) may be off.

    They are at most count; fewer if the matrix has no more.

    solve, stiffness, apply: K^-1, K and A.
    start: The first block (n, p), of some more vectors than are asked for.
    count: How many are asked for.
    blocks: How many blocks are made at most.
    """
    start = solve(start)
    next_, _ = _orthonormal(start, stiffness(start))
    room = VECTORS_KEPT + start.shape[1]
    basis, taken = np.empty((2, room, len(start)))  # Q and A Q, as rows
    held = 0
    for _ in range(blocks):
        applied, first = apply(next_), held
        held += next_.shape[1]
        basis[first:held], taken[first:held] = next_.T, applied.T
        q = basis[:held]
        values, shapes = np.linalg.eigh(_symmetric(q @ taken[:held].T))
        values, shapes = values[::-1], shapes[:, ::-1]
        # What K^-1 A takes out of the vectors so far, the next block: Q^T K times it is Q^T A.
        further = solve(applied)
        further -= q.T @ (q @ applied)
        stiff = stiffness(further)
        further -= q.T @ (q @ stiff)
        next_, rest = _orthonormal(further, stiff)
        errors = np.linalg.norm(rest @ shapes[first:], axis=0)
        right = (errors[:count] <= ACCURACY * np.abs(values[:count])).all()
        seen = (errors[count : count + 1] <= SEEN * np.abs(values[count - 1 : count])).all()
        if next_.shape[1] == 0 or (right and seen):
            break
        if held + next_.shape[1] > VECTORS_KEPT:
            kept, held = shapes[:, : VECTORS_KEPT // 2], VECTORS_KEPT // 2
            basis[:held], taken[:held] = kept.T @ q, kept.T @ taken[: len(shapes)]
            values, errors, shapes = values[:held], errors[:held], np.eye(held)
    return values[:count], basis[: len(shapes)].T @ shapes[:, :count], errors[:count]


def _orthonormal(vectors: Array, stiff: Array) -> tuple[Array, Array]:
    """Vectors (n, k) that are orthonormal with regard to K, and the shares (k, p) of each.

    vectors, stiff: V and K V (n, p); vectors that others hold are left out.
    """
    values, axes = np.linalg.eigh(_symmetric(vectors.T @ stiff))
    kept = values > DEPENDENT * max(values[-1], np.finfo(float).tiny)
    length = np.sqrt(values[kept])
    return vectors @ (axes[:, kept] / length), length[:, None] * axes[:, kept].T


def _symmetric(matrix: Array) -> Array:
    return 0.5 * (matrix + matrix.T)


SEED = 0
SPARE = 2
"""Vectors of a block beyond the values that are asked for."""
BLOCKS = 80
"""Krylov's iteration is given up after so many blocks: what it has not found by then is none. A
shell that is pulled all over has no positive value to find, and many just below 0."""
LOOSE = 1e-4
"""Modes that are off by more than this share by energy are none that are found."""


@record
class Inverse:
    """A structure some of whose rows act, as they are in a state that it moves about."""

    structure: Factorised  # the structure
    active: Booleans  # which rows act (M,), in both directions
    motions: Array  # what nothing resists (n, k), orthonormal: it is left out
    _law: Array

    @classmethod
    def of(cls, structure: Factorised, active: Booleans, motions: Array) -> Inverse:
        """The structure, prepared, with rows that are active (M,) and free motions (n, k)."""
        return cls(structure, active, motions, structure.reaction_operator(active))

    def solve(self, loads: Array) -> Array:
        """Displacements (n, p) under loads (n, p) without those along free motions."""
        structure = self.structure
        direct = structure.quick_solve(loads - self.motions @ (self.motions.T @ loads))
        moved = direct + structure.spread @ (self._law @ (structure.rows @ direct))
        return np.asarray(moved - self.motions @ (self.motions.T @ moved))

    def stiffness(self, moved: Array) -> Array:
        """Forces (n, p) of a structure that is moved (n, p) as rows which act allow."""
        return np.asarray(self.structure.soft_stiffness(moved, self.active))


def largest(
    inverse: Inverse, apply: Apply, count: int, near: Array | None = None
) -> tuple[Array, Array]:
    """Largest values (k,) of a matrix relative to the stiffness, and their vectors (n, k).

    Those that are found: maybe fewer, if most are about 0.

    apply: Products of the symmetric matrix with vectors (n, p).
    count: Number k of values.
    near: Vectors (n, j) that may be near to some of them.
    """
    size = len(inverse.structure.free)
    start = np.random.default_rng(SEED).standard_normal((size, min(count + SPARE, size)))
    if near is not None and near.shape[1]:
        start = np.concatenate([inverse.stiffness(near), start], axis=1)[:, : start.shape[1]]
    values, vectors, errors = largest_values(
        inverse.solve, inverse.stiffness, apply, start, count, blocks=BLOCKS
    )
    found = errors <= LOOSE * np.abs(values)
    return values[found], vectors[:, found]


def find_frequencies(inverse: Inverse, mass: csr_array, count: int) -> tuple[Array, Array]:
    """Lowest frequencies (count,) but those of free motions, and their modes (n, count) (Hz).

    mass: Of free dofs (n, n), in force by acceleration in the unit of the sheet.
    """
    free = inverse.motions
    heavy = np.asarray(mass @ free)
    held_back = np.linalg.solve(free.T @ heavy, heavy.T) if free.size else heavy.T

    def apply(moved: Array) -> Array:
        # Without the free motions' share, so that what is left is in balance.
        bare = moved - free @ (held_back @ moved)
        return np.asarray(mass @ bare - heavy @ (held_back @ bare))

    values, modes = largest(inverse, apply, count)
    return 1 / np.sqrt(values) / (2 * np.pi), modes - free @ (held_back @ modes)


NEVER = 1e-9
"""Factors above the inverse of this are none."""


def turning_stiffness(points: Array, pairs: Integers, pulls: Array, count: int) -> csr_array:
    """The matrix (D, D) of straight ties and struts.

    points: Nodes (N, 3).
    pairs: Nodes (m, 2) between which they are.
    pulls: With which force they pull (m,); struts push, less than 0 (N).
    count: Number of all dofs D.
    """
    away = points[pairs[:, 1]] - points[pairs[:, 0]]
    length = np.linalg.norm(away, axis=1)
    along = away / length[:, None]
    across = np.eye(3) - along[:, :, None] * along[:, None]
    block = (pulls / length)[:, None, None] * across
    elements = np.concatenate(
        [np.concatenate([block, -block], axis=2), np.concatenate([-block, block], axis=2)], axis=1
    )
    dofs = 3 * pairs[:, :, None] + np.arange(3)
    return assemble(elements, dofs.reshape(-1, 6), count)


def find_buckling(
    inverse: Inverse, apply: Apply, count: int, near: Array | None = None
) -> tuple[Array, Array]:
    """The lowest factors (at most count) at which the shell buckles, and their modes (n, k).

    Fewer, or none, if it buckles in no more ways.

    apply: Products of K_g with vectors (n, p) of free dofs.
    near: Modes (n, k) of another load case, which may be like those that are sought.
    """
    values, modes = largest(inverse, lambda moved: -apply(moved), count, near)
    buckles = values > NEVER
    return 1 / values[buckles], modes[:, buckles]
