"""What lies beside what, for panels in any order and either way round."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from orishell.conventions.errors import InputError
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.motion import measure_fold_angles
from orishell.motion.grid import Grid
from orishell.motion.mesh import build_mesh, measure_mesh_folds, measure_sector_sums
from orishell.motion.quads import reflex_corners
from strategies import graph


def mixed_faces(grid: Grid, seed: int) -> np.ndarray:
    """The grid's panels in another order, each from another corner on, some the other way."""
    rng = np.random.default_rng(seed)
    faces = rng.permutation(grid.faces_vertices())
    first = rng.integers(0, 4, len(faces))[:, None]
    way = np.where(rng.random((len(faces), 1)) < 0.3, -1, 1)
    order = (first + way * np.arange(4)) % 4
    return np.take_along_axis(faces, order.astype(np.int64), axis=1)


@given(st.integers(2, 7), st.integers(2, 7), st.integers(0, 99))
def test_a_grid_in_any_order(rows: int, columns: int, seed: int) -> None:
    grid = Grid(rows, columns)
    mesh = build_mesh(mixed_faces(grid, seed), grid.vertex_count)
    # A grid of rows x columns vertices has these many creases and inner vertices.
    assert mesh.crease.sum() == (rows - 2) * (columns - 1) + (columns - 2) * (rows - 1)
    inner = grid.vertices()[1:-1, 1:-1]
    np.testing.assert_array_equal(mesh.inner_vertices(), inner.ravel())
    assert not mesh.pieces.any()
    # Each panel has its edges on its left, neighbours therefore opposite ones: u -> v and v -> u.
    for edge, beside in enumerate(mesh.edge_faces):
        for face, way in zip(beside, (1, -1), strict=True):
            if face >= 0:
                corners = mesh.faces[face].tolist()
                pairs = list(pairwise([*corners, corners[0]]))
                assert tuple(mesh.edges[edge][::way].tolist()) in pairs


def test_fold_angles_are_those_of_the_grid() -> None:
    mechanism = design_parallel_repeating(
        graph("-x**2", -1, 1),
        graph("x**2/30", 0, 10),
        ParallelRepeatingPattern(rows=3, columns=4, xi_deg=np.rad2deg(0.8), flap=0.3),
    ).mechanism
    grid, positions = mechanism.grid, mechanism.positions(1.0)
    expected = measure_fold_angles(positions).on_edges()
    for seed in range(20):
        require_folds(grid, seed, positions.reshape(-1, 3), expected)


def require_folds(grid: Grid, seed: int, positions: np.ndarray, expected: np.ndarray) -> None:
    """The oracle is the measure on grids, up to the side from which the panels are seen."""
    mesh = build_mesh(mixed_faces(grid, seed), grid.vertex_count, grid.edges_vertices())
    folds = measure_mesh_folds(mesh, positions)
    side = np.sign(folds @ expected)
    np.testing.assert_allclose(side * folds, expected, atol=1e-13)


def test_most_panels_keep_their_way() -> None:
    grid = Grid(3, 4)
    faces = grid.faces_vertices()
    faces[2] = faces[2][::-1]
    mesh = build_mesh(faces, grid.vertex_count)
    np.testing.assert_array_equal(np.flatnonzero(mesh.reversed_faces), [2])
    assert mesh.faces[2].tolist() == [faces[2][0], *faces[2][:0:-1]]


def test_separate_pieces_are_turned_separately() -> None:
    faces = np.array([[0, 1, 2, 3], [4, 5, 6, 7], [5, 8, 9, 6], [10, 11, 8, 9]])
    mesh = build_mesh(faces, 12)
    assert mesh.pieces.tolist() == [0, 1, 1, 1]
    assert not mesh.reversed_faces[0]
    assert len(mesh.inner_vertices()) == 0


def test_a_cut_edge_does_not_join() -> None:
    grid = Grid(3, 3)
    edges = grid.edges_vertices()
    cut = np.zeros(len(edges), dtype=np.bool_)
    cut[2] = True
    assert edges[2].tolist() == [3, 4]
    mesh = build_mesh(grid.faces_vertices(), 9, edges, cut)
    assert mesh.crease.sum() == 3
    assert len(mesh.inner_vertices()) == 0


def test_sector_sums_of_a_chevron_and_its_complement() -> None:
    # A chevron and the kite that fills it: together one corner of the chevron's is full.
    positions = np.array(
        [[0, 0, 0], [2, -2, 0], [0, 3, 0], [-2, -2, 0], [0, -4, 0]], dtype=np.float64
    )
    mesh = build_mesh(np.array([[0, 1, 2, 3], [0, 3, 4, 1]]), 5)
    reflex = reflex_corners(positions[mesh.faces])
    assert reflex.sum() == 1
    np.testing.assert_array_equal(mesh.inner_vertices(), [0])
    assert measure_sector_sums(mesh, positions, reflex)[0] == pytest.approx(2 * np.pi)


def test_a_moebius_strip_is_refused_and_a_ring_is_not() -> None:
    ring = np.array([[k, (k + 1) % 5, 5 + (k + 1) % 5, 5 + k] for k in range(5)])
    assert build_mesh(ring, 10).crease.sum() == 5
    ring[-1] = [4, 5, 0, 9]
    with pytest.raises(InputError, match="only one side"):
        build_mesh(ring, 10)


@pytest.mark.parametrize(
    ("faces", "edges", "says"),
    [
        ([[0, 1, 2, 2]], None, "panel 0 repeats a corner"),
        (
            [[0, 1, 2, 3], [0, 1, 4, 5], [0, 1, 6, 7]],
            None,
            "edge 0-1 has more than two panels; got panels 0, 1, 2",
        ),
        ([[0, 1, 2, 3]], [[0, 1], [1, 2], [2, 3]], "a side of panel 0 is not among the edges"),
        ([[0, 1, 2, 3]], [[0, 1], [1, 2], [2, 3], [3, 0], [2, 1]], "edge 1-2 is listed twice"),
    ],
)
def test_faults(faces: list[list[int]], edges: list[list[int]] | None, says: str) -> None:
    with pytest.raises(InputError) as error:
        build_mesh(np.array(faces), 8, None if edges is None else np.array(edges))
    assert says in str(error.value)
