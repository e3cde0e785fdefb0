"""Bisection: as near to the limit as promised, from the side that works, and from either side."""

from __future__ import annotations

import pytest

from orishell.numerics.bisection import bisect, bisect_integers, largest_below


@pytest.mark.parametrize("limit", [0.1234, 7.0, 99.9])
def test_floats_come_near_to_the_limit_from_the_working_side(limit: float) -> None:
    from_below = bisect(lambda value: value <= limit, 0.0, 100.0, relative=0.0, absolute=1e-6)
    from_above = bisect(lambda value: value >= limit, 100.0, 0.0, relative=1e-6)
    assert limit - 1e-6 <= from_below <= limit
    assert limit <= from_above <= limit * (1 + 1e-6)


@pytest.mark.parametrize("limit", [1, 6, 63])
def test_integers_find_the_last_that_works(limit: int) -> None:
    assert bisect_integers(lambda number: number <= limit, 1, 64) == limit
    assert bisect_integers(lambda number: number >= limit, 64, 0) == limit


def test_the_largest_below_may_be_small_but_not_too_small() -> None:
    found = largest_below(lambda value: value <= 0.003, 1.0, smallest=1e-3)
    assert found is not None
    assert 0.003 * (1 - 1e-3) <= found <= 0.003
    assert largest_below(lambda value: value <= 0.003, 1.0, smallest=1e-2) is None
    assert largest_below(lambda _: False, 0.0, smallest=1e-3) is None
