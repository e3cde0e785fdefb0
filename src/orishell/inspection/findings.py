"""What a test finds: its figure, the limit, and the place of the worst."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from orishell.io import FoldFile
from orishell.quoting import in_one_line

Array = NDArray[np.float64]
Integers = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
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

    __repr__ = in_one_line

    def as_dict(self) -> dict[str, Any]:
        """The fields of the report."""
        return {"passed": self.passed, "text": self.text, **self.facts}


@dataclass(frozen=True, slots=True, eq=False)
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

    __repr__ = in_one_line


class Worst:
    """The figure that takes most of its limit, over all frames, and where it is."""

    def __init__(self) -> None:
        self.figure = 0.0
        self.limit = 0.0
        self.share = -math.inf
        self.frame = 0
        self.number = 0
        self.beyond: set[int] = set()

    @property
    def passed(self) -> bool:
        """Whether every figure is within its limit."""
        return not self.beyond

    @property
    def seen(self) -> bool:
        """Whether there was anything to measure."""
        return self.share > -math.inf

    def see(self, figures: Array, limits: Array, frame: int, numbers: Integers) -> None:
        """Take in figures (N,), their limits (N,) and the numbers (N,) of what they belong to."""
        if not len(figures):
            return
        with np.errstate(divide="ignore", over="ignore"):
            share = figures / np.maximum(limits, np.finfo(float).tiny)
        worst = int(np.argmax(share))
        if share[worst] > self.share:
            self.share, self.frame = float(share[worst]), frame
            self.figure, self.limit = float(figures[worst]), float(limits[worst])
            self.number = int(numbers[worst])
        self.beyond.update(numbers[figures > limits].tolist())

    def others(self, kind: str) -> str:
        """How many more are beyond their limit, as text."""
        return f"; {len(self.beyond)} {kind} beyond their limits" if len(self.beyond) > 1 else ""


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
        """Two panels."""
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
