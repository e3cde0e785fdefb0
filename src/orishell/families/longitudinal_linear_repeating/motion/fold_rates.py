"""How fast creases fold: first and second derivative of the fold angles by the drive, enclosed.

With v the drive, every fold angle of the mechanism's text is 2 atan2(Y, X), where in column
creases and F rows

    Y = P sin(v/2),    X = C cos(v/2),

and in S rows, the tangents' common factor cos(v/2)^2 multiplied out,

    Y = P sin v,       X = (A+B) + (A-B) cos v.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.families.longitudinal_linear_repeating.tessellation.columns import Columns
from orishell.numerics import Interval
from orishell.numerics.arrays import Array, Booleans


@record
class FoldRates:
    """First and second derivative of fold angles by the drive, per radian."""

    first: Interval
    second: Interval


def fold_rates(
    columns: Columns, flat_foldable: Booleans, start: Array, stop: Array
) -> tuple[FoldRates, FoldRates]:
    """Fold rates while the drive is in a range, for positive signs s of the mechanism's text.

    Parameters
    ----------
    columns
        Sectors and multipliers of the columns (n).
    flat_foldable
        Which rows are F rows (m,).
    start, stop
        Ends (S,) of ranges of the drive, in [0, pi] (radians).

    Returns
    -------
    tuple
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
    start, stop = drives
    square = Interval.between(_squares(P, C, start), _squares(P, C, stop))
    whole = Interval(np.ones_like(square.low), np.ones_like(square.low))
    return FoldRates(
        first=whole.over(square).times(P * C),
        second=_sine(start, stop).over(square.squared()).times(-0.5 * P * C * (P**2 - C**2)),
    )


def _squares(P: Array, C: Array, drive: Array) -> Array:
    return np.asarray((P * np.sin(drive / 2)) ** 2 + (C * np.cos(drive / 2)) ** 2)


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
