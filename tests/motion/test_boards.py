"""Surfaces of boards: manifold3d takes them as closed and oriented, with the volumes they have."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from cad_tools import closed_volume
from documents import FAMILIES, thick_document
from orishell.design import Construction, PanelSpec
from orishell.motion.boards import Boards, Surfaces
from orishell.motion.grid import CreaseValues, Grid
from orishell.solids import build_boards
from samples import examples
from timing import ROOM, seconds


def volumes(boards: Boards, corners: np.ndarray) -> np.ndarray:
    surfaces = boards.surfaces(corners)
    found = np.empty(len(boards))
    for board in range(len(boards)):
        triangles = surfaces.triangles[surfaces.boards == board]
        own, numbered = np.unique(triangles, return_inverse=True)
        found[board] = closed_volume(surfaces.vertices[own], numbered.reshape(-1, 3))
    # Vertices are shared within a board only, and each of them is a corner of something.
    assert len(np.unique(surfaces.triangles)) == len(surfaces.vertices)
    return found


def sheet(rows: int, columns: int, fold: float) -> tuple[np.ndarray, Grid, CreaseValues]:
    """Squares of side 1 whose creases fold alternately, by less along rows than along columns."""
    grid = Grid(rows + 1, columns + 1)
    x, y = np.meshgrid(np.arange(columns + 1.0), -np.arange(rows + 1.0))
    sign = np.where(np.add.outer(np.arange(rows), np.arange(columns)) % 2, -fold, fold)
    folds = CreaseValues(row=sign[1:], column=0.5 * sign[:, 1:])
    return np.stack([x, y, 0 * x], axis=-1), grid, folds


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("construction", ["sandwich", "bevel"])
def test_boards_of_a_shell(family: str, construction: Construction) -> None:
    document = thick_document(family, construction)
    for piece in (document, *document.attached):
        assert piece.boards is not None
        found = volumes(piece.boards, piece.boards_in(piece.shell))
        np.testing.assert_allclose(found, piece.boards.volumes(), rtol=1e-12)


@settings(max_examples=examples(40), deadline=None)
@given(
    st.sampled_from(["sandwich", "bevel"]),
    st.floats(0.02, 0.5),
    st.integers(0, 2**32 - 1),
    st.sampled_from([0.0, 1e-9, 0.1, 0.3]),
)
def test_boards_with_cut_corners(
    construction: Construction, thickness: float, seed: int, cut: float
) -> None:
    """Also where two corners of an outline nearly coincide, as after a cut of 1e-9."""
    flat, grid, folds = sheet(3, 3, 1.5)
    build = PanelSpec().replace_unchecked(
        thickness=thickness,
        construction=construction,
        membrane=0.1 * thickness * (construction == "sandwich"),
    )
    reliefs = cut * np.random.default_rng(seed).integers(0, 2, (4, 4)).astype(np.float64)
    boards = build_boards(flat, grid, build, folds, reliefs)
    # What a cut of less than COINCIDING leaves of an edge is not kept.
    np.testing.assert_allclose(
        volumes(boards, boards.outlines), boards.volumes(), rtol=1e-12 if cut != 1e-9 else 1e-8
    )


def test_a_cube_by_hand() -> None:
    square = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    outlines = np.stack([square, square + np.array([0, 0, 1])])[None]
    boards = Boards(np.array([0]), np.array([1]), outlines)
    surfaces = boards.surfaces(outlines)
    assert surfaces.vertices.shape == (8, 3)
    assert surfaces.triangles.shape == (12, 3)
    a, b, c = np.moveaxis(surfaces.vertices[surfaces.triangles], 1, 0)
    normals = np.cross(b - a, c - a)
    outward = (a + b + c) / 3 - 0.5
    assert ((normals * outward).sum(axis=1) > 0).all()
    np.testing.assert_allclose(np.abs(normals).sum(axis=1), 1.0)


def surfaced(size: int) -> Callable[[], Surfaces]:
    flat, grid, folds = sheet(size, size, 1.0)
    boards = build_boards(flat, grid, PanelSpec(thickness=0.1, membrane=0.01), folds)
    points = flat.reshape(-1, 3)
    corners = boards.carried(grid.faces_vertices(), points[:, :2], points)
    return lambda: boards.surfaces(corners)


def test_the_time_for_surfaces_grows_with_the_panels() -> None:
    small, large = surfaced(32), surfaced(100)
    assert large().triangles.shape == (20_000 * 12, 3)
    assert seconds(large) < ROOM * (100 / 32) ** 2 * seconds(small)
