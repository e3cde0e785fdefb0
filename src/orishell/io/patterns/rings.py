"""The closed walks of a graph in the plane: its panels, and what lies around them."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.io.fold_polygons import MOST_PLACES
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.components import find_components


@record
class Rings:
    """Closed walks that keep to the left of edges: panels, and what lies around all."""

    numbers: Integers  # the walk (2E,) of every edge, forwards first, then backwards
    after: Integers  # the step (2E,) that follows in its walk
    areas: Array  # enclosed area of every walk (R,), negative where it goes round from outside


def find_rings(points: Array, edges: Integers) -> Rings:
    """The walks of a graph."""
    steps = np.concatenate([edges, edges[:, ::-1]])
    count = len(steps)
    way = points[steps[:, 1]] - points[steps[:, 0]]
    order = np.lexsort((np.arctan2(way[:, 1], way[:, 0]), steps[:, 0]))
    tails = steps[order, 0]
    first = np.searchsorted(tails, tails, side="left")
    last = np.searchsorted(tails, tails, side="right") - 1
    place = np.arange(count)
    before = order[np.where(place == first, last, place - 1)]
    clockwise = np.empty(count, dtype=np.int64)
    clockwise[order] = before
    after = clockwise[(np.arange(count) + len(edges)) % count]
    numbers = find_components(np.stack([np.arange(count), after], axis=-1), count)
    here, there = (points[steps[:, k]] - points.mean(axis=0) for k in (0, 1))
    cross = here[:, 0] * there[:, 1] - here[:, 1] * there[:, 0]
    areas = np.asarray(0.5 * np.bincount(numbers, cross), dtype=np.float64)
    return Rings(numbers, after, areas)


def loops_of(rings: Rings, edges: Integers, chosen: Integers) -> Integers:
    """Points (F, K) around some walks, -1 behind the last.

    Raises InputError: If one has too many.
    """
    tails = np.concatenate([edges[:, 0], edges[:, 1]])
    longest = int(np.bincount(rings.numbers)[chosen].max())
    if longest * len(chosen) > MOST_PLACES:
        raise InputError("a panel has too many corners", got=str(longest))
    start = np.full(len(rings.areas), -1)
    start[rings.numbers[::-1]] = np.arange(len(rings.numbers))[::-1]
    begin = start[chosen]
    loops = np.full((len(chosen), longest), -1)
    loops[:, 0] = tails[begin]
    active, now = np.arange(len(chosen)), rings.after[begin]
    for column in range(1, longest):
        on = now != begin[active]
        active, now = active[on], now[on]
        loops[active, column] = tails[now]
        now = rings.after[now]
    return loops
