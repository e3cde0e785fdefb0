r"""Bounds of the accelerations of a sheet's edges from those of its creases.

From the middle crease one comes to a panel across creases with unit axes a_k that fold at rates
rho_k', so that it turns at omega = sum rho_k' a_k. Neighbouring creases turn against each other
and mostly cancel. So they are taken in pairs: both axes of a pair lie in one panel, and the angle
phi between them never changes. With p and q the sizes of their rates, g the product of the signs,

    size(Omega)^2 = (p - q)^2 + 2 p q (1 + g cos phi),

where p - q stays, in a range of the drive, as near to what it is in the middle as half the range
times the most by which p' and q' differ. The pair's axes turn with what comes before them, and one
of them about the other:

    size(Omega') <= size(rho_k'' a_k + rho_l'' a_l) + W size(Omega) + p q sin phi,

W being the sum of all sizes before. With W and W' the sums of all on the way, an edge e has

    size(e'') <= size(e) (W^2 + W').

A sheet that turns as a whole at an even rate w has (W + w)^2 in place of W^2.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array

Bound = tuple[Array, Array]
"""W and W' (..., S)."""


@record
class Rates:
    """First and second derivatives of fold angles by the drive, in ranges of the drive."""

    low: Array  # least size of rho' (K, S)
    high: Array  # largest
    second: Array  # largest size of rho''
    # Least and largest rho'' by the sign of rho; None where all creases fold faster and faster, or
    # all slower and slower.
    bends: tuple[Array, Array] | None = None
    # Size of rho' in the middle of the ranges, nan where it has none, and half the width (S,) of
    # these; None if they are not known
    middle: tuple[Array, Array] | None = None

    def half(self) -> Rates:
        """Those of half the angles: of one crease that nothing is paired with."""
        return Rates(0.5 * self.low, 0.5 * self.high, 0.5 * self.second)


@record
class Chains:
    """The ways from the middle crease to all panels: up and down, then along the rows."""

    middle: tuple[int, int]
    row_signs: Array  # (R, C+1)
    column_signs: Array  # (R+1, C)
    row_axes: Array  # unit vectors (R, C+1, 2) to the left along row creases of the flat sheet
    column_axes: Array  # unit vectors (R+1, C, 2) downwards
    along: Array  # lengths of edges along rows (R+2, C+1)
    down: Array  # lengths of edges down columns (R+1, C+2)

    @classmethod
    def of(cls, flat: Array, row: Array, column: Array, middle: tuple[int, int]) -> Chains:
        """Those of a flat sheet (2, R+2, C+2) whose creases fold to signs (R, C+1), (R+1, C)."""
        to_left = np.moveaxis(flat[:, :, :-1] - flat[:, :, 1:], 0, -1)
        below = np.moveaxis(flat[:, 1:] - flat[:, :-1], 0, -1)
        along, down = (np.linalg.norm(each, axis=-1) for each in (to_left, below))
        return cls(
            middle,
            np.sign(row),
            np.sign(column),
            (to_left / along[..., None])[1:-1],
            (below / down[..., None])[:, 1:-1],
            along,
            down,
        )

    def bounds(self, rows: Rates, columns: Rates, spin: float) -> tuple[Array, Array]:
        """Largest accelerations along rows (S, C+1) and down columns (S, R+1).

        spin: Rate at which the sheet turns as a whole (radians per radian of drive).
        """
        return self.of_edges(self.turns(rows, columns), spin)

    def turns(self, rows: Rates, columns: Rates) -> Bound:
        """W and W' (R+1, C+1, S) of all panels.

        rows: Of the row creases (R, S) that end at the middle column of panels.
        columns: Of the column creases (C, S), or (C, R+1, S) where a column's fold differently.
        """
        i, j = self.middle[0], self.middle[1] + 1
        count, across, ranges = len(rows.low), len(columns.low), columns.low.shape[-1]
        ends = np.empty((count + 1, ranges)), np.empty((count + 1, ranges))
        half = Rates(rows.low[i], rows.high[i], rows.second[i]).half()
        for order, first in ((range(i + 1, count), i + 1), (range(i - 1, -1, -1), i)):
            way = _chain(
                (half.high, half.second), order, rows, self.row_signs[:, j], self.row_axes[:, j]
            )
            for step, found in enumerate(way):
                place = first + step if first > i else first - step
                for each, value in zip(ends, found, strict=True):
                    each[place] = value
        w, bent = (np.empty((across + 1, count + 1, ranges)) for _ in range(2))
        signs, axes = self.column_signs.T, self.column_axes.swapaxes(0, 1)
        for order in (range(j, across), range(j - 1, -1, -1)):
            for step, found in enumerate(_chain(ends, order, columns, signs, axes)):
                place = j + step if order.step > 0 else j - step
                w[place], bent[place] = found
        return w.swapaxes(0, 1), bent.swapaxes(0, 1)

    def of_edges(self, turns: Bound, spin: float) -> tuple[Array, Array]:
        """Largest accelerations along rows (S, C+1) and down columns (S, R+1)."""
        panels = (turns[0] + spin) ** 2 + turns[1]
        size = np.pad(panels, ((1, 1), (1, 1), (0, 0)), constant_values=np.inf)
        # An edge is one of both panels beside it: the smaller bound holds.
        of_rows = np.minimum(size[:-1, 1:-1], size[1:, 1:-1])
        of_columns = np.minimum(size[1:-1, :-1], size[1:-1, 1:])
        return (
            (self.along[..., None] * of_rows).max(axis=0).T,
            (self.down[..., None] * of_columns).max(axis=1).T,
        )


