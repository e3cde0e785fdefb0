"""Panels by their corners: values known from elementary geometry."""

import numpy as np
import pytest

from orishell.motion.quads import (
    area_vectors,
    corner_distances,
    diagonal_gaps,
    reflex_corners,
    sector_angles,
    unit_normals,
)

RECTANGLE = np.array([[0, 0, 0], [3, 0, 0], [3, 4, 0], [0, 4, 0]], dtype=np.float64)
DART = np.array([[0, 0, 0], [2, 1, 0], [0, 2, 0], [1, 1, 0]], dtype=np.float64)
"""A chevron: the last corner points inwards."""


def test_rectangle() -> None:
    assert sorted(corner_distances(RECTANGLE)) == [3, 3, 4, 4, 5, 5]
    np.testing.assert_array_equal(area_vectors(RECTANGLE), [0, 0, 12])
    np.testing.assert_array_equal(unit_normals(RECTANGLE), [0, 0, 1])
    np.testing.assert_allclose(sector_angles(RECTANGLE), np.pi / 2)
    assert diagonal_gaps(RECTANGLE) == 0
    assert not reflex_corners(RECTANGLE).any()


def test_stacks_of_panels_are_measured_one_by_one() -> None:
    both = np.stack([RECTANGLE, DART])
    assert corner_distances(both).shape == (2, 6)
    np.testing.assert_array_equal(area_vectors(both)[:, 2], [12, 1])
    np.testing.assert_array_equal(np.argwhere(reflex_corners(both)), [[1, 3]])


def test_the_other_way_round_turns_the_normal_only() -> None:
    back = DART[::-1]
    np.testing.assert_array_equal(unit_normals(back), [0, 0, -1])
    np.testing.assert_array_equal(reflex_corners(back), reflex_corners(DART)[::-1])


def test_the_gap_of_a_tetrahedron_is_the_distance_of_its_opposite_edges() -> None:
    # Corners of a cube of side 1: the diagonals lie in opposite faces of it.
    corners = np.array([[0, 0, 0], [1, 0, 1], [1, 1, 0], [0, 1, 1]], dtype=np.float64)
    assert diagonal_gaps(corners) == pytest.approx(1)


def test_a_panel_without_area_has_no_normal() -> None:
    line = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]], dtype=np.float64)
    np.testing.assert_array_equal(unit_normals(line), 0)
