"""What every ``Mechanism`` keeps, whichever family it is of: sheets are in ``tests/mechanisms.py``.

What is special to a family is tested in its folder, what flaps do in ``tests/families``.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from accelerations import shares_of_bounds
from mechanisms import COMPLEXES, DRAWN, LEANING, NEAR, PARABOLA, longitudinal
from mechanisms import SAMPLES as SHEETS
from orishell.conventions.errors import DesignError
from orishell.families.orthodiagonal import OrthodiagonalPattern, design_orthodiagonal
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.motion import (
    FoldedState,
    FoldingMotion,
    Mechanism,
    diagonal,
    find_assignment,
    measure_fold_angles,
    panel_normals,
)
from orishell.motion.grid import crease_signs
from orishell.verification.residuals import measure_residuals
from rigid import distance_after_motion
from samples import THOROUGH, led_by, thorough
from strategies import graph

Array = np.ndarray
SAMPLES = {**SHEETS, **COMPLEXES}
every = pytest.mark.parametrize("name", SAMPLES)


@cache
def sheet(name: str) -> Mechanism:
    return SAMPLES[name].make()


def require_rigid(
    mechanism: Mechanism, states: list[FoldedState] | FoldingMotion, lengths: float, angles: float
) -> None:
    """Panels are rigid and plane, creases fold as the closed form says and never turn over."""
    residuals, assignment = measure_residuals(states, FoldedState.of(mechanism, 0.0))
    assert residuals.panel_length <= lengths
    assert residuals.planarity <= lengths
    assert residuals.fold_angle_rad <= angles
    assert residuals.sector_sum_rad <= angles
    assert assignment.constant
    assert assignment.maekawa


def shortest(flat: Array, *, slim: bool) -> float:
    """The shortest edge or, of slim panels, the shortest way between neighbouring columns."""
    down, right = np.diff(flat, axis=0), np.diff(flat, axis=1)
    found = [np.linalg.norm(each, axis=-1).min() for each in (down, right)]
    if slim:
        columns = (flat[-1] - flat[0]).mean(axis=0)
        columns /= np.linalg.norm(columns)
        found.append(np.linalg.norm(np.cross(right[0], columns), axis=-1).min())
    return float(min(found))


@pytest.mark.parametrize("family", DRAWN)
def test_any_sheet_is_rigid_and_folds_as_the_closed_form_says(family: str) -> None:
    kind = DRAWN[family]

    @settings(max_examples=kind.count if THOROUGH else 8)
    @given(kind.sheets, st.floats(0.01, 0.999))
    def check(mechanism: Mechanism, share: float) -> None:
        target, end = mechanism.target_drive, mechanism.end_drive
        states = [FoldedState.of(mechanism, drive) for drive in (share * end, target, end)]
        flat = mechanism.positions(0.0)
        size = np.abs(np.stack([state.positions for state in states])).max() + diagonal(flat)
        rounding = 50 * np.finfo(float).eps * size / shortest(flat, slim=kind.slim)
        require_rigid(mechanism, states, kind.lengths, kind.angles + rounding)

    check()


@every
def test_rigid_over_the_whole_motion(name: str) -> None:
    mechanism = sheet(name)
    require_rigid(mechanism, FoldingMotion(mechanism, 9), SAMPLES[name].residual, 1e-9)
    assert (find_assignment(mechanism).row != 0).all()


@every
def test_flat_sheet_is_the_mechanism_at_drive_0(name: str) -> None:
    mechanism = sheet(name)
    flat, folds = mechanism.positions(0.0), mechanism.fold_angles(0.0)
    assert flat.shape == (mechanism.grid.rows, mechanism.grid.columns, 3)
    assert np.ptp(flat[..., 2]) < 1e-15
    # Seen from +z rows run to the right of the columns' direction downwards.
    np.testing.assert_allclose(panel_normals(flat)[..., 2], 1.0, rtol=0, atol=1e-15)
    for measured, closed in zip(
        (measure_fold_angles(flat).row, measure_fold_angles(flat).column),
        (folds.row, folds.column),
        strict=True,
    ):
        assert np.abs(measured).max(initial=0.0) < 1e-12
        assert np.abs(closed).max(initial=0.0) < 1e-12


@every
def test_positions_of_many_drives_are_those_of_each(name: str) -> None:
    mechanism, (rounding, of_folds) = sheet(name), SAMPLES[name].rounding
    size = max(1.0, diagonal(mechanism.positions(0.0)))
    drives = np.linspace(0, mechanism.target_drive, 6).reshape(2, 3)
    together, angles = mechanism.positions(drives), mechanism.fold_angles(drives)
    assert together.shape == (2, 3, mechanism.grid.rows, mechanism.grid.columns, 3)
    for at, drive in np.ndenumerate(drives):
        alone = mechanism.positions(float(drive))
        np.testing.assert_allclose(together[at], alone, rtol=0, atol=rounding * size)
        folds = mechanism.fold_angles(float(drive))
        np.testing.assert_allclose(angles.row[at], folds.row, rtol=0, atol=of_folds)
        np.testing.assert_allclose(angles.column[at], folds.column, rtol=0, atol=of_folds)


@every
def test_motion_is_steady(name: str) -> None:
    # No jump: neighbouring states of a fine motion differ by steps that shrink with the step.
    mechanism = sheet(name)
    start, stop = mechanism.target_drive * np.array(SAMPLES[name].steady)
    step, finer = (
        np.linalg.norm(
            np.diff(mechanism.positions(np.linspace(start, stop, count)), axis=0), axis=-1
        ).max()
        for count in (101, 401)
    )
    assert finer == pytest.approx(step / 4, rel=0.05)


@pytest.mark.parametrize("name", [each for each in SAMPLES if SAMPLES[each].enlarged])
def test_scale_equivariance(name: str) -> None:
    make = SAMPLES[name].enlarged
    assert make is not None
    small, large = make(1.0), make(1000.0)
    drive = 0.41 * small.target_drive
    np.testing.assert_allclose(
        large.positions(drive), 1000 * small.positions(drive), rtol=1e-12, atol=1e-10
    )


@every
@pytest.mark.parametrize("ranges", [1, 3, 20, 512])
def test_edges_swing_no_faster_than_their_bounds(name: str, ranges: int) -> None:
    mechanism = sheet(name)
    for each in (mechanism, mechanism.least_turning):
        shares_of_bounds(each, 9, ranges)


@every
def test_fold_angles_are_below_pi_before_the_end(name: str) -> None:
    mechanism = sheet(name)
    target, end = mechanism.target_drive, mechanism.end_drive
    assert 0 < target <= end
    folds = mechanism.fold_angles(np.linspace(0, end, 50)[:-1])
    assert max(np.abs(each).max(initial=0.0) for each in (folds.row, folds.column)) < np.pi
    # Mountains and valleys stay so, also beyond the target.
    signs, wanted = crease_signs(folds), find_assignment(mechanism)
    for found, expected in ((signs.row, wanted.row), (signs.column, wanted.column)):
        assert (found * expected >= 0).all()


@every
def test_still_is_the_same_sheet(name: str) -> None:
    mechanism = sheet(name)
    still, size = mechanism.least_turning, diagonal(mechanism.positions(0.0))
    assert (still.grid, still.target_drive) == (mechanism.grid, mechanism.target_drive)
    for share in (0.0, 0.3, 0.8, 1.0):
        drive = share * mechanism.target_drive
        one, other = (each.positions(drive).reshape(-1, 3) for each in (mechanism, still))
        assert distance_after_motion(one, other) < 1e-13 * size
        row, column = mechanism.fold_angles(drive).row, mechanism.fold_angles(drive).column
        np.testing.assert_array_equal(still.fold_angles(drive).row, row)
        np.testing.assert_array_equal(still.fold_angles(drive).column, column)


@every
def test_flaps_end_the_motion_at_the_target(name: str) -> None:
    mechanism = sheet(name)
    bare, flaps = mechanism.without_flaps(), list(mechanism.flap_columns)
    target, size = mechanism.target_drive, diagonal(mechanism.positions(0.0))
    if not flaps:
        drives = np.linspace(0, mechanism.end_drive, 5)
        np.testing.assert_array_equal(bare.positions(drives), mechanism.positions(drives))
        assert mechanism.with_stop(0.1) is mechanism
        return
    assert target == mechanism.end_drive
    closed = measure_fold_angles(mechanism.positions(target)).row[:, flaps]
    np.testing.assert_allclose(np.abs(closed), np.pi, rtol=0, atol=1e-6)
    # Without them the sheet meets its target too, and goes on; with a stop they stay open by it.
    inner = mechanism.positions(target)[:, mechanism.inner_columns]
    assert bare.flap_columns == ()
    assert bare.target_drive < bare.end_drive
    assert bare.grid.columns == mechanism.grid.columns - len(flaps)
    stopped = mechanism.with_stop(0.02)
    for each in (bare, stopped):
        met = each.positions(each.target_drive)[:, each.inner_columns]
        assert np.abs(met - inner).max() < 1e-12 * size
    folds = np.abs(stopped.fold_angles(stopped.target_drive).row)[:, flaps]
    assert folds.max() == pytest.approx(np.pi - 0.04, abs=1e-12)
    with pytest.raises(DesignError):
        mechanism.with_stop(1.5)


def parallel_sheet(size: int, g: str, spacing: str) -> Mechanism:
    return design_parallel_repeating(
        PARABOLA.scaled(0.5),
        graph(g, 0, 20),
        ParallelRepeatingPattern(
            rows=size,
            columns=size,
            xi_deg=50,
            spacing="curvature" if spacing == "curvature" else "equal",
        ),
    ).mechanism


@pytest.mark.slow
@pytest.mark.parametrize(
    ("size", "g"),
    [
        (101, "5*sin(pi*x/10)"),
        pytest.param(999, "5*sin(pi*x/10)", marks=thorough),
        pytest.param(999, "3*exp(-(x-7)**2/8) + 0.02*x**2", marks=thorough),
    ],
)
@pytest.mark.parametrize("spacing", ["curvature", "equal"])
def test_large_parallel_sheets_keep_twelve_digits(size: int, g: str, spacing: str) -> None:
    mechanism = parallel_sheet(size, g, spacing)
    require_rigid(mechanism, FoldingMotion(mechanism, 5), 1e-12, 1e-9)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("size", "g"),
    [
        (99, "0.25*sin(pi*x/2)"),
        pytest.param(999, "0.25*sin(pi*x/2)/10", marks=thorough),
        pytest.param(99, "0.1*exp(-(x-2)**2/0.5) + 0.02*x**2", marks=thorough),
    ],
)
@pytest.mark.parametrize("spacing", led_by(["curvature", "equal"]))
def test_large_orthodiagonal_sheets_keep_twelve_digits(size: int, g: str, spacing: str) -> None:
    for f in (PARABOLA, LEANING):
        mechanism = design_orthodiagonal(
            f,
            graph(g, 0, 4),
            OrthodiagonalPattern(
                rows=size,
                columns=size,
                heading_deg="auto",
                spacing="curvature" if spacing == "curvature" else "equal",
            ),
        ).mechanism
        require_rigid(mechanism, FoldingMotion(mechanism, 5 if size > 99 else 25), 1e-12, 1e-9)


def test_large_longitudinal_sheets_keep_eleven_digits() -> None:
    # The largest of the paper's angles, and one near 90 degrees.
    for mechanism, frames in (
        (longitudinal(rows=35, columns=35), 13),
        (longitudinal(NEAR, 99, 99, equal=True), 5),
    ):
        require_rigid(mechanism, FoldingMotion(mechanism, frames), 1e-11, 1e-9)
