"""Whole boards on hinges close all their loops while they fold: by a tree of rigid bodies."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from board_tree import Tree
from flat_foldables import random_sheet
from orishell.design import PanelSpec
from orishell.motion import Mechanism, diagonal, drive_at_fold
from orishell.motion.grid import CreaseValues
from orishell.motion.hinges import Hinges
from orishell.motion.mechanism import panel_normals
from orishell.solids.hinged import find_hinges
from samples import thorough

DESIGNS = 200
QUICK = 12
LAST = np.deg2rad(179.9)
CLOSED = 1e-12
"""Of the diagonal, as asked; 2e-13 is the most that was seen, near 180 degrees."""

ZERO = 1e-13
"""Relative singular values below it are zero; 1e-7 is the least of the others that was seen."""


def hinged(seed: int) -> tuple[Mechanism, Hinges, float]:
    sheet = random_sheet(seed)
    size = diagonal(sheet.positions(0.0))
    build = PanelSpec(thickness=2e-3 * size, construction="hinged")
    return sheet, find_hinges(sheet, build), size


@pytest.mark.parametrize(
    "seeds",
    [
        range(QUICK),
        *(pytest.param(range(k, k + QUICK), marks=thorough) for k in range(QUICK, DESIGNS, QUICK)),
    ],
    ids=lambda seeds: f"{seeds[0]}-",
)
def test_all_loops_stay_closed_with_one_degree_of_freedom(seeds: range) -> None:
    for seed in seeds:
        sheet, hinges, size = hinged(seed)
        tree = Tree(sheet, hinges)
        for drive in np.linspace(0.0, drive_at_fold(sheet, LAST), 7):
            assert tree.open(float(drive)) <= CLOSED * size, seed
            assert hinges.gap(sheet.positions(drive)) <= CLOSED * size, seed
        second, first = tree.freedoms(0.6 * sheet.target_drive)
        assert first < ZERO < 1e4 * ZERO < second, seed


@pytest.mark.parametrize("seed", range(4))
def test_boards_are_shifted_as_the_tree_has_them(seed: int) -> None:
    sheet, hinges, size = hinged(seed)
    drive = 0.7 * sheet.end_drive
    turn, shift = Tree(sheet, hinges).placed(drive)
    positions = sheet.positions(drive)
    shifts = hinges.shifts(panel_normals(positions).reshape(-1, 3)).reshape(shift.shape)
    carried = np.einsum("rcij,rcj->rci", turn, sheet.positions(0.0)[:-1, :-1]) + shift
    # Both are the same but for a motion of all: compared in the first board's frame.
    corners = positions[:-1, :-1] + shifts
    apart = np.linalg.norm(carried[:, :, None, None] - carried, axis=-1)
    assert np.abs(apart - np.linalg.norm(corners[:, :, None, None] - corners, axis=-1)).max() <= (
        1e-12 * size
    )


@pytest.mark.parametrize("seed", range(4))
def test_a_hinge_off_by_a_millimetre_opens_the_loops_beside_it(seed: int) -> None:
    sheet, hinges, size = hinged(seed)
    off = 1e-4 * size
    heights = hinges.heights
    moved = heights.row.copy()
    moved[len(moved) // 2, moved.shape[1] // 2] += off
    wrong = replace(hinges, heights=CreaseValues(moved, heights.column))
    assert wrong.gap(sheet.positions(0.9 * sheet.target_drive)) > 0.1 * off
    assert Tree(sheet, wrong).open(0.9 * sheet.target_drive) > 0.1 * off
