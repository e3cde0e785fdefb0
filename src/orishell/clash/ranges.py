"""The search for the first contact: ranges of a path, halved where they leave something open."""

from __future__ import annotations

from collections.abc import Callable
from typing import Generic, TypeVar

from orishell.conventions.progress import Progress
from orishell.conventions.record import record

Left = TypeVar("Left")

TICKS = 1 << 36
"""Smallest steps along a path: a contact is found to this part of it."""
BASE = 8
"""Number of ranges into which the path is divided at first."""
LOOKING = "looking for contact"

Numbers = tuple[int, int]
"""Two panels, or two bodies."""


@record
class Outcome(Generic[Left]):
    """What is found in a range.

    Parameters
    ----------
    left
        What is to be looked at in both halves of it; None if all is proved apart.
    pair
        One of the pairs that are left, if there is any.
    at_start, at_stop
        Pairs that touch at its ends, if there are any: the nearest of them.
    """

    left: Left | None
    pair: Numbers | None
    at_start: Numbers | None
    at_stop: Numbers | None


def search_ranges(
    examine: Callable[[int, int, Left], Outcome[Left]], everything: Left, progress: Progress
) -> tuple[tuple[int, Numbers] | None, int]:
    """Work through the ranges of a path in their order, up to the first contact.

    Parameters
    ----------
    examine
        Looks at a range between two ticks.
    everything
        What it is to look at to begin with.

    Returns
    -------
    found
        Tick and pair of the first contact, or None.
    clear
        Everything is apart up to this tick.
    """
    step = TICKS // BASE
    stack = [(k * step, (k + 1) * step, everything) for k in reversed(range(BASE))]
    found: tuple[int, Numbers] | None = None
    clear = 0
    while stack:
        start, stop, pending = stack.pop()
        if found is not None and start >= found[0]:
            break
        # Ranges may be many that bring it no further: it is heard of, and can be ended, at each.
        progress(clear / TICKS, LOOKING)
        outcome = examine(start, stop, pending)
        if outcome.at_start is not None:
            found = (start, outcome.at_start)
            break
        if outcome.at_stop is not None:
            found = (stop, outcome.at_stop)
        if outcome.left is None:
            clear = stop
        elif stop - start == 1 and outcome.pair is not None:
            found = (stop, outcome.pair)
            break
        else:
            middle = (start + stop) // 2
            stack.append((middle, stop, outcome.left))
            stack.append((start, middle, outcome.left))
    progress(1.0, LOOKING)
    return found, clear
