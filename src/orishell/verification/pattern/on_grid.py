"""A crease pattern whose panels are those of a grid, as its rows and columns."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.grid import CreaseValues
from orishell.motion.gridding import find_grid
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
        count = len(pattern.vertices)
        keys = np.sort(pattern.edges, axis=1) @ [count, 1]
        order = np.argsort(keys)

        def edges(first: Integers, second: Integers) -> Integers:
            wanted = np.minimum(first, second) * count + np.maximum(first, second)
            return np.asarray(order[np.searchsorted(keys, wanted, sorter=order)])

        return cls(
            pattern,
            numbers,
            edges(numbers[1:-1, :-1], numbers[1:-1, 1:]),
            edges(numbers[:-1, 1:-1], numbers[1:, 1:-1]),
        )

    @property
    def flat(self) -> Array:
        """Vertices (rows, columns, 2)."""
        return self.pattern.vertices[self.numbers]

    @property
    def signs(self) -> CreaseValues:
        """Of the creases: 1 valley, -1 mountain, 0 flat, NaN where nothing is said."""
        signs = self.pattern.signs
        return CreaseValues(signs[self.row], signs[self.column])

    def on_edges(self, values: CreaseValues) -> Array:
        """Values (..., E) of all edges of the pattern, 0 at its border."""
        found = np.zeros((*values.row.shape[:-2], len(self.pattern.edges)))
        found[..., self.row], found[..., self.column] = values.row, values.column
        return found
