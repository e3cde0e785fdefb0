"""Sector angles of a flat sheet: what a family has in common, and by how much a sheet misses it.

Each function gives the miss of every condition (radians): the least change of sector angles, to
first order, that meets it. So it grows with errors of the vertices over the lengths of edges.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import CreaseValues
from orishell.numerics.arrays import Array, Booleans


@record
class Sectors:
    """Sector angles (R, C) at inner vertices, between creases of rows and columns (radians)."""

    ru: Array  # right-up
    lu: Array  # left-up
    ld: Array  # left-down
    rd: Array  # right-down
    # whether row creases are of one sign (R, C), which fold more then; None if that is not said
    row_mode: Booleans | None

    @property
    def straight(self) -> Array:
        """By how much (R, C) column creases are bent, half of it on either side."""
        return np.stack([self.ru + self.rd, self.lu + self.ld]) - np.pi

    @property
    def kawasaki(self) -> Array:
        """By how much (R, C) opposite sectors miss 180 degrees together."""
        return np.stack([self.lu + self.rd, self.ru + self.ld]) - np.pi

    def part(self, top: int, bottom: int, left: int, right: int) -> Sectors:
        """Those of a sheet that is cut off by so many rows and columns at its sides."""
        rows, columns = self.ru.shape
        place = slice(top, rows - bottom), slice(left, columns - right)
        mode = None if self.row_mode is None else self.row_mode[place]
        return Sectors(self.ru[place], self.lu[place], self.ld[place], self.rd[place], mode)


def sectors_of(flat: Array, signs: CreaseValues | None) -> Sectors:
    """Measure a flat sheet, drawn from either side.

    Parameters
    ----------
    flat
        Vertices (rows, columns, 2).
    signs
        Of the creases, NaN where none is said.
    """
    inner = flat[1:-1, 1:-1]
    around = [flat[1:-1, 2:], flat[:-2, 1:-1], flat[1:-1, :-2], flat[2:, 1:-1]]
    heading = [np.arctan2(*np.moveaxis(each - inner, -1, 0)[::-1]) for each in around]
    across, down = flat[:-1, 1:] - flat[:-1, :-1], flat[1:, :-1] - flat[:-1, :-1]
    seen = np.sign(np.sum(down[..., 0] * across[..., 1] - down[..., 1] * across[..., 0]))
    ru, lu, ld, rd = (
        np.mod(seen * (after - before), 2 * np.pi)
        for before, after in zip(heading, heading[1:] + heading[:1], strict=True)
    )
    return Sectors(ru, lu, ld, rd, None if signs is None else _row_mode(signs))


def _row_mode(signs: CreaseValues) -> Booleans | None:
    row, column = signs.row[:, :-1] * signs.row[:, 1:], signs.column[:-1] * signs.column[1:]
    if np.isnan(row).any() and np.isnan(column).any():
        return None
    return np.asarray(np.where(np.isnan(row), -column, row) > 0)


STEP = 1e-30
"""Of derivatives by complex steps, which lose nothing."""
INFINITE = 40.0
"""The logarithm of a ratio that is infinite: vertices at which only rows fold, or only columns."""


def same_rows(angles: Array) -> Array:
    """By how much angles (R, C) of rows differ from their mean."""
    return np.asarray(angles - angles.mean(axis=0))


def one_straight_row(sectors: Sectors) -> Array:
    """Columns go straight on, and all rows have the same sectors: parallel repeating."""
    return np.concatenate(
        [each.ravel() for each in (
            sectors.straight / np.sqrt(2), same_rows(sectors.ru), same_rows(sectors.lu),
        )]
    )  # fmt: skip


def parallel_columns(sectors: Sectors) -> Array:
    """Columns go straight on and are parallel."""
    apart = sectors.ru[:, :-1] + sectors.lu[:, 1:] - np.pi
    return np.concatenate([each.ravel() / np.sqrt(2) for each in (sectors.straight, apart)])


def miura(sectors: Sectors) -> Array:
    """Parallelograms, one row the mirror image of the next."""
    zigzag = (sectors.ru - sectors.lu) / np.sqrt(2)
    return np.concatenate([one_straight_row(sectors), parallel_columns(sectors), zigzag.ravel()])


def orthodiagonal(sectors: Sectors) -> Array:
    """Columns are parallel lines, slopes of rows across them products of their row and column.

    Cotangents of sectors, that is: equation (3) of the paper.
    """
    slopes = 1 / np.tan(np.concatenate([np.pi - sectors.lu[:, :1], sectors.ru], axis=1))
    left, size, right = np.linalg.svd(slopes, full_matrices=False)
    if not (left[:, 0] > 0).all() and not (left[:, 0] < 0).all():
        return np.full(1, np.inf)  # f is to turn to one side and the other by turns
    off = (slopes - size[0] * np.outer(left[:, 0], right[0])) / (1 + slopes**2)
    return np.concatenate([parallel_columns(sectors), off.ravel()])


def flat_foldable(sectors: Sectors) -> Array:
    """Kawasaki's condition, and ratios of tangents that are quotients of their row and column.

    |m| = |u/v| of half the fold angles of row and column creases, see families/flat_foldable/net.
    """
    a = 0.5 * (sectors.ld + np.pi - sectors.ru)
    b = 0.5 * (sectors.rd + np.pi - sectors.lu)
    kawasaki = (sectors.kawasaki / np.sqrt(2)).ravel()
    modes = [sectors.row_mode]
    if sectors.row_mode is None:
        modes = [np.full(a.shape, each) for each in (True, False)]
    found = [np.abs(_quotients(a, b, mode)) for mode in modes if mode is not None]
    return np.concatenate([kawasaki, min(found, key=np.max)])


def _quotients(a: Array, b: Array, row_mode: Booleans) -> Array:
    """By how much log |m| (R, C) misses X_i - Y_j, in changes of a and b."""
    first, second = np.tan(0.5 * a), np.tan(0.5 * b)
    k = np.where(row_mode, first * second, first / second)
    with np.errstate(divide="ignore"):
        ratio = np.abs(np.log(np.abs((1 + k) / (1 - k))))
        steepness = np.abs(2 * k / (1 - k * k)) * np.hypot(1 / np.sin(a), 1 / np.sin(b))
    log = np.where(row_mode, 1, -1) * np.minimum(ratio, INFINITE)
    steepness = np.clip(steepness, np.finfo(float).eps, np.exp(INFINITE))
    rows = len(log)
    weights = 1 / steepness**2
    matrix = np.block(
        [[np.diag(weights.sum(axis=1)), -weights], [-weights.T, np.diag(weights.sum(axis=0))]]
    )
    given = weights * log
    scale = 1 / np.sqrt(matrix.diagonal())
    fitted = (
        scale
        * np.linalg.lstsq(
            scale[:, None] * matrix * scale,
            scale * np.concatenate([given.sum(axis=1), -given.sum(axis=0)]),
        )[0]
    )
    off = log - fitted[:rows, None] + fitted[rows:]
    return np.asarray(off / steepness).ravel()


def longitudinal(sectors: Sectors) -> Array:
    """Rows that are flat-foldable and rows that columns go straight through, by turns; all alike.

    And equation (4) between neighbouring columns: fold angles of one are in proportion to those
    of the other, by the same factor in either kind of row.
    """
    found = [_alternating(sectors, first) for first in (0, 1)]
    return min(found, key=lambda each: float(np.abs(each).max()))


def _alternating(sectors: Sectors, first: int) -> Array:
    """The misses with flat-foldable rows from row ``first`` on."""
    if len(sectors.ru) < 2:
        return np.full(1, np.inf)
    folding, straight = slice(first, None, 2), slice(1 - first, None, 2)
    kinds = [
        sectors.kawasaki[:, folding] / np.sqrt(2), sectors.straight[:, straight] / np.sqrt(2),
        *(same_rows(each[rows]) for each in (sectors.ld, sectors.rd) for rows in
        (folding, straight)),
    ]  # fmt: skip
    angles = np.stack(
        [
            each[rows].mean(axis=0)
            for rows in (folding, straight)
            for each in (sectors.ld, sectors.rd)
        ]
    )
    beside = np.concatenate([angles[:, :-1], angles[:, 1:]])
    coupled = [np.abs(_miss(each, beside)).ravel() for each in (_by_cosines, _by_sines)]
    best = min(coupled, key=lambda each: each.max(initial=0.0))
    return np.concatenate([*(each.ravel() for each in kinds), best])


Equations = Callable[[Array], Array]


def _by_cosines(angles: Array) -> Array:
    """Equation (4) in its cosine version (2, C-1), of sectors ld, rd of F and S vertices (8, C-1).

    F vertices have tan(u/2) = -tan(v/2) cos((ld - rd)/2) / cos((ld + rd)/2).
    """
    ld, rd, _, _, ld_2, rd_2, _, _ = angles
    return _coupling(
        angles,
        np.cos(0.5 * (ld - rd)) * np.cos(0.5 * (ld_2 + rd_2)),
        np.cos(0.5 * (ld + rd)) * np.cos(0.5 * (ld_2 - rd_2)),
    )


def _by_sines(angles: Array) -> Array:
    """Equation (4) in its sine version (2, C-1); the row crease changes its sign at a vertex."""
    ld, rd, _, _, ld_2, rd_2, _, _ = angles
    return _coupling(
        angles,
        -np.sin(0.5 * (ld - rd)) * np.sin(0.5 * (ld_2 + rd_2)),
        np.sin(0.5 * (ld + rd)) * np.sin(0.5 * (ld_2 - rd_2)),
    )


def _coupling(angles: Array, above: Array, below: Array) -> Array:
    """Of S vertices, where fold angles of columns are as above to below, at all fold angles."""
    delta, gamma, delta_2, gamma_2 = angles[[2, 3, 6, 7]]
    near, far = np.sin(delta), np.sin(gamma_2)
    return np.stack(
        [
            near * np.sin(gamma_2 + delta_2) * below - far * np.sin(gamma + delta) * above,
            near * np.sin(delta_2 - gamma_2) * above - far * np.sin(gamma - delta) * below,
        ]
    )


def _miss(equations: Equations, angles: Array) -> Array:
    """What equations of angles (8, N) leave, over the steepest they change with them."""
    steps = angles[:, None] + 1j * STEP * np.eye(len(angles))[..., None]
    slopes = equations(steps).imag / STEP
    steepest = np.sqrt((slopes**2).sum(axis=1))
    return np.asarray(equations(angles) / np.maximum(steepest, np.finfo(float).tiny))
