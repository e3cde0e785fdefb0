"""Bars and coils cut to length: one-dimensional nesting, and how few there could be.

Pieces go, the longest first, to the bar that they fill best; a saw takes its cut between two of
them. A piece that is longer than a bar is made of whole bars, end to end, and a rest. How few there
are at least is known from Martello and Toth's bound (Knapsack Problems, 1990, section 8.3.2):
pieces longer than half a bar have one each, and what those leave room for is taken off the sum of
the others. Pieces that are longer than a bar may be divided anywhere: of them only the sum counts.
"""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Iterator

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import classes, descending
from orishell.workshop.fitting import above

SLACK = 1e-9
"""A piece fits if it is no longer than the bar by more than this share of it."""


@record
class CutBars:
    """Bars that pieces (N,) are cut from, numbered from 0."""

    bar: float  # length of one
    count: int  # how many there are
    least: int  # how few there are at least, whichever way they are cut
    of: Integers  # the bar (N,) of every piece, or of the rest of one that is longer
    # how many whole bars (N,) lie end to end before that, and the first of these
    whole: Integers
    first: Integers

    def names(self) -> Iterator[str]:
        """The bars of every piece, counted from 1: "7", "2, 7", "2 to 4, 7"."""
        each = self.first.tolist(), self.whole.tolist(), self.of.tolist()
        for first, whole, of in zip(*each, strict=True):
            ends = dict.fromkeys((first + 1, first + whole)) if whole else {}
            yield " to ".join(map(str, ends)) + (", " if whole else "") + str(of + 1)


def cut_bars(
    lengths: Array, bar: float, kerf: float, key: str, what: str, *, most: int = 1
) -> CutBars:
    """Cut pieces of lengths (N,) from bars of one length.

    Parameters
    ----------
    kerf
        What is lost between two pieces (length).
    key
        Where the design file has the length of bars.
    what
        What the longest piece is called in a refusal.
    most
        Of how many bars, end to end, a piece may be made.

    Raises
    ------
    InputError
        If a piece is longer than that; says what would do.
    """
    longest = float(lengths.max(initial=0.0))
    if longest > most * bar * (1 + SLACK):
        times = "" if most == 1 else f"{most} times as long as "
        raise InputError(
            f"{what} is longer than {times}what it is cut from",
            keys=(key,),
            got=plain(bar),
            expected=f"at least {plain(above(longest / most))}",
            remedy="longer coils" if "tie" in key else "longer bars, or more rows or columns",
        )
    whole = np.maximum(np.ceil(lengths / bar * (1 - SLACK)) - 1, 0).astype(np.int64)
    first = np.cumsum(whole) - whole
    # A cut after every piece, and a bar that is longer by one: the last piece needs none.
    room = (bar + kerf) * (1 + SLACK)
    sizes = np.minimum(lengths - whole * bar + kerf, room)
    # Equal pieces fit into equal remainders, however they were rounded.
    alike = classes(sizes, size=room)
    largest = np.zeros(len(sizes))
    np.maximum.at(largest, alike, sizes)
    sizes = largest[alike]
    of = np.zeros(len(lengths), np.int64)
    left: list[tuple[float, int]] = []  # what is left of every bar, the least first
    count = int(whole.sum())
    order = descending(sizes)
    for piece, size in zip(order.tolist(), sizes[order].tolist(), strict=True):
        place = bisect_left(left, (size, -1))
        if place == len(left):
            rest, number = room, count
            count += 1
        else:
            rest, number = left.pop(place)
        of[piece] = number
        insort(left, (rest - size, number))
    least = fewest_bars(sizes[whole == 0], room)
    if whole.any():
        least = max(least, int(np.ceil(float(lengths.sum()) / bar * (1 - SLACK))))
    return CutBars(bar, count, least, of, whole, first)


def fewest_bars(sizes: Array, room: float) -> int:
    """How few bars hold pieces of sizes (N,) at least: the bound of Martello and Toth."""
    if not len(sizes):
        return 0
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
