"""Residuals see what is wrong: each is shown a sheet that is wrong in one way."""

from dataclasses import fields, replace
from typing import Any

import numpy as np
import pytest

from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.motion import FoldedState, Mechanism, diagonal, extents, sheet_area
from orishell.motion.grid import CreaseValues
from orishell.verification import residuals
from orishell.verification.residuals import AssignmentCheck, Residuals, measure_residuals
from strategies import graph


@pytest.fixture
def mechanism() -> Mechanism:
    return design_parallel_repeating(
        graph("-x**2", -1, 1),
        graph("x**2/30", 0, 10),
        ParallelRepeatingPattern(rows=3, columns=4, xi_deg=np.rad2deg(0.8), flap=0.3),
    ).mechanism


def measure(mechanism: Mechanism, **change: Any) -> tuple[Residuals, AssignmentCheck]:
    good = FoldedState.of(mechanism, 1.0)
    bad = replace(good, **change) if change else good
    return measure_residuals([good, bad], FoldedState.of(mechanism, 0.0))


def test_a_good_state(mechanism: Mechanism) -> None:
    residuals, assignment = measure(mechanism)
    assert max(residuals.panel_length, residuals.planarity) < 1e-14
    assert max(residuals.sector_sum_rad, residuals.fold_angle_rad) < 1e-13
    assert assignment == AssignmentCheck(constant=True, maekawa=True)


def test_a_moved_vertex_is_seen(mechanism: Mechanism) -> None:
    positions = mechanism.positions(1.0)
    positions[2, 2] += [0.0, 0.0, 1e-6]
    residuals, _ = measure(mechanism, positions=positions)
    assert residuals.panel_length > 1e-9
    assert residuals.planarity > 1e-9
    assert residuals.sector_sum_rad > 1e-9
    assert residuals.fold_angle_rad > 1e-9


def test_a_stretched_sheet_is_seen(mechanism: Mechanism) -> None:
    stretched = 1.001 * mechanism.positions(1.0)
    residuals, _ = measure(mechanism, positions=stretched)
    assert residuals.panel_length > 1e-4


def test_wrong_angles_and_signs_are_seen(mechanism: Mechanism) -> None:
    angles = mechanism.fold_angles(1.0)
    wrong = CreaseValues(angles.row + 1e-3, angles.column)
    assert measure(mechanism, fold_angles=wrong)[0].fold_angle_rad == pytest.approx(1e-3)
    flipped = CreaseValues(-angles.row, angles.column)
    assert not measure(mechanism, fold_angles=flipped)[1].constant
    uneven = CreaseValues(np.abs(angles.row), np.abs(angles.column))
    assert not measure(mechanism, fold_angles=uneven)[1].maekawa


def test_sizes(mechanism: Mechanism) -> None:
    i, j = np.meshgrid(np.arange(3), np.arange(5), indexing="ij")
    sheet = np.stack([2.0 * j, -1.0 * i, 0.0 * i], axis=-1)
    assert sheet_area(sheet) == pytest.approx(16)
    assert extents(sheet) == (8.0, 2.0, 0.0)
    assert diagonal(sheet) == pytest.approx(np.hypot(8, 2))


@pytest.mark.parametrize("block", [1, 6, 12, 18, 24])
def test_rows_looked_at_apart_show_what_they_show_together(
    mechanism: Mechanism, monkeypatch: pytest.MonkeyPatch, block: int
) -> None:
    grid = mechanism.grid
    for row in range(grid.rows):
        positions = mechanism.positions(1.0)
        positions[row, 2] += [1e-3, 0.0, 1e-6]
        monkeypatch.undo()
        whole = measure(mechanism, positions=positions)
        monkeypatch.setattr(residuals, "BLOCK", block)
        assert measure(mechanism, positions=positions) == whole
    assert min(getattr(whole[0], each.name) for each in fields(Residuals)) > 1e-9
