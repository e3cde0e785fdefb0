"""Searches that go on in step, so that what all of them ask of a curve is answered at once."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from typing import TypeVar

import numpy as np

from orishell.curves.jets import Array

T = TypeVar("T")

Search = Generator[Array, tuple[Array, Array], T]
"""Yields points (P, 2), is sent the nearest points (P, 2) of a curve and the distances (P,)."""


def in_step(searches: Sequence[Search[T]]) -> Search[list[T]]:
    """Several searches as one."""
    found: dict[int, T] = {}
    answers: dict[int, tuple[Array, Array] | None] = dict.fromkeys(range(len(searches)))
    while True:
        asked: dict[int, Array] = {}
        for k, answer in answers.items():
            try:
                asked[k] = next(searches[k]) if answer is None else searches[k].send(answer)
            except StopIteration as end:
                found[k] = end.value
        if not asked:
            return [found[k] for k in range(len(searches))]
        feet, distances = yield np.concatenate(list(asked.values()))
        ends = np.cumsum([len(points) for points in asked.values()])[:-1]
        parts = zip(np.split(feet, ends), np.split(distances, ends), strict=True)
        answers = dict(zip(asked, parts, strict=True))


def turned(search: Search[T], angle: float) -> Search[T]:
    """A search of a curve that is turned by an angle (radians), as one of the curve unturned."""
    cos, sin = np.cos(angle), np.sin(angle)
    turn = np.array([[cos, sin], [-sin, cos]])
    try:
        points = next(search)
        while True:
            feet, distances = yield points @ turn.T
            points = search.send((feet @ turn, distances))
    except StopIteration as end:
        found: T = end.value
        return found


def answered(search: Search[T], nearest: Callable[[Array], tuple[Array, Array]]) -> T:
    """What a search finds.

    Parameters
    ----------
    search
        The search.
    nearest
        Answers it: the points (P, 2) of the curve nearest to points (P, 2), and their distances.
    """
    try:
        points = next(search)
        while True:
            points = search.send(nearest(points))
    except StopIteration as end:
        found: T = end.value
        return found
