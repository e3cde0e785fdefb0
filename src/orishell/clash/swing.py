"""How far panels can stray from the straight line between two states: the bound of the proof."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from orishell.clash.tree import Extents, Integers, PanelTree, in_chunks
from orishell.motion import Mechanism

Array = NDArray[np.float64]

RANGES = 32
"""Ranges of the drive that a table of accelerations has."""
LEVELS = 3
"""Halvings of the path from one table to those of its parts."""
TABLES_KEPT = 64
ROUNDING = 1 + 1e-9


class Swing:
    """Bounds of the accelerations of edges in any part of a path.

    A vector between two vertices is a sum of edges: along a row from one column to the other,
    then down a column. Its acceleration is at most the sum of their bounds, whichever row and
    column it takes. Tables of bounds are made for the parts of the path that are looked at, finer
    where these are finer.

    Parameters
    ----------
    mechanism
        The folding sheet.
    end
        The path goes from the flat sheet to this drive (radians).
    tree
        The tree over its panels, row by row.
    """

    def __init__(self, mechanism: Mechanism, end: float, tree: PanelTree) -> None:
        self.mechanism, self.end = mechanism, end
        self.columns = mechanism.grid.columns - 1
        first = np.stack(np.divmod(np.arange(len(tree.faces)), self.columns), axis=-1)
        self.hull = tree.gathered(first.astype(np.float64), first + 1.0)
        self.tables: OrderedDict[tuple[int, int], tuple[Array, Array]] = OrderedDict()

    def between(self, start: float, stop: float) -> Bound:
        """The bound in a part of the path, from one share to another: a half of a half of it."""
        halvings = round(-np.log2(stop - start))
        level = halvings - halvings % LEVELS
        parts = 2**level
        index = int(start * parts)
        rows, columns = self._table(level, index)
        part = slice(
            round((start * parts - index) * RANGES), round((stop * parts - index) * RANGES)
        )
        return Bound(
            _running(rows[part].max(axis=0)),
            _running(columns[part].max(axis=0)),
            self.hull,
            self.columns,
        )

    def _table(self, level: int, index: int) -> tuple[Array, Array]:
        """Bounds along rows (RANGES, C-1) and down columns (RANGES, R-1) in one part."""
        table = self.tables.get((level, index))
        if table is None:
            ends = self.end * (index + np.linspace(0.0, 1.0, RANGES + 1)) / 2**level
            rows, columns = self.mechanism.edge_accelerations(ends[:-1], ends[1:])
            table = rows * ROUNDING, columns * ROUNDING
            self.tables[level, index] = table
            if len(self.tables) > TABLES_KEPT:
                self.tables.popitem(last=False)
        return table


@dataclass(frozen=True, slots=True, eq=False)
class Bound:
    """Bounds in one part of the path.

    Parameters
    ----------
    along, down
        Running sums of the bounds of edges along rows (C,) and down columns (R,).
    hull
        First and last vertex row and column of the nodes of a :class:`PanelTree`.
    columns
        Number of columns of panels.
    """

    along: Array
    down: Array
    hull: Extents
    columns: int

    def accelerations(self, level: int, first: Integers, second: Integers) -> Array:
        """Bound (P,) of the acceleration of any vector between two nodes."""
        low, high = self.hull.low[level], self.hull.high[level]

        def of(first: Integers, second: Integers) -> Array:
            begin = np.minimum(low[first], low[second])
            end = np.maximum(high[first], high[second])
            # Nodes of empty places have no end; their gap is infinite anyway.
            begin, end = (np.where(np.isfinite(at), at, 0).astype(np.int64) for at in (begin, end))
            return np.asarray(
                self.down[end[:, 0]]
                - self.down[begin[:, 0]]
                + self.along[end[:, 1]]
                - self.along[begin[:, 1]]
            )

        return in_chunks(of, first, second)

    def within(self, level: int, nodes: Integers) -> Array:
        """Bound (P,) of the acceleration of any vector within a node."""
        return self.accelerations(level, nodes, nodes)

    def of_panels(self, first: Integers, second: Integers) -> Array:
        """Bound (P,) of the acceleration of any vector between two panels."""
        (i, j), (k, m) = np.divmod(first, self.columns), np.divmod(second, self.columns)
        return np.asarray(
            self.down[np.maximum(i, k) + 1]
            - self.down[np.minimum(i, k)]
            + self.along[np.maximum(j, m) + 1]
            - self.along[np.minimum(j, m)]
        )


def _running(steps: Array) -> Array:
    return np.concatenate([[0.0], np.cumsum(steps)])
