"""Degrees of freedom of folded states: fold angles less what closure takes from them.

Where every vertex has one motion, and there is no hole, they are counted from vertex to vertex
(:mod:`.couplings`), at a cost that grows with the sheet; elsewhere by singular values.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.motion.following.couplings import find_couplings
from orishell.motion.following.system import Closure
from orishell.numerics.arrays import Array, Integers

DENSE = 1000
"""Up to so many creases all singular values are found, beyond only the least."""
MOST_CREASES = 50_000
"""Beyond so many creases singular values are not looked for."""
CLOSED = 1e-10
"""By how much vertices miss closing in a state that closes but for rounding, at most."""
BLOCK = 16
"""Singular values that are found first of larger sheets; twice as many, until there is a gap."""
ROUNDS = 12
"""Steps of inverse iteration."""
ZERO = 1e-8
"""A singular value above this is none of a motion of a state that closes but for rounding."""
UNCERTAIN = 100.0
"""In others it may be so many times what the state misses by."""
GAP = 1e3
"""Singular values that are zero are less than others by this factor at least."""
NEAR, NEARLY = 3.0, 10.0
"""The factor of what a state misses by, and that of the gap, in states that close nearly only."""


@record
class Freedom:
    """How many ways there are to go on from one folded state, to first order."""

    drive: float  # the state's largest fold angle (radians)
    # degrees of freedom; None if no gap tells which numbers are zero
    count: int | None
    # the largest number that counts as zero, 0 if there is none, and the least that does not,
    # infinite if there is none: singular values, or rates of creases and sizes at vertices
    largest_zero: float
    least_other: float
    # how many there would be without couplings too weak to be felt; None if that is not known
    nearly: int | None = None
    # the part (I,) that each inner vertex, in their order in the closure, moves with; -1 where it
    # stands still; None if that is not known
    parts: Integers | None = None
    by_rank: bool = False  # whether singular values told it, and not the motions of vertices


def least_count(states: Sequence[Freedom]) -> int | None:
    """Degrees of freedom of a motion by those of some of its states: the least; None if not known.

    A state may have more than others, to first order, none has fewer than its motion. So one with a
    single one settles it.
    """
    counts = [each.count for each in states]
    known = [each for each in counts if each is not None]
    if not known or (min(known) > 1 and len(known) < len(counts)):
        return None
    return min(known)


def find_freedom(closure: Closure, folds: Array, *, nearly: bool = False) -> Freedom:
    """Count the singular values of the equations' derivatives that are zero in a state.

    In the flat state, and where creases are folded flat, there are more than the sheet has motions.

    Parameters
    ----------
    folds
        Fold angles (N,) of the unknowns in a closed state (radians).
    nearly
        Whether the state closes nearly only: singular values up to
        three times what it misses by are zero.
    """
    drive, unknowns = float(np.abs(folds).max(initial=0.0)), len(folds)
    holes = len(closure.holes) > 0
    if not closure.fans and not holes:
        return Freedom(drive, unknowns, 0.0, np.inf, unknowns, np.zeros(0, np.int64))
    left, entries = closure.residuals(folds)
    missed = float(np.abs(left).max())
    zero = max(ZERO, (NEAR if nearly else UNCERTAIN) * missed)
    coupled = None
    if not nearly and not holes and missed <= CLOSED:
        coupled = find_couplings(closure, closure.turns(folds)[1])
        if coupled is not None and (coupled.count is not None or unknowns > MOST_CREASES):
            zero_to_other = coupled.largest_zero, coupled.least_other
            return Freedom(drive, coupled.count, *zero_to_other, coupled.nearly, coupled.parts)
    if unknowns > MOST_CREASES:
        return Freedom(drive, None, 0.0, np.inf)
    block = unknowns if unknowns <= DENSE else BLOCK
    while True:
        values = _least_values(closure, entries, min(block, unknowns))
        zeros = int((values <= zero).sum())
        if zeros < len(values) or len(values) == unknowns:
            break
        block *= 2
    largest = float(values[zeros - 1]) if zeros else 0.0
    other = float(values[zeros]) if zeros < len(values) else np.inf
    clear = other >= (NEARLY if nearly else GAP) * max(largest, np.finfo(float).eps)
    if nearly and not zeros:  # there is a motion nearly
        clear = False
    found = Freedom(drive, zeros if clear else None, largest, other, by_rank=True)
    return found if coupled is None else replace(found, nearly=coupled.nearly, parts=coupled.parts)


def _least_values(closure: Closure, entries: Array, count: int) -> Array:
    """The least singular values (count,), ascending."""
    matrix = closure.matrix(entries)
    if count == len(closure.edges):
        values = np.linalg.svd(matrix.toarray(), compute_uv=False)
        return np.sort(np.append(values, np.zeros(count - len(values))))
    from scipy.sparse import eye_array
    from scipy.sparse.linalg import splu

    normal = matrix.T @ matrix + 1e-13 * eye_array(len(closure.edges))
    factors = splu(normal.tocsc())
    basis = np.random.default_rng(0).normal(size=(len(closure.edges), count + 4))
    for _ in range(ROUNDS):
        basis = np.linalg.qr(factors.solve(basis))[0]
    return np.sort(np.linalg.svd(matrix @ basis, compute_uv=False))[:count]
