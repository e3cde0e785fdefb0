"""Bars cut to length: nothing overlaps, and how few there could be is known."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.conventions.errors import InputError
from orishell.workshop.bars import CutBars, cut_bars
from samples import examples


def cut(lengths: list[float], bar: float, kerf: float = 0.0) -> CutBars:
    return cut_bars(np.array(lengths, float), bar, kerf, "workshop.hinge_stock", "a hinge")


def test_by_hand() -> None:
    """Two of 1.2 m and two of 0.8 m fill two bars of 2 m; a cut of 3 mm asks for a third."""
    assert cut([1.2, 0.8, 0.8, 1.2], 2.0).count == 2
    sawn = cut([1.2, 0.8, 0.8, 1.2], 2.0, 0.003)
    assert (sawn.count, sawn.least) == (3, 3)
    # Three of 0.7 m have no two on a bar of 1.3 m, though their sum is 1.6 bars.
    assert (cut([0.7, 0.7, 0.7], 1.3).count, cut([0.7, 0.7, 0.7], 1.3).least) == (3, 3)
    assert cut([], 2.0).count == 0


@settings(max_examples=examples(200), deadline=None)
@given(
    st.lists(st.integers(1, 50), min_size=1, max_size=40),
    st.integers(50, 90),
    st.integers(0, 3),
)
def test_pieces_and_cuts_fit_their_bars(lengths: list[int], bar: int, kerf: int) -> None:
    """Exact in whole numbers; 11/9 of the fewest and one beside is Johnson's bound."""
    found = cut(list(map(float, lengths)), float(bar), float(kerf))
    for number in range(found.count):
        mine = np.array(lengths)[found.of == number]
        assert len(mine)
        assert mine.sum() + kerf * (len(mine) - 1) <= bar
    total = sum(lengths) + kerf * len(lengths)
    assert -(-total // (bar + kerf)) <= found.least <= found.count


@settings(max_examples=examples(40), deadline=None)
@given(st.lists(st.integers(1, 20), min_size=1, max_size=6), st.integers(20, 30))
def test_the_bound_is_below_the_best_of_all_ways(lengths: list[int], bar: int) -> None:
    """All ways to put six pieces on bars are tried."""
    count = len(lengths)
    ways = np.array(list(product(range(count), repeat=count)))
    loads = np.stack([((ways == k) * np.array(lengths)).sum(axis=1) for k in range(count)])
    fits = (loads <= bar).all(axis=0)
    fewest = int((loads[:, fits] > 0).sum(axis=0).min())
    found = cut(list(map(float, lengths)), float(bar))
    assert found.least <= fewest <= found.count <= 11 * fewest / 9 + 1


def in_lengths(lengths: list[float], bar: float, kerf: float = 0.0) -> CutBars:
    return cut_bars(np.array(lengths), bar, kerf, "workshop.hinge_stock", "a hinge", most=20)


def test_a_hinge_that_is_longer_than_its_bar_is_made_of_several() -> None:
    """By hand: 5 m of bars of 2 m are two bars and 1 m, beside which 0.9 m fit; 4 m are two."""
    found = in_lengths([0.9, 5.0, 4.0], 2.0)
    assert (found.count, found.least) == (5, 5)
    assert list(found.names()) == ["5", "1 to 2, 5", "3, 4"]
    assert list(in_lengths([1.0, 3.0], 2.0, 0.01).names()) == ["2", "1, 3"]
    with pytest.raises(InputError, match=r"longer than 20 times .* at least 0\.1001") as caught:
        in_lengths([2.00101], 0.1)
    assert caught.value.keys == ("workshop.hinge_stock",)
    assert in_lengths([2.00101], 0.1001).count == 20


@settings(max_examples=examples(100), deadline=None)
@given(
    st.lists(st.integers(1, 200), min_size=1, max_size=30),
    st.integers(10, 90),
    st.integers(0, 3),
)
def test_lengths_end_to_end_are_the_hinges(lengths: list[int], bar: int, kerf: int) -> None:
    """Exact in whole numbers: every bar once whole, or cut; their sum bounds how few there are."""
    found = in_lengths(list(map(float, lengths)), float(bar), float(kerf))
    whole = {
        number
        for first, many in zip(found.first.tolist(), found.whole.tolist(), strict=True)
        for number in range(first, first + many)
    }
    assert len(whole) == found.whole.sum()
    rests = np.array(lengths) - bar * found.whole
    assert ((rests > 0) & (rests <= bar)).all()
    for number in set(found.of.tolist()):
        assert number not in whole
        mine = rests[found.of == number]
        assert mine.sum() + kerf * (len(mine) - 1) <= bar
    assert whole | set(found.of.tolist()) == set(range(found.count))
    assert -(-sum(lengths) // bar) <= found.least <= found.count


def test_a_size_that_is_offered_is_enough() -> None:
    with pytest.raises(InputError, match=r"at least 2\.346") as caught:
        cut([2.34511, 0.5], 2.0)
    assert caught.value.keys == ("workshop.hinge_stock",)
    assert cut([2.34511, 0.5], 2.346).count == 2


def test_very_many_pieces_come_near_the_bound() -> None:
    """Creases of a sheet of 300 by 300, 180,000 pieces, in a second; 2 % more than the bound."""
    lengths = np.random.default_rng(1).uniform(0.2, 0.6, 180_000)
    found = cut_bars(lengths, 2.0, 0.003, "workshop.hinge_stock", "a hinge")
    assert found.count <= 1.03 * found.least
