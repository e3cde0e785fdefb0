"""Invariants of the closed form, on designs of every kind."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.design import Design
from orishell.families.orthodiagonal import Orthodiagonal, design_orthodiagonal
from orishell.motion import (
    FoldedState,
    FoldingMotion,
    diagonal,
    find_assignment,
    measure_fold_angles,
)
from orishell.verification.residuals import measure_residuals
from samples import examples, thorough
from strategies import Request, graph, orthodiagonal_requests

PARABOLA, WAVE = graph("-x**2", -1, 1), graph("0.25*sin(pi*x/2)", 0, 4)


def mechanism_of(design: Design) -> Orthodiagonal:
    assert isinstance(design.mechanism, Orthodiagonal)
    return design.mechanism


def demo(rows: int = 9, columns: int = 13, **options: Any) -> Orthodiagonal:
    design = design_orthodiagonal(
        PARABOLA, WAVE, rows=rows, columns=columns, **{"depth": 0.12, "flap": 0.15, **options}
    )
    return mechanism_of(design)


def leaning(**options: Any) -> Orthodiagonal:
    """An asymmetric f, so that the middle row is tilted."""
    f = graph("0.5*x + 0.2*sin(2*x)", 0, 3)
    return mechanism_of(design_orthodiagonal(f, WAVE, rows=9, columns=12, **options))


def column_directions(mechanism: Orthodiagonal) -> tuple[complex, complex]:
    """Directions of t and n in plan."""
    t = complex(np.exp(-1j * mechanism.heading))
    return t, 1j * t


@settings(max_examples=examples(150))
@given(orthodiagonal_requests(), st.floats(0.01, 0.999))
def test_any_design_is_rigid_and_folds_as_the_closed_form_says(
    request: Request, share: float
) -> None:
    # Every request works, or works with the nearest value that the error names.
    mechanism = mechanism_of(request.feasible())
    drives = np.array([share * np.pi, mechanism.target_drive, np.pi])
    states = [FoldedState.of(mechanism, float(drive)) for drive in drives]
    residuals, assignment = measure_residuals(states, FoldedState.of(mechanism, 0.0))
    assert residuals.panel_length < 1e-12
    assert residuals.planarity < 1e-12
    assert assignment.constant
    assert assignment.maekawa
    # Angles lose what the rounding of coordinates takes from the shortest edge or panel.
    flat = mechanism.positions(0.0)
    _, n = column_directions(mechanism)
    shortest = min(
        np.linalg.norm(np.diff(flat, axis=0), axis=-1).min(),
        np.linalg.norm(np.diff(flat[0], axis=0), axis=-1).min(),
        np.diff(flat[0] @ np.array([n.real, n.imag, 0.0])).min(),
    )
    size = np.abs(np.stack([state.positions for state in states])).max() + diagonal(flat)
    tolerance = 1e-12 + 50 * np.finfo(float).eps * size / shortest
    assert residuals.fold_angle_rad < tolerance
    assert residuals.sector_sum_rad < tolerance


@settings(max_examples=examples(60))
@given(orthodiagonal_requests())
def test_locked_state_lies_on_the_polylines(request: Request) -> None:
    mechanism = mechanism_of(request.feasible())
    locked = mechanism.positions(mechanism.target_drive)
    plan = locked[..., :2] @ np.array([1, 1j])
    size = diagonal(mechanism.positions(0.0)) + np.abs(locked).max()
    middle = (locked.shape[0] - 1) // 2
    t, n = column_directions(mechanism)
    # The middle row is g's polyline, in z = 0 turned about n through g's first vertex.
    plan, locked = plan[:, mechanism.inner_columns], locked[:, mechanism.inner_columns]
    row, points = plan[middle] - mechanism.points[0], mechanism.points - mechanism.points[0]
    along, height = (row * np.conj(t)).real, locked[middle, :, 2]
    turned = np.exp(1j * mechanism.tilt) * (points * np.conj(t)).real
    np.testing.assert_allclose(along + 1j * height, turned, atol=1e-12 * size)
    np.testing.assert_allclose(
        (row * np.conj(n)).real, (points * np.conj(n)).real, atol=1e-12 * size
    )
    if mechanism.tilt == 0:
        np.testing.assert_array_equal(plan[middle], mechanism.points)
        np.testing.assert_array_equal(height, 0.0)
    # All columns have the angles beta of column 1 and stand in planes square to n.
    edges = np.diff(locked, axis=0)
    across = edges[..., 0] * n.real + edges[..., 1] * n.imag
    assert np.abs(across).max() < 1e-12 * size
    # The flaps are closed: their creases at 180 degrees, measured.
    if mechanism.flaps[0]:
        measured = measure_fold_angles(mechanism.positions(mechanism.target_drive)).row
        np.testing.assert_allclose(np.abs(measured[:, [0, -1]]), np.pi, atol=1e-6)


@settings(max_examples=examples(60))
@given(orthodiagonal_requests())
def test_column_lengths_are_those_of_the_flat_sheet(request: Request) -> None:
    mechanism = mechanism_of(request.feasible())
    flat = mechanism.positions(0.0)
    measured = np.linalg.norm(np.diff(flat, axis=0), axis=-1)
    size = diagonal(flat) + np.abs(flat).max()
    np.testing.assert_allclose(mechanism.column_lengths(), measured, atol=1e-12 * size)
    assert (mechanism.column_lengths() > 0).all()


def test_all_rows_reach_their_angle_together() -> None:
    for mechanism in (demo(), leaning()):
        for drive, kappa in ((0.0, 0.0), (2.0, np.sin(1.0)), (np.pi, 1.0)):
            # Outlines of flaps may be cut: the creases' columns only.
            columns = mechanism.positions(drive)[:, mechanism.inner_columns]
            edges = np.diff(columns, axis=0)
            edges /= np.linalg.norm(edges, axis=-1, keepdims=True)
            psi = np.pi - 2 * np.arcsin(0.5 * np.linalg.norm(np.diff(edges, axis=0), axis=-1))
            cot = kappa / np.tan(mechanism.angles / 2)
            expected = 2 * np.arctan2(1.0, cot)
            np.testing.assert_allclose(
                psi, np.broadcast_to(expected[:, None], psi.shape), atol=1e-10
            )


def test_sector_angles_are_equation_3() -> None:
    # Both flaps to the start of f: there the paper's signs hold. gamma is measured on the locked
    # middle row, "from the same side".
    mechanism = demo(flap_sides=("start", "start"))
    alpha = mechanism.sector_angles()
    beta = mechanism.angles
    middle = len(beta) // 2
    third, fourth = alpha[..., 2], alpha[..., 3]
    np.testing.assert_allclose(third[:, 0], (np.pi + beta) / 2, atol=1e-14)
    np.testing.assert_allclose(fourth[:, -1], (np.pi + beta) / 2, atol=1e-14)
    np.testing.assert_allclose(third[:, 1:], np.pi - fourth[:, :-1], atol=1e-14)
    segment = np.diff(mechanism.points)
    gamma = np.pi + np.angle(segment[1:] / segment[:-1])
    reach = abs(np.cos(third[middle, 0]))
    expected = np.cos(gamma - np.arccos(np.cos(third[middle, 1:-1]) / reach))
    np.testing.assert_allclose(np.cos(fourth[middle, 1:-1]) / reach, expected, atol=1e-12)
    ratio_right = np.tan(fourth[:-1, 1:-1]) / np.tan(fourth[1:, 1:-1])
    ratio_left = np.tan(third[:-1, 1:-1]) / np.tan(third[1:, 1:-1])
    np.testing.assert_allclose(ratio_right, ratio_left, rtol=1e-9)
    np.testing.assert_allclose(alpha[..., 0], np.pi - fourth, atol=1e-15)
    np.testing.assert_allclose(alpha[..., 1], np.pi - third, atol=1e-15)


def test_sector_angles_are_those_of_the_flat_sheet() -> None:
    mechanism = leaning(flap_sides=("start", "end"))
    flat = mechanism.positions(0.0)

    def angle(u: np.ndarray, v: np.ndarray) -> np.ndarray:
        cross = np.linalg.norm(np.cross(u, v), axis=-1)
        return np.asarray(np.arctan2(cross, (u * v).sum(axis=-1)))

    at = flat[1:-1, 1:-1]
    up, down = flat[:-2, 1:-1] - at, flat[2:, 1:-1] - at
    left, right = flat[1:-1, :-2] - at, flat[1:-1, 2:] - at
    measured = np.stack(
        [angle(right, up), angle(left, up), angle(left, down), angle(right, down)], axis=-1
    )
    np.testing.assert_allclose(measured, mechanism.sector_angles(), atol=1e-12)


def test_fold_angles_satisfy_the_degree_4_vertex_relation() -> None:
    # geometry.md section 2(a) at every inner vertex with a = LU, b = LD, c = RD:
    # P = cot(left/2), Q = cot(down/2); independent of the formulas used.
    mechanism = leaning()
    angles = mechanism.fold_angles(1.9)
    a, b, c = (mechanism.sector_angles()[..., k] for k in (1, 2, 3))
    left, down = angles.row[:, :-1], angles.column[1:]
    p, q = 1 / np.tan(left / 2), 1 / np.tan(down / 2)
    residual = (
        np.sin(a) * np.sin(b + c) * q**2
        + 2 * np.sin(a) * np.sin(c) * p * q
        + np.sin(a + b) * np.sin(c) * p**2
        + np.sin(a + c) * np.sin(b)
    )
    folded = np.abs(down) > 1e-6
    assert np.abs(residual / (1 + p**2 + q**2))[folded].max() < 1e-12


def test_straight_g_leaves_the_inner_columns_unfolded() -> None:
    for text in ("0*x", "0.1*x + 1"):
        g = graph(text, 0, 4)
        mechanism = design_orthodiagonal(PARABOLA, g, rows=9, columns=7).mechanism
        signs = find_assignment(mechanism)
        assert (signs.column[:, 1:-1] == 0).all()
        assert (signs.column[:, [0, -1]] != 0).all()
        assert (signs.row != 0).all()
        residuals, assignment = measure_residuals(
            FoldingMotion(mechanism, 9), FoldedState.of(mechanism, 0.0)
        )
        assert residuals.panel_length < 1e-14
        assert assignment.maekawa


def test_flat_sheet_is_the_mechanism_at_drive_0() -> None:
    assert (demo().positions(0.0)[..., 2] == 0).all()
    for mechanism in (demo(), leaning()):
        flat = mechanism.positions(0.0)
        assert np.ptp(flat[..., 2]) < 1e-15
        assert np.abs(measure_fold_angles(flat).row).max() < 1e-12
        # Seen from +z rows run to the right of the columns' direction downwards.
        right, down = flat[5, 6] - flat[5, 5], flat[6, 5] - flat[5, 5]
        assert np.cross(down, right)[2] > 0


def test_positions_of_many_drives_are_those_of_each() -> None:
    mechanism = leaning()
    drives = np.linspace(0, np.pi, 6).reshape(2, 3)
    together = mechanism.positions(drives)
    assert together.shape == (2, 3, 11, 14, 3)
    for index, drive in np.ndenumerate(drives):
        np.testing.assert_allclose(together[index], mechanism.positions(drive), atol=1e-14)
    angles = mechanism.fold_angles(drives)
    np.testing.assert_allclose(
        angles.row[1, 0], mechanism.fold_angles(float(drives[1, 0])).row, atol=1e-14
    )


def test_motion_is_steady() -> None:
    for mechanism in (demo(), leaning()):
        coarse = mechanism.positions(np.linspace(0, np.pi, 101))
        fine = mechanism.positions(np.linspace(0, np.pi, 401))
        step = np.linalg.norm(np.diff(coarse, axis=0), axis=-1).max()
        finer = np.linalg.norm(np.diff(fine, axis=0), axis=-1).max()
        assert finer == pytest.approx(step / 4, rel=0.05)
        # No drift: the middle row's centroid, weighted by length, stays, and so does n.
        row = fine[:, 5, 1:-1]
        length = np.abs(np.diff(mechanism.points))
        weight = 0.5 * (np.append(length, 0) + np.append(0, length)) / length.sum()
        centroid = (row * weight[:, None]).sum(axis=1)
        np.testing.assert_allclose(
            centroid, np.broadcast_to(centroid[-1], centroid.shape), atol=1e-12
        )
        t, _ = column_directions(mechanism)
        edges = np.diff(fine, axis=2)[..., 1:-1, :]
        along = edges[..., 0] * t.real + edges[..., 1] * t.imag
        slope = edges[..., 5, :, 2] * np.cos(mechanism.tilt * np.linspace(0, 1, 401))[:, None]
        rise = along[..., 5, :] * np.sin(mechanism.tilt * np.linspace(0, 1, 401))[:, None]
        np.testing.assert_allclose(slope, rise, atol=1e-12)


def test_flaps_fold_to_the_chosen_side() -> None:
    for sides in (("end", "end"), ("start", "end"), ("end", "start"), ("start", "start")):
        mechanism = demo(flap_sides=sides)
        locked = mechanism.positions(np.pi)[..., :2] @ np.array([1, 1j])
        t, _ = column_directions(mechanism)
        for side, outer, inner in (
            (sides[0], locked[5, 0], locked[5, 1]),
            (sides[1], locked[5, -1], locked[5, -2]),
        ):
            along = ((outer - inner) / abs(outer - inner) * np.conj(t)).real
            assert along == pytest.approx(1.0 if side == "end" else -1.0, abs=1e-12)


def test_flap_width_is_measured_square_to_its_column() -> None:
    flat = demo(flap=0.1).positions(0.0)[..., :2] @ np.array([1, 1j])
    for outer, inner in ((flat[:, 0], flat[:, 1]), (flat[:, -1], flat[:, -2])):
        column = inner[-1] - inner[0]
        distance = ((outer - inner) * (column / abs(column)).conj()).imag
        np.testing.assert_allclose(np.abs(distance), 0.1, atol=1e-13)


def test_scale_equivariance() -> None:
    small = demo()
    large = design_orthodiagonal(
        PARABOLA.scaled(1000), WAVE.scaled(1000), rows=9, columns=13, depth=120.0, flap=150.0
    ).mechanism
    np.testing.assert_allclose(
        large.positions(1.3), 1000 * small.positions(1.3), rtol=1e-9, atol=1e-6
    )


@thorough
@pytest.mark.slow
@pytest.mark.parametrize(
    ("rows", "columns", "g"),
    [
        (99, 99, "0.25*sin(pi*x/2)"),
        pytest.param(999, 999, "0.25*sin(pi*x/2)/10", marks=thorough),
        (99, 99, "0.1*exp(-(x-2)**2/0.5) + 0.02*x**2"),
    ],
)
@pytest.mark.parametrize("spacing", ["curvature", "equal"])
def test_large_sheets_keep_twelve_digits(rows: int, columns: int, g: str, spacing: Any) -> None:
    for f in (PARABOLA, graph("0.5*x + 0.2*sin(2*x)", 0, 3)):
        design = design_orthodiagonal(
            f, graph(g, 0, 4), rows=rows, columns=columns, heading="auto", spacing=spacing
        )
        motion = FoldingMotion(design.mechanism, 5 if rows > 99 else 25)
        residuals, assignment = measure_residuals(motion, motion.flat)
        assert residuals.panel_length <= 1e-12
        assert residuals.planarity <= 1e-12
        assert residuals.fold_angle_rad <= 1e-9
        assert residuals.sector_sum_rad <= 1e-9
        assert assignment.constant
        assert assignment.maekawa
