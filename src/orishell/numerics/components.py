"""Which things hang together."""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Integers


def find_components(pairs: Integers, count: int) -> Integers:
    """Numbers (count,), from 0, of the components that pairs (N, 2) of numbers join.

    They are in the order of the first of each.
    """
    first = np.arange(count)  # another of its component, or itself: in the end the first
    one, other = pairs.reshape(-1, 2).T
    while len(one):
        # The larger of two is joined to the smaller, and all then to the ends of their chains.
        np.minimum.at(first, np.maximum(one, other), np.minimum(one, other))
        while (first != (further := first[first])).any():
            first = further
        one, other = first[one], first[other]
        apart = one != other
        one, other = one[apart], other[apart]
    return np.asarray((first == np.arange(count)).cumsum()[first] - 1)
