"""What a crease pattern knows of its vertices: truths of plane geometry."""

import numpy as np

from orishell.motion.crease_pattern import CreasePattern

# A square sheet with both diagonals: one inner vertex, four triangles; numbers shuffled.
SQUARE = CreasePattern(
    vertices=np.array([[1.0, 1], [-1, 1], [0, 0.5], [-1, -1], [1, -1]]),
    edges=np.array([[0, 1], [2, 3], [1, 3], [2, 0], [3, 4], [4, 2], [4, 0], [1, 2]]),
    letters=np.array(list("BMBVBUBV")),
    faces=np.array([[0, 1, 2], [1, 3, 2], [2, 3, 4], [0, 2, 4]]),
    edge_faces=np.array([[0, -1], [2, 1], [1, -1], [0, 3], [2, -1], [2, 3], [3, -1], [0, 1]]),
)


def test_creases_go_counter_clockwise_around_an_inner_vertex() -> None:
    assert SQUARE.inner.tolist() == [2]
    creases, ends = SQUARE.fans
    first = ends[0].tolist().index(0)
    assert np.roll(ends[0], -first).tolist() == [0, 1, 3, 4]
    assert np.roll(creases[0], -first).tolist() == [3, 7, 1, 5]


def test_sectors_fill_the_plane() -> None:
    np.testing.assert_allclose(np.nansum(SQUARE.sectors), 2 * np.pi, rtol=1e-15)
    # The creases to (1, 1) and (-1, 1) rise by half a unit and go one aside.
    np.testing.assert_allclose(SQUARE.sectors.max(), np.pi - 2 * np.arctan(0.5), rtol=1e-15)


def test_signs_are_those_of_the_letters() -> None:
    np.testing.assert_array_equal(SQUARE.signs[[1, 3, 5]], [-1, 1, np.nan])


def test_a_sheet_without_inner_vertices_has_no_fans() -> None:
    alone = CreasePattern(
        np.array([[0.0, 0], [1, 0], [0, 1]]),
        np.array([[0, 1], [1, 2], [2, 0]]),
        np.array(list("BBB")),
        np.array([[0, 1, 2]]),
        np.array([[0, -1]] * 3),
    )
    assert len(alone.inner) == 0
    assert alone.sectors.shape == alone.fans[0].shape == (0, 0)
