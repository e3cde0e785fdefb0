"""Fold angles measured on hand-made sheets: the sign convention."""

import numpy as np
import pytest

from orishell.motion import measure_fold_angles, panel_normals


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
