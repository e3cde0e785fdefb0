"""The grid: numbering, orientation, assignments."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from orishell.motion.grid import CreaseValues, Grid, crease_signs, edges_assignment


@given(st.integers(2, 9), st.integers(2, 9))
def test_faces_and_edges_agree(rows: int, columns: int) -> None:
    grid = Grid(rows, columns)
    edges, faces, sides = grid.edges_vertices(), grid.faces_vertices(), grid.faces_edges()
    assert len(edges) == rows * (columns - 1) + columns * (rows - 1)
    assert len(faces) == grid.panel_count
    # Every side of a face joins two successive corners of it (any order of the edge's ends).
    around = np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1)
    assert (np.sort(edges[sides], axis=-1) == np.sort(around, axis=-1)).all()
    # Inner edges have two faces, border edges one.
    use = np.bincount(sides.ravel(), minlength=len(edges))
    assert set(use) <= {1, 2}
    assert (use == 1).sum() == 2 * (rows - 1) + 2 * (columns - 1)


def test_faces_turn_counter_clockwise_with_rows_downwards() -> None:
    grid = Grid(3, 4)
    i, j = np.divmod(np.arange(12), 4)
    points = np.stack([j, -i], axis=-1)[grid.faces_vertices()]
    x, y = points[..., 0], points[..., 1]
    area = 0.5 * (x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y).sum(axis=1)
    np.testing.assert_array_equal(area, 1.0)


def test_assignment_letters_go_to_their_edges() -> None:
    row = np.array([[0.5, -0.5, 0.0]])
    column = np.array([[1e-12, -1.0], [2.0, -2.0]])
    letters = edges_assignment(crease_signs(CreaseValues(row, column)))
    assert "".join(letters[:9]) == "BBB" + "VMF" + "BBB"
    assert "".join(letters[9:]) == "BFMB" + "BVMB"


def test_values_on_edges_of_many_states() -> None:
    values = CreaseValues(np.ones((5, 1, 3)), 2 * np.ones((5, 2, 2)))
    assert values.on_edges().shape == (5, 9 + 8)
    assert values.on_edges().sum() == pytest.approx(5 * (3 + 8))
