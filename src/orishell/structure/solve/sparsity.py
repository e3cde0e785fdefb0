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
    # the entry that each number of each element goes to (T k^2,), kind by kind; E if it is on a dof
    # that is restrained
    places: tuple[Integers, ...]

    @classmethod
    def of(cls, dofs: Sequence[Integers], free: Integers, count: int) -> Sparsity:
        """That of elements with dofs (T, k), kind by kind.

        free: Dofs (n,) that are not restrained.
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
        entries = np.unique(np.concatenate([np.unique(each) for each in keys]))
        entries = entries[entries >= 0]
        starts = np.searchsorted(entries, size * np.arange(size + 1))
        places = tuple(
            _short(np.where(each < 0, len(entries), np.searchsorted(entries, each)))
            for each in keys
        )
        return cls(size, _short(entries % size), _short(starts), places)

    def matrix(self, elements: Sequence[Array]) -> csc_array:
        """The matrix of elements (T, k, k), kind by kind."""
        from scipy.sparse import csc_array

        values = np.zeros(len(self.rows) + 1)
        for places, each in zip(self.places, elements, strict=True):
            values += np.bincount(places, each.ravel(), len(values))
        return csc_array((values[:-1], self.rows, self.starts), shape=(self.size, self.size))


def _short(numbers: Integers) -> Integers:
    """Whole numbers in half the memory."""
    return np.asarray(numbers, np.int32)
