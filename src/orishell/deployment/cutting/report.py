"""A shell cut with errors, in the report: what its hinges need, and where it then stands."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import plain, size
from orishell.conventions.record import Angle, record
from orishell.conventions.row import Row
from orishell.deployment.cutting.flaps import Shutting
from orishell.deployment.cutting.gaps import Fit
from orishell.deployment.cutting.shape import Shape
from orishell.deployment.cutting.sheet import CutSheet
from orishell.motion.grid import Vertex
from orishell.motion.layout import mesh_of, points_of
from orishell.motion.mechanism import Mechanism
from orishell.motion.quads import dots, lengths
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.settings import Cutting

if TYPE_CHECKING:
    from scipy.sparse import csr_array

SAMPLES, TOGETHER = 200, 50
"""Sheets that are tried, and how many of them at a time: memory grows with it."""
SEED = 1
"""The same samples each time, so that the same input gives the same bytes."""
SHARE = 0.95
"""Of sheets, in which nothing is larger than what is called the largest."""
LARGEST = 2_600_000
"""Panels times those across a sheet, 137 x 137 panels: 1 GB."""
FAR = 0.1
"""Vertices that are off by more than this share of the size of panels are not told to first order:
up to there it is right within a tenth in the sheets that were compared."""
MOST = 0.1
"""Errors above this share of the shortest side of a panel are no errors of cutting."""


@record
class Scatter:
    """How large something is in sheets that are cut with errors."""

    rms: float  # root mean square over sheets and places (length)
    largest: float  # the largest in a sheet, which 95 % of sheets do not exceed (length)


@record
class FlapStop:
    """Where flaps stop a shell that is cut with errors; 95 % of sheets do not exceed these."""

    off: Angle  # by how much the fold angle of the hinge that moves most is off where they shut
    last: Angle  # what the last pair of flaps then still lacks
    shape: float  # how far that leaves vertices from their places, rms over the shell (length)


@record
class CuttingReport:
    """What follows if a shell is cut with errors: to first order, at its target."""

    cutting: Cutting  # whether boards are cut apart, or creases in one sheet
    error: float  # standard deviation of a corner along each axis (length)
    bias: float  # by how much boards are too small all around (length)
    play: Scatter  # how far the two sides of a hinge are apart at its ends
    # the same if hinges slide along their axes: across and along these
    across: Scatter
    along: Scatter
    # how far corners of boards stand off their plane if hinges have no play across, and boards
    # twist
    lift: Scatter
    # how far vertices are from their places; None if that is not small, or if it moves in more ways
    # than one at the target
    shape: Scatter | None
    ends: Scatter | None  # feet alone, or the first and the last row of a shell without
    on_feet: bool  # whether these are feet
    flaps: FlapStop | None  # where its flaps stop it; None if it has none

    def rows(self, unit: str) -> Iterator[Row]:
        """What is said of it, lengths in its unit."""
        what = "boards cut apart" if self.cutting == "boards" else "creases in one sheet"
        errors = f"corners {size(self.error, unit)} off (rms along each axis, {what})"
        if self.bias:
            way = "small" if self.bias > 0 else "large"
            errors += f", sides {size(abs(self.bias), unit)} too {way}"
        miss = "where it then stands is not known: too far off, or it moves in more ways than one"
        if self.ends is not None:
            which = "feet" if self.on_feet else "ends"
            miss = f"{which} miss their places by {size(self.ends.rms, unit)} (rms)"
        yield Row(
            "says",
            "cut",
            f"{errors}: hinges need {size(self.play.rms, unit)} of play (rms), at most "
            f"{size(self.play.largest, unit, bound=True)} in 95 % of sheets; {miss}",
        )
        if self.flaps is not None:
            off, last = (plain(np.rad2deg(each), 2) for each in (self.flaps.off, self.flaps.last))
            yield Row(
                "says",
                "flaps",
                f"cut so, the first pair shuts within {off} degrees of the target (95 % of "
                f"sheets), which leaves the shell {size(self.flaps.shape, unit)} off (rms); the "
                f"last one then lacks up to {last} degrees",
            )


def measure_cutting(
    mechanism: Mechanism,
    *,
    error: float,
    bias: float = 0.0,
    cutting: Cutting = "boards",
    feet: tuple[Vertex, ...] = (),
) -> CuttingReport:
    """What hinges of a sheet need that is cut with errors, and where it then stands.

    Panels are rigid, and go where gaps at hinges are least in the mean square; errors are small
    (first order) and normally distributed. All of it is at the target, flaps left out; the shell is
    opened and placed so that its vertices are nearest to their places. The rms of ``play`` is
    exact if the sheet moves in one way only; all other figures are of 200 sheets, the same ones
    each time. Derived in
    docs/theory/cutting.md.

    Parameters
    ----------
    mechanism
        The folding sheet, with its flaps if it has any.
    error
        Standard deviation of a corner along each axis (length).
    bias
        By how much boards are too small all around, or too large if it is below 0 (length).
    cutting
        "boards": every corner errs by itself; "sheet": a vertex errs for all its panels alike.
    feet
        Rows and columns of vertices on which it stands; without, its first and last row count.

    Raises
    ------
    InputError
        If errors are as large as panels, or creases in one sheet have a bias.
    """
    _require(mechanism, error, bias, cutting)
    sheet = CutSheet.of(mechanism, mechanism.target_drive)
    spread = sheet.spread(cutting)
    samples = np.random.default_rng(SEED)
    drawn = [
        error * (spread @ samples.standard_normal((spread.shape[1], TOGETHER)))
        + bias * sheet.offset[:, None]
        for _ in range(SAMPLES // TOGETHER)
    ]
    tight = Fit.of(sheet)
    one_way = tight.moves_one_way
    shape = Shape.of(tight) if one_way else None
    shutting = None if shape is None else Shutting.of(tight, shape)
    play, moves, stops, lacks = [], [], [], []
    for errors in drawn:
        motions, gaps = tight.moved(sheet.opened @ errors)
        play.append(lengths(_by_ends(gaps)))
        if shape is None:
            continue
        moved, more = shape.moved(motions, errors)
        moves.append(moved)
        if shutting is not None:
            stop, last = shutting.stop(motions, errors)
            stops.append(np.abs(stop - more))
            lacks.append(last)
    slid = [_slid(fit_gaps, sheet) for fit_gaps in _gaps(Fit.of(sheet, sliding=True), drawn)]
    twisted = Fit.of(sheet, twisting=True)
    lift = [twisted.twists(twisted.moved(sheet.opened @ errors)[0]) for errors in drawn]
    apart = _scatter(play)
    off = None if shape is None else _scatter(moves)
    if off is not None and off.largest > FAR * sheet.size:
        shape = off = None
    at_ends = None if shape is None else np.isin(shape.vertices, _ends(mechanism, feet))
    return CuttingReport(
        cutting=cutting,
        error=error,
        bias=bias,
        play=replace(apart, rms=_exact(tight, spread, error, bias)) if one_way else apart,
        across=_scatter([across for across, _ in slid]),
        along=_scatter([along for _, along in slid]),
        lift=_scatter(lift),
        shape=off,
        ends=None if at_ends is None else _scatter([moved[at_ends] for moved in moves]),
        on_feet=bool(feet),
        flaps=None if shutting is None or shape is None else _flap_stop(shape, stops, lacks),
    )


def can_measure(mechanism: Mechanism) -> bool:
    """Whether there is the memory for it: it grows as the panels times those across the sheet."""
    grid = mechanism.grid
    return grid.panel_count * min(grid.rows, grid.columns) <= LARGEST


def _exact(fit: Fit, spread: csr_array, error: float, bias: float) -> float:
    """Root mean square of gaps, by the trace of their covariance, and of what a bias leaves."""
    opened = bias * (fit.sheet.opened @ fit.sheet.offset)
    left = _by_ends(fit.moved(opened[:, None])[1])
    square = error**2 * fit.mean_square(fit.sheet.opened @ spread)
    return float(np.sqrt(square + dots(left, left).mean()))


def _gaps(fit: Fit, drawn: list[Array]) -> Iterator[Array]:
    """Gaps (2 H, S, 3) that are left of errors in batches."""
    return (_by_ends(fit.moved(fit.sheet.opened @ errors)[1]) for errors in drawn)


def _by_ends(gaps: Array) -> Array:
    """Gaps (6 H, S) as vectors (2 H, S, 3)."""
    return np.moveaxis(gaps.reshape(-1, 3, gaps.shape[1]), 1, -1)


def _slid(gaps: Array, sheet: CutSheet) -> tuple[Array, Array]:
    """Gaps (2 H, S, 3) across hinges and along them, each (2 H, S)."""
    axes = sheet.axes[:, None]
    along = dots(gaps, axes)
    return lengths(gaps - along[..., None] * axes), along


def _flap_stop(shape: Shape, stops: list[Array], lacks: list[Array]) -> FlapStop:
    off = _exceeded(np.concatenate(stops))
    return FlapStop(off, _exceeded(np.concatenate(lacks)), off * shape.reach)


def _scatter(found: list[Array]) -> Scatter:
    """That of values (N, S) in batches of samples."""
    values = np.concatenate(found, axis=-1)
    rms = float(np.sqrt((values**2).mean()))
    return Scatter(rms, _exceeded(np.abs(values).max(axis=0)))


def _exceeded(values: Array) -> float:
    """What 95 % of samples (S,) do not exceed."""
    return float(np.quantile(values, SHARE))


def _ends(mechanism: Mechanism, feet: tuple[Vertex, ...]) -> Integers:
    """Vertices of the feet, or of the first and the last row without flaps."""
    numbers = mechanism.grid.vertices()
    if feet:
        rows, columns = np.array(feet).T
        return np.asarray(numbers[rows, columns])
    return np.asarray(numbers[[0, -1], mechanism.inner_columns].ravel())


def _require(mechanism: Mechanism, error: float, bias: float, cutting: Cutting) -> None:
    """Refuse errors that are as large as panels, and a bias of creases in one sheet."""
    if bias and cutting == "sheet":
        raise InputError(
            "creases in one sheet are not cut too small",
            keys=("workshop.cutting_bias", "workshop.cutting"),
            got=plain(bias),
            expected='0, or cutting = "boards": boards that are cut apart',
        )
    sides = points_of(mechanism, 0.0)[mesh_of(mechanism).edges]
    shortest = float(lengths(sides[:, 1] - sides[:, 0]).min())
    for key, value in (("error", error), ("bias", abs(bias))):
        if value > MOST * shortest:
            raise InputError(
                "panels cannot be cut as wrong as that",
                keys=(f"workshop.cutting_{key}",),
                got=plain(value),
                expected=f"at most a tenth of their shortest side, {plain(MOST * shortest)}",
            )
