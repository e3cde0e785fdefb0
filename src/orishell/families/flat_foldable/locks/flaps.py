"""Flaps that a sheet can have: columns beside straight borders, slit ones beside any other.

A column of flaps beside a straight border locks the sheet. Besides what all flaps share
(:mod:`~.locks.locked`), the crease between sheet and flaps folds by

    2 arctan((sqrt(1 + y^2) - y) tan(phi/2)),

y being sqrt(E) times that of the border (:mod:`~.locks.border`).
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import between
from orishell.conventions.record import record
from orishell.design import Design
from orishell.families.flat_foldable.locks.border import Border
from orishell.families.flat_foldable.locks.locked import Locked, sine_rates
from orishell.families.flat_foldable.locks.slit import SlitFlaps
from orishell.families.flat_foldable.mechanism import FlatFoldable, tangent_rates
from orishell.families.pattern import Auto
from orishell.families.shared.chains import Chains, Rates
from orishell.families.shared.folding import HalfFolds, Numbers, fold
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.mechanism import mechanism_in_one_line
from orishell.numerics.arrays import Array

NEARLY = 0.9
"""Flaps whose width is chosen are this share of the widest that there are."""


@record
class FlapColumns(Locked):
    """A flat-foldable sheet with flaps along its left border, its right border or both."""

    bare: FlatFoldable
    widths: tuple[float, float]  # of the left and the right flaps, square to the border; 0 for none
    stop: float = 0.0  # by how much flaps stop short of folding flat at the target (radians)

    __repr__ = mechanism_in_one_line

    def __post_init__(self) -> None:
        for name, border, width in zip(("left", "right"), self._borders, self.widths, strict=True):
            if border is not None and not width < border.widest(self._further):
                raise _too_wide(name, width, border.widest(self._further))

    @property
    def grid(self) -> Grid:
        """The grid of vertices, flaps included."""
        bare = self.bare.grid
        return Grid(bare.rows, bare.columns + sum(map(bool, self.widths)))

    @property
    def inner_columns(self) -> slice:
        """The columns of the sheet without its flaps."""
        start = int(self.widths[0] != 0)
        return slice(start, start + self.bare.grid.columns)

    @property
    def flap_columns(self) -> tuple[int, ...]:
        """The first and the last column of panels, as far as they are flaps."""
        last = self.grid.columns - 2
        return tuple(k for k, width in zip((0, last), self.widths, strict=True) if width)

    def positions(self, drive: ArrayLike) -> Array:
        """Positions (..., rows, columns, 3) of all vertices at drive angles (...) (radians)."""
        drives = np.asarray(drive, dtype=np.float64)
        rho = drives.ravel()
        places = fold(self._flat[..., None], self._half_folds(0.5 * rho), self._middle)
        return self.bare.placed(places, rho / self.target_drive, drives.shape)

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of all creases at drive angles (...), in closed form (radians)."""
        drives = np.asarray(drive, dtype=np.float64)
        folds = self._half_folds(0.5 * drives.ravel())
        row, column = (
            np.moveaxis(2 * np.arctan2(s, c), -1, 0).reshape(*drives.shape, *c.shape[:-1])
            for c, s in (folds.row, folds.column)
        )
        return CreaseValues(row=row, column=column)

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the accelerations of edges: see :class:`~.chains.Chains`."""
        row, column = (np.abs(each[..., 0]) for each in self._tangents)
        columns = [sine_rates(column[0], start, stop)]
        if self.widths[0]:
            columns.insert(0, self._hinge_rates(0, start, stop))
        if self.widths[1]:
            columns.append(self._hinge_rates(1, start, stop))
        rows = sine_rates(row[:, 0], start, stop)
        return self._chains.bounds(rows, _joined(columns), self._spin)

    @cached_property
    def _borders(self) -> tuple[Border | None, Border | None]:
        flat, tangents = self.bare.flat[..., 0], self.bare.sheet.tangents()[0][..., 0]
        left, right = (
            Border.of(flat, tangents[:, column], left=column == 0) if width else None
            for column, width in zip((0, -1), self.widths, strict=True)
        )
        return left, right

    @cached_property
    def _flat(self) -> Array:
        """Vertices (2, rows, columns) of the flat sheet, about the middle vertex."""
        flat = [self.bare.flat[..., 0]]
        for border, width, side in zip(self._borders, self.widths, (0, 1), strict=True):
            if border is not None:
                outer = border.flap(width, self._further).T[..., None]
                flat.insert(len(flat) if side else 0, outer)
        return np.concatenate(flat, axis=2)

    @property
    def _middle(self) -> tuple[int, int]:
        """Row and column of the middle inner vertex."""
        i, j = self.bare.sheet.net.middle
        return i, j + int(self.widths[0] != 0)

    def _hinge(self, side: int) -> Array:
        """(sqrt(1 + y^2) - y) (R+1, 1) with the signs of the crease between sheet and flaps."""
        border = self._borders[side]
        assert border is not None
        y = np.sqrt(self._further) * border.y
        signs = np.concatenate([-border.signs[:1], border.signs])
        return np.asarray(signs[:, None] / (np.hypot(1.0, y) + y))

    def _half_folds(self, phi: Array) -> HalfFolds:
        """Of all creases where half the drive is phi (B,)."""
        sine, cosine = np.sin(phi), np.where(phi == 0.5 * np.pi, 0.0, np.cos(phi))
        row, column = self._tangents
        folds = HalfFolds.of((row, column), 1.0, sine)
        rows, columns = [folds.row], [folds.column]
        for side, (width, beside) in enumerate(zip(self.widths, (0, -1), strict=True)):
            if not width:
                continue
            x = row[:, beside]
            flaps = HalfFolds.of((np.sign(x) * np.hypot(1.0, x), self._hinge(side)), cosine, sine)
            hinge = HalfFolds.of(
                (self._hinge(side), self._hinge(side)), np.cos(0.5 * phi), np.sin(0.5 * phi)
            )
            at = len(rows) if side else 0
            rows.insert(at, _as_column(flaps.row))
            columns.insert(at, _as_column(hinge.column))
        return HalfFolds(_beside(rows), _beside(columns))

    @cached_property
    def _chains(self) -> Chains:
        # Signs are those of half way.
        folds = self._half_folds(np.array([0.25 * np.pi]))
        return Chains.of(self._flat, folds.row[1][..., 0], folds.column[1][..., 0], self._middle)

    def _hinge_rates(self, side: int, start: Array, stop: Array) -> Rates:
        """Of 2 arctan(m tan(rho/4)): as of a sheet without flaps, half as fast."""
        found = tangent_rates(np.abs(self._hinge(side)[0]), 0.5 * start, 0.5 * stop)
        return Rates(0.5 * found.low, 0.5 * found.high, 0.25 * found.second)


def with_flaps(bare: FlatFoldable, width: float | None) -> FlapColumns:
    """A sheet with flaps beside each of its borders that is straight.

    width: Square to the border; None for the mean length of its edges, or less where row creases of
        flaps would meet.

    Raises DesignError if neither border is straight, or they are too wide.
    """
    flat, tangents = bare.flat[..., 0], bare.sheet.tangents()[0][..., 0]
    borders: list[Border | None] = []
    refusal: DesignError | None = None
    for column in (0, -1):
        try:
            borders.append(Border.of(flat, tangents[:, column], left=column == 0))
        except DesignError as error:
            borders.append(None)
            refusal = error
    straight = [each for each in borders if each is not None]
    if not straight:
        assert refusal is not None
        raise refusal
    if width is None:
        edges = float(np.mean([each.edge for each in straight]))
        width = min([edges, *(NEARLY * each.widest(1.0) for each in straight)])
    left, right = (0.0 if each is None else width for each in borders)
    return FlapColumns(bare, (left, right))


def _joined(rates: list[Rates]) -> Rates:
    parts = ((each.low, each.high, each.second) for each in rates)
    low, high, second = map(np.concatenate, zip(*parts, strict=True))
    return Rates(low, high, second)


def _as_column(pair: tuple[Numbers, Numbers]) -> tuple[Numbers, Numbers]:
    return pair[0][:, None], pair[1][:, None]


def _beside(pairs: list[tuple[Numbers, Numbers]]) -> tuple[Numbers, Numbers]:
    """Columns side by side."""
    cosines, sines = zip(*pairs, strict=True)
    return np.concatenate(cosines, axis=1), np.concatenate(sines, axis=1)


def _too_wide(side: str, width: float, widest: float) -> DesignError:
    return DesignError(
        f"the flaps on the {side} are too wide: their row creases meet",
        keys=("pattern.flap",),
        size=f"they are {width:.4g} wide, and two creases meet at {widest:.4g}",
        candidates=(Remedy({"pattern.flap": value}) for value in between(0, widest, width)),
        excess=width / widest - 1,
    )


def locked(design: Design, width: float | Auto, *, straight: bool) -> Design:
    """A design whose sheet has flaps of a width, "auto" for as wide as they can be.

    straight: Whether they are a column beside a straight border. Otherwise they are slit, and
        stand on the left and on the right.
    """
    assert isinstance(design.mechanism, FlatFoldable)
    bare, given = design.mechanism, None if width == "auto" else width
    sheet = with_flaps(bare, given) if straight else with_slit_flaps(bare, given)
    parameters = {**design.parameters, "flap": flap_width(sheet)}
    warnings = design.warnings if straight else (*design.warnings, warn_of_rows(bare))
    return replace(design, mechanism=sheet, parameters=parameters, warnings=warnings)


def with_any_flaps(bare: FlatFoldable, width: float | None) -> FlapColumns | SlitFlaps:
    """A sheet with columns of flaps beside its straight borders, or slit ones if it has none.

    width: None for the mean length of the border's edges, or less where flaps have no room for it.
    """
    try:
        return with_flaps(bare, width)
    except DesignError as error:
        if error.excess is not None:  # Its borders are straight, and flaps too wide.
            raise
        return with_slit_flaps(bare, width)


def with_slit_flaps(bare: FlatFoldable, width: float | None) -> SlitFlaps:
    """A sheet with slit flaps on its left and its right border.

    width: Of the widest at most; None for the mean length of the edges of both borders.

    Raises DesignError if flaps of a row cannot fold flat at the target.
    """
    if width is None:
        borders = bare.flat[:, :, [0, -1], 0]
        width = float(np.linalg.norm(np.diff(borders, axis=1), axis=0).mean())
    return SlitFlaps(bare, (width, width))


APART = np.deg2rad(0.15)
"""By so much the fold angles differ at which rows lock, if edges of 0.5 m are cut with errors of
0.3 mm (radians): measured, see docs/theory/flat-foldable.md."""


def warn_of_rows(bare: FlatFoldable) -> str:
    """Say how far the last flaps stay open if rows do not lock together.

    Short of the lock by a fold angle d of its row crease a flap is open by 2 sqrt(d/x), x the
    tangent of half that crease's fold angle at the lock.
    """
    open_by = float(np.rad2deg(2 * np.sqrt(APART / np.abs(bare.sheet.net.x).min())))
    return (
        "slit flaps lock every row by itself: if edges are cut with errors of 0.06 % (0.3 mm of "
        f"0.5 m), the last flaps stay up to {open_by:.2g} degrees open when the first are shut; "
        "clamp them shut"
    )


def flap_width(sheet: FlapColumns | SlitFlaps) -> float:
    """The width of the widest flaps."""
    return max(sheet.widths) if isinstance(sheet, FlapColumns) else sheet.widest
