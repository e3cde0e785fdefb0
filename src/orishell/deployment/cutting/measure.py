"""What errors of cutting do to a shell: sheets are drawn, and their panels share the errors out."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.deployment.cutting.flaps import Shutting
from orishell.deployment.cutting.gaps import Fit
from orishell.deployment.cutting.report import CuttingReport, FlapStop, Scatter
from orishell.deployment.cutting.shape import Shape
from orishell.deployment.cutting.sheet import CutSheet
from orishell.motion.grid import Vertex
from orishell.motion.layout import mesh_of, points_of
from orishell.motion.mechanism import Mechanism, is_flat_at_first
from orishell.motion.quads import dots, lengths
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.settings import Cutting

if TYPE_CHECKING:
    from scipy.sparse import csr_array

SAMPLES, TOGETHER = 200, 50
"""Sheets that are tried, and how many of them at a time: memory grows with it."""
SEED = 1
"""The seed of samples: they are alike each time, so that the same input gives the same bytes."""
SHARE = 0.95
"""Of sheets, in which nothing is larger than what is called the largest."""
LARGEST_WORK = 1_050_000
"""Panels times those across a sheet, 101 x 101 panels: 1 GB, and 15 s of processor time."""
FAR = 0.1
"""Vertices that are off by more than this share of the size of panels are not told to first order:
up to there it is right within a tenth in the sheets that were compared."""
SHARING = "sharing errors of cutting out"
LARGEST_ERROR = 0.1
"""Errors above this share of the shortest side of a panel are no errors of cutting."""


def measure_cutting(
    mechanism: Mechanism,
    *,
    error: float,
    bias: float = 0.0,
    cutting: Cutting = "boards",
    feet: tuple[Vertex, ...] = (),
    progress: Progress = no_progress,
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
    drawn = _Drawn.of(sheet, error, bias, cutting)
    # Each of these lets go of its factors before the next one makes its own.
    tight = _tight(drawn, _ends(mechanism, feet))
    progress(1 / 3, SHARING)
    across, along = _sliding(drawn)
    progress(2 / 3, SHARING)
    lift = _twisting(drawn)
    progress(1.0, SHARING)
    return CuttingReport(
        cutting=cutting,
        error=error,
        bias=bias,
        play=tight.play,
        across=across,
        along=along,
        lift=lift,
        shape=tight.shape,
        ends=tight.ends,
        on_feet=bool(feet),
        flaps=tight.flaps,
    )


@record
class _Drawn:
    """A sheet, and how corners of its samples err."""

    sheet: CutSheet
    error: float
    bias: float
    spread: csr_array  # from independent errors (Z,) to those of corners (2 F K)
    samples: list[Array]  # errors of corners (2 F K, TOGETHER)

    @classmethod
    def of(cls, sheet: CutSheet, error: float, bias: float, cutting: Cutting) -> _Drawn:
        spread = sheet.spread(cutting)
        draw = np.random.default_rng(SEED).standard_normal
        samples = [
            error * (spread @ draw((spread.shape[1], TOGETHER))) + bias * sheet.offset[:, None]
            for _ in range(SAMPLES // TOGETHER)
        ]
        return cls(sheet, error, bias, spread, samples)


@record
class _Tight:
    """What follows if hinges are tight, and panels do not twist."""

    play: Scatter
    shape: Scatter | None
    ends: Scatter | None
    flaps: FlapStop | None


def _tight(drawn: _Drawn, ends: Integers) -> _Tight:
    fit = Fit.of(drawn.sheet)
    one_way = fit.moves_one_way
    shape = Shape.of(fit) if one_way else None
    shutting = None if shape is None else Shutting.of(fit, shape)
    play, moves, stops, lacks = [], [], [], []
    for errors in drawn.samples:
        motions, gaps = fit.moved(drawn.sheet.opened @ errors)
        play.append(lengths(_by_ends(gaps)))
        if shape is None:
            continue
        moved, more = shape.moved(motions, errors)
        moves.append(moved)
        if shutting is not None:
            stop, last = shutting.stop(motions, errors)
            stops.append(np.abs(stop - more))
            lacks.append(last)
    apart = _scatter(play)
    if one_way:
        apart = replace(apart, rms=_exact(fit, drawn))
    off = None if shape is None else _scatter(moves)
    if shape is None or off is None or off.largest > FAR * drawn.sheet.size:
        return _Tight(apart, None, None, None)
    at_ends = np.isin(shape.vertices, ends)
    return _Tight(
        apart,
        off,
        _scatter([moved[at_ends] for moved in moves]),
        None if shutting is None else _flap_stop(shape, stops, lacks),
    )


def _sliding(drawn: _Drawn) -> tuple[Scatter, Scatter]:
    """Gaps across hinges that slide, and along them."""
    sheet = drawn.sheet
    fit = Fit.of(sheet, sliding=True)
    slid = [_slid(_by_ends(fit.moved(sheet.opened @ errors)[1]), sheet) for errors in drawn.samples]
    return _scatter([across for across, _ in slid]), _scatter([along for _, along in slid])


def _twisting(drawn: _Drawn) -> Scatter:
    """How far corners lift off boards that twist."""
    opened = drawn.sheet.opened
    fit = Fit.of(drawn.sheet, twisting=True)
    return _scatter([fit.twists(fit.moved(opened @ errors)[0]) for errors in drawn.samples])


def can_measure(mechanism: Mechanism) -> bool:
    """Whether it is a flat sheet, and there is the memory.

    That grows as the panels times those across the sheet.
    """
    grid = mechanism.grid
    work = grid.panel_count * min(grid.rows, grid.columns)
    return work <= LARGEST_WORK and is_flat_at_first(mechanism)


def _exact(fit: Fit, drawn: _Drawn) -> float:
    """Root mean square of gaps, by the trace of their covariance, and of what a bias leaves."""
    sheet = drawn.sheet
    opened = drawn.bias * (sheet.opened @ sheet.offset)
    left = _by_ends(fit.moved(opened[:, None])[1])
    square = drawn.error**2 * fit.mean_square(sheet.opened @ drawn.spread)
    return float(np.sqrt(square + dots(left, left).mean()))


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
        if value > LARGEST_ERROR * shortest:
            raise InputError(
                "panels cannot be cut as wrong as that",
                keys=(f"workshop.cutting_{key}",),
                got=plain(value),
                expected="at most a tenth of their shortest side, "
                f"{plain(LARGEST_ERROR * shortest)}",
            )