def _chain(
    start: Bound, order: Sequence[int], rates: Rates, signs: Array, axes: Array
) -> list[Bound]:
    """W and W' (..., S) at the start and behind every crease of a way.

    order: Numbers of creases.
    signs: Of creases (K, ...).
    axes: Unit vectors (K, ..., 2) along creases.
    """
    found = [start]
    w, bent = start
    for step, crease in enumerate(order):
        high, second = rates.high[crease], rates.second[crease]
        if step % 2 == 0:
            found.append((w + high, bent + second + w * high))
            continue
        other = order[step - 1]
        low, before = rates.low, rates.high[other]
        cosine = (axes[crease] * axes[other]).sum(axis=-1)[..., None]
        same = (signs[crease] * signs[other])[..., None] * cosine
        apart = np.maximum(high - low[other], before - low[crease])
        if rates.bends is not None and rates.middle is not None:
            apart = np.fmin(apart, _apart(rates.bends, rates.middle, crease, other))
        both = np.sqrt(apart**2 + 2 * high * before * np.maximum(1 + same, 0))
        if rates.bends is None:
            sharper, other_second = np.maximum(second, rates.second[other]), rates.second[other]
            opposed = np.sqrt(sharper**2 + 2 * second * other_second * np.maximum(1 + same, 0))
            along = np.where(same < 0, opposed, second + other_second)
        else:
            along = _longest(rates.bends, crease, other, same)
        turning = high * before * np.sqrt(np.maximum(1 - cosine**2, 0))
        bent = bent + along + w * both + turning
        w = w + both
        found.append((w, bent))
    return found


def _apart(
    bends: tuple[Array, Array], middle: tuple[Array, Array], crease: int, other: int
) -> Array:
    """By how much two rates differ: as in the middle, and by what they then bend otherwise."""
    (down, up), (rate, reach) = bends, middle
    bent = np.maximum(up[crease] - down[other], up[other] - down[crease])
    return np.asarray(np.abs(rate[crease] - rate[other]) + reach * bent)


def _longest(bends: tuple[Array, Array], crease: int, other: int, same: Array) -> Array:
    """The longest sum of two vectors along axes: it is largest at ends of both ranges."""
    squares = [
        x[crease] ** 2 + y[other] ** 2 + 2 * x[crease] * y[other] * same
        for x in bends
        for y in bends
    ]
    return np.asarray(np.sqrt(np.maximum(np.max(squares, axis=0), 0)))
