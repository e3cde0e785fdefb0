"""Which crease closes first: it drives the sheet, from flat to the end of its motion."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.families.drawn.cross import FOLDED_FLAT, LATER, Cross, proportions
from orishell.families.drawn.vertex import Half, Numbers, Vertices
from orishell.families.shared.folding import HalfFolds
from orishell.numerics.equals import first_largest


@record
class Drive:
    """A sheet's cross, turned so that the crease that closes first lies in its row."""

    cross: Cross
    across: bool  # whether rows and columns are exchanged

    def moved(self, flat: Numbers) -> Drive:
        """The drive of other flat vertices (2, rows, columns, ...), with the same signs."""
        own = flat.swapaxes(1, 2)[::-1] if self.across else flat
        states = (None,) * (own.ndim - 4)
        cross = self.cross
        vertices = Vertices.of(own, cross.vertices.mode[(..., *states)])
        rows, columns = (np.sign(each.real)[(..., *states)] for each in (cross.rows, cross.columns))
        found = replace(
            cross,
            vertices=vertices,
            rows=proportions(vertices.beyond_row, rows),
            columns=proportions(vertices.beyond_column.swapaxes(0, 1), columns),
        )
        return replace(self, cross=found)

    def heights(self, drive: Numbers) -> tuple[Half, Half]:
        """Heights (R, B) of rows and (C, B) of columns of the cross at drive angles (B,)."""
        cosine = np.where(drive == np.pi, FOLDED_FLAT, np.cos(0.5 * drive))
        with np.errstate(divide="ignore", invalid="ignore"):
            return self.cross.from_row((np.sin(0.5 * drive), cosine))

    def folds(self, drive: Numbers) -> HalfFolds:
        """Cosines and sines of half the fold angles of all creases at drive angles (B,)."""
        found = self.cross.folds(*self.heights(drive))
        if not self.across:
            return found
        row, column = (
            (each[0].swapaxes(0, 1), each[1].swapaxes(0, 1)) for each in (found.column, found.row)
        )
        return HalfFolds(row=row, column=column)

    def disagreement(self, drive: Numbers) -> Numbers:
        """By how much (R, C, B) vertices disagree at drive angles (B,) (radians).

        See ``Cross.disagreement``.
        """
        with np.errstate(divide="ignore", invalid="ignore"):
            found = self.cross.disagreement(self.cross.folds(*self.heights(drive)))
        return found.swapaxes(0, 1) if self.across else found


def find_drive(cross: Cross) -> Drive | None:
    """The drive of a sheet with creases (..., 1); None if parts of it fold independently.

    Of a sheet that does not fold, the line that closes before most others.
    """
    rows, columns = ((each[:, 0] != 0).any(axis=-1) for each in (cross.rows, cross.columns))
    alone = rows.sum() + columns.sum() == 1
    if not (alone or (rows.any() and columns.any())):
        return None
    with np.errstate(all="ignore"):
        first = cross.earlier()[..., 0]
        of_rows = np.where(rows, (first | ~columns).mean(axis=1), -1)
        of_columns = np.where(columns, (~first | ~rows[:, None]).mean(axis=0), -1)
        across = bool(of_columns.max() > of_rows.max())
        turned = cross.turned if across else cross
        leading = of_columns if across else of_rows
        candidates = np.flatnonzero(leading == leading.max())
        found = replace(turned, column=_column(turned))
        # Where all close together the limit has no digits left: a little before it has.
        closed = np.ones(1), np.full(1, np.sqrt(LATER))
        heights = np.array(
            [replace(found, row=int(row)).across(closed)[0][found.column, 0] for row in candidates]
        )
    heights = np.where(np.isfinite(heights), heights, np.inf)
    # Of rows that close together the one nearest to the middle.
    together = candidates[heights <= heights.min() * (1 + LATER)]
    row = together[np.abs(together - (len(turned.rows) - 1) / 2).argmin()]
    return Drive(replace(found, row=int(row)), across)


def _column(cross: Cross) -> int:
    """The column that takes its height to rows best: all of its creases fold by much there."""
    seen = np.abs(cross.columns[:, :-1, 0].T), np.abs(cross.rows[:, :-1, 0])
    folded = seen[1][:, 0] != 0
    return first_largest((seen[0] * seen[1])[folded].min(axis=0))
