"""A followed motion in closed form, where its panels make a grid that has one."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import OrishellError
from orishell.families.drawn import DrawnSheet, drawn_sheet
from orishell.motion.crease_pattern import SENSE, CreasePattern
from orishell.motion.following import Followed
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.gridding import find_grid
from orishell.numerics.arrays import Array, Integers

AGREES = 1e-9
"""A closed form that departs from the followed motion by more is not that of this motion (rad)."""


def in_closed_form(motion: Followed) -> Followed | None:
    """The same states with fold angles in closed form; None where that is not known.

    Panels must make a grid of quadrilaterals with inner vertices of degree four. The states are
    those in which the crease that closes first folds as it does in the followed ones.

    Parameters
    ----------
    motion
        The followed motion.
    """
    try:
        numbers = find_grid(motion.pattern)
        edges = _edges_of(motion.pattern, numbers)
        signs = np.array([SENSE.get(letter, np.nan) for letter in motion.letters[edges].tolist()])
        rows, columns = numbers.shape
        parted = _on_creases(Grid(rows, columns), signs)
        sheet = drawn_sheet(motion.pattern.vertices[numbers], parted, np.pi)
    except OrishellError:
        return None
    leading = edges[_drive_crease(sheet)]
    exact = np.array([_folds(sheet, each) for each in np.abs(motion.folds[:, leading]).tolist()])
    folds = np.zeros_like(motion.folds)
    folds[:, edges] = exact
    apart = np.abs(folds - motion.folds).max()
    return motion.with_folds(folds) if apart <= AGREES else None


def _folds(sheet: DrawnSheet, drive: float) -> Array:
    """Fold angles (E,) of all edges of the grid, in its order."""
    return sheet.fold_angles(drive).on_edges()


def _drive_crease(sheet: DrawnSheet) -> int:
    """The edge of the grid whose fold angle is the drive."""
    return int(np.abs(np.abs(_folds(sheet, 1.0)) - 1.0).argmin())


def _edges_of(pattern: CreasePattern, numbers: Integers) -> Integers:
    """Numbers of the pattern's edges in the order of the grid's edges (E,)."""
    size = len(pattern.vertices)
    wanted = numbers.ravel()[Grid(*numbers.shape).edges_vertices()]
    keys = np.sort(pattern.edges, axis=1) @ [size, 1]
    order = np.argsort(keys)
    place = np.searchsorted(keys, np.sort(wanted, axis=1) @ [size, 1], sorter=order)
    return np.asarray(order[place])


def _on_creases(grid: Grid, values: Array) -> CreaseValues:
    """Values (E,) of a grid's edges as those of its creases."""
    rows, columns = grid.rows, grid.columns
    row, column = np.split(values, [rows * (columns - 1)])
    return CreaseValues(
        row.reshape(rows, columns - 1)[1:-1], column.reshape(rows - 1, columns)[:, 1:-1]
    )
