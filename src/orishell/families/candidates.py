"""What a refusal leaves open, in keys of the design file: values worth a try (not in the paper)."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from orishell.curves import Curve
from orishell.errors import Remedy
from orishell.quoting import ROUNDING, between, rounded, tidy_degrees

FARTHER = (1 + ROUNDING, 1.1, 1.4, 2.0)
"""How far beyond a limit that a curve's size must not reach sizes are tried."""


def values(key: str, low: float, high: float, wanted: float) -> Iterator[Remedy]:
    """Values of an open interval, none if it is empty.

    Parameters
    ----------
    key
        A key of the table [pattern].
    low, high
        The interval, in the unit of the file.
    wanted
        What was asked for.
    """
    if low < high:
        yield from (Remedy({f"pattern.{key}": value}) for value in between(low, high, wanted))


def angles(key: str, low: float, high: float, wanted: float) -> Iterator[Remedy]:
    """The same for angles in radians.

    Parameters
    ----------
    key
        A key of the table [pattern] that is in degrees.
    low, high, wanted
        The interval and what was asked for (radians).
    """
    yield from values(key, tidy_degrees(low), tidy_degrees(high), tidy_degrees(wanted))


def sizes(name: str, curve: Curve, factor: float) -> Iterator[Remedy]:
    """Sizes of a curve beyond a limit.

    Parameters
    ----------
    name
        "f" or "g".
    curve
        The curve.
    factor
        How many times larger the curve would be at the limit: below 1 it must become smaller.
    """
    for farther in FARTHER:
        share = factor / farther if factor < 1 else factor * farther
        yield Remedy({f"target.{name}.scale": rounded(share * curve.scale)})


def part(name: str, curve: Curve, start: float, stop: float) -> Remedy:
    """A part of a curve.

    Parameters
    ----------
    name
        "f" or "g".
    curve
        The curve.
    start, stop
        Its parameters.
    """
    low, high = curve.drawn_part(start, stop)
    return Remedy({f"target.{name}.{curve.key}": [rounded(low, 6), rounded(high, 6)]})


def fewer(key: str, count: int) -> Iterator[Remedy]:
    """Smaller odd numbers of rows or columns.

    Parameters
    ----------
    key
        "rows" or "columns".
    count
        Their number.
    """
    while count > 3:
        count = count // 4 * 2 + 1
        yield Remedy({f"pattern.{key}": count})


def bisect(good: float, bad: float, works: Callable[[float], bool]) -> float:
    """The value nearest to one that does not work that does, to a ten-thousandth of itself.

    Parameters
    ----------
    good, bad
        A value that works, and one that does not.
    works
        Whether a value works.
    """
    while abs(bad - good) > 1e-4 * abs(good):
        middle = 0.5 * (good + bad)
        good, bad = (middle, bad) if works(middle) else (good, middle)
    return good
