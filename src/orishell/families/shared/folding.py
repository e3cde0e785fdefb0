"""Folded states of a flat sheet whose fold angles are known.

A panel's rotation from the flat sheet is that of its neighbour times one about their crease, where
that lies in the flat sheet. As quaternions, they are carried from the middle down one column of
panels and then along all rows: rotations stay rotations to rounding, so that errors grow no faster
than the sheet.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.record import record

Numbers = NDArray[Any]

SERIES_BELOW = 1e-7
"""Squares of angles below this are so small that two terms of a series are exact (radians)."""


@record
class HalfFolds:
    """Cosines and sines of half the fold angles, valley positive."""

    row: tuple[Numbers, Numbers]  # of row creases (R, C+1, B)
    column: tuple[Numbers, Numbers]  # of column creases (R+1, C, B)

    @classmethod
    def of(
        cls, tangents: tuple[Numbers, Numbers], c: Numbers | float, s: Numbers | float
    ) -> HalfFolds:
        """Those at t = s/c from tangents of half the fold angles at t = 1: finite up to c = 0."""
        found = []
        for each in tangents:
            size = np.sqrt(c * c + (each * s) ** 2)
            found.append((c / size, each * s / size))
        return cls(found[0], found[1])


def fold(flat: Numbers, folds: HalfFolds, middle: tuple[int, int]) -> Numbers:
    """Vertices (3, R+2, C+2, B) of folded states.

    The middle inner vertex stays at 0, its right crease along x if it does so in the flat sheet;
    the panels beside that crease are equally steep.

    flat: Vertices (2, R+2, C+2, B or 1) of the flat sheet.
    folds: Of all creases (B).
    middle: Row and column of the middle inner vertex.
    """
    turns = _rotations(flat, folds, middle)
    i, j = (at + 1 for at in middle)
    last = turns.shape[1]
    level = np.minimum(np.arange(last + 1), last - 1)
    rows = _turned(turns[:, level], flat[:, :, 1:] - flat[:, :, :-1])
    down = _turned(turns[:, :, j], flat[:, 1:, j] - flat[:, :-1, j])
    places = np.zeros((3, last + 1, turns.shape[2] + 1, rows.shape[3]), rows.dtype)
    places[:, 1:, 0] = np.cumsum(down, axis=1)
    base = places[:, :, 0] - places[:, i, None, 0]
    places[:, :, 0] = 0.0
    np.cumsum(rows, axis=2, out=places[:, :, 1:])
    places += (base - places[:, :, j])[:, :, None]
    return places


def _rotations(flat: Numbers, folds: HalfFolds, middle: tuple[int, int]) -> Numbers:
    """Unit quaternions (4, R+1, C+1, B) of all panels."""
    (row_cos, row_sin), (column_cos, column_sin) = folds.row, folds.column
    i, j = middle[0], middle[1] + 1  # the middle crease, and the column of panels beside it
    to_left = _unit(flat[:, 1:-1, j] - flat[:, 1:-1, j + 1])
    downwards = _unit(flat[:, 1:, 1:-1] - flat[:, :-1, 1:-1])
    (rows, _, states), columns = row_cos.shape, column_cos.shape[1]
    kind = np.result_type(flat, row_cos)
    turns = np.empty((4, rows + 1, columns + 1, states), kind)
    cos, sin = row_cos[:, j], row_sin[:, j]
    # Half of the middle fold on either side: a quarter of its angle in a quaternion.
    half = np.sqrt(0.5 * (1 + cos[i]))
    turns[0, i, j], turns[3, i, j] = half, 0.0
    turns[1:3, i, j] = -0.5 * sin[i] / half * to_left[:, i]
    for k in range(i, rows):
        turns[:, k + 1, j] = _then(turns[:, k, j], cos[k], sin[k] * to_left[:, k])
    for k in range(i, 0, -1):
        turns[:, k - 1, j] = _then(turns[:, k, j], cos[k - 1], -sin[k - 1] * to_left[:, k - 1])
    for k in range(j, columns):
        axis = column_sin[:, k] * downwards[:, :, k]
        turns[:, :, k + 1] = _then(turns[:, :, k], column_cos[:, k], axis)
    for k in range(j, 0, -1):
        axis = -column_sin[:, k - 1] * downwards[:, :, k - 1]
        turns[:, :, k - 1] = _then(turns[:, :, k], column_cos[:, k - 1], axis)
    return turns


def _then(turn: Numbers, cos: Numbers, sin: Numbers) -> Numbers:
    """Quaternions (4, ...) times those of cosine (...) and sines (2, ...) about flat axes."""
    w, x, y, z = turn
    p, q = sin
    return np.stack(
        [w * cos - x * p - y * q, w * p + x * cos - z * q, w * q + y * cos + z * p,
         z * cos + x * q - y * p]
    )  # fmt: skip


def _turned(turn: Numbers, flat: Numbers) -> Numbers:
    """Flat vectors (2, ...) turned by unit quaternions (4, ...)."""
    w, x, y, z = turn
    p, q = flat
    return np.stack(
        [
            p - 2 * (y * y + z * z) * p + 2 * (x * y - w * z) * q,
            q - 2 * (x * x + z * z) * q + 2 * (x * y + w * z) * p,
            2 * (x * z - w * y) * p + 2 * (y * z + w * x) * q,
        ]
    )


def _unit(flat: Numbers) -> Numbers:
    return np.asarray(flat / np.sqrt((flat * flat).sum(axis=0)))


def turned(places: Numbers, by: Numbers) -> Numbers:
    """Places (3, ..., B) turned by rotation vectors (3, B) (radians): Rodrigues' formula."""
    square = (by * by).sum(axis=0)
    small = np.abs(square) < SERIES_BELOW
    angle = np.sqrt(np.where(small, 1.0, square))
    sine = np.where(small, 1 - square / 6, np.sin(angle) / angle)
    versine = np.where(small, 0.5 - square / 24, (1 - np.cos(angle)) / angle**2)
    w = by.reshape(3, *(1,) * (places.ndim - 2), -1)
    across = _cross(w, places)
    return np.asarray(places + sine * across + versine * _cross(w, across))


def _cross(u: Numbers, v: Numbers) -> Numbers:
    return np.stack(
        [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    )
