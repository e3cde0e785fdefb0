"""A folding sheet and the sleeves over its rows: rigid bodies at lines where more than two meet.

To what asks how bodies move and which of them are neighbours this is a sheet with more panels:
those of the sheet come first, then those of every sleeve. Vectors between vertices accelerate no
more than edges of the sheet along rows and down columns, added up over all rows and columns from
the first to the last of both panels; strips reach from the row above that of their sleeve to the
row below (docs/theory/boxes.md).
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.layout import Layout
from orishell.motion.mechanism import Mechanism, mechanism_in_one_line
from orishell.motion.sleeves import Q, R, Sleeve, W
from orishell.numerics.arrays import Array, Integers


@record
class Complex:
    """A sheet without slit flaps and its sleeves, as one mechanism."""

    sheet: Mechanism
    sleeves: tuple[Sleeve, ...]

    def __repr__(self) -> str:
        return mechanism_in_one_line(self)

    @property
    def grid(self) -> Grid:
        """That of the sheet."""
        return self.sheet.grid

    @property
    def inner_columns(self) -> slice:
        """Those of the sheet."""
        return self.sheet.inner_columns

    @property
    def flap_columns(self) -> tuple[int, ...]:
        """Those of the sheet."""
        return self.sheet.flap_columns

    def without_flaps(self) -> Mechanism:
        """Itself: sleeves are over sheets without flaps."""
        return self

    def with_stop(self, stop: float) -> Mechanism:
        """Itself."""
        return self

    @property
    def least_turning(self) -> Complex:
        """The same on the sheet that turns as little as possible."""
        sheet = self.sheet.least_turning
        return Complex(sheet, tuple(each.on(sheet) for each in self.sleeves))

    @property
    def target_drive(self) -> float:
        """That of the sheet."""
        return self.sheet.target_drive

    @property
    def end_drive(self) -> float:
        """That of the sheet."""
        return self.sheet.end_drive

    def positions(self, drive: ArrayLike) -> Array:
        """Positions (..., rows, columns, 3) of the sheet's vertices."""
        return self.sheet.positions(drive)

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of the sheet's creases."""
        return self.sheet.fold_angles(drive)

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the accelerations of the sheet's edges, along rows of the sleeves' as well."""
        along, down = self.sheet.edge_accelerations(start, stop)
        return along * self._widest, down

    @cached_property
    def _widest(self) -> Array:
        """The widest side (columns - 1,) along a crease, by the crease, that a panel has."""
        widest = np.ones(self.grid.columns - 1)
        for each in self.sleeves:
            between = slice(each.columns.start, each.columns.stop - 1)
            widest[between] = np.maximum(widest[between], each.widths.max(axis=0))
        return widest

    def points(self, drive: ArrayLike) -> Array:
        """Positions (..., V, 3) of all vertices, those of the sheet first."""
        points = self.sheet.positions(drive)
        whole = points.reshape(*points.shape[:-3], -1, 3)
        found = np.empty((*whole.shape[:-2], self.firsts[1][-1] + self._last, 3))
        found[..., : whole.shape[-2], :] = whole
        # Rows of x, and those above and below, of all sleeves over the same columns at once.
        for columns, rows, above, below, places in self._carriers:
            x = points[..., rows, columns, :]
            up = above * (points[..., rows - 1, columns, :] - x)
            down = below * (points[..., rows + 1, columns, :] - x)
            found[..., places[Q], :] = x + up
            found[..., places[W], :] = x + up + down
            found[..., places[R], :] = x + down
        return found

    @cached_property
    def _last(self) -> int:
        """How many vertices the last part has."""
        parts = (self.grid, *(each.grid for each in self.sleeves))
        return parts[-1].vertex_count

    @cached_property
    def _carriers(self) -> list[tuple[slice, Integers, Array, Array, Integers]]:
        """Sleeves over the same columns: these, rows (S,), shares (S, n, 1), numbers (3, S, n)."""
        found = []
        numbers = [
            first + each.grid.vertices()
            for first, each in zip(self.firsts[1][1:], self.sleeves, strict=True)
        ]
        for start, stop in dict.fromkeys((s.columns.start, s.columns.stop) for s in self.sleeves):
            own = [
                k
                for k, s in enumerate(self.sleeves)
                if (s.columns.start, s.columns.stop) == (start, stop)
            ]
            above, below = (
                np.stack([getattr(self.sleeves[k], name) for k in own])[..., None]
                for name in ("above", "below")
            )
            rows = np.array([self.sleeves[k].row for k in own])
            places = np.stack([numbers[k] for k in own], axis=1)
            found.append((slice(start, stop), rows, above, below, places))
        return found

    @cached_property
    def firsts(self) -> tuple[Integers, Integers]:
        """Numbers (S+1,) of the first panel and the first vertex of the sheet and every sleeve."""
        grids = [self.grid, *(each.grid for each in self.sleeves)]
        panels = np.cumsum([0, *(each.panel_count for each in grids)])
        vertices = np.cumsum([0, *(each.vertex_count for each in grids)])
        return panels[:-1], vertices[:-1]

    @cached_property
    def part_of(self) -> Integers:
        """The part (F,) that each panel belongs to: 0 the sheet, then the sleeves."""
        grids = [self.grid, *(each.grid for each in self.sleeves)]
        return np.repeat(np.arange(len(grids)), [each.panel_count for each in grids])

    @cached_property
    def hinged(self) -> tuple[Integers, Integers]:
        """Panels of sleeves and of the sheet (H,), those that hang in the others' lines."""
        across, own, on = self.grid.columns - 1, [], []
        for first, sleeve in zip(self.firsts[0][1:], self.sleeves, strict=True):
            columns = np.arange(sleeve.columns.start, sleeve.columns.stop - 1)
            own.append(first + np.arange(2 * len(columns)))
            on.append((sleeve.row - 1) * across + columns)
            on.append(sleeve.row * across + columns)
        none = [np.zeros(0, np.int64)]
        return np.concatenate(none + own), np.concatenate(none + on)

    @cached_property
    def layout(self) -> Layout:
        """All panels: those of the sheet with the ends of sleeves' lines on their sides."""
        sheet = Layout.of(self.sheet)
        firsts, grids = self.firsts[1], [each.grid for each in self.sleeves]
        own = [grid.faces_vertices() + k for grid, k in zip(grids, firsts[1:], strict=True)]
        places = [self._places(each) for each in self.sleeves]
        faces = np.concatenate([sheet.faces, *own])
        loops = self._loops(sheet)
        width = loops.shape[1]
        more = np.pad(faces[len(loops) :], ((0, 0), (0, width - 4)), constant_values=-1)
        first = np.concatenate([sheet.first, *(each for each, _ in places)])
        last = np.concatenate([sheet.last, *(each for _, each in places)])
        parallel = np.arange(len(faces))
        hanging, on = self.hinged
        parallel[hanging] = on
        # A strip hangs on the panels above and is parallel to those below, or the other way.
        for k, sleeve in zip(self.firsts[0][1:], self.sleeves, strict=True):
            count = len(sleeve.above) - 1
            strips = parallel[k : k + 2 * count].reshape(2, count)
            parallel[k : k + 2 * count] = strips[::-1].ravel()
        return Layout(
            grid=self.grid,
            faces=faces,
            loops=np.concatenate([loops, more]),
            first=first,
            last=last,
            names=sheet.names[parallel],
            flaps=np.pad(sheet.flaps, (0, len(faces) - len(sheet.flaps))),
            pairs=sheet.pairs,
            hinges=sheet.hinges,
            parallel=parallel,
        )

    def _places(self, sleeve: Sleeve) -> tuple[Integers, Integers]:
        """Rows and columns (F, 2) from which and up to which panels of a sleeve reach."""
        columns = np.tile(np.arange(sleeve.columns.start, sleeve.columns.stop - 1), 2)
        rows = np.full(len(columns), sleeve.row)
        return np.stack([rows - 1, columns], axis=-1), np.stack([rows + 1, columns + 1], axis=-1)

    def _loops(self, sheet: Layout) -> Integers:
        """Corners (F, 8) of the sheet's panels and what lies on their sides, -1 behind the last."""
        grid = self.grid
        # On each edge of a column, from above: where, and which vertex, of at most two.
        shape = grid.rows - 1, grid.columns, 2
        share, vertex = np.full(shape, np.inf), np.full(shape, -1)
        for first, sleeve in zip(self.firsts[1][1:], self.sleeves, strict=True):
            number = first + sleeve.grid.vertices()
            share[sleeve.row - 1, sleeve.columns, 0] = 1 - sleeve.above
            vertex[sleeve.row - 1, sleeve.columns, 0] = number[Q]
            share[sleeve.row, sleeve.columns, 1] = sleeve.below
            vertex[sleeve.row, sleeve.columns, 1] = number[R]
        order = np.argsort(share, axis=-1, kind="stable")
        vertex = np.take_along_axis(vertex, order, axis=-1)
        left, right = vertex[:, :-1].reshape(-1, 2), vertex[:, 1:].reshape(-1, 2)[:, ::-1]
        f = sheet.faces
        loops = np.concatenate([f[:, :1], left, f[:, 1:3], right, f[:, 3:]], axis=1)
        return np.take_along_axis(loops, np.argsort(loops < 0, axis=1, kind="stable"), axis=1)
