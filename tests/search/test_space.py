"""Variants as points of a cube: which values they have, and that equal ones have equal points."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from orishell.design_file.search import Range
from orishell.design_file.tables import with_values
from orishell.search.space import Choices, Interval, Space, stepped

SPACE = Space({"a": Choices(("x", "y", "z")), "b": Interval(-1.5, 2.0), "c": Choices((5, 7))})
shares = st.floats(0.0, 1.0)


@given(st.lists(shares, min_size=3, max_size=3))
def test_snapping_keeps_the_variant_and_gives_equal_variants_equal_points(
    point: list[float],
) -> None:
    points = np.array([point])
    snapped = SPACE.snapped(points)
    assert SPACE.values(snapped[0]) == SPACE.values(points[0])
    again = SPACE.snapped(snapped)
    assert (again == snapped).all()


@given(shares)
def test_numbers_stay_within_their_range_and_have_six_digits(share: float) -> None:
    value = Interval(1 / 3, 2 / 3).value(share)
    assert 1 / 3 <= value <= 2 / 3
    assert value in (1 / 3, 2 / 3) or value == float(f"{value:.6f}")


def test_a_narrow_range_far_from_zero_has_its_numbers() -> None:
    """Digits count from the first of the range on, not of the number."""
    axis = Interval(100000.2, 100000.8)
    points = np.linspace(0, 1, 401)
    assert len({axis.value(share) for share in points}) == 401
    snapped = axis.snapped(points)
    assert [axis.value(share) for share in snapped] == [axis.value(share) for share in points]
    assert (axis.snapped(snapped) == snapped).all()


def test_a_design_file_is_a_point_where_its_values_may_be_chosen() -> None:
    space = Space({"a.b": Choices((3, 5)), "c.0.d": Interval(1.0, 2.0)})
    point = space.point({"a": {"b": 5}, "c": [{"d": 1.25}]})
    assert point is not None
    assert space.values(point) == {"a.b": 5, "c.0.d": 1.25}
    for other in ({"a": {"b": 4}, "c": [{"d": 1}]}, {"a": {"b": 5}, "c": []}, {}):
        assert space.point(other) is None


def test_every_choice_has_the_same_part_of_its_side() -> None:
    values = [SPACE.values(np.array([share, 0, 0]))["a"] for share in (0, 0.33, 0.34, 0.67, 1)]
    assert values == ["x", "x", "y", "z", "z"]


def test_a_grid_has_all_variants_once() -> None:
    space = Space({"a": Choices((1, 2, 3)), "b": Choices(("u", "v"))})
    found = [tuple(each.values()) for each in space.grid()]
    assert sorted(found) == [(a, b) for a in (1, 2, 3) for b in "uv"]
    assert space.count == 6
    assert SPACE.count == np.inf


@pytest.mark.parametrize(
    ("given", "whole", "values"),
    [
        (Range(low=3, high=9), True, (3, 4, 5, 6, 7, 8, 9)),
        (Range(low=3, high=9, step=2), True, (3, 5, 7, 9)),
        (Range(low=3, high=8, step=2), True, (3, 5, 7)),
        (Range(low=0.1, high=0.4, step=0.1), False, (0.1, 0.2, 0.3, 0.4)),
    ],
)
def test_steps_reach_the_end_whatever_rounding_does(
    given: Range, *, whole: bool, values: tuple[float, ...]
) -> None:
    axis = stepped(given, whole=whole)
    assert isinstance(axis, Choices)
    assert axis.values == values
    assert {type(each) for each in axis.values} == {int if whole else float}


def test_values_are_put_at_their_keys_and_the_tables_stay_as_they_were() -> None:
    tables = {"pattern": {"rows": 3}, "load_case": [{"snow": 1}, {"snow": 2}]}
    changed = with_values(tables, {"pattern.flap": 0.5, "load_case.1.snow": 7, "new.key": "x"})
    assert changed == {
        "pattern": {"rows": 3, "flap": 0.5},
        "load_case": [{"snow": 1}, {"snow": 7}],
        "new": {"key": "x"},
    }
    assert tables == {"pattern": {"rows": 3}, "load_case": [{"snow": 1}, {"snow": 2}]}


@pytest.mark.parametrize("key", ["load_case.2.snow", "load_case.x.snow", "pattern.rows.low"])
def test_a_key_that_lies_in_no_table_is_refused(key: str) -> None:
    with pytest.raises(LookupError):
        with_values({"pattern": {"rows": 3}, "load_case": [{}, {}]}, {key: 1})


def test_neighbours_on_a_side_are_neighbours_in_value() -> None:
    values = [Interval(0, 1).value(share) for share in np.linspace(0, 1, 11)]
    assert all(low < high for low, high in pairwise(values))
