"""Rows and columns are found whatever the order of panels and however the sheet lies."""

from __future__ import annotations

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.motion.crease_pattern import CreasePattern, pattern_of_panels
from orishell.motion.grid import Grid
from orishell.motion.gridding import find_grid, grid_edges
from patterns import SAMPLES, mirrored, miura, moved, scaled, shuffled
from timing import ROOM, seconds

Array = np.ndarray
GRIDS = [name for name, each in SAMPLES.items() if each.grid]


def places(pattern: CreasePattern) -> Array:
    return np.asarray(pattern.vertices[find_grid(pattern)])


def panels_of(pattern: CreasePattern) -> set[frozenset[int]]:
    return {frozenset(each) for each in pattern.faces.tolist()}


@pytest.mark.parametrize("name", GRIDS)
def test_all_panels_are_those_of_the_grid(name: str) -> None:
    pattern = shuffled(SAMPLES[name].make())
    numbers = find_grid(pattern)
    grid = Grid(*numbers.shape)
    found = numbers.ravel()[grid.faces_vertices()]
    assert {frozenset(each) for each in found.tolist()} == panels_of(pattern)
    assert len(np.unique(numbers)) == len(pattern.vertices) == grid.vertex_count
    edges = pattern.edges[grid_edges(pattern, numbers)]
    wanted = numbers.ravel()[grid.edges_vertices()]
    np.testing.assert_array_equal(np.sort(edges), np.sort(wanted))


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_the_order_of_panels_changes_nothing(seed: int) -> None:
    pattern = miura()
    np.testing.assert_array_equal(places(shuffled(pattern, seed)), places(pattern))


def test_rows_run_along_x_and_columns_downwards() -> None:
    pattern = miura(3, 5)
    for quarter in range(4):
        turn = np.linalg.matrix_power(np.array([[0.0, -1.0], [1.0, 0.0]]), quarter)
        for each in (moved(pattern, turn), mirrored(moved(pattern, turn)), scaled(pattern)):
            found = places(each)
            along, down = found[:, -1] - found[:, 0], found[-1] - found[0]
            assert (along.mean(axis=0)[0] > np.abs(along.mean(axis=0)[1])).all()
            assert down.mean(axis=0)[1] < 0
            corners = found[:-1, :-1], found[1:, :-1], found[1:, 1:]
            first, second = corners[1] - corners[0], corners[2] - corners[1]
            assert (first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0] > 0).all()


@pytest.mark.parametrize(
    ("name", "got"),
    [
        ("waterbomb", "a panel of 3 vertices"),
        ("Yoshimura", "a panel of 3 vertices"),
        ("Resch", "a panel of 3 vertices"),
        ("Miura with a hole", "3 panels at a vertex at a border"),
    ],
)
def test_what_is_no_grid_is_refused_by_place(name: str, got: str) -> None:
    with pytest.raises(InputError) as caught:
        find_grid(SAMPLES[name].make())
    assert caught.value.got == got
    assert caught.value.where.startswith("at (")


def test_two_sheets_are_no_grid() -> None:
    one = miura()
    count = len(one.vertices)
    both = pattern_of_panels(
        np.concatenate([one.vertices, one.vertices + 100]),
        np.concatenate([one.faces, one.faces + count]),
    )
    with pytest.raises(InputError, match="8 corners"):
        find_grid(both)


def large_grid(side: int) -> tuple[CreasePattern, Array]:
    grid = Grid(side, side)
    i, j = np.indices((side, side)).astype(np.float64)
    flat = np.stack([j, -i], axis=-1).reshape(-1, 2)
    pattern = shuffled(pattern_of_panels(flat, grid.faces_vertices()))
    assert pattern.inner.size == (side - 2) ** 2  # found once, and kept
    return pattern, flat


def test_the_time_for_large_grids_grows_with_their_panels() -> None:
    (small, _), (large, flat) = large_grid(101), large_grid(301)
    np.testing.assert_array_equal(large.vertices[find_grid(large)].reshape(-1, 2), flat)
    assert seconds(lambda: find_grid(large)) < ROOM * 9 * seconds(lambda: find_grid(small))
