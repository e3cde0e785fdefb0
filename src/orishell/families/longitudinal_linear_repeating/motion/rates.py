"""How fast creases fold, and bounds of the accelerations of edges.

With v the drive, every fold angle of the mechanism's text is 2 atan2(Y, X), where in column
creases and F rows

    Y = P sin(v/2),    X = C cos(v/2),

and in S rows, the tangents' common factor cos(v/2)^2 multiplied out,

    Y = P sin v,       X = (A+B) + (A-B) cos v.

An edge e of a panel with angular velocity w (a vector, by the drive) has

    e'' = w' x e + w x (w x e),

and behind a crease that folds at the rate theta' about the unit vector a

    w -> w + theta' a,      w' -> w' + theta'' a + theta' w x a.

Sizes bound what this can be anywhere in a range: sums of ``|theta'|`` from the panel whose turn is
given by the pose to all others, and so on. By themselves they are generous, since axes are added
up as if they were parallel and edges as if they were square to them. So e'' is taken exactly in
the middle of the range, and the sizes bound how far it departs from there: by the change of w',
for which no third derivative is needed, and by half the range times ``3 |w'| |w| + |w|^3``.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from orishell.conventions.record import record
from orishell.families.longitudinal_linear_repeating.motion.rotations import Rotations
from orishell.families.longitudinal_linear_repeating.tessellation.columns import Columns, Directions
from orishell.numerics import Interval
from orishell.numerics.arrays import Array, Booleans, Complex, Integers


@record
class FoldRates:
    """First and second derivative of fold angles by the drive, per radian."""

    first: Interval
    second: Interval


def fold_rates(
    columns: Columns, flat_foldable: Booleans, start: Array, stop: Array
) -> tuple[FoldRates, FoldRates]:
    """Fold rates while the drive is in a range, for positive signs s of the mechanism's text.

    Of column creases (S, 1, n), the same in all rows, and of row creases (S, m, n+1).
    """
    drives = start[:, None, None], stop[:, None, None]
    alpha, beta, gamma, delta = columns.sectors.T
    mu = columns.multipliers
    half_sum, half_difference = (alpha + beta) / 2, (alpha - beta) / 2
    if columns.version == "cosine":
        f = f_left = _of_half(np.cos(half_difference) * mu, np.sin(half_sum), drives)
    else:
        f = _of_half(-np.sin(half_difference) * mu, np.cos(half_sum), drives)
        f_left = _of_half(np.sin(half_difference) * mu, np.cos(half_sum), drives)
    opening, closing = -np.sin(gamma + delta), np.sin(gamma - delta) * mu**2
    s = _of_whole(-2 * mu * np.cos(delta), opening, closing, drives)
    s_left = _of_whole(-2 * mu * np.cos(gamma), opening, -closing, drives)

    def rows(f: Array, f_left: Array, s: Array, s_left: Array) -> Array:
        left = np.where(flat_foldable[:, None], f_left[..., :1], s_left[..., :1])
        return np.concatenate([left, np.where(flat_foldable[:, None], f, s)], axis=-1)

    each = (f, f_left, s, s_left)
    firsts, seconds = [kind.first for kind in each], [kind.second for kind in each]
    return _of_half(mu, np.ones_like(mu), drives), FoldRates(
        *(
            Interval(rows(*(x.low for x in intervals)), rows(*(x.high for x in intervals)))
            for intervals in (firsts, seconds)
        )
    )


def _of_half(P: Array, C: Array, drives: tuple[Array, Array]) -> FoldRates:
    """Fold rates of column creases and of F rows."""
    square = Interval.between(
        *((P * np.sin(drive / 2)) ** 2 + (C * np.cos(drive / 2)) ** 2 for drive in drives)
    )
    whole = Interval(np.ones_like(square.low), np.ones_like(square.low))
    return FoldRates(
        first=whole.over(square).times(P * C),
        second=_sine(*drives).over(square.squared()).times(-0.5 * P * C * (P**2 - C**2)),
    )


def _of_whole(P: Array, A: Array, B: Array, drives: tuple[Array, Array]) -> FoldRates:
    """Fold rates of S rows.

    With c = cos v, C = A + B, D = A - B, N = C c + D and R = X^2 + Y^2 the derivatives are 2 P N/R
    and -2 P sin v Q/R^2, Q = C R + 2 N ((P^2-D^2) c - C D). Both R and Q are quadratic in c, with
    extrema at -C D/(D^2-P^2) and -D/C. Near 90 degrees P is all but 2 and A, B all but 0: so N
    and X are taken from halves of the drive, and R as a sum of squares.
    """
    C, D = A + B, A - B
    E = P**2 - D**2
    swing, square, bend = [], [], []
    for drive in drives:
        opening, closing = A * np.cos(drive / 2) ** 2, B * np.sin(drive / 2) ** 2
        swing.append(2 * (opening - closing))
        square.append((P * np.sin(drive)) ** 2 + 4 * (opening + closing) ** 2)
        bend.append(C * square[-1] + 2 * swing[-1] * (E * np.cos(drive) - C * D))
    over = Interval.between(*square)
    of_square = _quotient(C * D, E), _quotient(P**2 * (E + C**2), E)
    of_bend = _quotient(-D, C), _quotient(4 * A * B * (E + C**2), C)
    over = _with_extremum(over, *of_square, drives)
    bends = _with_extremum(Interval.between(*bend), *of_bend, drives)
    return FoldRates(
        first=Interval.between(*swing).over(over).times(2 * P),
        second=(_sine(*drives) * bends).over(over.squared()).times(-2 * P),
    )


def _with_extremum(
    between: Interval, cosine: Array, value: Array, drives: tuple[Array, Array]
) -> Interval:
    """Extend a range by the value at a cosine of the drive, where the drive passes it."""
    start, stop = (np.cos(drive) for drive in drives)
    within = (stop < cosine) & (cosine < start)
    return Interval(
        np.where(within, np.minimum(between.low, value), between.low),
        np.where(within, np.maximum(between.high, value), between.high),
    )


def _quotient(numerator: Array, denominator: Array) -> Array:
    """The quotient; infinite where the denominator is 0, as a linear function has no extremum."""
    infinite = np.full_like(numerator, np.inf)
    return np.divide(numerator, denominator, out=infinite, where=denominator != 0)


def _sine(start: Array, stop: Array) -> Interval:
    """Range of the drive's sine."""
    ends = Interval.between(np.sin(start), np.sin(stop))
    return Interval(ends.low, np.where((start < np.pi / 2) & (stop > np.pi / 2), 1.0, ends.high))


