"""How a sheet is split: every panel once, every part connected and no larger than the stock."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from documents import FAMILIES, demo_document
from orishell.conventions.errors import InputError
from orishell.document import Document
from orishell.motion.mesh import build_mesh
from orishell.workshop.fitting import CutSheet, find_turns
from orishell.workshop.splitting import split_sheet
from samples import examples

families = pytest.mark.parametrize("family", list(FAMILIES))


def size(document: Document) -> np.ndarray:
    return np.asarray(np.ptp(document.require_flat(), axis=0))


def loose(document: Document) -> Document:
    """The same sheet as other programs list it: no grid, panels in another order."""
    order = np.random.default_rng(3).permutation(len(document.mesh.faces))
    mesh = build_mesh(
        document.mesh.faces[order], document.mesh.vertex_count, document.mesh.edges.copy()
    )
    return replace(document, mesh=mesh, grid_shape=None)


def assert_split(document: Document, parts: tuple[np.ndarray, ...], stock: np.ndarray) -> None:
    """Every panel is in one part; parts are in one piece and fit (shapely's own rectangles)."""
    mesh, flat = document.mesh, document.require_flat()
    assert np.array_equal(np.sort(np.concatenate(parts)), np.arange(len(mesh.faces)))
    for part in parts:
        shape = shapely.union_all(shapely.polygons(flat[mesh.faces[part]]))
        assert shape.geom_type == "Polygon"
        turns = find_turns(shapely.get_coordinates(shape), *stock)
        assert len(turns) > 0
        turned = shapely.affinity.rotate(shape, turns[0], origin=(0, 0), use_radians=True)
        left, bottom, right, top = turned.bounds
        assert right - left <= stock[0] * (1 + 2e-9)
        assert top - bottom <= stock[1] * (1 + 2e-9)


@families
@pytest.mark.parametrize("as_listed", [True, False], ids=["grid", "loose"])
def test_every_panel_in_one_part_that_fits(family: str, as_listed: bool) -> None:
    document = demo_document(family)
    document = document if as_listed else loose(document)
    stock = np.array([0.55, 0.5]) * size(document).max()
    assert_split(document, split_sheet(document, stock[0], stock[1], 0.0), stock)


@settings(max_examples=examples(25), deadline=None)
@given(
    family=st.sampled_from(list(FAMILIES)),
    shares=st.tuples(st.floats(0.1, 0.9), st.floats(0.1, 0.9)),
    allowance=st.sampled_from([0.0, 0.01, 0.1]),
    as_listed=st.booleans(),
)
def test_any_stock_gives_parts_that_fit_or_a_refusal(
    family: str, shares: tuple[float, float], allowance: float, as_listed: bool
) -> None:
    document = demo_document(family)
    document = document if as_listed else loose(document)
    stock = np.array(shares) * size(document).max()
    try:
        parts = split_sheet(document, stock[0], stock[1], allowance)
    except InputError as error:
        if "panels do not fit" not in str(error):
            raise
        return
    assert_split(document, parts, stock)


def squares(rows: int, columns: int) -> Document:
    """A grid of unit squares."""
    number = np.arange((rows + 1) * (columns + 1)).reshape(rows + 1, columns + 1)
    faces = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1)
    y, x = np.indices(number.shape)
    mesh = build_mesh(faces.reshape(-1, 4), number.size)
    return Document(
        "squares",
        "mm",
        mesh,
        tuple("V" if crease else "B" for crease in mesh.crease),
        np.stack([x, -y], axis=-1).reshape(-1, 2).astype(float),
        np.zeros(len(mesh.edges)),
        (),
        (rows + 1, columns + 1),
        {},
    )


@pytest.mark.parametrize(
    ("rows", "columns", "stock", "count"),
    [
        (6, 6, (3, 3), 4),  # area alone asks for 4
        (6, 6, (2, 3), 6),
        (4, 10, (5, 2), 4),
        (5, 7, (3, 2), 7),  # area: 35/6, so at least 6; 7 is what bands of rows or columns allow
        (28, 28, (14, 14), 4),  # more lines than are tried
        (45, 2, (1, 1), 90),  # all of them are needed
    ],
)
def test_squares_take_the_parts_that_their_area_asks_for(
    rows: int, columns: int, stock: tuple[int, int], count: int
) -> None:
    parts = split_sheet(squares(rows, columns), *stock, 0.0)
    assert len(parts) == count


