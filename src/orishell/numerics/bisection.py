"""Bisection: the place where a condition begins to fail, from one side of it."""

from __future__ import annotations

from collections.abc import Callable


def bisect(
    works: Callable[[float], bool],
    good: float,
    bad: float,
    *,
    relative: float = 1e-4,
    absolute: float = 0.0,
) -> float:
    """Return the working value nearest to ``bad``, which does not work; ``good`` does.

    Their distance is halved until it is at most ``relative`` times the working value, plus
    ``absolute``. One of the two must be positive.
    """
    while abs(bad - good) > relative * abs(good) + absolute:
        middle = 0.5 * (good + bad)
        good, bad = (middle, bad) if works(middle) else (good, middle)
    return good


def bisect_integers(works: Callable[[int], bool], good: int, bad: int) -> int:
    """Return the working whole number nearest to ``bad``, which does not work; ``good`` does."""
    while abs(bad - good) > 1:
        middle = (good + bad) // 2
        good, bad = (middle, bad) if works(middle) else (good, middle)
    return good


def largest_below(
    works: Callable[[float], bool], bad: float, *, smallest: float, relative: float = 1e-3
) -> float | None:
    """Return the largest working value below ``bad``, which does not work, or None if none is.

    Down to the share ``smallest`` of it, and to within ``relative`` of the largest.
    """
    least, good = smallest * bad, 0.5 * bad
    while not works(good):
        good, bad = 0.5 * good, good
        if good <= least:
            return None
    return bisect(works, good, bad, relative=relative)
