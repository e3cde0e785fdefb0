"""Where the entries of an assembled matrix are: found once, filled as often as it changes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers

if TYPE_CHECKING:
    from scipy.sparse import csc_array


@record
class Sparsity:
    """The entries of a matrix of free dofs (n, n)."""

    size: int  # n
    rows: Integers  # the row of every entry (E,), column by column
    starts: Integers  # the first entry of every column (n + 1,)
    # the entry that each number of each element goes to (M,); E if it is on a dof that is held
    places: Integers

    @classmethod
    def of(cls, dofs: Sequence[Integers], free: Integers, count: int) -> Sparsity:
        """That of elements with dofs (T, k), kind by kind.

        free: Dofs (n,) that are not held.
        count: Number of all dofs.
        """
        size = len(free)
        number = np.full(count, -1)
        number[free] = np.arange(size)
        keys = []
        for each in dofs:
            own = number[each]
            row, column = own[:, :, None], own[:, None, :]
            keys.append(np.where((row >= 0) & (column >= 0), column * size + row, -1).ravel())
        entries, places = np.unique(np.concatenate(keys), return_inverse=True)
        held = int(len(entries) > 0 and entries[0] < 0)
        entries = entries[held:]
        places = np.where(places < held, len(entries), places - held)
        starts = np.searchsorted(entries, size * np.arange(size + 1))
        return cls(size, entries % size, starts, places)

    def matrix(self, elements: Sequence[Array]) -> csc_array:
        """The matrix of elements (T, k, k), kind by kind."""
        from scipy.sparse import csc_array

        numbers = np.concatenate([each.ravel() for each in elements])
        values = np.bincount(self.places, numbers, len(self.rows) + 1)[:-1]
        return csc_array((values, self.rows, self.starts), shape=(self.size, self.size))
