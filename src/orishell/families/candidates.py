"""Changes to the design file that are worth trying after a refusal (not in the paper)."""

from __future__ import annotations

from collections.abc import Iterator

from orishell.conventions.errors import Remedy
from orishell.conventions.formatting import ROUNDING, between, rounded, tidy_degrees
from orishell.curves import Curve

FARTHER = (1 + ROUNDING, 1.1, 1.4, 2.0)
"""Sizes of a curve are tried beyond their limit by these factors."""


def values(key: str, low: float, high: float, wanted: float) -> Iterator[Remedy]:
    """Values of a key to try, within an open interval; none if it is empty.

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
    """Values of an angle to try, as :func:`values` gives them.

    Parameters
    ----------
    key
        A key of the table [pattern] that is in degrees.
    low, high, wanted
        The interval and what was asked for (radians).
    """
    yield from values(key, tidy_degrees(low), tidy_degrees(high), tidy_degrees(wanted))


def sizes(name: str, curve: Curve, factor: float) -> Iterator[Remedy]:
    """Sizes of a curve to try, beyond a limit that it must not reach.

    Parameters
    ----------
    name
        "f" or "g".
    factor
        How many times larger the curve would be at the limit: below 1 it must become smaller.
    """
    for farther in FARTHER:
        share = factor / farther if factor < 1 else factor * farther
        yield Remedy({f"target.{name}.scale": curve.scale_times(share)})


def part(name: str, curve: Curve, start: float, stop: float) -> Remedy:
    """The change that keeps only a part of a curve.

    Parameters
    ----------
    name
        "f" or "g".
    start, stop
        Its parameters.
    """
    low, high = curve.drawn_part(start, stop)
    return Remedy({f"target.{name}.{curve.key}": [rounded(low, 6), rounded(high, 6)]})


def fewer(key: str, count: int) -> Iterator[Remedy]:
    """Smaller odd numbers of rows or columns to try.

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
