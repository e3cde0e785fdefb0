"""Flat-foldable sheets from a row and a column: panels close, vertices are those of Feng et al."""

from __future__ import annotations

import time
import tracemalloc
from dataclasses import replace

import numpy as np
import pytest

from accelerations import shares_of_bounds
from fitted_shells import fitted
from mechanisms import TURNED, flat_foldable, miura_net, random_net
from orishell.families.flat_foldable.mechanism import FlatFoldable
from orishell.families.flat_foldable.net import Net
from orishell.families.shared.folding import HalfFolds, fold
from orishell.motion import measure_fold_angles
from samples import led_by, thorough
from timing import HANGS

Array = np.ndarray
LISTS = (
    "x",
    "y",
    "row_angles",
    "column_angles",
    "row_lengths",
    "column_lengths",
    "top",
    "bottom",
    "left",
    "right",
    "corners",
)


def changes_of_distances(sheet: FlatFoldable, drives: Array) -> float:
    """How much sides and diagonals of panels change at most from the flat sheet, by themselves."""

    def distances(places: Array) -> list[Array]:
        pairs = (
            (places[:, 1:], places[:, :-1]),
            (places[1:], places[:-1]),
            (places[1:, 1:], places[:-1, :-1]),
            (places[1:, :-1], places[:-1, 1:]),
        )
        return [np.linalg.norm(one - other, axis=-1) for one, other in pairs]

    flat = distances(sheet.positions(0.0))
    return max(
        float(np.abs(now / before - 1).max())
        for drive in drives
        for now, before in zip(distances(sheet.positions(drive)), flat, strict=True)
    )


def sectors_of(sheet: FlatFoldable) -> Array:
    """Sectors right-up, left-up, left-down, right-down (R, C, 4) measured in the flat sheet."""
    places = sheet.positions(0.0)[..., :2] @ np.array([1, 1j])
    here = places[1:-1, 1:-1]
    ways = [places[1:-1, 2:], places[:-2, 1:-1], places[1:-1, :-2], places[2:, 1:-1]]
    right, up, left, down = (each - here for each in ways)
    turns = [up / right, left / up, down / left, right / down]
    return np.stack([np.angle(each) for each in turns], axis=-1)


def multipliers(alpha: Array, beta: Array, sigma: Array) -> Array:
    """Feng, Dang, James and Plucinsky, J. Mech. Phys. Solids 142 (2020) 104018, eq. (35)."""
    return np.asarray(
        (-sigma + np.cos(alpha) * np.cos(beta) + np.sin(alpha) * np.sin(beta))
        / (np.cos(alpha) - sigma * np.cos(beta))
    )


@pytest.mark.parametrize("mixed", [False, True])
def test_panels_are_rigid_from_flat_to_the_flat_stack(mixed: bool) -> None:
    # Seen: 1.2e-13 and 1e-13.
    size = 16 if mixed else 30
    sheet = flat_foldable(random_net(size, size, 4, mixed=mixed), **TURNED)
    drives = np.append(np.linspace(0, np.pi, 12), sheet.target_drive)
    assert changes_of_distances(sheet, drives) < 1e-12


@pytest.mark.parametrize("surface", led_by(["cap", "saddle .5", "roof"]))
@pytest.mark.parametrize("count", led_by([5, 8, 30]))
def test_panels_of_fitted_sheets_are_rigid_from_flat_to_the_flat_stack(
    surface: str, count: int
) -> None:
    sheet = mechanism_of(surface, count)
    drives = np.append(np.linspace(0, np.pi, 12), sheet.target_drive)
    assert changes_of_distances(sheet, drives) < 1e-12


def mechanism_of(surface: str, count: int) -> FlatFoldable:
    mechanism = fitted(surface, count).mechanism
    assert isinstance(mechanism, FlatFoldable)
    return mechanism


@pytest.mark.parametrize("surface", ["cap", "saddle .5", "roof"])
def test_fitted_sheets_keep_the_conditions_of_feng_and_others(surface: str) -> None:
    require_conditions(mechanism_of(surface, 5), mixed=False)


