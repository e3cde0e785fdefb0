"""Frames fixed in panels, and the quaternions of their rotations."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from orishell.io.solids import find_frames, quaternions
from orishell.motion.quads import longer_diagonals


def test_quaternions_agree_with_scipy() -> None:
    """Random rotations, and half turns about axes, where one entry after the other is zero."""
    halves = Rotation.from_rotvec(
        np.pi * np.array([[1.0, 0, 0], [0, 1, 0], [0, 0, 1], [0.6, 0.8, 0]])
    )
    rotations = Rotation.concatenate([Rotation.random(200, random_state=1), halves])
    found = quaternions(rotations.as_matrix())
    np.testing.assert_allclose(np.linalg.norm(found, axis=1), 1.0, atol=1e-15)
    agreement = np.abs((found * rotations.as_quat()).sum(axis=1))
    np.testing.assert_allclose(agreement, 1.0, atol=1e-14)


def test_frames_move_with_their_panels() -> None:
    rotation, shift = Rotation.from_rotvec([0.3, -1.1, 0.7]), np.array([3.0, -2.0, 5.0])
    corners = np.array([[[0.0, 0, 0], [2, 0, 0], [3, 1, 0], [0, 2, 0]]])
    moved = rotation.apply(corners[0])[None] + shift
    along = longer_diagonals(corners)
    assert along.tolist() == [0]  # (3, 1) against (-2, 2)
    origin, axes = find_frames(corners, along)
    moved_origin, moved_axes = find_frames(moved, along)
    np.testing.assert_allclose(axes[0][:, 2], [0, 0, 1])
    np.testing.assert_allclose(moved_axes[0], rotation.as_matrix() @ axes[0], atol=1e-15)
    np.testing.assert_allclose(moved_origin, rotation.apply(origin) + shift, atol=1e-15)


@pytest.mark.parametrize(
    "corners",
    [
        [[0, 0, 0], [1, 1, 2], [2, 2, 4], [3, 3, 6]],
        [[0, 0, 0], [0, 1, 0], [0, 3, 0], [0, 2, 0]],
        [[1, 1, 1]] * 4,
    ],
    ids=["on a line", "on an axis", "in a point"],
)
def test_panels_without_area_have_a_frame_too(corners: list[list[float]]) -> None:
    panel = np.array([corners], dtype=np.float64)
    origin, axes = find_frames(panel, longer_diagonals(panel))
    np.testing.assert_allclose(axes[0].T @ axes[0], np.eye(3), atol=1e-15)
    assert np.linalg.det(axes[0]) == pytest.approx(1.0)
    turned = Rotation.from_quat(quaternions(axes)[0])
    local = (panel - origin[:, None]) @ axes
    np.testing.assert_allclose(turned.apply(local[0]) + origin, panel[0], atol=1e-14)
