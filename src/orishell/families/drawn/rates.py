r"""Bounds of how fast the creases of a sheet fold, in ranges of the drive.

From a crease of a line to another, whose sine is k times as large: rho' = k c/c_k, which grows with
the drive if k > 1 and falls if k < 1, and rho'' = k (k^2 - 1) s/(2 c_k^3), whose size grows. From a
crease v to its neighbour u, with o and w opposite to them and constants as in ``vertex``,

    r = A c_u c_w/((B c_v + P c_o) c_o)    (mode 1),
    r = (B c_u + P c_w) c_w/(C c_v c_o)    (mode -1),

because rates at a vertex are proportional to the sine of the crease times the cosine of the one
opposite. Creases fold further and further, so that sines grow and cosines fall, and bounds are
those of the ends of a range. The logarithmic derivative of r has positive and negative terms: its
size is at most that of the positive ones or that of the negative ones. Where several creases fold
flat together bounds are larger than any that shows something.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from orishell.conventions.record import record
from orishell.families.drawn.cross import ALIKE, Cross, times
from orishell.families.drawn.drive import Drive
from orishell.families.drawn.vertex import Half, Vertices
from orishell.families.shared.chains import Rates
from orishell.numerics.arrays import Array, Booleans

LARGEST = 1e60
"""Bounds are no larger: with this no range of the drive is short enough to show anything."""


@record
class Ends:
    """Creases (..., S) in ranges of the drive."""

    share: Array  # size of its sine by the height of its line (..., 1)
    sine: Array  # its size at the stop, where it is largest
    start: Array  # cosine at the start
    stop: Array  # and at the stop, where it is least

    @classmethod
    def of(cls, shares: Array, starts: Half, stops: Half) -> Ends:
        """Those of all creases (lines, creases, S) from heights (lines, S)."""
        _, start = times(shares, (starts[0][:, None], starts[1][:, None]))
        sine, stop = times(shares, (stops[0][:, None], stops[1][:, None]))
        return cls(np.abs(shares), np.abs(sine), start, stop)

    def __getitem__(self, which: Any) -> Ends:
        return Ends(*(each[which] for each in (self.share, self.sine, self.start, self.stop)))

    def pairs(self, other: Ends) -> tuple[Ends, Ends]:
        """Of two opposite creases the one that folds more, and the other."""
        more = self.share >= other.share
        pairs = [
            (np.where(more, a, b), np.where(more, b, a))
            for a, b in (
                (self.share, other.share),
                (self.sine, other.sine),
                (self.start, other.start),
                (self.stop, other.stop),
            )
        ]
        return Ends(*(one for one, _ in pairs)), Ends(*(other for _, other in pairs))


def fold_rates(
    drive: Drive, start: Array, stop: Array, which: tuple[Any, Any]
) -> tuple[Rates, Rates]:
    """Rates of row creases (R, ..., S) and column creases (C, ..., S) of the drive's cross.

    which: Creases of rows and of columns that are asked for.
    """
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        return _fold_rates(drive, start, stop, which)


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
    known = Rates(still + 1, still + 1, still)
    folded = cross.columns[:, :1] != 0
    beside, of_beside = _across(cross, rows, columns, leading, known)
    of_columns = _in_lines(of_beside, beside, columns[:, which[1]], folded)
    j, turned = cross.column, cross.turned
    one = Rates(of_beside.low[j], of_beside.high[j], of_beside.second[j])
    above, of_above = _across(turned, columns, rows, beside[j], one)
    of_rows = _in_lines(of_above, above, rows[:, which[0]], cross.rows[:, :1] != 0)
    own = _along(known, leading, rows[cross.row][which[0]])
    for name in ("low", "high", "second"):
        getattr(of_rows, name)[cross.row] = getattr(own, name)
    return of_rows, of_columns


def _in_lines(rates: Rates, beside: Ends, wanted: Ends, folded: Booleans) -> Rates:
    """Rates of the creases that are asked for from those of one crease of every line."""
    if wanted.sine.ndim == beside.sine.ndim:
        folded = folded[:, 0]
    else:
        rates = Rates(rates.low[:, None], rates.high[:, None], rates.second[:, None])
        beside = beside[:, None]
    found = _along(rates, beside, wanted)
    low, high, second = (
        np.where(folded, np.fmin(each, LARGEST), 0.0)
        for each in (found.low, found.high, found.second)
    )
    return Rates(low, high, second, alike=False)


def _along(rates: Rates, crease: Ends, other: Ends) -> Rates:
    """Rates of other creases of a line from those of one."""
    k = other.share / crease.share
    ends = k * crease.start / other.start, k * crease.stop / other.stop
    bend = np.where(np.abs(k - 1) < ALIKE, 0.0, np.abs(k * k - 1))
    second = 0.5 * k * bend * crease.sine / other.stop**3
    return _then(rates, Rates(np.minimum(*ends), np.maximum(*ends), second))


def _then(first: Rates, second: Rates) -> Rates:
    """Rates of what folds at some rate by what folds at another by the drive."""
    return Rates(
        first.low * second.low,
        first.high * second.high,
        second.second * first.high**2 + second.high * first.second,
    )


def _across(
    cross: Cross, rows: Ends, columns: Ends, leading: Ends, known: Rates
) -> tuple[Ends, Rates]:
    """The crease (C, S) of every column that folds more at the cross's row, and its rates.

    leading: A crease of the row, whose rates are known.
    """
    own, i = rows[cross.row], cross.row
    v, o = own[:-1].pairs(own[1:])
    u, w = columns[:, i].pairs(columns[:, i + 1])
    right = (own.share[:-1] < own.share[1:]).astype(int)
    lower = (columns.share[:, i] < columns.share[:, i + 1]).astype(int)
    vertices = cross.vertices.in_row(i)
    rate = _of_vertices(vertices, (right, lower), (v, o), (u, w))
    return u, _then(_along(known, leading, v), rate)


def _of_vertices(
    vertices: Vertices, sides: tuple[Array, Array], v_o: tuple[Ends, Ends], u_w: tuple[Ends, Ends]
) -> Rates:
    """Rates of column creases u by row creases v, at sides right (0, 1) and lower (0, 1)."""
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
    of_o = o.share / v.share * v.start / o.start
    of_w = w.share / u.share * u.start / w.start * high
    tan_u, tan_w, tan_v, tan_o = (each.sine / each.stop for each in (u, w, v, o))
    falls = np.where(
        first,
        tan_u * high + tan_w * of_w,
        (B * u.sine * high + P * w.sine * of_w) / up_stop + tan_w * of_w,
    )
    grows = np.where(
        first, (B * v.sine + P * o.sine * of_o) / base_stop + tan_o * of_o, tan_v + tan_o * of_o
    )
    return Rates(low, high, 0.5 * high * np.maximum(falls, grows))
