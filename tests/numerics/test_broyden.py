"""Positive unknowns with which sizes are what is asked for."""

from __future__ import annotations

import numpy as np
import pytest

from orishell.numerics.arrays import Array
from orishell.numerics.broyden import MOST_TRIALS, Sizing


def box(unknowns: Array) -> Array:
    """Sizes that depend on others, with a part that does not grow: folds about curves."""
    x, y, z = unknowns
    return np.array([3 * x + 0.3, 2 * y + 0.2 * z, 2.4 * z + 0.1 * np.sqrt(x)])


@pytest.mark.parametrize("seed", range(20))
def test_sizes_near_those_of_the_beginning_take_a_few_trials(seed: int) -> None:
    wanted = np.random.default_rng(seed).uniform(0.6, 1.8, 3)
    sizing = Sizing(box, box(wanted), 1e-5)
    assert sizing.run(np.ones(3))
    assert sizing.found[0] == pytest.approx(wanted, rel=1e-4)
    assert sizing.trials <= 10


def test_a_room_under_an_arch_is_found_from_where_hardly_anything_is_clear() -> None:
    """Clear width at 2 m of half an ellipse, and its height: steep where it is hardly higher."""

    def room(unknowns: Array) -> Array | None:
        wide, high = 3.0 * unknowns[0], 2.02 * unknowns[1]
        if high <= 2:
            return None
        return np.array([wide * np.sqrt(1 - (2 / high) ** 2), high])

    sizing = Sizing(room, np.array([2.5, 2.4]), 1e-5)
    assert sizing.run(np.ones(2))
    found = room(sizing.found[0])
    assert found is not None
    assert np.abs(found - [2.5, 2.4]).max() <= 1e-5


def test_what_is_never_reached_ends_with_the_nearest() -> None:
    def limited(unknowns: Array) -> Array | None:
        return None if unknowns[0] > 1.5 else 2 * unknowns

    sizing = Sizing(limited, np.array([4.0]), 1e-5)
    assert not sizing.run(np.ones(1))
    assert sizing.trials <= MOST_TRIALS
    assert 2.8 < sizing.found[1][0] <= 3.0