def test_parts_are_as_even_as_can_be() -> None:
    """Of seven squares in a row on stock for five, the cut leaves 3 and 4, not 5 and 2."""
    parts = split_sheet(squares(1, 7), 5, 1, 0.0)
    assert sorted(len(part) for part in parts) == [3, 4]


def test_a_fine_sheet_with_a_few_large_panels(monkeypatch: pytest.MonkeyPatch) -> None:
    """One column of 45 as wide as the stock: lines are added beside it, not everywhere."""
    document = squares(45, 45)
    flat = document.require_flat() + np.array([9.0, 0.0]) * (document.require_flat()[:, :1] > 20)
    tried = []
    fits = CutSheet.fits

    def counted(self: CutSheet, *args: np.ndarray) -> bool:
        tried.append(args)
        return fits(self, *args)

    monkeypatch.setattr(CutSheet, "fits", counted)
    parts = split_sheet(replace(document, flat=flat), 10, 9, 0.0)
    assert_split(replace(document, flat=flat), parts, np.array([10, 9]))
    # By area at least 27; cut along every other line no part is more than half empty.
    assert 27 <= len(parts) < 2 * 27
    # All lines would take 45 ** 3 / 2 blocks each way; and every panel is looked at once.
    assert len(tried) - 45**2 < 15_000


def test_tabs_count() -> None:
    """A tab of 0.25 reaches beyond stock that two squares fill: then each is a part."""
    assert len(split_sheet(squares(1, 4), 2, 1, 0.0)) == 2
    assert len(split_sheet(squares(1, 4), 2, 1, 0.25)) == 3  # the last one carries no tab
    assert len(split_sheet(squares(1, 4), 2.25, 1, 0.25)) == 2


def test_stock_smaller_than_a_panel_is_refused_with_the_size_that_would_do() -> None:
    with pytest.raises(InputError) as caught:
        split_sheet(squares(3, 3), 0.9, 5, 0.0)
    assert caught.value.where == "[workshop] stock"
    assert "0.9 x 5" in caught.value.got
    assert "at least 1 x 1" in caught.value.expected
    assert "9 of 9" in caught.value.what


def test_the_refusal_names_a_size_that_every_panel_fits() -> None:
    """Columns 1, 2 and 3 wide: stock for the first refused one would not do for the others."""
    document = squares(2, 3)
    flat = document.require_flat().copy()
    flat[:, 0] = np.array([0.0, 1.0, 3.0, 6.0])[flat[:, 0].astype(int)]
    document = replace(document, flat=flat)
    with pytest.raises(InputError, match=r"4 of 6 panels .* at least 3 x 1, .* panel 0,2,"):
        split_sheet(document, 1.5, 1.5, 0.0)
    assert len(split_sheet(document, 3, 1, 0.0)) == 4


def test_parts_of_figure_1_are_near_the_bound() -> None:
    """No more than twice what the area asks for, though a sheet that winds fills no rectangles."""
    document = demo_document("parallel-repeating")
    width, height = size(document)
    stock = (0.4 * width, 0.7 * height)
    bound = document.areas().sum() / (stock[0] * stock[1])
    assert len(split_sheet(document, stock[0], stock[1], 0.0)) <= np.ceil(2 * bound)


def test_turns_fit_a_bar_along_the_diagonal_only() -> None:
    """A bar of 13 x 0.2 fits 12 x 5.5 only when turned; none longer than the diagonal does."""
    bar = np.array([[0, 0], [13, 0], [13, 0.2], [0, 0.2]])
    turns = find_turns(bar, 12, 5.5)
    assert len(turns) > 0
    for turn in turns:
        turned = shapely.affinity.rotate(shapely.Polygon(bar), turn, (0, 0), use_radians=True)
        left, bottom, right, top = turned.bounds
        assert right - left <= 12 * (1 + 1e-8)
        assert top - bottom <= 5.5 * (1 + 1e-8)
    assert len(find_turns(bar * [1.02, 1], 12, 5.5)) == 0
