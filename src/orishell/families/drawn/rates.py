r"""Bounds of how fast the creases of a sheet fold, in ranges of the drive.

From a crease of a line to another, whose sine is k times as large: rho' = k c/c_k, which grows with
the drive if k > 1 and falls if k < 1, and rho'' = k (k^2 - 1) s/(2 c_k^3), whose size grows. From a
crease v to its neighbour u, with o and w opposite to them and constants as in ``vertex``,

    r = A c_u c_w/((B c_v + P c_o) c_o)    (mode 1),
    r = (B c_u + P c_w) c_w/(C c_v c_o)    (mode -1),

because rates at a vertex are proportional to the sine of the crease times the cosine of the one
opposite. Creases fold further and further, so that sines grow and cosines fall, and bounds are
those of the ends of a range. The logarithmic derivative of r has positive and negative terms, which
all grow: so the second derivatives of fold angles, of either sign, are in a range, too. Where
several creases fold flat together bounds are larger than any that shows something.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from orishell.conventions.record import record
from orishell.families.drawn.cross import ALIKE, Cross, times
from orishell.families.drawn.drive import Drive
from orishell.families.drawn.vertex import Half, Vertices
from orishell.families.shared.chains import Rates
from orishell.numerics.arrays import Array, Booleans

LARGEST_BOUND = 1e60
"""Bounds are no larger: with this no range of the drive is short enough to show anything."""


@record
class Ends:
    """Creases (..., S) in ranges of the drive."""

    share: Array  # size of its sine by the height of its line (..., 1)
    sine: Array  # its size at the stop, where it is largest
    first: Array  # and at the start
    start: Array  # cosine at the start
    stop: Array  # and at the stop, where it is least

    @classmethod
    def of(cls, shares: Array, starts: Half, stops: Half) -> Ends:
        """Those of all creases (lines, creases, S) from heights (lines, S)."""
        first, start = times(shares, (starts[0][:, None], starts[1][:, None]))
        sine, stop = times(shares, (stops[0][:, None], stops[1][:, None]))
        return cls(np.abs(shares), np.abs(sine), np.abs(first), start, stop)

    @property
    def parts(self) -> tuple[Array, ...]:
        """All fields."""
        return self.share, self.sine, self.first, self.start, self.stop

    def __getitem__(self, which: Any) -> Ends:
        return Ends(*(each[which] for each in self.parts))

    def pairs(self, other: Ends) -> tuple[Ends, Ends]:
        """Of two opposite creases the one that folds more, and the other."""
        more = self.share >= other.share
        pairs = [
            (np.where(more, a, b), np.where(more, b, a))
            for a, b in zip(self.parts, other.parts, strict=True)
        ]
        return Ends(*(one for one, _ in pairs)), Ends(*(other for _, other in pairs))


Range = tuple[Array, Array]
"""Least and largest."""


@record
class Swing:
    """How creases (..., S) fold by the drive, all by the sign of the fold angle."""

    rate: Range
    bend: Range  # second derivatives

    def __getitem__(self, which: Any) -> Swing:
        (low, high), (down, up) = self.rate, self.bend
        return Swing((low[which], high[which]), (down[which], up[which]))

    def rates(self) -> Rates:
        """Their bounds; none is larger than LARGEST_BOUND."""
        low, high, down, up = (
            np.clip(np.nan_to_num(each, nan=nan), -LARGEST_BOUND, LARGEST_BOUND)
            for each, nan in zip(
                (*self.rate, *self.bend), (0, np.inf, -np.inf, np.inf), strict=True
            )
        )
        return Rates(low, high, np.maximum(-down, up), (down, up))


def fold_rates(
    drive: Drive, start: Array, stop: Array, which: tuple[Any, Any]
) -> tuple[Rates, Rates]:
    """Rates of row creases (R, ..., S) and column creases (C, ..., S) of the drive's cross.

    which: Creases of rows and of columns that are asked for.
    """
    middle = 0.5 * (start + stop)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        wide, narrow = (
            _fold_rates(drive, *ends, which) for ends in ((start, stop), (middle, middle))
        )
    rows, columns = (
        replace(
            each,
            middle=(np.where(at.high < LARGEST_BOUND, at.high, np.nan), 0.5 * (stop - start)),
        )
        for each, at in zip(wide, narrow, strict=True)
    )
    return rows, columns


def _fold_rates(
    drive: Drive, start: Array, stop: Array, which: tuple[Any, Any]
) -> tuple[Rates, Rates]:
    starts, stops = drive.heights(start), drive.heights(stop)
    cross = drive.cross
    rows, columns = (
        Ends.of(shares, *heights)
        for shares, heights in (
            (cross.rows, (starts[0], stops[0])),
            (cross.columns, (starts[1], stops[1])),
        )
    )
    leading = rows[cross.row][int(np.abs(cross.rows[cross.row, :, 0]).argmax())]
    still = np.zeros(len(start))
    known = Swing((still + 1, still + 1), (still, still))
    folded = cross.columns[:, :1] != 0
    beside, of_beside = _across(cross, rows, columns, leading, known)
    of_columns = _in_lines(of_beside, beside, columns[:, which[1]], folded)
    j, turned = cross.column, cross.turned
    above, of_above = _across(turned, columns, rows, beside[j], of_beside[j])
    of_rows = _in_lines(of_above, above, rows[:, which[0]], cross.rows[:, :1] != 0)
    own = _along(known, leading, rows[cross.row][which[0]])
    for each, value in zip((*of_rows.rate, *of_rows.bend), (*own.rate, *own.bend), strict=True):
        each[cross.row] = value
    return of_rows.rates(), of_columns.rates()


def _in_lines(known: Swing, beside: Ends, wanted: Ends, folded: Booleans) -> Swing:
    """Those of the creases that are asked for from those of one crease of every line."""
    if wanted.sine.ndim == beside.sine.ndim:
        folded = folded[:, 0]
    else:
        known, beside = known[:, None], beside[:, None]
    found = _along(known, beside, wanted)
    rate, bend = (
        tuple(np.where(folded, each, 0.0) for each in pair) for pair in (found.rate, found.bend)
    )
    return Swing((rate[0], rate[1]), (bend[0], bend[1]))


def _along(known: Swing, crease: Ends, other: Ends) -> Swing:
    """Those of other creases of a line from those of one."""
    k = other.share / crease.share
    rates = k * crease.start / other.start, k * crease.stop / other.stop
    bend = 0.5 * k * np.where(np.abs(k - 1) < ALIKE, 0.0, k * k - 1)
    bends = bend * crease.first / other.start**3, bend * crease.sine / other.stop**3
    return _then(known, Swing(_ordered(rates), _ordered(bends)))


def _ordered(ends: Range) -> Range:
    return np.minimum(*ends), np.maximum(*ends)


def _then(first: Swing, second: Swing) -> Swing:
    """Those of what folds at some rate by what folds at another by the drive."""
    (low, high), (by_low, by_high) = first.rate, second.rate
    bends = [
        one + other
        for one, other in zip(
            _times(second.bend, (low * low, high * high)),
            _times(first.bend, second.rate),
            strict=True,
        )
    ]
    return Swing((low * by_low, high * by_high), (bends[0], bends[1]))


def _times(signed: Range, sizes: Range) -> Range:
    """Products of numbers of either sign with numbers of none."""
    low, high = signed
    return (
        np.minimum(low * sizes[0], low * sizes[1]),
        np.maximum(high * sizes[0], high * sizes[1]),
    )


def _across(
    cross: Cross, rows: Ends, columns: Ends, leading: Ends, known: Swing
) -> tuple[Ends, Swing]:
    """The crease (C, S) of every column that folds more at the cross's row, and how it folds.

    leading: A crease of the row, of which that is known.
    """
    own, i = rows[cross.row], cross.row
    v, o = own[:-1].pairs(own[1:])
    u, w = columns[:, i].pairs(columns[:, i + 1])
    right = (own.share[:-1] < own.share[1:]).astype(int)
    lower = (columns.share[:, i] < columns.share[:, i + 1]).astype(int)
    vertices = cross.vertices.at(i)
    rate = _of_vertices(vertices, (right, lower), (v, o), (u, w))
    return u, _then(_along(known, leading, v), rate)


def _of_vertices(
    vertices: Vertices, sides: tuple[Array, Array], v_o: tuple[Ends, Ends], u_w: tuple[Ends, Ends]
) -> Swing:
    """Those of column creases u by row creases v, at sides right (0, 1) and lower (0, 1)."""
    (v, o), (u, w), (right, lower) = v_o, u_w, sides

    def sector(across: Array, down: Array) -> Array:
        left, beyond = (np.where(down, each[1], each[0]) for each in vertices.sectors)
        return np.asarray(np.where(across, beyond, left))

    a, c = sector(right, 1 - lower), sector(1 - right, lower)
    # Sines of straight angles between opposite creases, from A and C of the upper left sector.
    ld, ru = vertices.sectors[0, 1], vertices.sectors[1, 0]
    A, C = a * np.abs(vertices.A / ld), c * np.abs(vertices.C / ru)
    B, P, first = a * c, vertices.P, vertices.mode > 0

    def sums(one: Ends, other: Ends) -> tuple[Array, Array]:
        return B * one.start + P * other.start, B * one.stop + P * other.stop

    (base_start, base_stop), (up_start, up_stop) = sums(v, o), sums(u, w)
    high = np.where(
        first,
        A * u.start * w.start / (base_stop * o.stop),
        up_start * w.start / (C * v.stop * o.stop),
    )
    low = np.where(
        first,
        A * u.stop * w.stop / (base_start * o.start),
        up_stop * w.stop / (C * v.start * o.start),
    )
    # The opposite creases fold less: their rates by those of u and v fall.
    of_o, of_w = (
        tuple(
            small.share / large.share * c
            for c in (large.stop / small.stop, large.start / small.start)
        )
        for small, large in ((o, v), (w, u))
    )

    def terms(end: int, rate: Array, base: Array, up: Array) -> Range:
        """How fast r falls and grows by v, over r/2: least at the start (0), most at the stop."""
        (s_v, t_v), (s_o, t_o), (s_u, t_u), (s_w, t_w) = (
            (each.sine, each.sine / each.stop) if end else (each.first, each.first / each.start)
            for each in (v, o, u, w)
        )
        r_o, r_w = of_o[end], of_w[end] * rate
        falls = np.where(first, t_u * rate, (B * s_u * rate + P * s_w * r_w) / up) + t_w * r_w
        grows = np.where(first, (B * s_v + P * s_o * r_o) / base, t_v) + t_o * r_o
        return falls, grows

    least, most = terms(0, low, base_start, up_start), terms(1, high, base_stop, up_stop)
    change = 0.5 * (least[1] - most[0]), 0.5 * (most[1] - least[0])
    return Swing((low, high), _times(change, (low, high)))
