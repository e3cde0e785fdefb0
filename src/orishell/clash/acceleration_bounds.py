"""Bounds of accelerations in parts of the path, which give the chord errors of the proof."""

from __future__ import annotations

from collections import OrderedDict

import numpy as np

from orishell.clash.broad_phase import Extents, PanelTree, in_chunks
from orishell.conventions.record import record
from orishell.motion import Mechanism
from orishell.motion.layout import Layout
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array, Integers

RANGES, LEVELS, TABLES_KEPT = 16, 3, 64
"""Ranges of the drive in a table, halvings of the path to the tables of its parts, tables kept."""
ROUNDED_UP = 1 + 1e-9
"""Factor on a bound, far above what the sums and products that make it may be rounded down by."""
SUMMED = 4 * float(np.finfo(np.float64).eps)
"""Rounding of a running sum, by the number of its terms and the last of it."""
FLATTEST = 1e-30
"""The area that two edges span counts as at least this share of the largest."""


class EdgeBounds:
    """Bounds of the accelerations of edges in any part of the path between two drives.

    A vector between two vertices is a sum of edges: along a row from one column to the other,
    then down a column. Its acceleration is at most the sum of their bounds, whichever row and
    column it takes. Shorter parts of the path have finer tables of bounds.
    """

    def __init__(
        self,
        mechanism: Mechanism,
        ends: tuple[float, float],
        tree: PanelTree,
        panels: Integers | None = None,
    ) -> None:
        """Bounds between nodes of a tree over panels, or over parts (N,) of ``panels``."""
        self.mechanism, self.ends = mechanism, ends
        self.layout = layout = Layout.of(mechanism)
        which = slice(None) if panels is None else panels
        first, last = (each[which].astype(float) for each in (layout.first, layout.last))
        self.hull = tree.enclosing(first, last)
        self.tables: OrderedDict[tuple[int, int], tuple[Array, Array]] = OrderedDict()

    def within(self, start: float, stop: float) -> RangeBounds:
        """The bounds from one share of the path to another, which are 1/2, 1/4, 1/8 ... apart."""
        halvings = round(-np.log2(stop - start))
        level = halvings - halvings % LEVELS
        parts = 2**level
        index = int(start * parts)
        rows, columns = self._table(level, index)
        part = slice(*(round((end * parts - index) * RANGES) for end in (start, stop)))
        steps = rows[part].max(axis=0), columns[part].max(axis=0)
        along, down = (Running.of(each) for each in steps)
        return RangeBounds(steps, along, down, self.hull, self.layout)

    def _table(self, level: int, index: int) -> tuple[Array, Array]:
        """Bounds along rows (RANGES, C-1) and down columns (RANGES, R-1) in one part."""
        table = self.tables.get((level, index))
        if table is None:
            start, end = self.ends
            drives = start + (end - start) * (index + np.linspace(0.0, 1.0, RANGES + 1)) / 2**level
            # The path may lead towards the flat sheet.
            ranges = np.sort([drives[:-1], drives[1:]], axis=0)
            rows, columns = self.mechanism.edge_accelerations(*ranges)
            # Where a family knows no bound there is none.
            table = _known(rows) * ROUNDED_UP, _known(columns) * ROUNDED_UP
            self.tables[level, index] = table
            if len(self.tables) > TABLES_KEPT:
                self.tables.popitem(last=False)
        return table


def _known(bounds: Array) -> Array:
    return np.where(np.isnan(bounds), np.inf, bounds)


