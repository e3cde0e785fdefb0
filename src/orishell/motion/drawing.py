"""A drawn sheet as it is given: flat vertices row by row, and what its creases are to be."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion.crease_pattern import CreasePattern, pattern_of_panels
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.gridding import find_grid, grid_creases
from orishell.numerics.arrays import Array


@record
class Drawing:
    """A flat sheet of quadrilaterals."""

    flat: Array  # vertices (rows, columns, 2) in the order of a Grid
    # signs of creases: 1 valley, -1 mountain, 0 never folded, NaN where nothing is said
    signs: CreaseValues
    notes: tuple[str, ...] = ()  # what is to be said of how it was read

    @property
    def inner(self) -> tuple[int, int]:
        """Rows and columns of inner vertices."""
        rows, columns, _ = self.flat.shape
        return rows - 2, columns - 2

    @property
    def shortest(self) -> float:
        """Length of the shortest edge."""
        edges = np.diff(self.flat, axis=0), np.diff(self.flat, axis=1)
        return float(min(np.linalg.norm(each, axis=-1).min() for each in edges))

    @property
    def pattern(self) -> CreasePattern:
        """The sheet as panels and edges, each with its letter."""
        grid = Grid(*self.flat.shape[:2])
        signs = self.signs.on_edges(np.nan)
        letters = np.where(signs > 0, "V", np.where(signs < 0, "M", np.where(signs == 0, "F", "U")))
        faces, edges = grid.faces_vertices(), grid.edges_vertices()
        return pattern_of_panels(self.flat.reshape(-1, 2), faces, edges, letters)


def drawing_of(pattern: CreasePattern) -> Drawing:
    """The drawing of a pattern whose panels are those of a grid.

    Parameters
    ----------
    pattern
        The pattern.

    Raises
    ------
    InputError
        If they are not: where.
    """
    numbers = find_grid(pattern)
    row, column = grid_creases(pattern, numbers)
    signs = CreaseValues(pattern.signs[row], pattern.signs[column])
    return Drawing(pattern.vertices[numbers], signs)