@pytest.mark.parametrize("mixed", [False, True])
def test_vertices_and_panels_keep_the_conditions_of_feng_and_others(mixed: bool) -> None:
    require_conditions(flat_foldable(random_net(8, 7, 5, mixed=mixed), **TURNED), mixed=mixed)


def require_conditions(sheet: FlatFoldable, *, mixed: bool) -> None:
    sectors = sectors_of(sheet)
    # Kawasaki, and the sum of a panel's angles.
    np.testing.assert_allclose(sectors[..., 0] + sectors[..., 2], np.pi, atol=1e-12)
    np.testing.assert_allclose(sectors[..., 1] + sectors[..., 3], np.pi, atol=1e-12)
    around = sectors[:-1, :-1, 3] + sectors[:-1, 1:, 2] + sectors[1:, 1:, 1] + sectors[1:, :-1, 0]
    np.testing.assert_allclose(around, 2 * np.pi, atol=1e-12)
    # Opposite fold angles have one size, one pair of them one sign, and the other two.
    drive = 0.7 * sheet.target_drive
    folds = measure_fold_angles(sheet.positions(drive))
    left, right, up, down = (
        folds.row[:, :-1], folds.row[:, 1:], folds.column[:-1], folds.column[1:],
    )  # fmt: skip
    np.testing.assert_allclose(np.abs(left), np.abs(right), atol=1e-12)
    np.testing.assert_allclose(np.abs(up), np.abs(down), atol=1e-12)
    sigma = np.sign(up * down)
    assert (sigma == -np.sign(left * right)).all()
    assert set(sigma.ravel()) == ({1.0, -1.0} if mixed else {-1.0})
    # Tangents of half the fold angles are in the ratio of eq. (35), in all states.
    ratio = multipliers(sectors[..., 2], sectors[..., 3], sigma)
    found = np.tan(0.5 * right) / np.tan(0.5 * down)
    np.testing.assert_allclose(np.abs(found), np.abs(ratio), rtol=1e-11)
    # Eq. (63): round every panel the multipliers have the product 1.
    size = np.abs(ratio)
    product = size[:-1, :-1] * size[1:, 1:] / (size[:-1, 1:] * size[1:, :-1])
    np.testing.assert_allclose(product, 1, rtol=1e-12)


def test_complex_steps_are_the_derivatives() -> None:
    net, step = random_net(5, 6, 6, mixed=True), 1e-6
    rng = np.random.default_rng(1)
    changes = {name: rng.normal(size=getattr(net, name).shape) for name in LISTS}
    changes["column_angles"][net.middle[0]] = changes["row_angles"][net.middle[1]]

    def places(by: complex) -> Array:
        moved = replace(net, **{k: getattr(net, k) + by * each for k, each in changes.items()})
        sheet = moved.march()
        return fold(sheet.flat(), HalfFolds.of(sheet.tangents(), 1.0, 1.0), net.middle)[..., 0]

    exact = places(1e-30j).imag / 1e-30
    differences = (places(step) - places(-step)).real / (2 * step)
    # Differences are right to step^2 times third derivatives.
    np.testing.assert_allclose(exact, differences, atol=1e-7 * np.abs(exact).max())
    np.testing.assert_allclose(places(1e-30j).real, places(0.0), rtol=0, atol=1e-13)


def test_many_sheets_at_once_are_those_of_each() -> None:
    nets = [random_net(5, 6, seed) for seed in range(3)]
    together = Net(**{k: np.concatenate([getattr(n, k) for n in nets], axis=-1) for k in LISTS})
    flat = together.march().flat()
    for number, net in enumerate(nets):
        np.testing.assert_allclose(flat[..., number], net.march().flat()[..., 0], atol=1e-14)


