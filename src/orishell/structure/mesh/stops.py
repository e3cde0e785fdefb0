"""Where lines of nodes have to be, because something that stiffens a sheet ends, or hangs, there.

Plates that stand on edges of columns end at a share of these; strips of box girders hang on lines
that cut panels from a share of one edge to another share of the next. On both edges of a panel the
same line of its nodes is moved there, so that between them it is straight.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, pairwise

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers

TOGETHER = 1e-6
"""Two stops that are nearer to each other, as shares of an edge, are one."""
NONE = -1
"""The line of nodes of a row of panels where nothing ends."""


@record
class Stops:
    """Shares of edges of columns at which something ends that goes along them from a vertex."""

    # of edges (rows - 1, columns), from the vertex above it downwards, and from the vertex below it
    # upwards; NaN where nothing does
    down: Array
    up: Array
    # whether as many lines lie between a vertex and its stop in all rows, above and below it
    even: bool = False

    @classmethod
    def none(cls, grid: Grid) -> Stops:
        """No stops."""
        return cls(*np.full((2, grid.rows - 1, grid.columns), np.nan))

    @classmethod
    def of_plates(cls, grid: Grid, rows: Sequence[int], share: float) -> Stops:
        """Where plates end that go up and down from vertices of rows, by one share of edges."""
        found = cls.none(grid)
        found.down[list(rows)] = found.up[np.array(rows, np.int64) - 1] = share
        return cls(found.down, found.up, even=True)

    def lines(self, cells: int) -> Integers:
        """The line of nodes (rows - 1, 2) of each row of panels that is at its stops.

        That of stops from above, and that of stops from below, counted downwards.

        Raises InputError: If lines cross on a panel.
        """
        return np.array([self._of_row(row, cells) for row in range(len(self.down))])

    def _of_row(self, row: int, cells: int) -> tuple[int, int]:
        first, second = _filled(self.down[row]), 1 - _filled(self.up[row])
        there = ~np.isnan([first[0], second[0]])
        if self.even and there.any():
            share = float(first[0] if there[0] else 1 - second[0])
            line = plate_line(share, cells)
            return (line if there[0] else NONE, cells - line if there[1] else NONE)
        apart = second - first
        two = there.all() and np.abs(apart).max() >= TOGETHER
        _require_lines(cells, 2 if two else int(there.any()))
        places, lines = np.arange(1, cells) / cells, range(1, cells)
        if not there.all():
            near = [
                lines[int(np.argmin(np.abs(places - each.mean())))] if any_ else NONE
                for each, any_ in zip((first, second), there, strict=True)
            ]
            return near[0], near[1]
        if np.abs(apart).max() < TOGETHER:
            line = lines[int(np.argmin(np.abs(places - first.mean())))]
            return line, line
        if np.abs(np.sign(apart).sum()) < len(apart) or np.abs(apart).min() < TOGETHER:
            raise InputError(
                "strips of two box girders hang on the same panels, on lines that cross there",
                where=f"in row {row} of panels",
                keys=("stiffeners.share", "stiffeners.rows"),
                expected="rows that do not follow each other, or shares up to a half",
                remedy='rows = "valleys" in [stiffeners]',
            )
        means = np.sort([first.mean(), second.mean()])
        pairs = np.array(list(combinations(lines, 2)))
        low, high = pairs[np.argmin(((pairs / cells - means) ** 2).sum(axis=1))].tolist()
        return (low, high) if apart[0] > 0 else (high, low)

    def moved(self, down: Array) -> Array:
        """Lines of nodes (P, cells+1) of rows of panels, as shares of the way down, moved there.

        (P, columns, cells+1): those along every column.
        """
        count, cells = self.down.shape[1], down.shape[1] - 1
        found = np.repeat(down[:, None], count, axis=1)
        lines = self.lines(cells)
        for row in np.flatnonzero((lines != NONE).any(axis=1)):
            stops = {0: np.zeros(count), cells: np.ones(count)}
            for line, shares in zip(
                lines[row], (_filled(self.down[row]), 1 - _filled(self.up[row])), strict=True
            ):
                if line != NONE:
                    stops[int(line)] = shares
            at = sorted(stops)
            for begin, end in pairwise(at):
                own = down[row, begin : end + 1]
                part = (own - own[0]) / (own[-1] - own[0])
                first, last = stops[begin][:, None], stops[end][:, None]
                found[row, :, begin : end + 1] = first * (1 - part) + last * part
        return found


def _require_lines(cells: int, count: int) -> None:
    """Refuse cells with fewer lines of nodes between them than something hangs on."""
    if cells <= count:
        raise InputError(
            "strips of box girders hang on lines of nodes inside panels, and there are too few",
            keys=("structure.cells",),
            got=f"{cells}",
            expected=f"at least {count + 1}",
            remedy=f"cells = {count + 1} in [structure]",
        )


def _filled(shares: Array) -> Array:
    """Shares (columns,), where there is none that of the nearest column that has one."""
    known = np.flatnonzero(~np.isnan(shares))
    if not len(known):
        return shares
    return np.interp(np.arange(len(shares)), known, shares[known])


def plate_line(share: float, cells: int) -> int:
    """Which line of nodes is where plates end, counted from their vertex.

    share: Of edges above and below it.
    """
    half, lines = 0.5 * cells, np.arange(1, cells)
    beyond = lines > half if share > 0.5 else lines < half
    if abs(share - 0.5) < TOGETHER:
        beyond = lines == half
    if not beyond.any():
        raise InputError(
            "gussets end in the middle of edges, where there is no line of nodes",
            keys=("structure.cells", "stiffeners.share"),
            got=f"cells = {cells}, share = {share}",
            expected="an even number of cells, at least 4, or another share",
        )
    able = lines[beyond]
    return int(able[np.argmin(np.abs(able / cells - share))])
