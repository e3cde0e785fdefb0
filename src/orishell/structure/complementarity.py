"""The linear complementarity problem: w = M z + q, both without negative parts, one of each pair 0.

Lemke's algorithm (R. W. Cottle, J.-S. Pang and R. E. Stone, "The Linear Complementarity Problem",
1992, section 4.4), lexicographic, so that it ends where several rows are equally tight.
"""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array

PIVOT = 1e-9
"""Entries below this, relative to the largest of their column, are none."""
LEVEL = 1e-10
"""Ratios that differ by less than this, relative to the largest, are equal."""
PIVOTS = 10
"""Pivots that are tried at most, by the size of the problem."""
FRESH = 16
"""After so many pivots the table is made afresh, so that rounding does not add up."""


def solve_complementarity(matrix: Array, vector: Array) -> Array | None:
    """The solution z (n,); None if there is none, or none is found.

    Parameters
    ----------
    matrix
        M (n, n), copositive: z^T M z is never negative where z is not.
    vector
        q (n,).
    """
    size = len(vector)
    if (vector >= 0).all():
        return np.zeros(size)
    # Columns: q, w, z and the artificial variable.
    given = np.concatenate([vector[:, None], np.eye(size), -matrix, -np.ones((size, 1))], axis=1)
    table = given.copy()
    basis = 1 + np.arange(size)
    artificial = 2 * size + 1
    row, entering = int(np.argmin(vector)), artificial
    for number in range(1, PIVOTS * size + 1):
        leaving = int(basis[row])
        basis[row] = entering
        if number % FRESH:
            _pivot(table, row, entering)
        else:
            table = np.linalg.solve(given[:, basis], given)
        if leaving == artificial:
            z = np.zeros(2 * size + 2)
            z[basis] = table[:, 0]
            return z[1 + size : 1 + 2 * size]
        entering = leaving + size if leaving <= size else leaving - size
        tight = _tightest(table, entering, basis == artificial)
        if tight is None:
            return None
        row = tight
    return None


def _pivot(table: Array, row: int, column: int) -> None:
    table[row] /= table[row, column]
    factor = table[:, column].copy()
    factor[row] = 0.0
    table -= factor[:, None] * table[row]


def _tightest(table: Array, column: int, artificial: Array) -> int | None:
    """The row that limits a variable, lexicographically; None if none does."""
    size = len(table)
    entry = table[:, column]
    rows = np.flatnonzero(entry > PIVOT * np.abs(entry).max())
    if not len(rows):
        return None
    for key in range(size + 1):
        ratio = table[rows, key] / entry[rows]
        rows = rows[ratio <= ratio.min() + LEVEL * np.abs(ratio).max()]
        if artificial[rows].any():
            return int(rows[artificial[rows]][0])
        if len(rows) == 1:
            break
    return int(rows[0])
