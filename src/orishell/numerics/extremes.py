"""The first of the largest or least values: equal ones are told apart by number, not by rounding.

What is worst, nearest or best is often so in several places at once, as a shell is symmetric.
Processors round differently, so that the largest of such values is here one and there another;
the first of those that are equal but for rounding is the same everywhere.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from orishell.numerics.arrays import Array

ALIKE = 1e-9
"""Values that differ by less than this share of the largest size are equal but for rounding."""


def first_largest(values: ArrayLike) -> int:
    """Number of the first value that none exceeds by more than rounding, counted through.

    Sizes that are not finite do not count in the share that is rounding.
    """
    numbers = np.asarray(values, dtype=float).ravel()
    top = numbers.max()
    if not np.isfinite(top):
        return int(numbers.argmax())
    return int(np.argmax(numbers >= top - _rounding(numbers)))


def first_least(values: ArrayLike) -> int:
    """Number of the first value that exceeds none by more than rounding, counted through."""
    return first_largest(-np.asarray(values, dtype=float))


def _rounding(numbers: Array) -> float:
    sizes = np.abs(numbers[np.isfinite(numbers)])
    return ALIKE * float(sizes.max(initial=0.0))
