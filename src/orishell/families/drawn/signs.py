"""Mountains and valleys that let a sheet fold, where some or all are not said.

At a small drive of one row every column has two heights, one for either mode of its vertex there,
and from one column every row has two (modules ``vertex`` and ``cross``). A row and a column fit
where heights agree in one of the modes of their vertex. So there are two choices for every line,
and conditions on pairs of lines: what is ruled out is struck until nothing more is, and where a
choice is left both are followed.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.families.drawn.cross import Cross, proportions, times
from orishell.families.drawn.drive import find_drive
from orishell.families.drawn.sheet import find_cross
from orishell.families.drawn.vertex import Half, Vertices
from orishell.motion.grid import CreaseValues
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.equals import first_largest

SMALL_FOLD = 0.01
"""Sine of half the fold angle at which choices are told apart: no crease is near closing."""
FIT = 0.02
"""Heights agree where they differ by no more than this share: sheets may fold only nearly."""
LEAST_HEIGHT = 1e-9
"""Lines whose heights are below this stay unfolded: these are 0 but for rounding."""
DRIVES = np.array([0.4, 0.9])
FOLDS = 0.02
"""A choice is one that folds, or nearly, if vertices disagree by less at these drives (radians)."""
EXACT = 1e-9
"""Ways that miss by no more come first (radians)."""
ROUNDED, NEAR = 1e-6, 10.0
"""Ways are left out that miss by more than coordinates rounded to so much of the diagonal do, and
than so many times what the best of them misses by."""
MOST_WAYS = 16
"""Ways to fold that are found, at most."""
TRIALS = 200
"""Choices that are followed, at most."""


def find_signs(flat: Array, given: CreaseValues) -> list[CreaseValues]:
    """Signs of all creases with which a sheet folds, at most :data:`MOST_WAYS`.

    First those with which it folds exactly, and of these those with which most creases fold. Up to
    turning the sheet over, where nothing is given that tells.

    Parameters
    ----------
    flat
        Vertices (rows, columns, 2).
    given
        Signs, NaN where they are to be found.
    """
    found = _ways(flat, given)
    # A row in the middle may stay unfolded where columns fold: they change parts.
    turned = _ways(flat.swapaxes(0, 1)[..., ::-1], CreaseValues(given.column.T, given.row.T))
    for apart, signs in turned.values():
        back = CreaseValues(signs.column.T, signs.row.T)
        if not back.row[(back.row.shape[0] - 1) // 2].any():
            found[back.on_edges().tobytes()] = apart, back
    ways = sorted(found.values(), key=lambda each: (each[0] > EXACT, _unfolded(each[1])))[
        :MOST_WAYS
    ]
    edges = np.concatenate([np.diff(flat, axis=k).reshape(-1, 2) for k in (0, 1)])
    size = float(np.linalg.norm(np.ptp(flat, axis=(0, 1))))
    rounding = ROUNDED * size / float(np.linalg.norm(edges, axis=-1).min())
    least = min((apart for apart, _ in ways), default=0.0)
    return [signs for apart, signs in ways if apart <= max(rounding, NEAR * least)]


def _ways(flat: Array, given: CreaseValues) -> dict[bytes, tuple[float, CreaseValues]]:
    """Signs of a sheet whose row in the middle folds, and by how much vertices disagree."""
    places = np.moveaxis(flat, -1, 0)[..., None]
    found: dict[bytes, tuple[float, CreaseValues]] = {}
    with np.errstate(all="ignore"):
        for mode, folded in _choices(places):
            signs = _signs_of(places, mode, folded, given)
            if signs is None:
                continue
            apart = _apart(places, signs)
            if apart < FOLDS:
                found[signs.on_edges().tobytes()] = apart, signs
            if len(found) == MOST_WAYS:
                break
    return found


def _choices(flat: Array) -> Iterator[tuple[Array, tuple[Booleans, Booleans]]]:
    """Modes (R, C) of vertices that fit, and which rows (R,) and columns (C,) fold then."""
    inner = flat.shape[1] - 2, flat.shape[2] - 2
    vertices = Vertices.of(flat, np.ones((*inner, 1)))
    rows = proportions(vertices.beyond_row, np.ones((inner[0], inner[1] + 1, 1)))
    down = vertices.beyond_column.swapaxes(0, 1)
    columns = proportions(down, np.ones((inner[1], inner[0] + 1, 1)))
    cross = Cross(vertices, rows, columns, inner[0] // 2)
    first = np.full(1, SMALL_FOLD), np.sqrt(1 - np.full(1, SMALL_FOLD) ** 2)
    s, c = _both_modes(cross, first)
    # A column that stays unfolded takes nothing to the rows.
    cross = replace(cross, column=first_largest(np.nan_to_num(s[..., 0]).min(axis=1)))
    for choice in range(2):
        of_rows, _ = _both_modes(cross.turned, (s[cross.column, choice], c[cross.column, choice]))
        x, y = of_rows[..., 0], s[..., 0].copy()
        x[cross.row] = SMALL_FOLD, np.nan
        y[cross.column] = y[cross.column, choice], np.nan
        misfits = _misfits(cross, x, y)
        fits = np.asarray((misfits <= 1).any(axis=0))
        for row, column in _consistent(fits, np.isfinite(x), np.isfinite(y)):
            i, j = np.ogrid[: inner[0], : inner[1]]
            first_mode, second = misfits[:, i, row[:, None], j, column]
            folded = x[i[:, 0], row] > LEAST_HEIGHT, y[j[0], column] > LEAST_HEIGHT
            yield np.where(first_mode <= second, 1.0, -1.0), folded


def _both_modes(cross: Cross, height: Half) -> Half:
    """Heights (C, 2, 1) of columns in both modes, from that (1,) of the row; NaN beyond closing."""
    found = []
    for mode in (1.0, -1.0):
        vertices = replace(cross.vertices, mode=np.full_like(cross.vertices.mode, mode))
        s, c = replace(cross, vertices=vertices).across(height)
        found.append((np.where((c > 0) & (np.abs(s) <= 1), np.abs(s), np.nan), c))
    sines, cosines = (np.stack(each, axis=1) for each in zip(*found, strict=True))
    return sines, cosines


def _misfits(cross: Cross, x: Array, y: Array) -> Array:
    """What heights (R, 2) and (C, 2) miss by, over FIT: (2, R, 2, C, 2), in mode 1 and in -1."""
    of_columns = _crossing(cross, x)[..., None]
    of_rows = np.moveaxis(_crossing(cross.turned, y), -1, 0)[:, None]
    x = x[:, :, None, None]
    first = np.abs(of_columns - y) / (FIT * y + LEAST_HEIGHT)
    second = np.abs(of_rows - x) / (FIT * x + LEAST_HEIGHT)
    found = np.stack(np.broadcast_arrays(first, second))
    return np.where(np.isfinite(found), found, np.inf)


def _crossing(cross: Cross, heights: Array) -> Array:
    """Heights (R, 2, C) that rows of heights (R, 2) give to columns, in mode 1."""
    half = heights[..., None], np.sqrt(1 - heights[..., None] ** 2)
    s, c = times(cross.rows[:, None, :, 0], half)
    A, B, P = (
        each[:, None, :, 0] for each in (cross.vertices.A, cross.vertices.B, cross.vertices.P)
    )
    base, sine = B * c[..., :-1] + P * c[..., 1:], np.abs(A) * s[..., :-1]
    return np.asarray(sine / np.hypot(sine, base) / cross.columns[:, :-1, 0].T[:, None])


def _consistent(
    fits: Booleans, rows: Booleans, columns: Booleans
) -> Iterator[tuple[Integers, Integers]]:
    """Choices (R,) and (C,) among those of rows (R, 2) and columns (C, 2) that fit pair by pair.

    fits: Whether choices fit (R, 2, C, 2).
    """
    waiting = [(rows, columns)]
    for _ in range(TRIALS):
        if not waiting:
            return
        rows, columns = waiting.pop()
        before = -1
        while (left := int(rows.sum() + columns.sum())) != before:
            before = left
            rows = rows & np.any(fits & columns, axis=3).all(axis=2)
            columns = columns & np.any(fits & rows[:, :, None, None], axis=1).all(axis=0)
        if not (rows.any(axis=1).all() and columns.any(axis=1).all()):
            continue
        if left == len(rows) + len(columns):
            yield rows.argmax(axis=1), columns.argmax(axis=1)
            continue
        for choice in (1, 0):
            branch = np.concatenate([rows, columns])
            branch[int(np.argmax(branch.all(axis=1))), choice] = False
            waiting.append((branch[: len(rows)], branch[len(rows) :]))


def _signs_of(
    flat: Array, mode: Array, folded: tuple[Booleans, Booleans], given: CreaseValues
) -> CreaseValues | None:
    """Signs by modes, and by which rows and columns fold; None if others are given."""
    vertices = Vertices.of(flat, mode[..., None])
    turns = -np.sign(np.where(mode > 0, vertices.A[..., 0], vertices.C[..., 0]))
    ones = np.ones_like(mode)
    row = np.cumprod(np.concatenate([ones[:, :1], mode], axis=1), axis=1)
    column = np.cumprod(np.concatenate([ones[:1], -mode], axis=0), axis=0)
    # From the first row to all columns that fold, and from the first of these to the rows.
    i, j = int(folded[0].argmax()), int(folded[1].argmax())
    if folded[0].any() and folded[1].any():  # else a line folds without any that crosses it
        column *= turns[i] * row[i, :-1] * column[i]
        row *= (turns[:, j] * column[:-1, j] * row[:, j])[:, None]
    row *= folded[0][:, None]
    column *= folded[1]
    for side in (1.0, -1.0):
        signs = CreaseValues(side * row, side * column)
        pairs = (signs.row, given.row), (signs.column, given.column)
        if all((np.isnan(asked) | (made == asked)).all() for made, asked in pairs):
            return signs
    return None


def _unfolded(signs: CreaseValues) -> int:
    return int((signs.row == 0).sum() + (signs.column == 0).sum())


def _apart(flat: Array, signs: CreaseValues) -> float:
    """By how much vertices disagree at most (radians); inf if the signs cannot fold."""
    try:
        drive = find_drive(find_cross(flat, signs))
    except DesignError:
        return np.inf
    if drive is None:
        return np.inf
    apart = np.abs(drive.disagreement(DRIVES)).max()
    return float(apart) if np.isfinite(apart) else np.inf
