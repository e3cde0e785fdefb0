"""The outcome of a test: its worst figure, the limit there, and the place."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from orishell.conventions.record import record
from orishell.io import FoldFile
from orishell.numerics.arrays import Array, Integers


@record
class Check:
    """The outcome of one test.

    Parameters
    ----------
    name
        The test, as in the report.
    passed
        Whether everything is within its limit.
    text
        What was found, in one line.
    facts
        The same for the report: ``worst``, ``limit``, ``frame`` and the place.
    """

    name: str
    passed: bool
    text: str
    facts: dict[str, Any]

    def as_dict(self) -> dict[str, Any]:
        """The fields of the report."""
        return {"passed": self.passed, "text": self.text, **self.facts}


@record
class Contacts:
    """Panels that touch in one frame.

    Parameters
    ----------
    frame
        The frame's number.
    pairs
        Numbers (P, 2) of the panels.
    """

    frame: int
    pairs: Integers


class Worst:
    """The worst figure over all frames, measured against its limit, and where it is.

    ``name`` and ``place`` say what a figure belongs to, by its number: in words, in the report.
    """

    def __init__(self, name: Callable[[int], str], place: Callable[[int], dict[str, Any]]) -> None:
        self._name, self._place = name, place
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
        worst = int(np.argmax(share))
        if share[worst] > self._share:
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
        facts = {
            "worst": self._figure,
            "limit": self._limit,
            "beyond": beyond,
            "frame": self._frame,
            **self._place(self._number),
        }
        text = (
            f"{says.format(f'{self._figure:.1e}')} (limit {self._limit:.1e}), "
            f"{self._name(self._number)} in frame {self._frame}{others}"
        )
        # Every figure is within its limit if none is beyond it.
        return [Check(test, not beyond, text, facts)]


class Names:
    """Panels, vertices and edges as a report names them."""

    def __init__(self, file: FoldFile) -> None:
        self._mesh = file.mesh
        self._shape = file.grid_shape

    def panel(self, number: int) -> str:
        """A panel by its number and, on a grid, by row and column."""
        return f"panel {number}{self._bracket(self.panel_place(number))}"

    def vertex(self, number: int) -> str:
        """A vertex by its number and, on a grid, by row and column."""
        return f"vertex {number}{self._bracket(self.vertex_place(number))}"

    def edge(self, number: int) -> str:
        """An edge by its vertices."""
        first, second = self._mesh.edges[number]
        return f"edge {first}-{second}"

    def panel_place(self, number: int) -> dict[str, Any]:
        """The report's fields for a panel."""
        return {"panel": number, **self._grid(int(self._mesh.faces[number].min()))}

    def vertex_place(self, number: int) -> dict[str, Any]:
        """The report's fields for a vertex."""
        return {"vertex": number, **self._grid(number)}

    def edge_place(self, number: int) -> dict[str, Any]:
        """The report's fields for an edge."""
        return {"edge": number, "vertices": self._mesh.edges[number].tolist()}

    def pair(self, panels: Integers) -> str:
        """Two panels by their numbers and, on a grid, by row and column."""
        first, second = (f"{n}{self._bracket(self.panel_place(n))}" for n in panels.tolist())
        return f"panels {first} and {second}"

    def pair_place(self, panels: Integers) -> dict[str, Any]:
        """The report's fields for two panels."""
        places = [self.panel_place(number) for number in panels.tolist()]
        grid = {"grid": [place["grid"] for place in places]} if self._shape else {}
        return {"panels": panels.tolist(), **grid}

    def _grid(self, vertex: int) -> dict[str, Any]:
        return {"grid": list(divmod(vertex, self._shape[1]))} if self._shape else {}

    def _bracket(self, place: dict[str, Any]) -> str:
        return f" {place['grid']}" if "grid" in place else ""
