"""Where lines of nodes have to be, because plates that stand on edges of columns end there."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.numerics.arrays import Array

TOGETHER = 1e-6
"""Two stops that are nearer to each other, as shares of an edge, are one."""


@record
class Stops:
    """Where plates end that go up and down from vertices of some rows, by a share of edges."""

    rows: frozenset[int]  # rows of vertices
    share: float  # of edges above and below them

    def line(self, cells: int) -> int:
        """Which line of nodes is where they end, counted from their vertex."""
        half, lines = 0.5 * cells, np.arange(1, cells)
        beyond = lines > half if self.share > 0.5 else lines < half
        if abs(self.share - 0.5) < TOGETHER:
            beyond = lines == half
        if not beyond.any():
            raise InputError(
                "gussets end in the middle of edges, where there is no line of nodes",
                keys=("structure.cells", "stiffeners.share"),
                got=f"cells = {cells}, share = {self.share}",
                expected="an even number of cells, at least 4, or another share",
            )
        able = lines[beyond]
        return int(able[np.argmin(np.abs(able / cells - self.share))])

    def moved(self, down: Array) -> Array:
        """Lines of nodes (P, cells+1) of rows of panels, as shares of the way down, moved there."""
        if not self.rows:
            return down
        cells = down.shape[1] - 1
        line, found = self.line(cells), down.copy()
        for row in range(len(down)):
            stops = {0: 0.0, cells: 1.0}
            if row in self.rows:
                stops[line] = self.share
            if row + 1 in self.rows:
                stops[cells - line] = 1 - self.share
            at = sorted(stops)
            found[row] = np.interp(down[row], down[row, at], [stops[each] for each in at])
        return found


NO_STOPS = Stops(frozenset(), 0.5)


def stops_of(rows: Sequence[int], shares: Sequence[float]) -> Stops:
    """Where plates end: from vertices of rows, by shares of edges, all of which are the same."""
    if not rows:
        return NO_STOPS
    assert len(set(shares)) == 1, "plates go along edges by one share"
    return Stops(frozenset(rows), shares[0])
