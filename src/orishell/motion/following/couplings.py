"""Degrees of freedom from vertex to vertex: what moves each of them, and which move together.

In a folded state the rates of the fold angles at a vertex, each along its crease, add up to 0
(:mod:`.system`). Where its crease directions span space, a vertex of four creases has one such set
of rates, to a factor: its *motion*. A crease that folds in the motions of both of its ends couples
them: one factor gives the other. One that folds at one end only keeps that end still. So the
degrees of freedom of a sheet are the parts that hang together by couplings, less those that are
kept still, or whose loops ask for factors that differ. Time and memory grow with the sheet.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.record import record
from orishell.motion.following.system import Closure
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.components import find_components

SPANNED = 1e-3
"""Four unit vectors whose motion is longer, unscaled, span space well."""
ZERO, GAP = 1e-8, 1e3
"""Numbers of the size of 1 that are 0 but for rounding, and how much larger all others are."""
WEAK = 1e-4
"""A crease whose rate is a smaller share of the largest rate at its vertex couples too weakly to be
felt."""


@record
class Coupled:
    """What moves by itself in a folded state."""

    count: int | None  # degrees of freedom; None if no gap tells which numbers are 0
    nearly: int  # how many there were without couplings that are too weak to be felt
    turning: Booleans  # which unknown creases (N,) turn in them
    # the part (I,) that every inner vertex is felt to move with; -1 where it stands still
    parts: Integers
    largest_zero: float  # the largest number that counts as 0
    least_other: float  # the least that does not


def find_couplings(
    closure: Closure, along: Sequence[Array], held: Booleans | None = None
) -> Coupled | None:
    """What moves by itself in a closed state; None where a vertex has more motions than one.

    Parameters
    ----------
    along
        Unit vectors (I', 3, D) along creases in that state, as :meth:`.Closure.turns` gives them.
    held
        Which unknowns (N,) something keeps as they are; None for none.
    """
    count, gap = len(closure.vertices), _Gap()
    motions = _motions(closure, along, gap)
    if motions is None:
        return None
    ends, vertices, rates = motions
    moves = gap.told(np.abs(rates))
    fixed = np.zeros(len(closure.edges), np.bool_) if held is None else held
    inner = np.bincount(
        ends, minlength=len(closure.edges)
    )  # how many ends of each crease are inner
    # Both ends of creases between inner vertices, the two beside each other.
    order = np.argsort(ends, kind="stable")
    pairs = order[inner[ends[order]] == 2].reshape(-1, 2)
    both = moves[pairs].all(axis=1)
    stopped = np.zeros(count, np.bool_)
    stopped[vertices[pairs[moves[pairs] & ~both[:, None]]]] = True
    stopped[vertices[moves & fixed[ends]]] = True
    pairs = pairs[both]
    at, rate = vertices[pairs], rates[pairs]
    moving = np.zeros(count, np.bool_)
    moving[vertices[moves]] = True
    parts = find_components(at, count)
    apart = _disagreements(parts, at, rate)
    stopped[at[gap.told(apart)]] = True
    alone = int(((inner == 0) & ~fixed).sum())  # creases from border to border

    def without(still: Booleans, labels: Integers) -> Integers:
        return np.where(moving & ~np.isin(labels, labels[still]), labels, -1)

    found = without(stopped, parts)
    strong = find_components(at[np.abs(rate).min(axis=1) >= WEAK], count)
    least = without(np.isin(parts, parts[stopped]), strong)
    turning = (inner == 0) & ~fixed
    turning[ends[moves & (found[vertices] >= 0)]] = True
    return Coupled(
        count=_number(found) + alone if gap.clear else None,
        turning=turning,
        nearly=_number(least) + alone,
        parts=least,
        largest_zero=gap.largest_zero,
        least_other=gap.least_other,
    )


class _Gap:
    """Which numbers are 0, and what they are told from others by."""

    def __init__(self) -> None:
        self.largest_zero, self.least_other = 0.0, np.inf

    def told(self, sizes: Array) -> Booleans:
        """Which sizes are not 0."""
        other = np.asarray(sizes > ZERO)
        self.largest_zero = max(self.largest_zero, float(sizes[~other].max(initial=0.0)))
        self.least_other = min(self.least_other, float(sizes[other].min(initial=np.inf)))
        return other

    @property
    def clear(self) -> bool:
        """Whether there is a gap between them."""
        return self.least_other >= GAP * max(self.largest_zero, np.finfo(float).eps)


def _motions(
    closure: Closure, along: Sequence[Array], gap: _Gap
) -> tuple[Integers, Integers, Array] | None:
    """For every end (K,) of a crease at an inner vertex: crease, vertex, and rate.

    Rates at a vertex are shares of the largest there; 0 where it stands still. None if a vertex has
    more motions than one.
    """
    first = 0
    creases, vertices, rates = ([np.zeros(0, np.int64)], [np.zeros(0, np.int64)], [np.zeros(0)])
    for (unknowns, _), of_fan in zip(closure.fans, along, strict=True):
        folding = (unknowns >= 0).sum(axis=1)
        for degree in np.unique(folding[folding > 0]).tolist():
            here = np.flatnonzero(folding == degree)
            own = unknowns[here]
            chosen = own >= 0
            directions = np.moveaxis(of_fan[here], 1, 2)[chosen].reshape(len(here), degree, 3)
            found = _vertex_motions(directions, gap)
            if found is None:
                return None
            creases.append(own[chosen])
            vertices.append(np.repeat(first + here, degree))
            rates.append(found.ravel())
        first += len(unknowns)
    return np.concatenate(creases), np.concatenate(vertices), np.concatenate(rates)


def _vertex_motions(directions: Array, gap: _Gap) -> Array | None:
    """Rates (I, D) whose sum along unit directions (I, D, 3) is 0; 0 where there are none.

    None if there are several at a vertex.
    """
    count, degree, _ = directions.shape
    if degree > 4:
        return None
    rates = np.zeros((count, degree))
    rest = np.ones(count, np.bool_)
    if degree == 4:
        rates = np.stack([_minor(directions, left) for left in range(4)], axis=1)
        size = np.sqrt((rates**2).sum(axis=1))
        rest = np.asarray(size < SPANNED)
        gap.told(size[~rest])
    if rest.any():
        _, sizes, turned = np.linalg.svd(np.swapaxes(directions[rest], 1, 2))
        spanned = np.zeros((int(rest.sum()), degree), np.bool_)
        spanned[:, : sizes.shape[1]] = gap.told(sizes)
        if (spanned.sum(axis=1) < degree - 1).any():
            return None
        # The last of them is orthogonal to all that is spanned.
        rates[rest] = np.where(spanned.all(axis=1, keepdims=True), 0.0, turned[:, -1])
    largest = np.abs(rates).max(axis=1, keepdims=True)
    return np.asarray(rates / np.where(largest > 0, largest, 1.0))


def _minor(directions: Array, left: int) -> Array:
    """Signed volumes (I,) of three of four directions (I, 4, 3)."""
    a, b, c = (directions[:, k] for k in range(4) if k != left)
    return np.asarray((-1) ** left * (np.cross(a, b) * c).sum(axis=1))


def _disagreements(parts: Integers, at: Integers, rates: Array) -> Array:
    """By how much couplings (C,) ask for other factors than those on the way to them do.

    As a logarithm; 1 at least where one asks for the other sign.

    parts: Part (I,) of every vertex.
    at: Vertices (C, 2) that are coupled.
    rates: Rates (C, 2) of the crease between them, in the motion of each.
    """
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import breadth_first_order

    if not len(at):
        return np.zeros(0)
    count = len(parts)
    _, firsts = np.unique(parts, return_index=True)
    # From a root beyond all vertices to the first one of each part, and on by couplings.
    starts = np.stack([np.full_like(firsts, count), firsts], axis=1)
    links = np.concatenate([at, starts])
    number = np.arange(1, len(links) + 1)
    shape = (count + 1, count + 1)
    both_ways = np.hstack([links.T, links.T[::-1]])
    graph = csr_array((np.concatenate([number, number]), (both_ways[0], both_ways[1])), shape)
    _, before = breadth_first_order(graph, count, directed=False)
    before[count] = count
    steps = np.zeros(count + 1, np.int64)
    steps[:count] = np.asarray(graph[np.arange(count), before[:count]]).ravel()
    with np.errstate(divide="ignore"):
        logs = np.log(np.abs(np.concatenate([rates, np.ones(starts.shape)])))
    signs = np.sign(np.concatenate([rates, np.ones(starts.shape)]))
    own = steps[:count] - 1
    forward = (links[own, 1] == np.arange(count)).astype(np.int64)
    # Factor of a vertex by that of the one before it, as logarithm and sign.
    size, sign = np.zeros(count + 1), np.ones(count + 1)
    size[:count] = logs[own, 1 - forward] - logs[own, forward]
    sign[:count] = signs[own].prod(axis=1)
    while (before != count).any():
        size, sign = size + size[before], sign * sign[before]
        before = before[before]
    (one, other), (first, second) = at.T, logs[: len(at)].T
    apart = np.abs(size[one] + first - size[other] - second)
    wrong = sign[one] * sign[other] * signs[: len(at)].prod(axis=1) < 0
    return np.asarray(np.where(wrong, np.maximum(apart, 1.0), apart))


def _number(labels: Integers) -> int:
    """How many labels there are beside -1."""
    return len(np.unique(labels[labels >= 0]))
