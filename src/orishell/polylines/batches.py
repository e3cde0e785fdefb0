"""Several searches at a time, so that all their questions to a curve are answered at once."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from typing import TypeVar

import numpy as np

from orishell.numerics.arrays import Array

T = TypeVar("T")

Search = Generator[Array, tuple[Array, Array], T]
"""Yields points (P, 2), is sent the nearest points (P, 2) of a curve and the distances (P,)."""


def batched(searches: Sequence[Search[T]]) -> Search[list[T]]:
    """Join searches into one, which asks the questions of all of them together."""
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


def rotated_search(search: Search[T], angle: float) -> Search[T]:
    """Make a search of a curve turned by an angle (radians) ask the curve that is not turned."""
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


def run_search(search: Search[T], nearest: Callable[[Array], tuple[Array, Array]]) -> T:
    """Run a search to its end; ``nearest`` answers it, and what it finds is returned."""
    try:
        points = next(search)
        while True:
            points = search.send(nearest(points))
    except StopIteration as end:
        found: T = end.value
        return found
