"""Parallel repeating alone; what every mechanism keeps is in ``tests/motion/test_contract.py``."""

import numpy as np
import pytest
from hypothesis import given, settings

from mechanisms import parallel, parallel_of
from orishell.curves import trace_curve
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.motion import (
    diagonal,
    find_assignment,
    measure_fold_angles,
)
from orishell.polylines import fit_staircase
from samples import examples
from strategies import Request, graph, requests


@settings(max_examples=examples(60))
@given(requests())
def test_locked_state_lies_on_the_polylines(request: Request) -> None:
    mechanism = parallel_of(request.feasible())
    locked = mechanism.positions(mechanism.target_drive)
    middle = (locked.shape[0] - 1) // 2
    row = locked[middle, mechanism.inner_columns]
    size = diagonal(mechanism.positions(0.0))
    # The middle row is exactly g's polyline, in z = 0 (contract, "Locked frame").
    np.testing.assert_array_equal(row[:, 0] + 1j * row[:, 1], mechanism.points)
    np.testing.assert_array_equal(row[:, 2], 0.0)
    # Column 1 is a zigzag of constant angle xi in the vertical plane of t.
    column = locked[:, mechanism.inner_columns][:, 0]
    edges = np.diff(column, axis=0)
    t = mechanism.axes[0]
    reach = (edges[:, 0] + 1j * edges[:, 1]) * t.conj()
    assert np.abs(reach.imag).max() < 1e-12 * size
    np.testing.assert_allclose(
        reach.real, mechanism.lengths * np.sin(mechanism.xi / 2), atol=1e-12 * size
    )
    heights = mechanism.lengths * np.cos(mechanism.xi / 2)
    np.testing.assert_allclose(np.abs(edges[:, 2]), heights, atol=1e-12 * size)
    assert (np.sign(edges[1:, 2]) == -np.sign(edges[:-1, 2])).all()
    # The flaps are closed: their creases at 180 degrees, measured.
    if mechanism.flaps[0]:
        measured = measure_fold_angles(locked).row
        np.testing.assert_allclose(np.abs(measured[:, [0, -1]]), np.pi, atol=1e-6)


@settings(max_examples=examples(60))
@given(requests())
def test_row_lengths_are_those_of_the_flat_sheet(request: Request) -> None:
    mechanism = parallel_of(request.feasible())
    flat = mechanism.positions(0.0)
    size = diagonal(flat)
    for row in (0, flat.shape[0] - 1):
        measured = np.linalg.norm(np.diff(flat[row, mechanism.inner_columns], axis=0), axis=-1)
        np.testing.assert_allclose(mechanism.row_lengths(row), measured, atol=1e-12 * size)


def test_column_1_is_the_staircase_of_f() -> None:
    f = trace_curve(graph("-x**2 + 0.2*x", -1, 1.1))
    staircase = fit_staircase(f, np.deg2rad(40), 12)
    design = design_parallel_repeating(
        graph("-x**2 + 0.2*x", -1, 1.1),
        graph("x**2/40", 0, 20),
        ParallelRepeatingPattern(rows=11, columns=7, xi_deg=40),
    )
    mechanism = parallel_of(design)
    column = mechanism.positions(np.pi)[:, 1]
    across = (column[:, 0] + 1j * column[:, 1] - mechanism.points[0]) * mechanism.axes[0].conj()
    found = np.stack([across.real, column[:, 2]], axis=-1)
    expected = staircase.vertices - staircase.vertices[6]
    np.testing.assert_allclose(found, expected, atol=1e-12)


