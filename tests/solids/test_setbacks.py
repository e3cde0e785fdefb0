"""Boards stand clear of the planes that bisect their creases, at every fold up to the largest."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.conventions.errors import DesignError
from orishell.design import PanelSpec
from orishell.motion import Mechanism
from orishell.motion.grid import CreaseValues, Grid
from orishell.solids import build_boards, find_set_backs, largest_folds
from orishell.solids.boards import inset_panels
from samples import examples
from strategies import Request, orthodiagonal_requests, requests


def square(size: int = 2) -> tuple[np.ndarray, Grid]:
    grid = Grid(size + 1, size + 1)
    x, y = np.meshgrid(np.arange(size + 1.0), -np.arange(size + 1.0))
    return np.stack([x, y, 0 * x], axis=-1), grid


def folds_of(mechanism: Mechanism, drives: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    angles = mechanism.fold_angles(drives)
    return angles.row, angles.column


@settings(max_examples=examples(40))
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
    folds = CreaseValues(
        row=np.array([[2 * np.arctan(2.5), 0.0]]), column=np.array([[2 * np.arctan(1.0)], [0.0]])
    )
    boards = build_boards(flat, grid, PanelSpec(thickness=0.2, membrane=0.02), folds)
    assert boards.panels.tolist() == [0, 0, 1, 1, 2, 2, 3, 3]
    assert boards.sides.tolist() == [1, -1] * 4
    top, bottom = (boards.chosen(boards.sides == side) for side in (1, -1))
    assert bottom.areas() == pytest.approx(np.ones(4))
    assert top.areas() == pytest.approx([0.9 * 0.75, 0.9, 0.75, 1.0])
    assert top.volumes() == pytest.approx(0.09 * top.areas())
    assert top.outlines[0].min(axis=(0, 1)) == pytest.approx([0, -0.75, 0.01])
    assert top.outlines[0].max(axis=(0, 1)) == pytest.approx([0.9, 0, 0.1])


def test_bevelled_squares_are_frusta() -> None:
    """Gap 0.1: 0.05 all along a crease on the hinge plane, 0.25 more on the closing side."""
    flat, grid = square()
    folds = CreaseValues(row=np.array([[2 * np.arctan(2.5), 0.0]]), column=np.zeros((2, 1)))
    boards = build_boards(
        flat, grid, PanelSpec(thickness=0.2, construction="bevel", gap=0.1), folds
    )
    assert boards.sides.tolist() == [0] * 4
    below, middle, above = boards.outlines[0, :, :, 2].T[0]
    assert (below, middle, above) == pytest.approx((-0.1, 0.0, 0.1))
    full = 0.95 * 0.95
    assert boards.volumes()[0] == pytest.approx(0.1 * full + 0.1 * 0.95 * (0.95 + 0.75) / 2)
    assert boards.volumes()[1] == pytest.approx(0.2 * full)


@settings(max_examples=examples(60))
@given(st.integers(0, 2**32 - 1), st.booleans())
def test_outlines_agree_with_half_planes_of_shapely(seed: int, cut: bool) -> None:
    """A panel cut along a line inside each edge, by polygon clipping of another program."""
    from shapely import Polygon
    from shapely.geometry.base import BaseGeometry

    random = np.random.default_rng(seed)
    flat, grid = square(1)
    flat[..., :2] += random.uniform(-0.3, 0.3, (2, 2, 2))
    distance, relief = random.uniform(0, 0.25, 4), random.uniform(0, 0.3, 4) * cut
    corners = flat.reshape(-1, 3)[grid.faces_vertices()[0], :2]
    (outline,) = inset_panels(corners[None], distance[None], grid, relief[None] if cut else None)
    expected: BaseGeometry = Polygon(corners)

    def halved(near: np.ndarray, inward: np.ndarray) -> BaseGeometry:
        along = np.array([inward[1], -inward[0]])
        half = [near - 9 * along, near + 9 * along, near + 9 * (along + inward)]
        return expected.intersection(Polygon([*half, near + 9 * (inward - along)]))

    sides = np.roll(corners, -1, axis=0) - corners
    inward = np.stack([-sides[:, 1], sides[:, 0]], axis=-1)
    inward /= np.hypot(*inward.T)[:, None]
    for k in range(4):
        expected = halved(corners[k] + distance[k] * inward[k], inward[k])
        if cut:
            halving = inward[k] + inward[k - 1]
            halving /= np.hypot(*halving)
            expected = halved(corners[k] + relief[k] * halving, halving)
    assert outline.shape == (8 if cut else 4, 2)
    assert Polygon(outline).area == pytest.approx(expected.area, abs=1e-12)
    assert Polygon(outline).symmetric_difference(expected).area < 1e-12


def test_a_panel_that_vanishes_is_named() -> None:
    flat, grid = square()
    folds = CreaseValues(row=np.full((1, 2), 2.8), column=np.full((2, 1), 2.8))
    with pytest.raises(DesignError, match=r"leave nothing of a panel, of panel \[0, 0\]"):
        build_boards(flat, grid, PanelSpec().replace_unchecked(thickness=0.4), folds)


def test_no_board_lies_where_a_crease_folds_flat() -> None:
    flat, grid = square()
    folds = CreaseValues(row=np.array([[np.pi, 0.0]]), column=np.zeros((2, 1)))
    boards = build_boards(flat, grid, PanelSpec(thickness=0.1, membrane=0.01), folds)
    named = set(zip(boards.panels.tolist(), boards.sides.tolist(), strict=True))
    assert named == {(0, -1), (1, 1), (1, -1), (2, -1), (3, 1), (3, -1)}
