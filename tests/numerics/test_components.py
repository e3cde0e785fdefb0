"""Which things hang together, against SciPy."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from orishell.numerics.components import find_components
from samples import examples


@settings(max_examples=examples(100), deadline=None)
@given(st.integers(1, 200), st.integers(0, 300), st.integers(0, 2**32 - 1))
def test_components_are_those_of_scipy(count: int, joins: int, seed: int) -> None:
    """Of any graph: with things by themselves, loops, and pairs more than once."""
    pairs = np.random.default_rng(seed).integers(0, count, (joins, 2))
    graph = coo_array((np.ones(joins), pairs.T), shape=(count, count))
    assert find_components(pairs, count).tolist() == connected_components(graph)[1].tolist()


def test_a_chain_in_any_order_is_one() -> None:
    order = np.random.default_rng(1).permutation(5000)
    assert not find_components(np.stack([order[1:], order[:-1]], axis=1), 5000).any()
