"""Which family a flat sheet of quadrilaterals belongs to, if it is one of ours.

A name is only a name: that a sheet folds, and how, follows from its vertices without one
(``families/drawn``).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import combinations

import numpy as np

from orishell.conventions.record import Angle, record
from orishell.conventions.row import Row
from orishell.families.recognised.conditions import (
    Sectors,
    flat_foldable,
    longitudinal,
    miura,
    one_straight_row,
    orthodiagonal,
    sectors_of,
)
from orishell.motion.grid import CreaseValues
from orishell.numerics.arrays import Array

CONDITIONS: dict[str, Callable[[Sectors], Array]] = {
    "Miura": miura,
    "parallel-repeating": one_straight_row,
    "orthodiagonal": orthodiagonal,
    "longitudinal-linear-repeating": longitudinal,
    "flat-foldable": flat_foldable,
}
"""Of every family, the most special first."""

NAMES = tuple(CONDITIONS)


@record
class Recognised:
    """The family that a sheet belongs to."""

    family: str  # one of NAMES, the most special
    also: tuple[str, ...]  # others that it belongs to
    # by how much sector angles miss the family's conditions at the worst place (radians)
    miss: Angle
    turned: bool  # whether its rows are the family's columns
    # how many rows and columns of vertices at the top, bottom, left and right are not of the
    # family: flaps and strips at the border
    beside: tuple[int, int, int, int]

    @property
    def row(self) -> Row:
        """The family that a sheet belongs to, in words."""
        also = f" (also {', '.join(self.also)})" if self.also else ""
        sides = [
            f"{number} {name}"
            for number, name in zip(self.beside, ("above", "below", "left", "right"), strict=True)
            if number
        ]
        apart = f"; but for lines of vertices at its border: {', '.join(sides)}" if sides else ""
        return Row("says", "family", f"{self.family}{also}: sectors to {self.miss:.1g} rad{apart}")


def recognise(
    flat: Array, signs: CreaseValues | None = None, tolerance: float = 1e-9
) -> Recognised | None:
    """Find the most special family that a sheet belongs to, to a tolerance.

    Parameters
    ----------
    flat
        Vertices (rows, columns, 2), seen from either side.
    signs
        Of the creases, NaN where none is said. Flat-foldable sheets in which some vertices fold
        rows more and others columns are not known without.
    tolerance
        By how much sector angles may miss (radians).

    Returns
    -------
    The family, or None if it is none of ours, or its creases are lines that cross. If the whole
    sheet is none, single rows and columns at its border are left out, as few as will do.
    """
    whole = _both_ways(flat, signs)
    if whole[0].ru.size == 0 or _of_lines(whole, tolerance):
        return None
    sides = list(_sides(whole[0].ru.shape))
    # What the midst of a sheet misses no border mends.
    names = [name for name in NAMES if min(_misses(name, whole, sides[-1])) <= 2 * tolerance]
    for beside in sides:
        found = {name: _misses(name, whole, beside) for name in names}
        fitting = [name for name, both in found.items() if min(both) <= tolerance]
        if fitting:
            first, turned = found[fitting[0]]
            is_turned = first > tolerance
            return Recognised(
                fitting[0], tuple(fitting[1:]), turned if is_turned else first, is_turned, beside
            )
    return None


def misses(flat: Array, signs: CreaseValues | None = None) -> dict[str, float]:
    """By how much the whole of a sheet misses every family (radians).

    Parameters
    ----------
    flat
        Vertices (rows, columns, 2), seen from either side, with an inner one at least.
    signs
        Of the creases, NaN where none is said.
    """
    whole = _both_ways(flat, signs)
    return {name: min(_misses(name, whole, (0, 0, 0, 0))) for name in NAMES}


Beside = tuple[int, int, int, int]


def _both_ways(flat: Array, signs: CreaseValues | None) -> tuple[Sectors, Sectors]:
    """The sectors of a sheet, and of the sheet with rows and columns exchanged."""
    turned = None
    if signs is not None:
        turned = CreaseValues(row=signs.column.T, column=signs.row.T)
    return sectors_of(flat, signs), sectors_of(flat.swapaxes(0, 1), turned)


def _sides(shape: tuple[int, ...]) -> Iterator[Beside]:
    """Borders to leave out, fewest first, that leave three rows and columns of inner vertices."""
    yield 0, 0, 0, 0
    for count in range(1, 5):
        for chosen in combinations(range(4), count):
            top, bottom, left, right = (int(side in chosen) for side in range(4))
            if min(shape[0] - top - bottom, shape[1] - left - right) >= 3:
                yield top, bottom, left, right


def _of_lines(whole: tuple[Sectors, Sectors], tolerance: float) -> bool:
    """Whether rows and columns go straight on at every vertex: they fold one at a time."""
    return all(np.abs(each.straight).max() <= tolerance for each in whole)


def _misses(name: str, whole: tuple[Sectors, Sectors], beside: Beside) -> tuple[float, float]:
    """The miss of a family, and that with rows and columns exchanged."""
    first, turned = whole[0].part(*beside), whole[1].part(*beside[2:], *beside[:2])
    condition = CONDITIONS[name]
    return float(np.abs(condition(first)).max()), float(np.abs(condition(turned)).max())
