"""Which things hang together."""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Integers


def find_components(pairs: Integers, count: int) -> Integers:
    """Numbers (count,), from 0, of the components that pairs (N, 2) of numbers join."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    graph = coo_array((np.ones(len(pairs), np.int8), pairs.T), shape=(count, count))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int64)
