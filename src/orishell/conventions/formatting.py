"""Numbers as messages quote them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

INSIDE_LIMIT = 1e-3
"""A value is quoted this share inside the limit that was found, so that it works in few digits."""


def in_degrees(angle: float) -> str:
    """Degrees to four decimals, as text, of an angle in radians."""
    return f"{np.rad2deg(angle):.4f}".rstrip("0").rstrip(".")


def tidy_degrees(angle: float) -> float:
    """Degrees of an angle in radians, without the last digits that the conversion leaves."""
    return float(f"{np.rad2deg(angle):.13g}")


def rounded(value: float, digits: int = 4) -> float:
    """A number rounded to as many significant digits as are worth typing."""
    return float(f"{value:.{digits}g}")


def between(low: float, high: float, wanted: float) -> list[float]:
    """Values to try of an open interval: near its end next to a wanted value, inside, midway."""
    near, far = (low, high) if abs(wanted - low) <= abs(wanted - high) else (high, low)
    values = inside(near, far), inside(near, far, 0.1), 0.5 * (low + high)
    return [as_typed(value, lambda typed: low < typed < high) for value in values]


def as_typed(value: float, works: Callable[[float], bool], fewest: int = 4) -> float:
    """The value in as few digits as still work when they are typed in, at least ``fewest``."""
    typed = (rounded(value, digits) for digits in range(fewest, 17))
    return next((each for each in typed if works(each)), value)


def rounded_down(value: float, digits: int = 4) -> float:
    """A positive number rounded down to as many significant digits as are worth typing."""
    unit = 10.0 ** (np.floor(np.log10(value)) + 1 - digits)
    return rounded(float(np.floor(value / unit) * unit), digits)


def inside(limit: float, start: float, share: float = INSIDE_LIMIT) -> float:
    """A value a little nearer to ``start`` than the limit, so that it still works when quoted."""
    return float(start + (limit - start) * (1 - share))
