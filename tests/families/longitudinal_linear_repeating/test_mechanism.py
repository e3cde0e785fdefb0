"""Invariants of the closed form, on sheets of every kind."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.families.longitudinal_linear_repeating import (
    LongitudinalLinearRepeating,
    RowKind,
    Sectors,
    find_solutions,
)
from orishell.families.longitudinal_linear_repeating.motion.measures import departures_from_plane
from orishell.families.longitudinal_linear_repeating.sheet import with_fitting_border
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Directions,
    repeat_columns,
    sector_table,
)
from orishell.families.longitudinal_linear_repeating.tessellation.even_lengths import (
    InnerLengths,
    find_even_lengths,
)
from orishell.families.longitudinal_linear_repeating.tessellation.program import Wanted
from orishell.motion import FoldedState, FoldingMotion, find_assignment
from orishell.verification.residuals import measure_residuals
from samples import examples

PAPER = (85.0, 80.0, 95.0, 100.0)
NEAR = (89.95, 89.9, 90.05, 90.1)


def sheet(
    degrees: tuple[float, ...] = PAPER,
    rows: int = 5,
    columns: int = 6,
    first_row: RowKind = "F",
    solution: int = 0,
    *,
    equal: bool = False,
) -> LongitudinalLinearRepeating:
    chosen = find_solutions(Sectors.from_degrees(degrees))[solution]
    made = repeat_columns(chosen, columns)
    directions = Directions.of(made, rows, first_row)
    inner = (
        InnerLengths.marched(directions, np.ones(columns - 1), np.ones(rows - 1))
        if equal
        else find_even_lengths(directions, Wanted())
    )
    assert inner is not None
    return with_fitting_border(made, first_row, inner, (0.02, 0.02), "auto")


def require_rigid(mechanism: LongitudinalLinearRepeating, frames: int = 9) -> None:
    motion = FoldingMotion(mechanism, frames)
    residuals, assignment = measure_residuals(motion, motion.flat)
    assert residuals.panel_length <= 1e-11
    assert residuals.planarity <= 1e-11
    assert residuals.fold_angle_rad <= 1e-9
    assert residuals.sector_sum_rad <= 1e-9
    assert assignment.constant
    assert assignment.maekawa


@pytest.mark.parametrize("first_row", ["F", "S"])
@pytest.mark.parametrize(("rows", "columns"), [(1, 2), (1, 7), (2, 2), (4, 3), (5, 6), (9, 9)])
def test_rigid_over_the_whole_motion(rows: int, columns: int, first_row: RowKind) -> None:
    require_rigid(sheet(rows=rows, columns=columns, first_row=first_row))


@settings(max_examples=examples(30))
@given(
    st.lists(st.floats(75, 105).map(lambda x: round(x, 3)), min_size=4, max_size=4),
    st.sampled_from(["F", "S"]),
)
def test_any_solution_folds_rigidly(degrees: list[float], first_row: RowKind) -> None:
    # A sheet of 3 x 4 inner vertices exists for most angles, of both versions.
    for number, solution in enumerate(find_solutions(Sectors.from_degrees(degrees))):
        directions = Directions.of(repeat_columns(solution, 4), 3, first_row)
        inner = find_even_lengths(directions, Wanted())
        if inner is not None and inner.ratio < 100:
            require_rigid(sheet(tuple(degrees), 3, 4, first_row, number), frames=4)


def test_sine_version_folds_rigidly() -> None:
    for first_row in ("F", "S"):
        mechanism = sheet((85, 80, 85, 100), 5, 5, "F" if first_row == "F" else "S", 1)
        assert mechanism.columns.version == "sine"
        require_rigid(mechanism)


def test_largest_sheet_of_the_papers_angles() -> None:
    require_rigid(sheet(rows=35, columns=35), frames=13)


def test_99_x_99_near_90_degrees() -> None:
    require_rigid(sheet(NEAR, 99, 99, equal=True), frames=5)


@pytest.mark.slow
def test_999_x_999_near_90_degrees() -> None:
    mechanism = sheet((89.9995, 89.999, 90.0005, 90.001), 999, 999, equal=True)
    flat = FoldedState.of(mechanism, 0.0)
    residuals, _ = measure_residuals([FoldedState.of(mechanism, 1.0)], flat)
    assert residuals.panel_length <= 1e-11


def test_sector_angles_are_those_of_figure_3() -> None:
    # geometry.md section 5: F = (pi-beta, alpha, beta, pi-alpha), S = (pi-delta, delta, gamma,
    # pi-gamma) as LU, LD, RD, RU; columns 1, 2, 2', 1' with (pi-RU, pi-RD, pi-LD, pi-LU).
    mechanism = sheet(rows=3, columns=5)
    flat = mechanism.positions(0.0)
    at = flat[1:-1, 1:-1]

    def angle(u: np.ndarray, v: np.ndarray) -> np.ndarray:
        cross = np.linalg.norm(np.cross(u, v), axis=-1)
        return np.asarray(np.rad2deg(np.arctan2(cross, (u * v).sum(axis=-1))))

    up, down = flat[:-2, 1:-1] - at, flat[2:, 1:-1] - at
    left, right = flat[1:-1, :-2] - at, flat[1:-1, 2:] - at
    measured = np.stack(
        [angle(left, up), angle(left, down), angle(right, down), angle(right, up)], axis=-1
    )
    a, b, c, d = PAPER
    np.testing.assert_allclose(measured[0, 0], [180 - b, a, b, 180 - a], atol=1e-10)
    np.testing.assert_allclose(measured[1, 0], [180 - d, d, c, 180 - c], atol=1e-10)
    np.testing.assert_allclose(measured[:, 3], 180 - measured[:, 0, ::-1], atol=1e-10)
    np.testing.assert_allclose(measured[:, 2], 180 - measured[:, 1, ::-1], atol=1e-10)
    np.testing.assert_allclose(measured[:, 4], measured[:, 0], atol=1e-10)
    np.testing.assert_allclose(measured[2], measured[0], atol=1e-10)
    table = 90 + np.rad2deg(sector_table(mechanism.columns, 3, "F"))
    np.testing.assert_allclose(table[..., [1, 2, 3, 0]], measured, atol=1e-10)


def test_motion_ends_where_a_crease_is_folded_flat() -> None:
    # geometry.md section 5: v_1 = 119.74 degrees, where an S row's crease reaches pi.
    mechanism = sheet()
    assert np.rad2deg(mechanism.target_drive) == pytest.approx(119.747, abs=1e-3)
    end = mechanism.fold_angles(mechanism.target_drive)
    assert np.abs(end.row).max() == pytest.approx(np.pi, abs=1e-12)
    assert np.abs(end.row[::2]).max() < np.pi - 0.1
    before = mechanism.fold_angles(0.999 * mechanism.target_drive)
    assert np.abs(before.row).max() < np.pi


def test_drive_is_the_fold_angle_of_column_1() -> None:
    mechanism = sheet()
    column = mechanism.fold_angles(1.2).column[:, 0]
    np.testing.assert_allclose(column, [-1.2, 1.2, -1.2, 1.2, -1.2, 1.2], atol=1e-15)


def test_columns_keep_their_ratio() -> None:
    # tan(v_2/2) = c tan(v_1/2), and 1, c, -c, -1 over a period.
    mechanism = sheet(columns=8)
    c = mechanism.columns.multipliers[1]
    tangents = np.tan(mechanism.fold_angles(np.array([0.3, 1.9])).column / 2)
    expected = tangents[..., :1] * np.array([1, c, -c, -1, 1, c, -c, -1])
    np.testing.assert_allclose(tangents, expected, rtol=1e-13)


def test_all_rows_fold_the_same_way() -> None:
    signs = find_assignment(sheet())
    assert (signs.row == -1).all()
    assert (find_assignment(sheet(first_row="S")).row == 1).all()


def test_s_rows_are_planar_and_f_rows_are_not() -> None:
    # geometry.md section 5: F rows are off by 0.01 in a 2-unit row at v_1 = 100 degrees.
    rows = sheet(rows=5, columns=9).positions(np.deg2rad(100))[1:-1, 1:-1]
    departure = departures_from_plane(rows)
    assert departure[1::2].max() < 1e-14
    assert departure[::2].min() > 1e-4


def test_flat_sheet_is_the_mechanism_at_drive_0() -> None:
    flat = sheet().positions(0.0)
    assert np.abs(flat[..., 2]).max() < 1e-15
    # Rows run to the right, columns downwards.
    assert (np.diff(flat[..., 0], axis=1) > 0).all()
    assert (np.diff(flat[..., 1], axis=0) < 0).all()


def test_positions_of_many_drives_are_those_of_each() -> None:
    mechanism = sheet()
    drives = np.linspace(0, mechanism.target_drive, 5)
    together = mechanism.positions(drives)
    assert together.shape == (5, 7, 8, 3)
    for drive, state in zip(drives, together, strict=True):
        np.testing.assert_allclose(state, mechanism.positions(float(drive)), atol=1e-15)
    angles = mechanism.fold_angles(drives)
    np.testing.assert_array_equal(angles.row[3], mechanism.fold_angles(float(drives[3])).row)


def test_motion_is_steady() -> None:
    mechanism = sheet(rows=3, columns=4)
    end = 0.5 * mechanism.target_drive
    coarse = mechanism.positions(np.linspace(0.2, end, 101))
    fine = mechanism.positions(np.linspace(0.2, end, 401))
    step = np.linalg.norm(np.diff(coarse, axis=0), axis=-1).max()
    finer = np.linalg.norm(np.diff(fine, axis=0), axis=-1).max()
    assert finer == pytest.approx(step / 4, rel=0.05)
    centroid = fine[:, 2, 1:-1].mean(axis=1)
    np.testing.assert_allclose(centroid, 0 * centroid, atol=1e-14)


def test_scale_equivariance() -> None:
    mechanism = sheet()
    lengths = mechanism.lengths
    larger = LongitudinalLinearRepeating(
        mechanism.columns, "F", type(lengths)(1000 * lengths.row, 1000 * lengths.column)
    )
    np.testing.assert_allclose(
        larger.positions(1.0), 1000 * mechanism.positions(1.0), rtol=1e-12, atol=1e-10
    )
