"""Numbers as messages quote them, and things as a prompt shows them."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import fields, is_dataclass
from pathlib import Path

import numpy as np

ROUNDING = 1e-3
"""Nearest values that work are quoted this share inside the limit."""
SHOWN = 60
"""Characters that a part may take in the line of the whole; else its type is shown."""


def in_degrees(angle: float) -> str:
    """Degrees to four decimals, as text.

    Parameters
    ----------
    angle
        The angle (radians).
    """
    return f"{np.rad2deg(angle):.4f}".rstrip("0").rstrip(".")


def tidy_degrees(angle: float) -> float:
    """Degrees without the last digits that the conversion leaves.

    Parameters
    ----------
    angle
        The angle (radians).
    """
    return float(f"{np.rad2deg(angle):.13g}")


def rounded(value: float, digits: int = 4) -> float:
    """A number rounded to as many digits as are worth typing.

    Parameters
    ----------
    value
        The number.
    digits
        Significant digits.
    """
    return float(f"{value:.{digits}g}")


def between(low: float, high: float, wanted: float) -> list[float]:
    """Values to try of an open interval: near its end next to a wanted value, farther in, midway.

    Parameters
    ----------
    low, high
        The interval.
    wanted
        The value that was asked for.
    """
    near, far = (low, high) if abs(wanted - low) <= abs(wanted - high) else (high, low)
    values = inside(near, far), inside(near, far, 0.1), 0.5 * (low + high)
    return [as_typed(value, lambda typed: low < typed < high) for value in values]


def as_typed(value: float, works: Callable[[float], bool], fewest: int = 4) -> float:
    """The value in as few digits as still work when they are typed in.

    Parameters
    ----------
    value
        The value.
    works
        Whether a value works.
    fewest
        Significant digits at least.
    """
    typed = (rounded(value, digits) for digits in range(fewest, 17))
    return next((each for each in typed if works(each)), value)


def rounded_down(value: float, digits: int = 4) -> float:
    """A positive number rounded down to as many digits as are worth typing.

    Parameters
    ----------
    value
        The number.
    digits
        Significant digits.
    """
    unit = 10.0 ** (np.floor(np.log10(value)) + 1 - digits)
    return rounded(float(np.floor(value / unit) * unit), digits)


def inside(limit: float, start: float, share: float = ROUNDING) -> float:
    """A value a little nearer to ``start`` than the limit, so that it still works when quoted.

    Parameters
    ----------
    limit
        What may not be reached.
    start
        A value that works.
    share
        How much nearer, as a share of the way from the limit to it.
    """
    return float(start + (limit - start) * (1 - share))


def in_one_line(thing: object) -> str:
    """A dataclass as a prompt shows it: numbers to six digits, arrays by their shape.

    It is the ``__repr__`` of what holds arrays; functions and what is private are left out.

    Parameters
    ----------
    thing
        The dataclass.
    """
    assert is_dataclass(thing)
    parts = {each.name: getattr(thing, each.name) for each in fields(thing) if each.repr}
    shown = (
        f"{name}={_short(part)}"
        for name, part in parts.items()
        if not name.startswith("_") and not callable(part)
    )
    return f"{type(thing).__name__}({', '.join(shown)})"


def _short(part: object) -> str:
    match part:
        case np.ndarray():
            text = f"array{part.shape}"
        case str():
            text = repr(part if len(part) < SHOWN - 1 else part[: SHOWN - 5] + "...")
        case float():
            text = f"{part:.6g}"
        case Path():
            text = repr(str(part))
        case tuple():
            text = f"({', '.join(map(_short, part))})"
        case _:
            text = repr(part)
    if len(text) <= SHOWN:
        return text
    size = len(part) if isinstance(part, Collection) and not isinstance(part, str) else "..."
    return f"{type(part).__name__}({size})"
