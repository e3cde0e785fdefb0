"""The outcome of a test: its worst figure, the limit there, and the place."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from orishell.conventions.record import record
from orishell.io import FoldFile
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import NEAR, first_largest


@record
class Check:
    """The outcome of one test."""

    name: str  # the test, as in the report
    passed: bool  # whether everything is within its limit
    text: str  # what was found, in one line
    facts: dict[str, Any]  # the same for the report: ``worst``, ``limit``, ``frame`` and the place

    def as_dict(self) -> dict[str, Any]:
        """The fields of the report."""
        return {"passed": self.passed, "text": self.text, **self.facts}


@record
class Contacts:
    """Panels that touch in one frame."""

    frame: int  # the frame's number
    pairs: Integers  # numbers (P, 2) of the panels


class Place(NamedTuple):
    """What a figure belongs to, in words and in the report's fields."""

    words: str
    facts: dict[str, Any]

    def __str__(self) -> str:
        return self.words


class Worst:
    """The worst figure over all frames, measured against its limit, and where it is.

    Figures belong to what is named by a number.
    """

    def __init__(self, name: Callable[[int], Place]) -> None:
        self._name = name
        self._figure = self._limit = 0.0
        self._share = -math.inf
        self._frame = self._number = 0
        self._beyond: set[int] = set()

    def see(self, figures: Array, limits: Array, frame: int, numbers: Integers) -> None:
        """Take in figures (N,), their limits (N,) and the numbers (N,) of what they belong to."""
        if not len(figures):
            return
        with np.errstate(divide="ignore", over="ignore"):
            share = figures / np.maximum(limits, np.finfo(float).tiny)
        worst = first_largest(share)
        if share[worst] > self._share * (1 + NEAR):
            self._share, self._frame = float(share[worst]), frame
            self._figure, self._limit = float(figures[worst]), float(limits[worst])
            self._number = int(numbers[worst])
        self._beyond.update(numbers[figures > limits].tolist())

    def checks(self, test: str, says: str, kind: str) -> list[Check]:
        """The outcome of a test, if there was anything to measure.

        ``says`` is what is wrong, with braces for the figure; figures belong to things of a kind.
        """
        if self._share == -math.inf:
            return []
        beyond = len(self._beyond)
        others = f"; {beyond} {kind} beyond their limits" if beyond > 1 else ""
        place = self._name(self._number)
        facts = {
            "worst": self._figure,
            "limit": self._limit,
            "beyond": beyond,
            "frame": self._frame,
            **place.facts,
        }
        text = (
            f"{says.format(f'{self._figure:.1e}')} (limit {self._limit:.1e}), "
            f"{place} in frame {self._frame}{others}"
        )
        # Every figure is within its limit if none is beyond it.
        return [Check(test, not beyond, text, facts)]


class Names:
    """Panels, vertices and edges by their numbers and, on a grid, by row and column."""

    def __init__(self, file: FoldFile) -> None:
        self._mesh = file.mesh
        self._shape = file.grid_shape

    def panel(self, number: int) -> Place:
        """A panel, whose place is that of its first corner."""
        return self._named("panel", number, int(self._mesh.faces[number].min()))

    def vertex(self, number: int) -> Place:
        """A vertex."""
        return self._named("vertex", number, number)

    def edge(self, number: int) -> Place:
        """An edge by its vertices."""
        vertices = self._mesh.edges[number].tolist()
        return Place(f"edge {vertices[0]}-{vertices[1]}", {"edge": number, "vertices": vertices})

    def pair(self, panels: Integers) -> Place:
        """Two panels."""
        places = [self.panel(number) for number in panels.tolist()]
        words = " and ".join(place.words.removeprefix("panel ") for place in places)
        grid = {"grid": [place.facts["grid"] for place in places]} if self._shape else {}
        return Place(f"panels {words}", {"panels": panels.tolist(), **grid})

    def _named(self, kind: str, number: int, vertex: int) -> Place:
        words, facts = f"{kind} {number}", {kind: number}
        if not self._shape:
            return Place(words, facts)
        grid = list(divmod(vertex, self._shape[1]))
        return Place(f"{words} {grid}", {**facts, "grid": grid})
