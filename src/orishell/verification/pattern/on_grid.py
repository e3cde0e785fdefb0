"""A crease pattern whose panels are those of a grid, as its rows and columns."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.gridding import find_grid, grid_creases
from orishell.numerics.arrays import Array, Integers


@record
class OnGrid:
    """The rows and columns of a pattern."""

    pattern: CreasePattern
    numbers: Integers  # of its vertices (rows, columns)
    row: Integers  # numbers (R, C+1) of the edges that are row creases
    column: Integers  # numbers (R+1, C) of the edges that are column creases

    @classmethod
    def of(cls, pattern: CreasePattern) -> OnGrid | None:
        """Find them; None if its panels are not those of a grid with an inner vertex."""
        try:
            numbers = find_grid(pattern)
        except InputError:
            return None
        if min(numbers.shape) < 3:
            return None
        return cls(pattern, numbers, *grid_creases(pattern, numbers))

    @property
    def flat(self) -> Array:
        """Vertices (rows, columns, 2)."""
        return self.pattern.vertices[self.numbers]

    @property
    def signs(self) -> CreaseValues:
        """Of the creases: 1 valley, -1 mountain, 0 flat, NaN where nothing is said."""
        signs = self.pattern.signs
        return CreaseValues(signs[self.row], signs[self.column])

    def with_signs(self, signs: CreaseValues) -> OnGrid:
        """The rows and columns, with letters after signs where their pattern has none."""
        pattern, asked = self.pattern, self.on_edges(signs)
        found = np.where(asked > 0, "V", np.where(asked < 0, "M", "F"))
        missing = pattern.crease & np.isnan(pattern.signs)
        letters = np.where(missing, found, pattern.letters)
        return replace(self, pattern=replace(pattern, letters=letters))

    @cached_property
    def panels(self) -> Integers:
        """Numbers (F,) that its panels have in the pattern, row by row."""
        asked = np.sort(self.numbers.ravel()[Grid(*self.numbers.shape).faces_vertices()], axis=1)
        known = np.sort(self.pattern.faces[:, :4], axis=1)
        found = np.empty(len(known), np.int64)
        found[np.lexsort(asked.T)] = np.lexsort(known.T)
        return found

    def on_edges(self, values: CreaseValues) -> Array:
        """Values (..., E) of all edges of the pattern, 0 at its border."""
        found = np.zeros((*values.row.shape[:-2], len(self.pattern.edges)))
        found[..., self.row], found[..., self.column] = values.row, values.column
        return found
