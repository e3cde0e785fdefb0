"""The paper's Figure 1: f = -x**2 on [-1, 1], g = 5 sin(pi x/10) on [0, 20], 9 x 11.

The paper's text gives the curves and the numbers of vertices; xi and the flaps are ours.
"""

from dataclasses import astuple
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell import Shell, design_shell
from orishell.families.parallel_repeating import ParallelRepeating

EXAMPLE = Path(__file__).parents[2] / "examples" / "figure1.toml"


@pytest.fixture(scope="module")
def shell() -> Shell:
    return design_shell(EXAMPLE)


def test_residuals(shell: Shell) -> None:
    assert shell.report.residuals is not None
    assert all(value <= 1e-12 for value in astuple(shell.report.residuals))
    assert shell.report.assignment.constant
    assert shell.report.assignment.maekawa
    assert shell.report.assignment.unfolded == 10  # the inflection's column


def test_middle_row_lies_on_g(shell: Shell) -> None:
    row = shell.motion.target.positions[5, 1:-1]
    np.testing.assert_allclose(row[:, 1], 5 * np.sin(np.pi * row[:, 0] / 10), atol=1e-12)
    np.testing.assert_array_equal(row[[0, -1], 0], [0, 20])
    assert not row[:, 2].any()


def test_column_1_keeps_the_ends_of_f(shell: Shell) -> None:
    column = shell.motion.target.positions[:, 1]
    # f's ends are 2 apart and equally high; column 1 is perpendicular to g's start.
    chord = column[-1] - column[0]
    slope = np.pi / 2  # g'(0)
    across = np.array([slope, -1.0, 0.0]) / np.hypot(slope, 1)
    np.testing.assert_allclose(chord, 2 * across, atol=1e-12)
    mechanism = shell.design.mechanism
    assert isinstance(mechanism, ParallelRepeating)
    assert np.rad2deg(mechanism.xi) == pytest.approx(50)


def test_flaps_lock(shell: Shell) -> None:
    angles = np.array(shell.motion.target.fold_angles.row)
    np.testing.assert_allclose(np.abs(angles[:, [0, -1]]), np.pi, atol=1e-12)
    assert (np.abs(angles[:, 1:-1]) < np.pi - 0.5).all()
    assert (shell.report.lock.drive, shell.report.lock.cause) == (np.pi, "flaps")


def test_report_has_the_fields_of_the_contract(shell: Shell) -> None:
    report: Any = shell.report.as_dict()
    assert (report["family"], report["unit"]) == ("parallel-repeating", "m")
    assert (report["rows"], report["columns"], report["feasible"]) == (9, 11, True)
    assert set(report["residuals"]) == {
        "panel_length",
        "planarity",
        "sector_sum_rad",
        "fold_angle_rad",
    }
    parts = {"f", "g", "crests", "valleys", "surface", "tilted", "approached"}
    assert set(report["deviation"]) == parts
    sizes = {"max", "rms", "mean", "p95", "sample_spacing"}
    surface = report["deviation"]["surface"]
    assert set(surface) == sizes | {"shell_to_surface", "surface_to_shell"}
    for way in ("shell_to_surface", "surface_to_shell"):
        assert set(surface[way]) == sizes | {"grid_spacing"}
        assert surface[way]["max"] <= surface["max"]
    assert surface["max"] == pytest.approx(0.226, abs=1e-3)
    assert surface["sample_spacing"] < 1e-3
    assert report["deviation"]["approached"] is None
    assert report["deviation"]["f"]["max"] == pytest.approx(0.133464, abs=1e-6)
    assert set(report["sheet"]) == {"width", "height", "area", "strips"}
    assert set(report["deployed"]) == {"width", "depth", "height"}
    assert report["deployed"]["height"] == pytest.approx(1 + 0.133464, abs=1e-6)


def test_sheet_area_is_the_same_in_every_state(shell: Shell) -> None:
    from orishell.motion import sheet_area

    areas = [sheet_area(state.positions) for state in shell.motion]
    np.testing.assert_allclose(areas, shell.report.sheet.area, rtol=1e-13)
