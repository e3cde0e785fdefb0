"""Longitudinal sheets alone; what every mechanism keeps: ``tests/motion/test_contract.py``."""

import numpy as np
import pytest

from mechanisms import PAPER, SINE, longitudinal
from orishell.families.longitudinal_linear_repeating.placement import departures_from_plane
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    sector_table,
)
from orishell.motion import FoldedState, find_assignment
from orishell.verification.residuals import measure_residuals
from samples import led_by


@pytest.mark.slow
@pytest.mark.parametrize("size", led_by([299, 999]))
def test_large_sheets_near_90_degrees(size: int) -> None:
    mechanism = longitudinal((89.9995, 89.999, 90.0005, 90.001), size, size, equal=True)
    flat = FoldedState.of(mechanism, 0.0)
    residuals, _ = measure_residuals([FoldedState.of(mechanism, 1.0)], flat)
    assert residuals.panel_length <= 1e-11


def test_sector_angles_are_those_of_figure_3() -> None:
    # geometry.md section 5: F = (pi-beta, alpha, beta, pi-alpha), S = (pi-delta, delta, gamma,
    # pi-gamma) as LU, LD, RD, RU; columns 1, 2, 2', 1' with (pi-RU, pi-RD, pi-LD, pi-LU).
    mechanism = longitudinal(rows=3, columns=5)
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
    mechanism = longitudinal()
    assert np.rad2deg(mechanism.target_drive) == pytest.approx(119.747, abs=1e-3)
    end = mechanism.fold_angles(mechanism.target_drive)
    assert np.abs(end.row).max() == pytest.approx(np.pi, abs=1e-12)
    assert np.abs(end.row[::2]).max() < np.pi - 0.1
    before = mechanism.fold_angles(0.999 * mechanism.target_drive)
    assert np.abs(before.row).max() < np.pi


def test_drive_is_the_fold_angle_of_column_1() -> None:
    mechanism = longitudinal()
    column = mechanism.fold_angles(1.2).column[:, 0]
    np.testing.assert_allclose(column, [-1.2, 1.2, -1.2, 1.2, -1.2, 1.2], atol=1e-15)


def test_columns_keep_their_ratio() -> None:
    # tan(v_2/2) = c tan(v_1/2), and 1, c, -c, -1 over a period.
    mechanism = longitudinal(columns=8)
    c = mechanism.columns.multipliers[1]
    tangents = np.tan(mechanism.fold_angles(np.array([0.3, 1.9])).column / 2)
    expected = tangents[..., :1] * np.array([1, c, -c, -1, 1, c, -c, -1])
    np.testing.assert_allclose(tangents, expected, rtol=1e-13)


def test_versions_of_solutions() -> None:
    versions = [longitudinal(SINE, 5, 5, "F", number).columns.version for number in (0, 1)]
    assert versions == ["cosine", "sine"]


def test_all_rows_fold_the_same_way() -> None:
    signs = find_assignment(longitudinal())
    assert (signs.row == -1).all()
    assert (find_assignment(longitudinal(first_row="S")).row == 1).all()


def test_s_rows_are_planar_and_f_rows_are_not() -> None:
    # geometry.md section 5: F rows are off by 0.01 in a 2-unit row at v_1 = 100 degrees.
    rows = longitudinal(rows=5, columns=9).positions(np.deg2rad(100))[1:-1, 1:-1]
    departure = departures_from_plane(rows)
    assert departure[1::2].max() < 1e-14
    assert departure[::2].min() > 1e-4


def test_rows_of_the_flat_sheet_run_to_the_right() -> None:
    flat = longitudinal().positions(0.0)
    assert np.abs(flat[..., 2]).max() < 1e-15
    # And columns downwards.
    assert (np.diff(flat[..., 0], axis=1) > 0).all()
    assert (np.diff(flat[..., 1], axis=0) < 0).all()


def test_the_middle_row_does_not_drift() -> None:
    mechanism = longitudinal(rows=3, columns=4)
    fine = mechanism.positions(np.linspace(0.2, 0.5 * mechanism.target_drive, 401))
    centroid = fine[:, 2, 1:-1].mean(axis=1)
    np.testing.assert_allclose(centroid, 0 * centroid, atol=1e-14)
