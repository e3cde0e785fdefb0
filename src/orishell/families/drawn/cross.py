"""All fold angles of a sheet from one row and one column of its vertices.

Along a row of vertices the sines of half the fold angles keep their proportions, as they do down a
column (module ``vertex``). So a row folds by one number, its *height*: the sine at the crease that
folds most in it. A row of vertices takes its height to all columns, a column of vertices its own to
all rows. What the other vertices disagree by is how far the sheet is from folding.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.families.drawn.vertex import Half, Numbers, Vertices
from orishell.families.shared.folding import HalfFolds

ALIKE = 1e-13
"""Sines whose proportion differs from 1 by less are alike, but for rounding."""
FOLDED_FLAT = 1e-100
"""The cosine of a crease that is folded flat: limits are those of creases nearly folded flat."""
LATER = 1e-12
"""A line closes before another one if its height then differs from 1 by more."""


def proportions(steps: Numbers, signs: Numbers) -> Numbers:
    """Signed sines (lines, creases, ...) of creases by that of the one that folds most in its line.

    steps: Sizes of sines by those of the creases before them (lines, creases - 1, ...).
    signs: Of the creases (lines, creases, ...); 0 of lines that stay unfolded.
    """
    sizes = np.cumprod(np.concatenate([np.ones_like(steps[:, :1]), steps], axis=1), axis=1)
    largest = np.take_along_axis(sizes, sizes.real.argmax(axis=1, keepdims=True), axis=1)
    return np.asarray(signs * sizes / largest)


def times(share: Numbers, half: Half) -> Half:
    """Sine and cosine of half a fold angle whose sine is a share of another's.

    Near 180 degrees, where 1 - s^2 has no digits left, from the other's cosine.
    """
    s, c = half
    rest = (1 - share) * (1 + share)
    square = rest - np.where(np.abs(rest.real) < ALIKE, rest.real, 0.0) + (share * c) ** 2
    least = FOLDED_FLAT * FOLDED_FLAT
    size = np.sqrt(np.where(square.real > least, square, least))
    return share * s, np.where(c.real < -LATER, -size, size)


@record
class Cross:
    """A row and a column of vertices from which all of a sheet folds.

    ``rows`` (R, C+1, ...) and ``columns`` (C, R+1, ...) are found by ``proportions``.
    """

    vertices: Vertices
    rows: Numbers
    columns: Numbers
    row: int = 0
    column: int = 0

    @property
    def turned(self) -> Cross:
        """The cross with rows and columns exchanged."""
        return Cross(self.vertices.turned, self.columns, self.rows, self.column, self.row)

    def from_row(self, height: Half) -> tuple[Half, Half]:
        """Heights (R, ...) of rows and (C, ...) of columns from that (...) of the cross's row."""
        columns = self.across(height)
        rows = self.turned.across((columns[0][self.column], columns[1][self.column]))
        for each, own in zip(rows, height, strict=True):
            each[self.row] = own
        return rows, columns

    def across(self, height: Half) -> Half:
        """Heights (C, ...) of all columns from that (...) of the cross's row."""
        s, c = times(self.rows[self.row], height)
        above = self.vertices.at(self.row).above((s[:-1], c[:-1]), c[1:])
        share = self.columns[:, self.row]
        folded = share != 0
        s, c = times(1 / np.where(folded, share, 1.0), above)
        return np.where(folded, s, 0.0), np.where(folded, c, 1.0)

    def folds(self, rows: Half, columns: Half) -> HalfFolds:
        """Cosines and sines of half the fold angles of all creases from heights of lines."""
        s, c = times(self.rows, (rows[0][:, None], rows[1][:, None]))
        across = times(self.columns, (columns[0][:, None], columns[1][:, None]))
        sine, cosine = (each.swapaxes(0, 1) for each in across)
        return HalfFolds(row=(c, s), column=(cosine, sine))

    def disagreement(self, folds: HalfFolds) -> Numbers:
        """By how much (R, C, ...) vertices and creases disagree (radians).

        What its upper crease should fold by, seen from the row, less what it does; the left crease,
        seen from the column, where the column creases have one sign.
        """
        (row_c, row_s), (column_c, column_s) = folds.row, folds.column
        first, v = self.vertices.mode > 0, self.vertices
        c = np.where(first, row_c[:, :-1], column_c[:-1])
        s = np.where(first, row_s[:, :-1], column_s[:-1])
        beyond = np.where(first, row_c[:, 1:], column_c[1:])
        cosine, sine = v.B * c + v.P * beyond, -np.where(first, v.A, v.C) * s
        own_c = np.where(first, column_c[:-1], row_c[:, :-1])
        own_s = np.where(first, column_s[:-1], row_s[:, :-1])
        return np.asarray(
            2 * np.arctan((sine * own_c - cosine * own_s) / (cosine * own_c + sine * own_s))
        )

    def earlier(self) -> Numbers:
        """Which rows close before, or with, which columns (R, C, ...)."""
        seen = (_crossing(self), _crossing(self.turned).swapaxes(0, 1))
        first = self.vertices.mode > 0
        return np.where(first, seen[0] <= 1 + LATER, seen[1] >= 1 - LATER)


def _crossing(cross: Cross) -> Numbers:
    """Heights (R, C, ...) of columns where rows close, of vertices in mode 1."""
    closed = np.ones_like(cross.rows), np.full_like(cross.rows, FOLDED_FLAT)
    s, c = times(cross.rows, closed)
    found, _ = replace(cross.vertices, mode=np.ones_like(cross.vertices.mode)).above(
        (s[:, :-1], c[:, :-1]), c[:, 1:]
    )
    share = cross.columns[:, :-1].swapaxes(0, 1)
    return np.abs(found / np.where(share != 0, share, np.inf))
