"""T-hedra with vertices on any profile: rigid, of one freedom, over their whole range.

The motion is derived in ``orishell.families.shared.t_hedron``; here nothing of that is used but the
positions: distances of corners, planes of panels, the rank of what joins rigid bodies, and states
that Newton's method finds from distances alone.
"""

from __future__ import annotations

import tracemalloc
from collections.abc import Iterator
from itertools import combinations

import numpy as np
import pytest

from orishell.families.t_hedral import THedral
from orishell.motion import measure_fold_angles
from orishell.motion.freedom import find_freedom_of_sheet
from orishell.motion.grid import Grid
from orishell.motion.quads import grid_corners
from orishell.numerics.arrays import Array
from rigid import distance_after_motion
from rigid_rank import freedoms_of_panels
from samples import thorough
from t_hedra import random_sheet

PAIRS = tuple(combinations(range(4), 2))


def drives_of(sheet: THedral, count: int) -> Array:
    return np.linspace(0, sheet.end_drive, count)


def distances(points: Array) -> Array:
    """Six distances (..., 6) of the corners of every panel of grids (..., R, C, 3)."""
    corners = grid_corners(points)
    return np.stack(
        [np.linalg.norm(corners[..., a, :] - corners[..., b, :], axis=-1) for a, b in PAIRS], -1
    )


def test_200_sheets_are_rigid_and_plane_in_40_states_of_their_whole_range() -> None:
    for seed in range(200):
        sheet = random_sheet(seed, flaps=seed % 2 == 1)
        states = sheet.positions(drives_of(sheet, 40))
        size = np.ptp(states.reshape(-1, 3), axis=0).max()
        found = distances(states)
        assert np.abs(found - found[:1]).max() < 1e-12 * size
        centred = grid_corners(states)
        centred = centred - centred.mean(axis=-2, keepdims=True)
        assert np.linalg.svd(centred, compute_uv=False)[..., 2].max() < 1e-12 * size


def test_creases_fold_as_the_closed_form_says() -> None:
    for seed in range(40):
        sheet = random_sheet(seed, flaps=seed % 2 == 1)
        inside = drives_of(sheet, 20)[1:-1]
        states, closed = sheet.positions(inside), sheet.fold_angles(inside)
        for found, said in zip(
            *((each.row, each.column) for each in (measure_fold_angles(states), closed)),
            strict=True,
        ):
            assert np.abs(np.angle(np.exp(1j * (found - said)))).max(initial=0) < 1e-11


def test_they_have_one_freedom() -> None:
    """By the rank of rigid bodies along hinges, and by what the program says."""
    for seed in range(40):
        sheet = random_sheet(seed, rows=4, columns=6)
        assert freedoms_of_panels(sheet, 0.5 * sheet.end_drive) == 1
        assert find_freedom_of_sheet(sheet).count == 1


def pulled_back(points: Array, wanted: Array, held: float) -> Array:
    """The state nearby with given distances, by Newton's method, and one distance across it.

    Of a plane quadrilateral six distances are five conditions to first order: that it is plane is
    asked by the volume of its corners.
    """
    rows, columns, _ = points.shape
    number = np.arange(rows * columns).reshape(rows, columns)
    faces = Grid(rows, columns).faces_vertices()
    pairs = np.concatenate([faces[:, pair] for pair in PAIRS])
    ends = np.append(pairs, [[number[0, 0], number[0, -1]]], axis=0)
    lengths = np.append(wanted.reshape(-1, len(PAIRS)).T.ravel(), held)
    x, row, panel = points.reshape(-1, 3).copy(), np.arange(len(ends)), np.arange(len(faces))
    for _ in range(12):
        way = x[ends[:, 0]] - x[ends[:, 1]]
        away = np.linalg.norm(way, axis=1)
        of_lengths = np.zeros((len(ends), *x.shape))
        of_lengths[row, ends[:, 0]] += way / away[:, None]
        of_lengths[row, ends[:, 1]] -= way / away[:, None]
        sides = x[faces[:, 1:]] - x[faces[:, :1]]
        across = [np.cross(sides[:, k - 2], sides[:, k - 1]) for k in range(3)]
        of_volumes = np.zeros((len(faces), *x.shape))
        for k in range(3):
            of_volumes[panel, faces[:, k + 1]] += across[k]
            of_volumes[panel, faces[:, 0]] -= across[k]
        off = np.append(away - lengths, (sides[:, 0] * across[0]).sum(axis=1))
        matrix = np.concatenate([of_lengths, of_volumes]).reshape(len(off), -1)
        x -= np.linalg.lstsq(matrix, off, rcond=1e-9)[0].reshape(x.shape)
    return x


def corrugated() -> Iterator[THedral]:
    """Sheets with neighbouring columns that turn, so that rows of them come nearer steadily."""
    for seed in range(12):
        yield random_sheet(seed, rows=4, columns=5)


def test_distances_alone_lead_back_to_the_same_states() -> None:
    random = np.random.default_rng(3)
    for sheet in corrugated():
        for share in (0.3, 0.5, 0.7):
            state = sheet.positions(share * sheet.end_drive)
            held = float(np.linalg.norm(state[0, 0] - state[0, -1]))
            start = state + 1e-4 * random.standard_normal(state.shape)
            found = pulled_back(start, distances(state), held)
            assert distance_after_motion(found, state.reshape(-1, 3)) < 1e-9


def test_a_state_takes_little_more_than_its_array() -> None:
    """Of 10^5 panels: at most three times as much."""
    count = 317
    x = np.linspace(-1, 1, count + 1)
    rise, run = np.diff(-0.5 * x**2 + 1e-3 * x), np.diff(x)
    zigzag = np.arange(count) * 0.02 + 0.01j * (-1) ** np.arange(count)
    sheet = THedral(
        lengths=np.hypot(rise, run),
        slopes=rise / run,
        points=zigzag,
        axes=np.full(count, -1j),
        flaps=(0.0, 0.0),
    )
    drive = 0.5 * sheet.end_drive
    size = sheet.positions(drive).nbytes
    tracemalloc.start()
    try:
        sheet.positions(drive)
        most = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert most < 3 * size


@thorough
@pytest.mark.parametrize("seed", range(200, 400))
def test_more_sheets_have_one_freedom(seed: int) -> None:
    sheet = random_sheet(seed, rows=4, columns=6)
    assert freedoms_of_panels(sheet, 0.5 * sheet.end_drive) == 1
