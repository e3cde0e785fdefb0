"""The paper's Figure 3: (85, 80, 95, 100) degrees, equal lengths down column 1.

The paper gives the sector angles, to two decimals those of column 2, that column 1's lengths are
equal, and that the circular section's radius grows from r to 1.67 r. Sizes are ours.
"""

import json
import runpy
from dataclasses import astuple
from pathlib import Path

import numpy as np
import pytest

from orishell import Shell, design_shell, write_shell
from orishell.design_file import starter_file

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def shell() -> Shell:
    return design_shell(EXAMPLES / "figure3.toml")


def test_sector_angles(shell: Shell) -> None:
    second = np.asarray(shell.report.parameters["second_sector_deg"], float)
    assert np.round(second, 2).tolist() == [91.23, 86.23, 106.23, 76.23]


def test_residuals(shell: Shell) -> None:
    assert shell.report.residuals is not None
    assert all(value <= 1e-12 for value in astuple(shell.report.residuals))
    assert shell.report.assignment.constant
    assert shell.report.assignment.maekawa


def test_equal_lengths_down_column_1(shell: Shell) -> None:
    column = shell.motion.flat.positions[:, 1]
    lengths = np.linalg.norm(np.diff(column, axis=0), axis=-1)
    np.testing.assert_allclose(lengths, lengths[0], rtol=1e-12)


def test_radius_grows_to_1_67_r(shell: Shell) -> None:
    first, last = np.asarray(shell.report.parameters["radius"], float)
    assert first / last == pytest.approx(1.67, abs=0.005)
    # Circular: column 1 on f, and every column near its circle seen along the line.
    assert shell.design.closeness["f"].max < 0.007
    radii = []
    for column in np.moveaxis(shell.motion.target.positions[:, 1:-1, 1:], 1, 0):
        system = np.concatenate([column, np.ones((len(column), 1))], axis=1)
        solved = np.linalg.lstsq(system, (column**2).sum(axis=1), rcond=None)[0]
        radius = np.sqrt(solved[2] + (solved[:2] ** 2).sum() / 4)
        distances = np.linalg.norm(column - solved[:2] / 2, axis=1)
        assert np.abs(distances - radius).max() < 0.05 * radius
        radii.append(float(radius))
    assert (np.diff(radii) < 0).all()


def test_lock(shell: Shell) -> None:
    # Column 1's motion could go to 119.747 degrees; beyond the target the rims meet long before.
    assert shell.report.lock.cause == "clash"
    assert shell.report.feasible
    assert shell.report.parameters["motion_end_deg"] == pytest.approx(119.747, abs=1e-3)
    assert np.rad2deg(shell.motion.target.drive) == pytest.approx(
        shell.report.parameters["stage_deg"]
    )


def test_s_rows_are_planar(shell: Shell) -> None:
    # The paper says that each row is; F rows are not (geometry.md section 5).
    assert shell.report.parameters["planar"] == ["S rows"]


def test_files(shell: Shell, tmp_path: Path) -> None:
    write_shell(shell, tmp_path / "out")
    fold = json.loads((tmp_path / "out" / "shell.fold").read_text())
    assert fold["orishell:grid_shape"] == [9, 11]
    assert len(fold["file_frames"]) == 25


def test_starter_file_is_the_same_shell(shell: Shell, tmp_path: Path) -> None:
    path = tmp_path / "shell.toml"
    path.write_text(starter_file("longitudinal-linear-repeating"))
    other = design_shell(path)
    assert other.report.parameters["c"] == shell.report.parameters["c"]
    assert other.design.closeness["f"].max < 0.01


def test_example(capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(EXAMPLES / "figure3.py"), run_name="__main__")
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "cosine version: (91.23, 86.23, 106.23, 76.23), c = 0.169948"
    assert lines[3] == "f is met to 0.0068, the radius grows to 1.67 r"
    assert lines[4].startswith("panels keep their lengths to ")
