"""Of values that differ by rounding the first is taken, whichever of them rounding makes larger."""

from __future__ import annotations

import numpy as np
import pytest

from orishell.numerics.equals import (
    ascending,
    classes,
    descending,
    first_largest,
    first_smallest,
    largest_along_first,
    largest_of,
    smallest_of,
)

ROUNDED = [np.array([120.0, -120.0]) * (1 + k * np.finfo(float).eps) for k in range(-3, 4)]


@pytest.mark.parametrize("first", ROUNDED, ids=str)
@pytest.mark.parametrize("second", ROUNDED, ids=str)
def test_whichever_way_two_are_rounded_the_first_is_taken(
    first: np.ndarray, second: np.ndarray
) -> None:
    values = np.array([0.0, first[0], abs(second[1]), 119.9])
    assert first_largest(values) == 1
    assert first_smallest(-values) == 1
    assert descending(values).tolist() == [1, 2, 3, 0]
    assert ascending(-values).tolist() == [1, 2, 3, 0]
    assert classes(values).tolist() == [0, 2, 2, 1]
    columns = np.array([[first[0], 0.0], [abs(second[1]), 1.0]])
    assert largest_along_first(columns).tolist() == [0, 1]
    assert largest_of("abc", dict(zip("abc", values[[3, 1, 2]], strict=True)).__getitem__) == "b"
    assert smallest_of("abc", dict(zip("abc", -values[[3, 1, 2]], strict=True)).__getitem__) == "b"


def test_what_is_larger_by_more_is_larger() -> None:
    """1e-8 is more than the share 1e-9."""
    assert first_largest([1.0, 1.0 + 1e-8]) == 1
    assert first_smallest([1.0, 1.0 - 1e-8]) == 1
    # A large value that is not chosen does not blur those that are.
    assert first_smallest([1e9, 0.5, 0.2]) == 2


def test_differences_are_equal_by_what_they_are_differences_of() -> None:
    noise = [3e-17, 0.0, -2e-17]
    assert first_smallest(noise) == 2
    assert first_smallest(noise, size=1.0) == 0
    assert first_largest(noise, near=1e-3, size=1e-9) == 0


def test_infinities_and_what_is_no_number() -> None:
    infinite = np.inf
    assert first_largest([1.0, infinite, infinite]) == 1
    assert first_smallest([infinite, infinite]) == 0
    assert first_largest([1.0, np.nan, infinite]) == 1  # as argmax
    assert ascending([infinite, 1.0, -infinite, infinite, np.nan]).tolist() == [2, 1, 0, 3, 4]
    assert classes([]).tolist() == []


def test_places_of_an_array_are_counted_along_its_rows() -> None:
    table = np.array([[0.0, 2.0], [2.0 + 1e-12, 1.0]])
    assert divmod(first_largest(table), 2) == (0, 1)
