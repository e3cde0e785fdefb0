r"""All flat-foldable quadrilateral meshes that fold rigidly, from a row and a column of each.

At vertex (i, j), i down and j to the right, the sectors left-down and right-down are a and b;
right-up and left-up are pi - a and pi - b, as a vertex that folds flat has them (Kawasaki). With
T = tan(sector/2) and u, v the tangents of half the fold angles of its row and column creases,

    row mode     u_left = u_right,  v_up = -v_down,  m = -u_right/v_down,  T_a T_b = (m-1)/(m+1),
    column mode  v_up = v_down,  u_left = -u_right,  m = -u_right/v_down,  T_a/T_b = (1+m)/(1-m):

those creases keep their sign that fold more. So tangents keep their size along whole rows and
columns, u = +-x_i t and v = +-y_j t with one parameter t of the motion, and x and y say all about
how a sheet folds (Feng, Dang, James and Plucinsky, J. Mech. Phys. Solids 142 (2020) 104018). The
angles a of one row and one column give those of all, as the four sectors of a panel sum to 2 pi,

    b_ij + a_i,j+1 = a_i+1,j + b_i+1,j+1,

and lengths along them all lengths, panel by panel. Everything is analytic: complex numbers give
exact derivatives by complex steps. The last axis of all arrays is one of many sheets.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.families.flat_foldable.march import (
    Numbers,
    march_lengths,
    march_of,
    march_sectors,
)
from orishell.numerics.arrays import Array, Booleans


@record
class Net:
    """What makes a sheet of R x C inner vertices, B sheets at once."""

    x: Numbers  # (R, B), tangents of half the fold angles of the row creases at t = 1, signed
    y: Numbers  # (C, B), those of the column creases
    # log tan(a/2) along the middle row (C, B) and the middle column (R, B), alike where they meet
    row_angles: Numbers
    column_angles: Numbers
    row_lengths: Numbers  # (C-1, B), of the edges along the middle row
    column_lengths: Numbers  # (R-1, B), of those down the middle column
    top: Numbers  # (C, B), of the creases that end at the border
    bottom: Numbers  # (C, B)
    left: Numbers  # (R, B)
    right: Numbers  # (R, B)
    # corners (4, 2, B), top left, top right, bottom left, bottom right: from the nearest inner
    # vertex by shares of the ways to the border vertices beside it, along the row and the column
    corners: Numbers

    @property
    def middle(self) -> tuple[int, int]:
        """The row and the column that are given."""
        return len(self.x) // 2, len(self.y) // 2

    @property
    def row_mode(self) -> Booleans:
        """Which vertices (R, C) are of the row mode: those whose row creases fold more."""
        return np.asarray(np.abs(self.x[:, None, 0].real) > np.abs(self.y[None, :, 0].real))

    def march(self, column: int | None = None) -> Sheet:
        """The sheet; sectors are not numbers, or lengths negative, where there is none.

        column: The number of the column that is given; the middle one if None.
        """
        i, j = self.middle
        given = i, j if column is None else column % len(self.y)
        mode, row_signs, column_signs, ties = self._ties()
        with np.errstate(all="ignore"):
            a, b = self._sectors(ties, mode, given)
            lengths = self._lengths(a, b, given)
        return Sheet(self, a, b, *lengths, row_signs, column_signs)

    def with_straight_columns(self) -> Net:
        """The net, its creases going straight on along the middle row and column.

        Columns do where rows fold more (a = b), and rows where columns do (a + b = pi).
        """
        _, _, _, ties = self._ties()
        straight = 0.5 * ties
        i, j = self.middle
        return replace(self, row_angles=straight[i], column_angles=straight[:, j])

    def with_straight_column(self, column: int) -> Net:
        """The net, a column of row mode that is given going straight on in all rows."""
        _, _, _, ties = self._ties()
        straight, row = 0.5 * ties[:, column], self.row_angles.copy()
        row = row.astype(np.result_type(row, straight))
        row[column] = straight[self.middle[0]]
        return replace(self, row_angles=row, column_angles=straight)

    def _ties(self) -> tuple[Booleans, Array, Array, Numbers]:
        """Modes (R, C), signs of creases, and log tan(a/2) +- log tan(b/2) (R, C, B)."""
        mode = self.row_mode
        row_signs = np.ones((mode.shape[0], mode.shape[1] + 1))
        column_signs = np.ones((mode.shape[0] + 1, mode.shape[1]))
        row_signs[:, 1:] = np.cumprod(np.where(mode, 1.0, -1.0), axis=1)
        column_signs[1:] = np.cumprod(np.where(mode, -1.0, 1.0), axis=0)
        m = -(row_signs[:, 1:, None] * self.x[:, None]) / (column_signs[1:, :, None] * self.y)
        # A vertex with equal tangents has no sectors: m = 1.
        with np.errstate(divide="ignore", invalid="ignore"):
            ties = np.log(np.where(mode[..., None], (m - 1) / (m + 1), (1 + m) / (1 - m)))
        return mode, row_signs, column_signs, ties

    def _sectors(
        self, ties: Numbers, mode: Booleans, given: tuple[int, int]
    ) -> tuple[Numbers, Numbers]:
        """Sectors a and b (R, C, B): from the cross to the four quadrants beside it."""
        i, j = given
        a = np.zeros(ties.shape, np.result_type(ties, self.row_angles))
        a[i], a[:, j] = self.row_angles, self.column_angles
        b = np.where(mode[..., None], ties - a, a - ties)
        march = march_of(mode.shape, given)
        seen = march.seen(a, b)
        march_sectors(march, *seen, *march.seen_ties(ties, mode))
        a, b = march.unseen(seen, a.shape)
        return 2 * np.arctan(np.exp(a)), 2 * np.arctan(np.exp(b))

    def _lengths(self, a: Numbers, b: Numbers, given: tuple[int, int]) -> tuple[Numbers, Numbers]:
        """Lengths of edges along rows (R, C-1, B) and down columns (R-1, C, B)."""
        i, j = given
        count, across, many = a.shape
        rows = np.empty((count, across - 1, many), a.dtype)
        columns = np.empty((count - 1, across, many), a.dtype)
        rows[i], columns[:, j] = self.row_lengths, self.column_lengths
        march = march_of(a.shape[:2], given)
        march_lengths(march, rows, columns, *march.seen_sectors(a, b))
        return rows, columns


@record
class Sheet:
    """A sheet that was marched: all its sectors and lengths, and the signs of its creases."""

    net: Net
    a: Numbers  # (R, C, B), sectors left-down of inner vertices
    b: Numbers  # (R, C, B), sectors right-down
    rows: Numbers  # (R, C-1, B), lengths of edges along rows
    columns: Numbers  # (R-1, C, B), lengths of edges down columns
    row_signs: Array  # (R, C+1), of row creases relative to x
    column_signs: Array  # (R+1, C), of column creases relative to y

    def tangents(self) -> tuple[Numbers, Numbers]:
        """Of half the fold angles at t = 1: row creases (R, C+1, B), column creases (R+1, C, B)."""
        net = self.net
        return (
            self.row_signs[..., None] * net.x[:, None],
            self.column_signs[..., None] * net.y[None],
        )

    def flat(self) -> Numbers:
        """Vertices (2, R+2, C+2, B) of the flat sheet.

        Its middle vertex is at 0, that one's right crease runs along x.
        """
        net, (i, j) = self.net, self.net.middle
        # A row crease's left neighbour lies a + b clockwise from it, the column crease below b.
        turns = np.cumsum(self.a + self.b - np.pi, axis=1)
        drops = np.zeros((len(self.a), 1, self.a.shape[2]), self.a.dtype)
        drops[1:, 0] = np.cumsum(self.a[1:, j] - self.b[:-1, j], axis=0)
        heading = drops - drops[i] + turns - turns[:, [j]]
        places = np.zeros((2, len(self.a) + 2, self.a.shape[1] + 2, self.a.shape[2]), self.a.dtype)
        inner = places[:, 1:-1, 1:-1]
        steps = self.columns[:, j] * _direction(heading[:-1, j] - self.b[:-1, j])
        inner[:, 1:] += np.cumsum(steps, axis=1)[:, :, None]
        inner -= inner[:, [i]].copy()
        along = np.zeros_like(inner)
        along[:, :, 1:] = np.cumsum(self.rows * _direction(heading[:, :-1]), axis=2)
        inner += along - along[:, :, [j]]
        up, below = heading[0] + np.pi - self.a[0], heading[-1] - self.b[-1]
        back = heading[:, 0] - self.a[:, 0] - self.b[:, 0]
        places[:, 0, 1:-1] = inner[:, 0] + net.top * _direction(up)
        places[:, -1, 1:-1] = inner[:, -1] + net.bottom * _direction(below)
        places[:, 1:-1, 0] = inner[:, :, 0] + net.left * _direction(back)
        places[:, 1:-1, -1] = inner[:, :, -1] + net.right * _direction(heading[:, -1])
        for shares, (row, column) in zip(net.corners, CORNERS, strict=True):
            near_row, near_column = (1 if at == 0 else -2 for at in (row, column))
            near = places[:, near_row, near_column]
            places[:, row, column] = (
                near
                + shares[0] * (places[:, near_row, column] - near)
                + shares[1] * (places[:, row, near_column] - near)
            )
        return places


CORNERS = ((0, 0), (0, -1), (-1, 0), (-1, -1))
"""Rows and columns of the corners of a sheet."""


def _direction(angle: Numbers) -> Numbers:
    """Unit vectors (2, ...) at angles (...)."""
    return np.stack([np.cos(angle), np.sin(angle)])
