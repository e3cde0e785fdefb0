"""Play of hinges that are screwed on beside their places, against random errors of them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from flat_foldables import random_sheet
from orishell.design import PanelSpec
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.mechanism import Mechanism, panel_normals
from orishell.numerics.arrays import Array
from orishell.solids.hinged import find_hinges
from orishell.solids.hinged.play import Play, find_play
from samples import led_by

TRIES = 2500
NEAR = 0.05
"""Of a root mean square of so many tries; MOSTSEEN is the most that was seen."""


def across(sheet: Mechanism, drive: float, rng: np.random.Generator) -> tuple[Array, Array]:
    """Wrong steps of shifts (TRIES, H, 3) by unit errors: first of heights, then any way across."""
    positions = sheet.positions(drive)
    normals = panel_normals(positions)
    pairs = [(normals[:-1], normals[1:]), (normals[:, :-1], normals[:, 1:])]
    runs = [np.diff(positions[1:-1], axis=1), np.diff(positions[:, 1:-1], axis=0)]
    first, second = (np.concatenate([each[k].reshape(-1, 3) for each in pairs]) for k in (0, 1))
    along = np.concatenate([each.reshape(-1, 3) for each in runs])
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    up = first - second
    flat = np.cross(along, first) - np.cross(along, second)
    of_heights = rng.standard_normal((TRIES, len(up), 1)) * up
    way = rng.uniform(0, 2 * np.pi, (TRIES, len(up), 1))
    size = rng.standard_normal((TRIES, len(up), 1))
    return of_heights, size * (np.cos(way) * up + np.sin(way) * flat)


def measured(steps: Array, grid: Grid) -> Play:
    """The play of wrong steps (TRIES, H, 3) of a grid, by least squares."""
    panel = np.arange(grid.panel_count).reshape(grid.rows - 1, grid.columns - 1)
    row = (grid.rows - 2) * (grid.columns - 1)
    beside = np.concatenate(
        [
            np.stack([panel[:-1], panel[1:]], axis=-1).reshape(-1, 2),
            np.stack([panel[:, :-1], panel[:, 1:]], axis=-1).reshape(-1, 2),
        ]
    )
    differences = np.zeros((len(beside), grid.panel_count))
    differences[np.arange(len(beside)), beside[:, 0]] = -1.0
    differences[np.arange(len(beside)), beside[:, 1]] = 1.0
    inverse = np.linalg.pinv(differences)
    shifts = np.einsum("ph,thx->tpx", inverse, steps)
    left = steps - np.einsum("hp,tpx->thx", differences, shifts)
    down = steps[:, :row].reshape(len(steps), grid.rows - 2, -1, 3)
    right = steps[:, row:].reshape(len(steps), grid.rows - 1, -1, 3)
    loops = right[:, :-1] + down[:, :, 1:] - down[:, :, :-1] - right[:, 1:]
    mean = [np.sqrt((each**2).sum(axis=-1).mean(axis=0)) for each in (loops, left, shifts)]
    rms = [float(np.sqrt((each**2).mean())) for each in mean[1:]]
    return Play(float(mean[0].max()), *rms)


@pytest.mark.parametrize("seed", led_by([0, 3, 1, 2], 2))
def test_play_is_that_of_random_errors(seed: int) -> None:
    """Errors in heights, and errors any way across a hinge, leave as much open."""
    sheet, rng = random_sheet(seed), np.random.default_rng(seed)
    for drive in (sheet.target_drive, 0.97 * sheet.end_drive):
        found = find_play(sheet.positions(drive))
        for steps in across(sheet, drive, rng):
            play = measured(steps, sheet.grid)
            assert found.loop == pytest.approx(play.loop, rel=NEAR)
            assert found.hinge == pytest.approx(play.hinge, rel=NEAR)
            assert found.board == pytest.approx(play.board, rel=NEAR)


def test_wrong_heights_open_loops_by_as_much() -> None:
    """The mean of the loops that :class:`Hinges` leaves open, at the vertex where it is largest."""
    sheet = random_sheet(2)
    hinges = find_hinges(sheet, PanelSpec(thickness=0.01, construction="hinged"))
    positions, rng, d = sheet.positions(sheet.target_drive), np.random.default_rng(5), 1e-3
    normals, found = panel_normals(positions), []
    for _ in range(2000):
        row, column = (
            each + d * rng.standard_normal(each.shape)
            for each in (hinges.heights.row, hinges.heights.column)
        )
        wrong = replace(hinges, heights=CreaseValues(row, column))
        down, right = wrong._steps(normals)
        around = right[:-1] + down[:, 1:] - down[:, :-1] - right[1:]
        found.append((around**2).sum(axis=-1))
    largest = float(np.sqrt(np.mean(found, axis=0).max()))
    assert largest == pytest.approx(d * find_play(positions).loop, rel=NEAR)


def test_nothing_is_open_in_the_flat_sheet_and_four_errors_in_the_pack() -> None:
    sheet = random_sheet(1)
    flat, pack = (find_play(sheet.positions(drive)) for drive in (0.0, sheet.end_drive))
    assert (flat.loop, flat.hinge, flat.board) == (0.0, 0.0, 0.0)
    # Twice the error at each of four hinges that fold by 180 degrees.
    assert pack.loop == pytest.approx(4.0, abs=1e-6)


def test_pieces_are_sheets_of_their_own() -> None:
    sheet = random_sheet(1)
    positions = sheet.positions(sheet.target_drive)
    rows = len(positions) - 1
    middle = rows // 2
    both = find_play(positions, [slice(0, middle), slice(middle, rows)])
    upper, lower = find_play(positions[: middle + 1]), find_play(positions[middle:])
    assert both.loop == max(upper.loop, lower.loop)
    share = middle / rows
    mean = share * upper.board**2 + (1 - share) * lower.board**2
    assert both.board == pytest.approx(np.sqrt(mean), rel=1e-12)
    # A row of boards has no loop, and needs no play.
    single = find_play(positions[:2])
    assert (single.loop, single.hinge) == (0.0, 0.0)
    assert single.board > 0
