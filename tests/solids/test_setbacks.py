"""Boards stand clear of the planes that bisect their creases, at every fold up to the largest."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.errors import DesignError
from orishell.motion import Mechanism
from orishell.sheet.grid import CreaseValues, Grid
from orishell.solids import SetBacks, cut_boards, find_set_backs, largest_folds
from strategies import Request, orthodiagonal_requests, requests


def square(size: int = 2) -> tuple[np.ndarray, Grid]:
    grid = Grid(size + 1, size + 1)
    x, y = np.meshgrid(np.arange(size + 1.0), -np.arange(size + 1.0))
    return np.stack([x, y, 0 * x], axis=-1), grid


def folds_of(mechanism: Mechanism, drives: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    angles = mechanism.fold_angles(drives)
    return angles.row, angles.column


@settings(max_examples=40)
@given(st.one_of(requests(), orthodiagonal_requests()), st.floats(0.3, 0.95))
def test_no_fold_on_the_way_is_larger(request: Request, share: float) -> None:
    """Against 2000 states; with the sign that the crease keeps."""
    mechanism = request.feasible().mechanism.without_flaps()
    limit = share * mechanism.end_drive
    found = largest_folds(mechanism, limit)
    for largest, angles in zip(
        (found.row, found.column),
        folds_of(mechanism, np.linspace(0, limit, 2000)),
        strict=True,
    ):
        if angles.size:
            assert (np.abs(angles).max(axis=0) <= np.abs(largest) + 1e-7).all()
            assert (np.abs(largest) <= np.abs(angles).max(axis=0) + 1e-4).all()
            assert (largest * angles >= -1e-9).all()


def test_set_backs_are_on_the_closing_side() -> None:
    """A right angle asks for as much as boards are high; mountains close below."""
    grid = Grid(3, 3)
    folds = CreaseValues(
        row=np.array([[np.pi / 2, -np.pi / 2]]), column=np.array([[0.0], [2 * np.arctan(3.0)]])
    )
    found = find_set_backs(folds, 0.01, gap=0.002)
    edges = {tuple(edge): k for k, edge in enumerate(grid.edges_vertices().tolist())}
    valley, mountain, flat, steep = (edges[each] for each in ((3, 4), (4, 5), (1, 4), (4, 7)))
    assert found.top[[valley, mountain, flat, steep]] == pytest.approx([0.01, 0.001, 0.001, 0.03])
    assert found.bottom[[valley, mountain, flat, steep]] == pytest.approx(
        [0.001, 0.01, 0.001, 0.001]
    )
    assert found.top[edges[(0, 1)]] == found.bottom[edges[(6, 7)]] == 0  # the border


def test_boards_meet_the_bisecting_plane_at_the_largest_fold() -> None:
    """Two boards of height b, folded by phi about their crease, touch along their upper edges."""
    height, phi = 0.02, 2.0
    back = height * np.tan(phi / 2)
    half = phi / 2
    # In the plane across the crease, the bisecting plane upright: the panel goes down by phi/2.
    edge = np.array([back * np.cos(half), back * np.sin(half)])
    upper = edge + height * np.array([-np.sin(half), np.cos(half)])
    assert upper[0] == pytest.approx(0, abs=1e-15)


def test_boards_of_squares_are_rectangles() -> None:
    flat, grid = square()
    distance = np.zeros(len(grid.edges_vertices()))
    edges = {tuple(edge): k for k, edge in enumerate(grid.edges_vertices().tolist())}
    distance[edges[(3, 4)]], distance[edges[(1, 4)]] = 0.25, 0.1
    top, bottom = cut_boards(flat, grid, SetBacks(distance, 0 * distance))
    assert bottom.areas() == pytest.approx(np.ones(4))
    assert top.areas() == pytest.approx([0.9 * 0.75, 0.9, 0.75, 1.0])
    assert top.corners[0].min(axis=0) == pytest.approx([0, -0.75])
    assert top.corners[0].max(axis=0) == pytest.approx([0.9, 0])


@settings(max_examples=60)
@given(st.integers(0, 2**32 - 1))
def test_areas_agree_with_half_planes_of_shapely(seed: int) -> None:
    """A panel cut along a line inside each edge, by polygon clipping of another program."""
    from shapely import Polygon
    from shapely.geometry.base import BaseGeometry

    random = np.random.default_rng(seed)
    flat, grid = square(1)
    flat[..., :2] += random.uniform(-0.3, 0.3, (2, 2, 2))
    distance = random.uniform(0, 0.25, 4)
    (board,) = cut_boards(flat, grid, SetBacks(distance, distance))[0].corners
    corners = flat.reshape(-1, 3)[grid.faces_vertices()[0], :2].copy()
    expected: BaseGeometry = Polygon(corners)
    for k, back in enumerate(distance[grid.faces_edges()[0]]):
        start, along = corners[k], corners[(k + 1) % 4] - corners[k]
        along /= np.hypot(*along)
        inward = np.array([-along[1], along[0]])
        near = start + back * inward
        half = [near - 9 * along, near + 9 * along, near + 9 * (along + inward)]
        expected = expected.intersection(Polygon([*half, near + 9 * (inward - along)]))
    assert Polygon(board).area == pytest.approx(expected.area, abs=1e-12)


def test_a_panel_that_vanishes_is_named() -> None:
    flat, grid = square()
    distance = np.full(len(grid.edges_vertices()), 0.6)
    with pytest.raises(DesignError, match=r"leave nothing of a panel, of panel \[0, 0\]"):
        cut_boards(flat, grid, SetBacks(distance, distance))