class NormalBounds:
    """Bounds of the accelerations of the normals of panels, given in the flat sheet (V, 3).

    With edges u, v of a panel its normal n is u x v over a constant area A, and as u' u' = -u u''
    for a rigid edge,

        abs(n'') <= (sqrt(abs(u'') abs(v)) + sqrt(abs(v'') abs(u)))^2 / A.

    Flaps beside the grid have such bounds at the grid's vertex only: their hinge lies on an edge
    of the border.
    """

    def __init__(self, layout: Layout, flat: Array) -> None:
        # At corner 0, 1, 2, 3 the edge along a row is 3, 1, 1, 3, that down a column 0, 0, 2, 2.
        corners = flat[layout.faces]
        sides = np.roll(corners, -1, axis=-2) - corners
        row, column = sides[..., [3, 1, 1, 3], :], sides[..., [0, 0, 2, 2], :]
        area = lengths(np.cross(row, column))
        # At a corner of 180 degrees there is no bound, and the other corners give one.
        area = np.maximum(area, FLATTEST * area.max())
        self.along = np.sqrt(lengths(column) / area)
        self.down = np.sqrt(lengths(row) / area)
        self.layout = layout
        self.known = layout.faces < layout.grid.vertex_count

    def within(self, along: Array, down: Array) -> Array:
        """Bounds (..., F) for those of edges along rows (..., C-1) and down columns (..., R-1)."""
        row, column = self.layout.first.T[..., None]
        root = np.sqrt(along)[..., column] * self.along + np.sqrt(down)[..., row] * self.down
        found = np.asarray((root**2).min(axis=-1, initial=np.inf, where=self.known))
        return found if self.layout.parallel is None else found[..., self.layout.parallel]


@record
class Running:
    """Running sums (K+1,) of bounds (K,), of which some may be infinite."""

    finite: Array  # of those that are finite
    infinite: Integers  # numbers of those that are not
    rounding: float  # by how much a difference of two may be too small

    @classmethod
    def of(cls, bounds: Array) -> Running:
        """Those of bounds (K,), none of which is negative."""
        known = np.isfinite(bounds)
        finite = np.concatenate([[0.0], np.cumsum(np.where(known, bounds, 0.0))])
        infinite = np.concatenate([[0], np.cumsum(~known)])
        return cls(finite, infinite, SUMMED * len(finite) * float(finite[-1]))

    def between(self, begin: Integers, end: Integers) -> Array:
        """Sums (P,) of the bounds from some on and up to others (P,); 0 where these are the same.

        Large ones must not swallow small ones, nor infinite ones each other.
        """
        found = self.finite[end] - self.finite[begin] + self.rounding * (end > begin)
        if self.infinite[-1]:
            found[self.infinite[end] > self.infinite[begin]] = np.inf
        return np.asarray(found)


@record
class RangeBounds:
    """Bounds of accelerations of edges along rows and down columns in one part of the path."""

    steps: tuple[Array, Array]  # (C-1,) and (R-1,)
    along: Running  # of those along rows, by columns
    down: Running  # of those down columns, by rows
    hull: Extents  # vertex rows and columns of the nodes of a PanelTree
    layout: Layout

    def between_nodes(self, level: int, first: Integers, second: Integers) -> Array:
        """Bound (P,) of the acceleration of any vector between vertices of two nodes."""
        low, high = self.hull.low[level], self.hull.high[level]

        def of(first: Integers, second: Integers) -> Array:
            begin = np.minimum(low[first], low[second])
            end = np.maximum(high[first], high[second])
            # Nodes of empty places have no end; their gap is infinite anyway.
            begin, end = (np.where(np.isfinite(at), at, 0).astype(np.int64) for at in (begin, end))
            return self._across(begin.T, end.T)

        return in_chunks(of, first, second)

    def between_panels(self, first: Integers, second: Integers) -> Array:
        """Bound (P,) of the acceleration of any vector between vertices of two panels."""
        begin, end = self.layout.first, self.layout.last
        return self._across(
            np.minimum(begin[first], begin[second]).T, np.maximum(end[first], end[second]).T
        )

    def _across(self, begin: Integers, end: Integers) -> Array:
        """Bound (P,) between vertices at rows and columns (2, P): the sum of those of the edges."""
        return self.down.between(begin[0], end[0]) + self.along.between(begin[1], end[1])