def test_a_net_of_one_number_each_is_a_miura_sheet() -> None:
    sheet = miura_net().march()
    angles = np.rad2deg(sheet.a[..., 0])
    np.testing.assert_allclose(np.minimum(angles, 180 - angles), 60, atol=1e-12)
    assert (np.sign(angles[1:] - 90) == np.sign(angles[:-1] - 90)).mean() in (0, 1)
    np.testing.assert_allclose(sheet.rows, 1, atol=1e-13)
    np.testing.assert_allclose(sheet.columns, 1, atol=1e-13)
    # tan(rho/2) of its row creases is 1/cos(60 degrees) that of its column creases.
    row, column = sheet.tangents()
    np.testing.assert_allclose(np.abs(row).min(), 2 * np.abs(column).max(), rtol=1e-13)


def test_bounds_hold_up_to_the_flat_stack() -> None:
    for mixed in (False, True):
        sheet = flat_foldable(random_net(7, 6, 8, mixed=mixed), **TURNED)
        for each in (sheet, sheet.least_turning):
            shares_of_bounds(each, 24, 60, end=each.end_drive)


@pytest.mark.parametrize(
    ("size", "digits"), [(30, 1e-12), (100, 3e-11), pytest.param(300, 3e-10, marks=thorough)]
)
def test_large_sheets_lose_digits_slowly(size: int, digits: float) -> None:
    # Seen: 1.2e-13, 2.9e-12, 5.7e-11: errors of angles grow with the rows, and so do their levers.
    sheet = flat_foldable(random_net(size, size, 9), **TURNED)
    drives = np.array([0.3, sheet.target_drive, 2.5, np.pi])
    assert changes_of_distances(sheet, drives) < digits


def test_a_state_is_made_in_15_times_its_own_memory() -> None:
    # Seen: 7 times, with 300 x 300 vertices; the march of the sheet takes 0.1 s, a state 0.05 s.
    begun = time.perf_counter()
    sheet = flat_foldable(random_net(298, 298, 9), **TURNED)
    sheet.positions(0.5)
    assert time.perf_counter() - begun < HANGS
    tracemalloc.start()
    try:
        state = sheet.positions(1.0)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert state.shape == (300, 300, 3)
    assert peak < 15 * state.nbytes


@pytest.mark.parametrize("mixed", [False, True])
def test_folded_sheets_move_in_one_way_only(mixed: bool) -> None:
    # Rates of fold angles about the axes of all four creases of every inner vertex sum to nothing.
    sheet = flat_foldable(random_net(6, 5, 11, mixed=mixed), **TURNED)
    rows, columns = 6, 5
    row_number = np.arange(rows * (columns + 1)).reshape(rows, columns + 1)
    column_number = row_number.size + np.arange((rows + 1) * columns).reshape(rows + 1, columns)
    step = 1e-5
    for drive in (0.3, sheet.target_drive, 2.5, 3.0):
        places = sheet.positions(drive)
        matrix = np.zeros((rows, columns, 3, row_number.size + column_number.size))
        for i, j in np.ndindex(rows, columns):
            here = places[i + 1, j + 1]
            for number, end in (
                (row_number[i, j], places[i + 1, j]),
                (row_number[i, j + 1], places[i + 1, j + 2]),
                (column_number[i, j], places[i, j + 1]),
                (column_number[i + 1, j], places[i + 2, j + 1]),
            ):
                matrix[i, j, :, number] = (end - here) / np.linalg.norm(end - here)
        _, sizes, ways = np.linalg.svd(matrix.reshape(-1, matrix.shape[-1]))
        assert sizes[-1] < 1e-13
        assert sizes[-2] > 1e-3  # Seen: 2e-3 at 0.3, 2e-2 at the target.
        # That way is the mechanism's own.
        before, after = (sheet.fold_angles(drive + by) for by in (-step, step))
        own = np.concatenate(
            [(after.row - before.row).ravel(), (after.column - before.column).ravel()]
        )
        assert abs(ways[-1] @ own) == pytest.approx(np.linalg.norm(own), rel=1e-8)
