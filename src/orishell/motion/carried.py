"""Strips of panels that a folding sheet carries: each stays parallel to a row of its panels.

A line of vertices goes from a row of the sheet's, at vertex p_ij of row i in column j, along shares
of edges e_kj = p_k+1,j - p_kj down the columns:

    x_j = p_ij + sum_t s_tj e_kt,j,

or lies straight above or below that by a height that stays.

Where every next line of a strip is farther by a positive share of the edges of one row k of panels,
and its creases are positive multiples of those of that row, its panels are as rigid as the sheet's
are, and parallel to those of row k in all states. So a strip is a folding sheet of its own: its
fold angles are the sheet's, added up over the rows between those that its panels are parallel to,
and its edges accelerate as multiples of the sheet's. Sleeves over a row are such strips, and so are
a second skin and the walls between both.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.motion.flap_free import FlapFree
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.on_sheet import OnSheet
from orishell.numerics.arrays import Array, Integers


@record
class Lines:
    """Lines (K,) of vertices over columns (n,) of a sheet, along edges of these."""

    columns: slice  # of vertices of the sheet, at least 2
    rows: Integers  # rows (K,) of vertices of the sheet that they go from
    edges: Integers  # rows (T, K) of panels of the sheet along whose edges they go on
    shares: Array  # of these edges (T, K, n)
    up: Array | None = None  # by how much (K,) they lie above that; None: in it (length)

    def carried(self, points: Array) -> Array:
        """Positions (..., K, n, 3) of their vertices on vertices (..., rows, columns, 3)."""
        over = points[..., self.columns, :]
        found = over[..., self.rows, :, :]
        for edges, shares in zip(self.edges, self.shares[..., None], strict=True):
            found = found + shares * (over[..., edges + 1, :, :] - over[..., edges, :, :])
        if self.up is not None:
            found[..., 2] += self.up[:, None]
        return np.asarray(found)

    def volumes(self, points: Array) -> Array:
        """Volumes (..., n-1) of a cavity between its columns, if they go around it in order.

        Its sides are plane, and so are its sections along columns.
        """
        ring = self.carried(points)
        near, far = ring[..., :-1, :], ring[..., 1:, :]
        near, far = near - ring[..., :1, :-1, :], far - ring[..., :1, :-1, :]
        after, beyond = (np.roll(each, -1, axis=-3) for each in (near, far))
        # Two triangles of each side, and those of the farther end from its first corner; the nearer
        # end is in one plane with the origin.
        sides = (near, after, beyond), (near, beyond, far), (far[..., :1, :, :], far, beyond)
        total = sum((one * np.cross(two, three)).sum(axis=(-3, -1)) for one, two, three in sides)
        return np.asarray(np.abs(total) / 6)

    @classmethod
    def joined(cls, several: list[Lines]) -> Lines:
        """All of several over the same columns, one after the other."""
        ups = [np.zeros(len(each.rows)) if each.up is None else each.up for each in several]
        return cls(
            several[0].columns,
            np.concatenate([each.rows for each in several]),
            np.concatenate([each.edges for each in several], axis=1),
            np.concatenate([each.shares for each in several], axis=1),
            None if all(each.up is None for each in several) else np.concatenate(ups),
        )


@record
class Hanging:
    """Where a line of vertices hangs on a row of panels."""

    line: int  # of the strip that hangs there
    part: int  # 0: the sheet; k: strip k of those that it carries
    panels: int  # the row of panels of that part
    parallel: int  # the row of panels of the sheet that these are parallel to
    at: Array  # how far down the edges (n,) of these panels, as shares


@record
class Carried(FlapFree, OnSheet):
    """Strips of panels that a sheet carries: a folding sheet of their own."""

    lines: Lines  # of its vertices (K,)
    parallel: Integers  # rows (K-1,) of panels of the sheet that its own are parallel to
    down: Array  # lengths (K-1, n) of its edges down columns, by those of these panels
    # lengths (K, n-1) of its edges along rows, by those of an edge of the sheet between these
    # columns, in one of its rows
    widths: Array
    # rows (K-1, 2) of vertices of the sheet from which and up to which each strip reaches
    between: Integers
    hung: tuple[Hanging, ...]  # where it hangs
    cells: tuple[Lines, ...]  # lines around each cavity that it closes, in order

    @property
    def columns(self) -> slice:
        """The columns of vertices of the sheet that it is over."""
        return self.lines.columns

    @property
    def grid(self) -> Grid:
        """The grid of its vertices."""
        return Grid(len(self.lines.rows), self.lines.shares.shape[-1])

    def positions(self, drive: ArrayLike) -> Array:
        """Positions (..., K, n, 3) of its vertices."""
        return self.carried(self.sheet.positions(drive))

    def carried(self, points: Array) -> Array:
        """Positions (..., K, n, 3) of its vertices on vertices (..., rows, columns, 3)."""
        return self.lines.carried(points)

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of its creases: those of the sheet."""
        folds = self.sheet.fold_angles(drive)
        over = slice(self.columns.start, self.columns.stop - 1)
        turns = [
            turn_between(folds.row[..., over], one, other)
            for one, other in zip(self.parallel[:-1], self.parallel[1:], strict=True)
        ]
        inner = slice(self.columns.start, self.columns.stop - 2)
        column = folds.column[..., self.parallel, inner]
        none = np.zeros((*column.shape[:-2], 0, self.grid.columns - 1))
        return CreaseValues(np.stack(turns, axis=-2) if turns else none, column)

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the accelerations of its edges: those of the sheet, times what they share."""
        along, down = self.sheet.edge_accelerations(start, stop)
        return (
            along[:, self.columns.start : self.columns.stop - 1] * self.widths.max(axis=0),
            down[:, self.parallel] * self.down.max(axis=1),
        )

    def hung_folds(self, hanging: Hanging, drive: ArrayLike) -> Array:
        """Fold angles (..., n-1) between panels that hang on a line and those that it is on.

        They are lines of one strip only, or of two that are parallel to the same panels.
        """
        folds = self.sheet.fold_angles(drive).row
        over = slice(self.columns.start, self.columns.stop - 1)
        own = self.parallel[max(hanging.line - 1, 0)]
        return turn_between(folds[..., over], int(own), hanging.parallel)


def turn_between(folds: Array, one: int, other: int) -> Array:
    """By how much panels of one row turn into those of another about creases that are parallel.

    Parameters
    ----------
    folds
        Fold angles (..., R, n) about creases between rows of panels.
    """
    low, high = sorted((int(one), int(other)))
    turn = folds[..., low:high, :].sum(axis=-2)
    return np.asarray(turn if one < other else -turn)
