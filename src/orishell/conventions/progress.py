"""Reporting the progress of work that takes time."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TypeVar

Progress = Callable[[float, str], None]
"""Called with the share of the work that is done, from 0 to 1, and with what the work is."""


def no_progress(share: float, what: str) -> None:
    """Report no progress: the default where nobody watches.

    Parameters
    ----------
    share
        The share that is done.
    what
        What is being done.
    """


def stretch(progress: Progress, start: float, stop: float) -> Progress:
    """Report the progress of a part of some work as that of the whole.

    Parameters
    ----------
    progress
        Is told of the whole.
    start, stop
        Where the part begins and ends, as shares of the whole.
    """
    return lambda share, what: progress(start + share * (stop - start), what)


T = TypeVar("T")


def followed(items: Iterable[T], count: int, progress: Progress, what: str) -> Iterator[T]:
    """Pass items on, and report what share of them is done.

    Parameters
    ----------
    items
        The things.
    count
        How many they are.
    what
        What is being done with them.
    """
    for number, item in enumerate(items, start=1):
        yield item
        progress(number / count, what)