def test_sector_angles_are_equation_2() -> None:
    mechanism = parallel()
    # Equation (2) of the paper, its inputs measured on the locked state and not on the design.
    locked = mechanism.positions(np.pi)
    row = locked[5, 1:-1, :2] @ np.array([1, 1j])
    t = (locked[6, 1:-1, :2] - locked[4, 1:-1, :2]) @ np.array([1, 1j])
    segment = np.diff(row)
    delta_odd = np.angle(segment / t[:-1])
    delta_even = np.abs(np.angle(-segment / t[1:]))
    xi = mechanism.xi
    alpha = (
        mechanism.sector_angles()
    )  # columns: alpha_{4j-3}, alpha_{4j-2}, alpha_{4j-1}, alpha_{4j}
    third, fourth = alpha[:, 2], alpha[:, 3]
    assert third[0] == pytest.approx((np.pi - xi) / 2, abs=1e-14)
    assert np.cos(fourth[0]) == pytest.approx(np.cos(delta_odd[0]) * np.cos(third[0]), abs=1e-12)
    np.testing.assert_allclose(
        np.tan(third[1:]) / np.tan(delta_even), np.tan(fourth[:-1]) / np.tan(delta_odd), rtol=1e-9
    )
    inner = np.abs(np.cos(delta_even[:-1])) > 1e-6
    np.testing.assert_allclose(
        (np.cos(fourth[1:-1]) / np.cos(delta_odd[1:]))[inner],
        (np.cos(third[1:-1]) / np.cos(delta_even[:-1]))[inner],
        rtol=1e-9,
    )
    assert abs(np.cos(fourth[-1])) == pytest.approx(
        abs(np.cos(third[-1]) / np.cos(delta_even[-1])), abs=1e-12
    )
    np.testing.assert_allclose(alpha[:, 0], np.pi - fourth, atol=1e-15)
    np.testing.assert_allclose(alpha[:, 1], np.pi - third, atol=1e-15)


def test_sector_angles_are_those_of_the_flat_sheet() -> None:
    mechanism = parallel(plane_deg=70, flap_side=["start", "end"])
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
    expected = np.broadcast_to(mechanism.sector_angles(), measured.shape)
    np.testing.assert_allclose(measured, expected, atol=1e-12)


def test_fold_angles_satisfy_the_degree_4_vertex_relation() -> None:
    # geometry.md section 2(a), checked at every inner vertex with a = LU, b = LD, c = RD:
    # P = cot(left/2), Q = cot(down/2); independent of the column-straight formulas used.
    mechanism = parallel(plane_deg=75)
    angles = mechanism.fold_angles(1.9)
    alpha = mechanism.sector_angles()
    a, b, c = alpha[:, 1], alpha[:, 2], alpha[:, 3]
    left, down = angles.row[:, :-1], angles.column[1:]
    p, q = 1 / np.tan(left / 2), 1 / np.tan(down / 2)
    residual = (
        np.sin(a) * np.sin(b + c) * q**2
        + 2 * np.sin(a) * np.sin(c) * p * q
        + np.sin(a + b) * np.sin(c) * p**2
        + np.sin(a + c) * np.sin(b)
    )
    scale = 1 + p**2 + q**2
    folded = np.abs(down) > 1e-6
    assert np.abs(residual / scale)[folded].max() < 1e-12


def test_inflection_leaves_an_unfolded_column() -> None:
    signs = find_assignment(parallel())
    # Figure 1's g has its inflection at x = 10, where column 6 of 11 stands.
    assert (signs.column[:, 5] == 0).all()
    assert (np.delete(signs.column, 5, axis=1) != 0).all()
    assert (signs.row != 0).all()


def test_the_middle_row_does_not_drift() -> None:
    mechanism = parallel(columns=12)
    fine = mechanism.positions(np.linspace(0, np.pi, 401))
    # Its centroid, weighted by length, stays.
    row = fine[:, 5, 1:-1, :2]
    length = np.abs(np.diff(mechanism.points))
    weight = 0.5 * (np.append(length, 0) + np.append(0, length)) / length.sum()
    centroid = (row * weight[:, None]).sum(axis=1)
    np.testing.assert_allclose(centroid, np.broadcast_to(centroid[-1], centroid.shape), atol=1e-12)


def test_flaps_fold_to_the_chosen_side() -> None:
    for sides in (("end", "end"), ("start", "end"), ("end", "start"), ("start", "start")):
        mechanism = parallel(flap_side=sides)
        locked = mechanism.positions(np.pi)[..., :2] @ np.array([1, 1j])
        for side, outer, inner, axis in (
            (sides[0], locked[5, 0], locked[5, 1], mechanism.axes[0]),
            (sides[1], locked[5, -1], locked[5, -2], mechanism.axes[-1]),
        ):
            along = ((outer - inner) / abs(outer - inner) * axis.conj()).real
            assert along == pytest.approx(1.0 if side == "end" else -1.0, abs=1e-12)


def test_flap_width_is_measured_square_to_its_column() -> None:
    flat = parallel(flap=0.3).positions(0.0)[..., :2] @ np.array([1, 1j])
    for outer, inner in ((flat[:, 0], flat[:, 1]), (flat[:, -1], flat[:, -2])):
        column = inner[-1] - inner[0]
        distance = ((outer - inner) * (column / abs(column)).conj()).imag
        np.testing.assert_allclose(np.abs(distance), 0.3, atol=1e-13)
