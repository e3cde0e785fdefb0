"""Orthodiagonal alone; what every mechanism keeps is in ``tests/motion/test_contract.py``."""

import numpy as np
import pytest
from hypothesis import given, settings

from mechanisms import PARABOLA, leaning, orthodiagonal_of, upright
from orishell.families.orthodiagonal import (
    Orthodiagonal,
    OrthodiagonalPattern,
    design_orthodiagonal,
)
from orishell.motion import (
    FoldedState,
    FoldingMotion,
    diagonal,
    find_assignment,
    measure_fold_angles,
)
from orishell.verification.residuals import measure_residuals
from samples import examples
from strategies import Request, graph, orthodiagonal_requests


def column_directions(mechanism: Orthodiagonal) -> tuple[complex, complex]:
    """Directions of t and n in plan."""
    t = complex(np.exp(-1j * mechanism.heading))
    return t, 1j * t


@settings(max_examples=examples(60))
@given(orthodiagonal_requests())
def test_locked_state_lies_on_the_polylines(request: Request) -> None:
    mechanism = orthodiagonal_of(request.feasible())
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
    mechanism = orthodiagonal_of(request.feasible())
    flat = mechanism.positions(0.0)
    measured = np.linalg.norm(np.diff(flat, axis=0), axis=-1)
    size = diagonal(flat) + np.abs(flat).max()
    np.testing.assert_allclose(mechanism.column_lengths(), measured, atol=1e-12 * size)
    assert (mechanism.column_lengths() > 0).all()


def test_all_rows_reach_their_angle_together() -> None:
    for mechanism in (upright(), leaning()):
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
    mechanism = upright(flap_side=["start", "start"])
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
    mechanism = leaning(flap_side=["start", "end"])
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
        mechanism = design_orthodiagonal(
            PARABOLA, g, OrthodiagonalPattern(rows=9, columns=7)
        ).mechanism
        signs = find_assignment(mechanism)
        assert (signs.column[:, 1:-1] == 0).all()
        assert (signs.column[:, [0, -1]] != 0).all()
        assert (signs.row != 0).all()
        residuals, assignment = measure_residuals(
            FoldingMotion(mechanism, 9), FoldedState.of(mechanism, 0.0)
        )
        assert residuals.panel_length < 1e-14
        assert assignment.maekawa


def test_the_middle_row_does_not_drift() -> None:
    for mechanism in (upright(), leaning()):
        fine = mechanism.positions(np.linspace(0, np.pi, 401))
        # Its centroid, weighted by length, stays, and so does n.
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
        mechanism = upright(flap_side=sides)
        locked = mechanism.positions(np.pi)[..., :2] @ np.array([1, 1j])
        t, _ = column_directions(mechanism)
        for side, outer, inner in (
            (sides[0], locked[5, 0], locked[5, 1]),
            (sides[1], locked[5, -1], locked[5, -2]),
        ):
            along = ((outer - inner) / abs(outer - inner) * np.conj(t)).real
            assert along == pytest.approx(1.0 if side == "end" else -1.0, abs=1e-12)


def test_flap_width_is_measured_square_to_its_column() -> None:
    flat = upright(flap=0.1).positions(0.0)[..., :2] @ np.array([1, 1j])
    for outer, inner in ((flat[:, 0], flat[:, 1]), (flat[:, -1], flat[:, -2])):
        column = inner[-1] - inner[0]
        distance = ((outer - inner) * (column / abs(column)).conj()).imag
        np.testing.assert_allclose(np.abs(distance), 0.1, atol=1e-13)
