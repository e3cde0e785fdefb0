"""A cache of results for the last few curves, since searches ask the same again and again."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, partial, wraps
from threading import Lock
from typing import Concatenate, ParamSpec, TypeVar

C = TypeVar("C")
P = ParamSpec("P")
R = TypeVar("R")

CURVES, RESULTS = 4, 64
"""How many curves each function remembers, and results for each: bounds the memory."""


def remembered(function: Callable[Concatenate[C, P], R]) -> Callable[Concatenate[C, P], R]:
    """Keep what a function of a curve returns, for the last few curves.

    Curves are told apart by identity; further arguments must be hashable, results are shared and
    not to be changed.

    Parameters
    ----------
    function
        Its first argument is a curve, or a trace.
    """
    kept: dict[C, Callable[..., R]] = {}
    lock = Lock()

    @wraps(function)
    def asked(curve: C, /, *args: P.args, **kwargs: P.kwargs) -> R:
        with lock:
            if curve not in kept:
                kept[curve] = lru_cache(RESULTS)(partial(function, curve))
            answers = kept.pop(curve)
            kept[curve] = answers  # the last one asked about is the last to go
            if len(kept) > CURVES:
                del kept[next(iter(kept))]
        return answers(*args, **kwargs)

    return asked