AT_ONCE = 200_000
"""Panels of all states that are worked on at once."""


@record
class Sheet:
    """The parts of a mechanism from which the bounds are found."""

    columns: Columns  # sectors and multipliers
    directions: Directions  # directions of the creases in the flat sheet
    flat_foldable: Booleans  # which rows are F rows (m,)
    signs: Array  # signs of the column creases (m+1,)
    flat: Complex  # vertices x + iy of the flat sheet (m+2, n+2)
    turn: Array  # angular velocity (3,) of the middle panel, the same in all states
    panels: Callable[[Array], Rotations]  # rotations (S, m+1, n+1) of all panels at drives (S,)

    @property
    def anchor(self) -> tuple[int, int]:
        """Row and column of the middle panel, whose rotation is given."""
        rows, columns = (count - 1 for count in self.flat.shape)
        return (rows - 1) // 2 + 1, columns // 2


def bound_edges(sheet: Sheet, start: Array, stop: Array) -> tuple[Array, Array]:
    """Bounds of the second derivative of edge vectors by the drive: along rows, down columns."""
    rows, columns = (count - 1 for count in sheet.flat.shape)
    along, down = np.empty((len(start), columns)), np.empty((len(start), rows))
    count = max(AT_ONCE // (rows * columns), 1)
    for first in range(0, len(start), count):
        part = slice(first, first + count)
        along[part], down[part] = _bound(sheet, start[part], stop[part])
    return along, down


def _bound(sheet: Sheet, start: Array, stop: Array) -> tuple[Array, Array]:
    middle = 0.5 * (start + stop)
    sizes = _Sizes.of(sheet, start, stop)
    panels = sheet.panels(middle)
    speed, acceleration = _middle(sheet, middle, panels)

    def bound(edges: Complex, rows: Integers, columns: Integers) -> Array:
        """Bounds for edges (a, b) of the flat sheet, in panels of rows (a,) and columns (b,)."""
        index = (slice(None), rows[:, None], columns)
        edge = Rotations(panels.a[index], panels.b[index]).turned(edges)
        w, length = speed[index], np.abs(edges)
        exact = np.cross(acceleration[index], edge) + np.cross(w, np.cross(w, edge))
        near = np.linalg.norm(exact, axis=-1) + length * sizes.departure[index]
        return np.asarray(np.minimum(near, length * sizes.largest[index]))

    # Of the two panels beside an edge, that nearer to the anchor.
    row, column = sheet.anchor
    i, j = (np.arange(count) for count in sheet.flat.shape)
    along = bound(np.diff(sheet.flat, axis=1), i - (i > row), j[:-1])
    down = bound(np.diff(sheet.flat, axis=0), i[:-1], j - (j > column))
    return along.max(axis=1), down.max(axis=2)


def _middle(sheet: Sheet, drive: Array, panels: Rotations) -> tuple[Array, Array]:
    """Angular velocity and its derivative (S, m+1, n+1, 3) of all panels at drives (S,)."""
    row, column = sheet.anchor
    rates = fold_rates(sheet.columns, sheet.flat_foldable, drive, drive)
    across_column = -1j * np.exp(1j * sheet.directions.column[row])
    across_row = -np.exp(1j * sheet.directions.row)
    axes = (panels[:, row : row + 1, 1:].turned(across_column), panels[:, 1:].turned(across_row))
    signs = sheet.signs[row : row + 1], sheet.signs[1:]

    speed, acceleration = sheet.turn[None, None, None], np.zeros((1, 1, 1, 3))
    for each, axis, sign, at, along in zip(rates, axes, signs, (column, row), (2, 1), strict=True):
        first, second = (sign[:, None, None] * x.low[..., None] for x in (each.first, each.second))
        speed = speed + _from(first * axis, at, along)
        bend = second * axis + first * np.cross(_sides(speed, along)[0], axis)
        acceleration = acceleration + _from(bend, at, along)
    return speed, acceleration


@record
class _Sizes:
    """Bounds for all panels (S, m+1, n+1) while the drive is in ranges (S,)."""

    largest: Array  # |e''| by the edge's length
    departure: Array  # |e'' - its value in the middle| by the edge's length

    @classmethod
    def of(cls, sheet: Sheet, start: Array, stop: Array) -> _Sizes:
        half = (0.5 * (stop - start))[:, None, None]
        speed = np.full((1, 1, 1), np.linalg.norm(sheet.turn))
        acceleration, change = np.zeros((2, 1, 1, 1))
        row, column = sheet.anchor
        rates = fold_rates(sheet.columns, sheet.flat_foldable, start, stop)
        for each, at, along in zip(rates, (column, row), (2, 1), strict=True):
            first, second = each.first.magnitude(), each.second.magnitude()
            speed = speed + np.abs(_from(first, at, along))
            w = np.minimum(*_sides(speed, along))  # on the anchor's side
            acceleration = acceleration + np.abs(_from(second + first * w, at, along))
            step = (each.second.high - each.second.low) + half * (
                2 * second * w + first * (np.minimum(*_sides(acceleration, along)) + w**2)
            )
            change = change + np.abs(_from(step, at, along))
        return cls(
            largest=acceleration + speed**2,
            departure=change + half * (3 * speed * acceleration + speed**3),
        )


def _from(steps: Array, anchor: int, axis: int) -> Array:
    """Sums of ``steps`` over the creases from the anchor to every panel, negative before it."""
    shape = list(steps.shape)
    shape[axis] += 1
    sums = np.zeros(shape)
    np.cumsum(steps, axis=axis, out=_sides(sums, axis)[1])
    sums -= np.take(sums, [anchor], axis)
    return sums


def _sides(panels: Array, axis: int) -> tuple[Array, Array]:
    """The values of the panels before every crease, and of those after it."""
    before, after = [slice(None)] * panels.ndim, [slice(None)] * panels.ndim
    before[axis], after[axis] = slice(-1), slice(1, None)
    return panels[tuple(before)], panels[tuple(after)]
