"""The largest, the smallest and an order of floats, chosen alike by every machine.

Machines round the last digits differently, and of values that differ by these only a plain argmax
takes now one, now another. Here such values are equal, and the first of equals is taken. Whatever
names a place, chooses one of several or orders what is written asks these functions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike

from orishell.numerics.arrays import Array, Integers

NEAR = 1e-9
"""Values so near to each other, as a share of their size, are equal: a million roundings."""

SOLVED = 1e-6
"""Solutions of equations, which have fewer digits, are equal up to this share of their size."""

T = TypeVar("T")


def first_largest(values: ArrayLike, near: float = NEAR, size: float | None = None) -> int:
    """The number, in the order of the flattened array, of the first of the largest values.

    Parameters
    ----------
    values
        Floats of any shape, one at least. Of those that are no number the first is the largest,
        as to argmax.
    near
        Values that fall short of the largest by no more than this share of its size are equal.
    size
        What it is a share of: for differences, and where zero is a value, the size of what they
        are measured by. The largest value itself if it is left out.
    """
    flat = np.asarray(values, dtype=np.float64).ravel()
    best = flat[flat.argmax()]
    if not np.isfinite(best):
        return int(flat.argmax())
    within = near * (abs(best) if size is None else size)
    return int((flat >= best - within).argmax())


def first_smallest(values: ArrayLike, near: float = NEAR, size: float | None = None) -> int:
    """As :func:`first_largest`, of the smallest values."""
    return first_largest(-np.asarray(values, dtype=np.float64), near, size)


def classes(values: ArrayLike, near: float = NEAR, size: float | None = None) -> Integers:
    """Numbers (N,) of classes of values (N,), smallest first; neighbours so near are in one.

    Their size is the largest finite one if it is left out.
    """
    flat = np.asarray(values, dtype=np.float64)
    order = np.argsort(flat, kind="stable")
    ascending = flat[order]
    if size is None:
        size = float(np.abs(flat[np.isfinite(flat)]).max(initial=0.0))
    # Infinities of one sign are equal, as are those that are no number, which come last.
    with np.errstate(invalid="ignore"):
        apart = ~(np.diff(ascending) <= near * size) & (ascending[1:] != ascending[:-1])
    apart &= ~np.isnan(ascending[:-1])
    found = np.empty(len(flat), np.int64)
    found[order] = np.concatenate([[0], np.cumsum(apart)])[: len(flat)]
    return found


def ascending(values: ArrayLike, near: float = NEAR, size: float | None = None) -> Integers:
    """The numbers (N,) of values (N,), the smallest first, and equal ones as they stand."""
    return np.argsort(classes(values, near, size), kind="stable")


def descending(values: ArrayLike, near: float = NEAR, size: float | None = None) -> Integers:
    """The numbers (N,) of values (N,), the largest first, and equal ones as they stand."""
    return ascending(-np.asarray(values, dtype=np.float64), near, size)


def largest_of(items: Iterable[T], figure: Callable[[T], float], near: float = NEAR) -> T:
    """The first of the items, one at least, whose figure is the largest."""
    found = list(items)
    return found[first_largest([figure(each) for each in found], near)]


def smallest_of(items: Iterable[T], figure: Callable[[T], float], near: float = NEAR) -> T:
    """The first of the items, one at least, whose figure is the smallest."""
    found = list(items)
    return found[first_smallest([figure(each) for each in found], near)]


def largest_along_first(values: Array, near: float = NEAR) -> Integers:
    """Numbers (...,) along the first axis of the first of the largest values (N, ...), finite."""
    best = values.max(axis=0)
    return np.asarray((values >= best - near * np.abs(best)).argmax(axis=0))
