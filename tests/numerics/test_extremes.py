"""What is first among equals is the same on every processor."""

import numpy as np
import pytest

from orishell.numerics.extremes import first_largest, first_least
from samples import examples


@pytest.mark.parametrize("seed", range(examples(8)))
def test_rounding_does_not_decide_which_of_equals_is_taken(seed: int) -> None:
    """Values that repeat, each with an error of some last digits of its own."""
    rng = np.random.default_rng(seed)
    values = rng.permutation(np.repeat(rng.normal(size=5), 7)) * 10.0 ** rng.integers(-6, 7)
    rounded = values * (1 + rng.normal(scale=1e-15, size=values.shape))
    assert first_largest(rounded) == int(np.flatnonzero(values == values.max())[0])
    assert first_least(rounded) == int(np.flatnonzero(values == values.min())[0])


def test_what_differs_by_more_is_told_apart() -> None:
    assert first_largest([1.0, 1.0 + 1e-6, 1.0]) == 1
    assert first_least([[2.0, 1.0], [1.0 - 1e-6, 3.0]]) == 2


def test_values_that_are_left_out_are_infinite() -> None:
    assert first_least([np.inf, 2.0, 2.0 - 1e-15]) == 1
    assert first_largest([-np.inf, -2.0, -2.0 + 1e-15]) == 1
    assert first_largest([1.0, np.inf, np.inf]) == 1


def test_nothing_but_rounding_is_equal() -> None:
    """Distances of 0 but for rounding, beside others of the size of the shell."""
    assert first_least([3.0, 1e-17, 0.0, -1e-17]) == 1
