"""Parts on stock: inside it, apart by the spacing, and not on more sheets than need be."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.conventions.errors import InputError
from orishell.workshop import nesting
from orishell.workshop.nesting import fewest_sheets, nest_parts
from orishell.workshop.placing import Placement
from samples import examples, led_by

Outline = np.ndarray


def rectangle(width: float, height: float) -> Outline:
    return np.array([[0, 0], [width, 0], [width, height], [0, height]], dtype=float)


def star(seed: int, size: float) -> Outline:
    """A star-shaped polygon, convex or not."""
    rng = np.random.default_rng(seed)
    angles = np.sort(rng.uniform(0, 2 * np.pi, 9)) + np.arange(9) * 1e-3
    radii = size * rng.uniform(0.3, 1, 9)
    return np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]) + rng.uniform(-9, 9, 2)


def assert_nested(
    outlines: list[Outline],
    places: tuple[Placement, ...],
    stock: tuple[float, float],
    spacing: float,
) -> None:
    shapes = [shapely.Polygon(p.move(o)) for o, p in zip(outlines, places, strict=True)]
    slack = 1e-8 * max(stock)
    for shape, outline in zip(shapes, outlines, strict=True):
        left, bottom, right, top = shape.bounds
        assert min(left, bottom) >= -slack
        assert right <= stock[0] + slack
        assert top <= stock[1] + slack
        assert shape.area == pytest.approx(shapely.Polygon(outline).area)
        assert shape.exterior.is_ccw == shapely.Polygon(outline).exterior.is_ccw  # not turned over
    for (one, p), (two, q) in itertools.combinations(zip(shapes, places, strict=True), 2):
        if p.sheet == q.sheet:
            assert one.distance(two) >= spacing
            assert one.intersection(two).area <= 1e-12
    assert {p.sheet for p in places} == set(range(1 + max(p.sheet for p in places)))


@settings(max_examples=examples(40), deadline=None)
@given(
    seeds=st.lists(st.integers(0, 10**6), min_size=1, max_size=12),
    spacing=st.sampled_from([0.0, 0.05, 0.4]),
)
def test_parts_keep_apart(seeds: list[int], spacing: float) -> None:
    outlines = [star(seed, 0.2 + 1.3 * (k % 3) / 2) for k, seed in enumerate(seeds)]
    stock = (5.0, 3.5)
    assert_nested(outlines, nest_parts(outlines, *stock, spacing), stock, spacing)


def test_rectangles_fill_a_sheet() -> None:
    """Sixteen squares of 1 with 0.1 between them need 4.3 x 4.3: just that is enough."""
    squares = [rectangle(1, 1)] * 16
    side = 4.3 + 1e-6
    places = nest_parts(squares, side, side, 0.1)
    assert_nested(squares, places, (side, side), 0.1)
    assert {place.sheet for place in places} == {0}
    assert {place.sheet for place in nest_parts(squares, 4.29, 4.29, 0.1)} == {0, 1}


def test_a_long_part_is_turned() -> None:
    (place,) = nest_parts([rectangle(1, 5)], 5, 1, 0.0)
    assert np.ptp(place.move(rectangle(1, 5)), axis=0) == pytest.approx([5, 1])


def test_small_parts_fill_what_large_ones_leave() -> None:
    large, small = rectangle(3, 2), rectangle(0.9, 0.9)
    places = nest_parts([large, large, small, small], 4, 2, 0.05)
    assert [place.sheet for place in places] == [0, 1, 0, 0]


def test_hundred_parts_waste_less_than_a_third() -> None:
    """Rectangles between 0.4 and 1.4: a mean part is a fiftieth of the stock."""
    rng = np.random.default_rng(5)
    parts = [rectangle(*rng.uniform(0.4, 1.4, 2)) for _ in range(100)]
    places = nest_parts(parts, 8, 5, 0.02)
    assert_nested(parts, places, (8, 5), 0.02)
    full = [
        sum(shapely.Polygon(o).area for o, p in zip(parts, places, strict=True) if p.sheet == k)
        for k in range(max(p.sheet for p in places))
    ]
    assert min(full) / 40 > 2 / 3


@pytest.mark.parametrize("spacing", led_by([0.05, 0.0]))
def test_many_small_parts_lie_in_rows(spacing: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """200 stars: 30 of them where there is room, the others in rows, all of them apart."""
    monkeypatch.setattr(nesting, "MOST_NESTED", 30)
    outlines = [star(seed, 0.1 + seed % 5 / 10) for seed in range(200)]
    places = nest_parts(outlines, 5.0, 3.5, spacing)
    assert_nested(outlines, places, (5.0, 3.5), spacing)
    boxes = sum(float(np.prod(np.ptp(outline, axis=0) + spacing)) for outline in outlines)
    assert 1 + max(place.sheet for place in places) <= 1 + np.ceil(1.3 * boxes / (5.0 * 3.5))


@pytest.mark.parametrize("turned", [False, True])
def test_wedges_lie_beside_each_other(turned: bool) -> None:
    """Forty right triangles fill squares of twice their area, so rows of their boxes take double.

    A square of 4 holds sixteen pairs of them, of 1 x 1, and no more by their areas.
    """
    wedge = np.array([[0, 0], [1, 0], [0, 1]], dtype=float)
    wedges = [-wedge if turned and k % 2 else wedge for k in range(40)]
    places = nest_parts(wedges, 4 + 1e-6, 4 + 1e-6, 0.0)
    assert_nested(wedges, places, (4 + 1e-6, 4 + 1e-6), 0.0)
    assert 1 + max(place.sheet for place in places) == 2


@settings(max_examples=examples(30), deadline=None)
@given(sides=st.lists(st.tuples(st.integers(1, 8), st.integers(1, 8)), min_size=1, max_size=9))
def test_no_nest_has_fewer_sheets_than_there_are_at_least(sides: list[tuple[int, int]]) -> None:
    """Rectangles larger than half a sheet have one each; all of them have the area of theirs."""
    places = nest_parts([rectangle(*each) for each in sides], 8.0, 8.0, 0.0)
    areas = np.array([float(width * height) for width, height in sides])
    least = fewest_sheets(areas, 64.0)
    assert max(np.ceil(areas.sum() / 64), (areas > 32).sum()) <= least
    assert least <= 1 + max(place.sheet for place in places)


def test_a_part_larger_than_the_stock_is_refused() -> None:
    with pytest.raises(InputError, match="does not fit the stock"):
        nest_parts([rectangle(3, 3)], 4, 2, 0.0)
