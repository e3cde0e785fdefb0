"""Fold angles measured on hand-made sheets: the sign convention."""

import numpy as np
import pytest

from orishell.motion import corrugation_depth, measure_fold_angles, panel_normals


def strip(angle: float, *, along_rows: bool) -> np.ndarray:
    """Two unit panels side by side, the second turned up about their common edge."""
    x = np.array([-1.0, 0.0, np.cos(angle)])
    z = np.array([0.0, 0.0, np.sin(angle)])
    positions = np.zeros((2, 3, 3))
    positions[..., 0], positions[..., 2] = x, z
    positions[1, :, 1] = -1.0
    if along_rows:
        # The same, the second panel below the first: rows downwards.
        turned = np.zeros((3, 2, 3))
        turned[..., 1], turned[..., 2] = -x[:, None], z[:, None]
        turned[:, 1, 0] = 1.0
        return turned
    return positions


@pytest.mark.parametrize("angle", [-2.0, -0.3, 0.0, 0.7, 3.1])
def test_valley_is_positive(angle: float) -> None:
    # Turned up towards +z, seen from +z: a valley (geometry.md section 1).
    assert measure_fold_angles(strip(angle, along_rows=False)).column[0, 0] == pytest.approx(angle)
    assert measure_fold_angles(strip(angle, along_rows=True)).row[0, 0] == pytest.approx(angle)


def test_normals_of_the_flat_sheet_point_up() -> None:
    np.testing.assert_array_equal(
        panel_normals(strip(0.0, along_rows=False)), [[[0, 0, 1], [0, 0, 1]]]
    )


@pytest.mark.parametrize("half", [0.3, 1e-3, 1e-9, 0.0])
def test_a_zigzag_is_as_deep_as_its_edges_reach_from_its_ends(half: float) -> None:
    # Edges of length 1, each at an angle of half the zigzag's with the normal; 0: folded flat.
    down = np.arange(3) * np.sin(half)
    depth = np.array([0.0, 1.0, 0.0]) * np.cos(half)
    column = np.stack([0 * down, down, depth], axis=-1)
    positions = np.stack([column, column + np.array([1.0, 0.0, 0.0])], axis=1)
    assert corrugation_depth(positions) == pytest.approx(np.cos(half), rel=1e-9)
