"""Differences of angles, Maekawa's condition and changes of sign, on any sheet."""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array, Booleans, Integers


def turn_between(first: Array, second: Array) -> Array:
    """The smaller turn from one angle to another, from 0 to pi, for arrays of angles (radians)."""
    return np.asarray(np.abs(np.mod(first - second + np.pi, 2 * np.pi) - np.pi))


def meets_maekawa(edges: Integers, signs: Array, vertex_count: int) -> Booleans:
    """Which vertices (V,) meet Maekawa's condition: as many mountains as valleys but for two.

    So a vertex with four creases that fold has three of one kind and one of the other, and one
    with unfolded creases has two of one kind.

    Parameters
    ----------
    edges
        Vertices (E, 2) of edges.
    signs
        Their signs (E,): +1 valley, -1 mountain, 0 neither.
    vertex_count
        Number of vertices.
    """
    total = np.bincount(edges.T.ravel(), np.tile(signs, 2), minlength=vertex_count)
    return np.asarray(np.abs(total) == 2)


class SignsSeen:
    """Which edges have been mountains and which valleys in the states so far."""

    def __init__(self, count: int) -> None:
        self.mountain = np.zeros(count, dtype=np.bool_)
        self.valley = self.mountain.copy()

    def see(self, signs: Array) -> Booleans:
        """Take in the signs (E,) of a state, and say which edges have had the opposite one."""
        changed = (signs > 0) & self.mountain | (signs < 0) & self.valley
        self.mountain |= signs < 0
        self.valley |= signs > 0
        return np.asarray(changed)
