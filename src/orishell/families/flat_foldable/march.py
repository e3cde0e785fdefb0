"""From a row and a column of a flat-foldable sheet to all of it, a diagonal at a time.

The four quarters beside the cross that is given are marched at once: what a step does to them is
the same, seen from the middle vertex. The last axis of all arrays is one of many sheets.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.record import record
from orishell.numerics.arrays import Booleans, Integers

Numbers = NDArray[Any]
"""Real or complex numbers."""


@record
class Step:
    """A diagonal of all four quadrants: what is next to what."""

    vertices: Integers  # (K,), of the march
    before: Integers  # (K,), those diagonally before them, nearer to the middle
    above: Integers  # (K,), those a row before them
    beside: Integers  # (K,), those a column before them
    # Edges of the panels between them, of the sheet: known, and what follows from them.
    along: Integers  # (K,), along rows, nearer to the middle
    down: Integers  # (K,), down columns
    next_along: Integers  # (K,)
    next_down: Integers  # (K,)


@record
class March:
    """The four quarters of a sheet, each seen from the middle vertex as going down and right.

    In a mirror sectors a and b change places; upside down they are pi - b and pi - a. Vertices of
    the march are those of the quarters, one after the other: of the cross there are several.
    """

    vertices: Integers  # (N,), of the sheet
    upwards: Booleans  # (N, 1)
    swapped: Booleans  # (N, 1), where a is seen as b
    mirrored: Booleans  # (N, 1)
    steps: tuple[Step, ...]

    def seen(self, a: Numbers, b: Numbers) -> tuple[Numbers, Numbers]:
        """log tan of half sectors (N, B) as they are seen, of those of the sheet (R, C, B)."""
        a, b = (each.reshape(-1, each.shape[-1])[self.vertices] for each in (a, b))
        a, b = (np.where(self.upwards, -each, each) for each in (a, b))
        return np.where(self.swapped, b, a), np.where(self.swapped, a, b)

    def unseen(
        self, seen: tuple[Numbers, Numbers], shape: tuple[int, ...]
    ) -> tuple[Numbers, Numbers]:
        """Those of the sheet (R, C, B), of those that are seen (N, B)."""
        a, b = (np.where(self.upwards, -each, each) for each in seen)
        found = []
        for each in (np.where(self.swapped, b, a), np.where(self.swapped, a, b)):
            whole = np.empty((shape[0] * shape[1], shape[2]), each.dtype)
            whole[self.vertices] = each
            found.append(whole.reshape(shape))
        return found[0], found[1]

    def seen_sectors(self, a: Numbers, b: Numbers) -> tuple[Numbers, Numbers]:
        """Sectors (N, B)."""
        a, b = (each.reshape(-1, each.shape[-1])[self.vertices] for each in (a, b))
        a, b = (np.where(self.upwards, np.pi - each, each) for each in (a, b))
        return np.where(self.swapped, b, a), np.where(self.swapped, a, b)

    def seen_ties(self, ties: Numbers, mode: Booleans) -> tuple[Numbers, Booleans]:
        """Sums of logs in row mode, differences in column mode (N, B); which are (N, 1)."""
        rows = mode.reshape(-1, 1)[self.vertices]
        signs = np.where(
            rows, np.where(self.upwards, -1.0, 1.0), np.where(self.mirrored, -1.0, 1.0)
        )
        return signs * ties.reshape(-1, ties.shape[-1])[self.vertices], rows


@lru_cache(64)
def march_of(shape: tuple[int, int], given: tuple[int, int]) -> March:
    """How a sheet of R x C inner vertices is marched from a row and a column that are given."""
    rows, columns = shape
    number = np.arange(rows * columns).reshape(shape)
    along = np.arange(rows * (columns - 1)).reshape(rows, -1)
    down = np.arange((rows - 1) * columns).reshape(-1, columns)
    vertices, flags, begun = [], [], 0
    steps: dict[int, list[Integers]] = {}
    for upwards, mirrored in product((False, True), repeat=2):
        i = np.arange(given[0], -1, -1) if upwards else np.arange(given[0], rows)
        j = np.arange(given[1], -1, -1) if mirrored else np.arange(given[1], columns)
        # The edges before a vertex have the numbers below its own.
        below, beside = i[: len(i) - 1] - upwards, j[: len(j) - 1] - mirrored
        own = begun + np.arange(len(i) * len(j)).reshape(len(i), len(j))
        along_here, down_here = along[np.ix_(i, beside)], down[np.ix_(below, j)]
        for k, (p, q) in enumerate(_diagonals(len(i), len(j))):
            steps.setdefault(k, []).append(
                np.stack(
                    [
                        *(own[p, q], own[p - 1, q - 1], own[p - 1, q], own[p, q - 1]),
                        *(along_here[p - 1, q - 1], down_here[p - 1, q - 1]),
                        *(along_here[p, q - 1], down_here[p - 1, q]),
                    ]
                )
            )
        vertices.append(number[np.ix_(i, j)].ravel())
        flags.append(np.tile([upwards, mirrored is not upwards, mirrored], (own.size, 1)))
        begun += own.size
    flag = np.concatenate(flags)
    return March(
        np.concatenate(vertices),
        flag[:, 0, None],
        flag[:, 1, None],
        flag[:, 2, None],
        tuple(Step(*np.concatenate(steps[k], axis=1)) for k in sorted(steps)),
    )


def _diagonals(high: int, wide: int) -> Iterator[tuple[Integers, Integers]]:
    """Rows and columns, from 1 on, of one diagonal after the other."""
    for number in range(2, high + wide - 1):
        i = np.arange(max(1, number - wide + 1), min(high - 1, number - 1) + 1)
        yield i, number - i


def march_sectors(
    march: March, log_a: Numbers, log_b: Numbers, ties: Numbers, mode: Booleans
) -> None:
    """Fill in log tan(a/2) and log tan(b/2) (N, B), known in the first row and column."""
    a, b = (2 * np.arctan(np.exp(each)) for each in (log_a, log_b))
    for step in march.steps:
        at = step.vertices
        b[at] = angle = b[step.before] + a[step.above] - a[step.beside]
        log_b[at] = log = np.log(np.tan(0.5 * angle))
        log_a[at] = other = np.where(mode[at], ties[at] - log, ties[at] + log)
        a[at] = 2 * np.arctan(np.exp(other))


def march_lengths(march: March, rows: Numbers, columns: Numbers, a: Numbers, b: Numbers) -> None:
    """Fill in lengths along rows (R, C-1, B) and down columns (R-1, C, B), known along the cross.

    The edges of a panel close: their parts square to the right and to the lower edge are 0.
    """
    along, down = (each.reshape(-1, each.shape[-1]) for each in (rows, columns))
    for step in march.steps:
        row, column = along[step.along], down[step.down]
        near, right, low = b[step.before], a[step.above], a[step.beside]
        far = np.sin(b[step.vertices])
        along[step.next_along] = (row * np.sin(right) - column * np.sin(near + right)) / far
        down[step.next_down] = (column * np.sin(low) + row * np.sin(near - low)) / far
