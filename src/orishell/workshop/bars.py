"""Bars and coils cut to length: one-dimensional nesting, and how few there could be.

Pieces go, the longest first, to the bar that they fill best; a saw takes its cut between two of
them. How few there are at least is known from Martello and Toth's bound (Knapsack Problems, 1990,
section 8.3.2): pieces longer than half a bar have one each, and what those leave room for is taken
off the sum of the others.
"""

from __future__ import annotations

from bisect import bisect_left, insort

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.fitting import above

SLACK = 1e-9
"""A piece fits if it is no longer than the bar by more than this share of it."""


@record
class CutBars:
    """Bars that pieces (N,) are cut from."""

    bar: float  # length of one
    count: int  # how many there are
    least: int  # how few there are at least, whichever way they are cut
    of: Integers  # the bar (N,) of every piece, from 0


def cut_bars(lengths: Array, bar: float, kerf: float, key: str, what: str) -> CutBars:
    """Cut pieces of lengths (N,) from bars of one length.

    Parameters
    ----------
    kerf
        What is lost between two pieces (length).
    key
        Where the design file has the length of bars.
    what
        What the longest piece is called in a refusal.

    Raises
    ------
    InputError
        If a piece is longer than a bar; says what would do.
    """
    if not len(lengths):
        return CutBars(bar, 0, 0, np.zeros(0, np.int64))
    longest = int(np.argmax(lengths))
    if lengths[longest] > bar * (1 + SLACK):
        raise InputError(
            f"{what} is longer than what it is cut from",
            keys=(key,),
            got=plain(bar),
            expected=f"at least {plain(above(float(lengths[longest])))}",
            remedy="longer coils" if "tie" in key else "longer bars, or more rows or columns",
        )
    # A cut after every piece, and a bar that is longer by one: the last piece needs none.
    room = (bar + kerf) * (1 + SLACK)
    sizes = np.minimum(lengths + kerf, room)
    of = np.zeros(len(lengths), np.int64)
    left: list[tuple[float, int]] = []  # what is left of every bar, the least first
    count = 0
    order = np.argsort(-sizes, kind="stable")
    for piece, size in zip(order.tolist(), sizes[order].tolist(), strict=True):
        place = bisect_left(left, (size, -1))
        if place == len(left):
            rest, number = room, count
            count += 1
        else:
            rest, number = left.pop(place)
        of[piece] = number
        insort(left, (rest - size, number))
    return CutBars(bar, count, _least(sizes, room), of)


def _least(sizes: Array, room: float) -> int:
    """How few bars hold pieces of sizes (N,) at least."""
    ascending = np.sort(sizes)
    sums = np.concatenate([[0.0], np.cumsum(ascending)])
    half = np.searchsorted(ascending, 0.5 * room, side="right")
    # Pieces below a size are left out; those that leave no room for one of that size stand alone.
    starts = np.unique(ascending[:half], return_index=True)[1]
    starts = np.append(starts, half)
    smallest = np.append(ascending, room)[starts]
    alone = np.searchsorted(ascending, room - smallest, side="right")
    alone = np.maximum(alone, half)
    beside = (alone - half) * room - (sums[alone] - sums[half])
    rest = (sums[half] - sums[starts] - beside) / room
    more = np.maximum(np.ceil(rest * (1 - SLACK)), 0.0)
    return int((len(sizes) - half + more).max())
