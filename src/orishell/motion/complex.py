"""A folding sheet and strips that it carries: rigid bodies at lines where more than two meet.

To what asks how bodies move and which of them are neighbours this is a sheet with more panels:
those of the sheet come first, then those of all strips. Vectors between vertices accelerate no more
than edges of the sheet along rows and down columns, added up over all rows and columns from the
first to the last of both panels; strips say from which row up to which they reach
(docs/theory/boxes.md).
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.motion.carried import Carried, Hanging, Lines
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.layout import Layout
from orishell.motion.mechanism import Mechanism
from orishell.motion.on_sheet import OnSheet
from orishell.numerics.arrays import Array, Integers


@record
class Complex(OnSheet):
    """A sheet without slit flaps and the strips that it carries, as one mechanism."""

    strips: tuple[Carried, ...]

    @property
    def grid(self) -> Grid:
        """That of the sheet."""
        return self.sheet.grid

    def on(self, sheet: Mechanism) -> Complex:
        """All of it on a sheet of the same panels, which stands otherwise."""
        return Complex(sheet, tuple(each.on(sheet) for each in self.strips))

    def positions(self, drive: ArrayLike) -> Array:
        """Positions (..., rows, columns, 3) of the sheet's vertices."""
        return self.sheet.positions(drive)

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of the sheet's creases."""
        return self.sheet.fold_angles(drive)

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the accelerations of the sheet's edges, along rows of the strips' as well."""
        along, down = self.sheet.edge_accelerations(start, stop)
        return along * self._widest, down

    @cached_property
    def _widest(self) -> Array:
        """The widest side (columns - 1,) along a crease, by the crease, that a panel has."""
        widest = np.ones(self.grid.columns - 1)
        for each in self.strips:
            between = slice(each.columns.start, each.columns.stop - 1)
            widest[between] = np.maximum(widest[between], each.widths.max(axis=0))
        return widest

    def points(self, drive: ArrayLike) -> Array:
        """Positions (..., V, 3) of all vertices, those of the sheet first."""
        points = self.sheet.positions(drive)
        whole = points.reshape(*points.shape[:-3], -1, 3)
        found = np.empty((*whole.shape[:-2], self.firsts[1][-1] + self._last, 3))
        found[..., : whole.shape[-2], :] = whole
        for lines, places in self._carriers:
            found[..., places, :] = lines.carried(points)
        return found

    @cached_property
    def _last(self) -> int:
        """How many vertices the last part has."""
        parts = (self.grid, *(each.grid for each in self.strips))
        return parts[-1].vertex_count

    @cached_property
    def _carriers(self) -> list[tuple[Lines, Integers]]:
        """Lines of all strips over the same columns, and the numbers (K, n) of their vertices."""
        by_columns: dict[tuple[int, int], list[int]] = {}
        for k, each in enumerate(self.strips):
            by_columns.setdefault((each.columns.start, each.columns.stop), []).append(k)
        firsts = self.firsts[1][1:]
        return [
            (
                Lines.joined([self.strips[k].lines for k in own]),
                np.concatenate([firsts[k] + self.strips[k].grid.vertices() for k in own]),
            )
            for own in by_columns.values()
        ]

    @cached_property
    def firsts(self) -> tuple[Integers, Integers]:
        """Numbers (S+1,) of the first panel and the first vertex of the sheet and all strips."""
        grids = [self.grid, *(each.grid for each in self.strips)]
        panels = np.cumsum([0, *(each.panel_count for each in grids)])
        vertices = np.cumsum([0, *(each.vertex_count for each in grids)])
        return panels[:-1], vertices[:-1]

    @cached_property
    def part_of(self) -> Integers:
        """The part (F,) that each panel belongs to: 0 the sheet, then the strips."""
        grids = [self.grid, *(each.grid for each in self.strips)]
        return np.repeat(np.arange(len(grids)), [each.panel_count for each in grids])

    def panels(self, part: int, row: int, columns: slice) -> Integers:
        """Numbers (n-1,) of the panels of a row of a part, between columns of the sheet."""
        count, before = self.grid.columns - 1, 0
        if part:
            own = self.strips[part - 1]
            count, before = own.grid.columns - 1, own.columns.start
        between = np.arange(columns.start, columns.stop - 1) - before
        return np.asarray(self.firsts[0][part] + row * count + between)

    @cached_property
    def hangings(self) -> tuple[tuple[int, Hanging], ...]:
        """Where all strips hang, each with the number of its part."""
        return tuple((k, each) for k, s in enumerate(self.strips, 1) for each in s.hung)

    @cached_property
    def hinged(self) -> tuple[Integers, Integers]:
        """Panels (H,) that hang in lines, and those that they hang on."""
        own, on = [np.zeros(0, np.int64)], [np.zeros(0, np.int64)]
        for part, hanging in self.hangings:
            strips = self.strips[part - 1]
            beside = {max(hanging.line - 1, 0), min(hanging.line, len(strips.parallel) - 1)}
            for row in sorted(beside):
                own.append(self.panels(part, row, strips.columns))
                on.append(self.panels(hanging.part, hanging.panels, strips.columns))
        return np.concatenate(own), np.concatenate(on)

    @cached_property
    def layout(self) -> Layout:
        """All panels, each with the ends of lines that hang on its sides."""
        sheet = Layout.of(self.sheet)
        firsts, grids = self.firsts[1], [each.grid for each in self.strips]
        own = [grid.faces_vertices() + k for grid, k in zip(grids, firsts[1:], strict=True)]
        places = [self._places(each) for each in self.strips]
        faces = np.concatenate([sheet.faces, *own])
        parallel = np.concatenate(
            [np.arange(len(sheet.faces))]
            + [self.panels(0, row, each.columns) for each in self.strips for row in each.parallel]
        )
        return Layout(
            grid=self.grid,
            faces=faces,
            loops=self._loops(faces),
            first=np.concatenate([sheet.first, *(each for each, _ in places)]),
            last=np.concatenate([sheet.last, *(each for _, each in places)]),
            names=sheet.names[parallel],
            flaps=np.pad(sheet.flaps, (0, len(faces) - len(sheet.flaps))),
            pairs=sheet.pairs,
            hinges=sheet.hinges,
            parallel=parallel,
        )

    def _places(self, strips: Carried) -> tuple[Integers, Integers]:
        """Rows and columns (F, 2) from which and up to which panels of strips reach."""
        first = np.arange(strips.columns.start, strips.columns.stop - 1)
        count = len(strips.between)
        columns = np.tile(first, count)
        low, high = np.repeat(strips.between, len(first), axis=0).T
        return np.stack([low, columns], axis=-1), np.stack([high, columns + 1], axis=-1)

    def _loops(self, faces: Integers) -> Integers:
        """Corners (F, K) of all panels and what lies on their sides, -1 behind the last."""
        # On the edges of columns of every row of panels, from above: where, and which vertex.
        sides: dict[tuple[int, int], list[tuple[Array, Integers]]] = {}
        for part, hanging in self.hangings:
            strips, columns = self.strips[part - 1], self._columns(hanging.part)
            own = slice(strips.columns.start - columns.start, strips.columns.stop - columns.start)
            at = np.full(columns.stop - columns.start, np.inf)
            vertex = np.full(len(at), -1)
            at[own] = hanging.at
            vertex[own] = self.firsts[1][part] + strips.grid.vertices()[hanging.line]
            sides.setdefault((hanging.part, hanging.panels), []).append((at, vertex))
        most = max(map(len, sides.values()), default=0)
        left = np.full((len(faces), most), -1)
        right = left.copy()
        for (part, row), several in sides.items():
            order = np.argsort(np.stack([at for at, _ in several], axis=-1), kind="stable")
            numbers: Integers = np.stack([each for _, each in several], axis=-1)
            numbers = np.take_along_axis(numbers, order, axis=-1)
            panels = self.panels(part, row, self._columns(part))
            left[panels, : len(several)] = numbers[:-1]
            right[panels, : len(several)] = numbers[1:, ::-1]
        loops = np.concatenate([faces[:, :1], left, faces[:, 1:3], right, faces[:, 3:]], axis=1)
        return np.take_along_axis(loops, np.argsort(loops < 0, axis=1, kind="stable"), axis=1)

    def _columns(self, part: int) -> slice:
        """The columns of vertices of the sheet that a part is over."""
        return self.strips[part - 1].columns if part else slice(0, self.grid.columns)
