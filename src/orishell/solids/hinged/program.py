"""The shortest longest arm, by a linear program (HiGHS), for boards of thickness 1."""

from __future__ import annotations

from typing import Any

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.hinges import Hinges
from orishell.numerics.arrays import Array, Integers
from orishell.solids.hinged.conditions import Vertices, crease_numbers
from orishell.solids.hinged.joints import Rows, hinges_of

MOST_PANELS = 5000
"""Sheets of more panels are refused: the program takes 2 s for 2500 panels, 20 s for these."""
EXACT = 1e-10
"""Accuracy that the program is asked for, in thicknesses; conditions are then met to rounding."""
APART = 1e-8
"""Hinges keep so much off the faces, in thicknesses, that no rounding puts them inside a board."""
JOINTS = 0.1
"""What the depth of joints counts, beside the longest arm: boards are cut back for it."""


def least_arms(vertices: Vertices, joints: Rows = ()) -> Hinges:
    """The hinges with the shortest longest arm, and how high boards then lie, thickness 1.

    Rows of creases that are ``joints`` have no arms. They lie on the faces on which they close or
    on the other side of these, as near to them as short arms let them.

    Raises
    ------
    DesignError
        If the sheet is too large for the program.
    """
    from scipy.optimize import linprog

    rows, columns = vertices.shape
    grid = Grid(rows + 2, columns + 2)
    if grid.panel_count > MOST_PANELS:
        raise DesignError(
            "hinges of so large a sheet are found only where its columns are straight",
            keys=("pattern.rows", "pattern.columns"),
            size=f"it has {grid.panel_count} panels, and may have {MOST_PANELS}",
            excess=grid.panel_count / MOST_PANELS - 1,
        )
    matrix, bounds = _inequalities(vertices, grid, joints)
    conditions = vertices.conditions()
    heights, panels = conditions.shape[1], grid.panel_count
    longest = [1.0, JOINTS] if joints else [1.0]  # arm, and depth of joints
    objective = np.concatenate([np.zeros(heights + panels), longest])
    free: list[tuple[float | None, float | None]] = [(None, None)] * (heights + panels)
    free[heights] = (-0.5, -0.5)
    found = linprog(
        objective,
        A_ub=matrix,
        b_ub=bounds,
        A_eq=_widened(conditions, panels + len(longest)),
        b_eq=np.zeros(conditions.shape[0]),
        bounds=[*free, *[(0.0, None)] * len(longest)],
        method="highs",
        options={
            "primal_feasibility_tolerance": EXACT,
            "dual_feasibility_tolerance": EXACT,
        },
    )
    if found.x is None:
        raise DesignError(
            "no heights of hinges were found with which whole boards fold flat",
            keys=("panel.construction",),
            size="arms grow with every row and column of a sheet whose columns are not straight",
        )
    h = _on_conditions(found.x[:heights], conditions)
    row, column = crease_numbers(grid)
    levels = found.x[heights : heights + panels].reshape(grid.rows - 1, grid.columns - 1)
    return hinges_of(vertices.signs, CreaseValues(h[row], h[column]), levels, joints)


def _inequalities(vertices: Vertices, grid: Grid, joints: Rows) -> tuple[Any, Array]:
    """A sparse matrix and bounds on heights, levels, the longest arm, and the deepest joint."""
    from scipy.sparse import coo_array

    row, column = crease_numbers(grid)
    panel = np.arange(grid.panel_count).reshape(grid.rows - 1, grid.columns - 1)
    signs = vertices.signs
    beside: list[tuple[Integers, Array, Integers]] = [
        (row, signs.row, panel[:-1]),
        (row, signs.row, panel[1:]),
        (column, signs.column, panel[:, :-1]),
        (column, signs.column, panel[:, 1:]),
    ]
    crease, sign, board = (np.concatenate([each[k].ravel() for each in beside]) for k in range(3))
    folds = sign != 0
    crease, sign, board = crease[folds], sign[folds], board[folds]
    heights, count = row.size + column.size, len(crease)
    place, last = np.arange(count), np.full(count, heights + grid.panel_count)
    # An arm is s (h - b), less 1 of a valley: at least APART, at most the last unknown. At joints
    # it is at most 0, and at least the last unknown's negative.
    joined = np.isin(crease, row[list(joints)])
    over = np.where(sign > 0, 1.0, 0.0)
    sign = np.where(joined, -sign, sign)
    over = np.where(joined, -over, over)
    last = last + joined
    least = over + np.where(joined, 0.0, APART)
    where = np.concatenate([place, place, count + place, count + place, count + place])
    which = np.concatenate([crease, heights + board, crease, heights + board, last])
    value = np.concatenate([-sign, sign, sign, -sign, -np.ones(count)])
    shape = 2 * count, heights + grid.panel_count + 1 + bool(joints)
    return coo_array((value, (where, which)), shape=shape).tocsr(), np.concatenate([-least, over])


def _widened(matrix: Any, more: int) -> Any:
    """The matrix with further columns of zeros."""
    from scipy.sparse import csr_array, hstack

    return hstack([matrix, csr_array((matrix.shape[0], more))], format="csr")


def _on_conditions(heights: Array, conditions: Any) -> Array:
    """The nearest heights that meet the conditions to rounding."""
    from scipy.sparse.linalg import splu

    solve = splu((conditions @ conditions.T).tocsc()).solve
    for _ in range(2):
        heights = heights - conditions.T @ solve(conditions @ heights)
    return np.asarray(heights)
