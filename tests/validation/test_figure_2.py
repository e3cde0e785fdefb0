"""The paper's Figure 2: f = -x**2 on [-1, 1], g = 0.25 sin(pi x/2) on [0, 4], 9 x 13.

The paper's text gives the curves and the numbers of vertices; depth, heading and flaps are ours.
"""

from dataclasses import astuple
from pathlib import Path

import numpy as np
import pytest

from orishell import Shell, design_shell
from orishell.families.orthodiagonal import Orthodiagonal

EXAMPLE = Path(__file__).parents[2] / "examples" / "figure2.toml"


@pytest.fixture(scope="module")
def shell() -> Shell:
    return design_shell(EXAMPLE)


def mechanism(shell: Shell) -> Orthodiagonal:
    assert isinstance(shell.design.mechanism, Orthodiagonal)
    return shell.design.mechanism


def test_residuals(shell: Shell) -> None:
    assert shell.report.residuals is not None
    assert all(value <= 1e-12 for value in astuple(shell.report.residuals))
    assert shell.report.assignment.constant
    assert shell.report.assignment.maekawa
    assert shell.report.assignment.unfolded == 10  # g's inflection at x = 2 is column 7


def test_middle_row_lies_on_g(shell: Shell) -> None:
    row = shell.motion.target.positions[5, 1:-1]
    np.testing.assert_allclose(row[:, 1], 0.25 * np.sin(np.pi * row[:, 0] / 2), atol=1e-12)
    np.testing.assert_array_equal(row[[0, -1], 0], [0, 4])
    assert not row[:, 2].any()


def test_column_1_is_the_zigzag_of_f(shell: Shell) -> None:
    column = shell.motion.target.positions[:, 1]
    np.testing.assert_allclose(column[:, 0], 0.0, atol=1e-12)  # heading 90: f's plane is x = 0
    # In f's axes: x to the right of g, which is -y; its ends are f's, the others 0.12 away.
    x = -(column[:, 1] - 0.5 * (column[0, 1] + column[-1, 1]))
    y = column[:, 2] - column[0, 2] - 1
    np.testing.assert_allclose(x[[0, -1]], [-1, 1], atol=1e-12)
    np.testing.assert_allclose(y[[0, -1]], -1, atol=1e-12)
    s = np.linspace(-1.2, 1.2, 200001)
    distance = [np.hypot(a - s, b + s**2).min() for a, b in zip(x[1:-1], y[1:-1], strict=True)]
    np.testing.assert_allclose(distance, 0.12, atol=1e-8)
    side = np.sign(y + x**2)[1:-1]
    assert (side[1:] == -side[:-1]).all()


def test_shell_stands_on_level_ground(shell: Shell) -> None:
    locked = shell.motion.target.positions
    assert shell.report.parameters["ends"] == ["level", "level"]
    np.testing.assert_allclose(locked[[0, -1], :, 2], locked[0, 0, 2], atol=1e-12)
    assert locked[1:-1, :, 2].min() > locked[0, 0, 2] + 0.1


def test_flaps_lock(shell: Shell) -> None:
    angles = np.array(shell.motion.target.fold_angles.row)
    np.testing.assert_allclose(np.abs(angles[:, [0, -1]]), np.pi, atol=1e-12)
    assert (np.abs(angles[:, 1:-1]) < np.pi - 0.5).all()
    assert (shell.report.lock.drive, shell.report.lock.cause) == (np.pi, "flaps")


def test_admissible_alpha_0_is_narrower_than_the_papers(shell: Shell) -> None:
    interval, angle, zigzag = (
        np.asarray(shell.report.parameters[name], float)
        for name in ("alpha_0_interval_deg", "alpha_0_deg", "zigzag_deg")
    )
    (low, high), middle = interval, zigzag[4]
    assert 90 < low < angle < high < (180 + middle) / 2
    assert (mechanism(shell).column_lengths() > 0).all()


def test_all_columns_lock_at_the_angles_of_column_1(shell: Shell) -> None:
    edges = np.diff(shell.motion.target.positions, axis=0)
    edges /= np.linalg.norm(edges, axis=-1, keepdims=True)
    cos = -(edges[1:] * edges[:-1]).sum(axis=-1)
    expected = np.deg2rad(shell.report.parameters["zigzag_deg"])
    np.testing.assert_allclose(
        np.arccos(cos), np.broadcast_to(expected[:, None], cos.shape), atol=1e-10
    )
