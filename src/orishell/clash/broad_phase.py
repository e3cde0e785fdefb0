"""Broad phase: a binary tree over the panels, whose nodes are bounded along 13 directions.

The tree follows the sheet, so that no state needs a new one; in a state its nodes are bounded by
discrete oriented polytopes (26-DOPs: what they span along the directions). Panels are sorted along
a Morton curve; node k of a level has the nodes 2k and 2k+1 of the next one below it, and the lowest
level holds the panels, filled up with empty places.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers

Pairs = tuple[Integers, Integers]
"""Nodes of one level, or panels: firsts and seconds."""

DIRECTIONS = np.array([d for d in product((1.0, 0.0, -1.0), repeat=3) if d > (0.0, 0.0, 0.0)])
DIRECTIONS /= np.linalg.norm(DIRECTIONS, axis=-1, keepdims=True)
"""The 13 directions (13, 3) to faces, edges and corners of a cube, along which nodes are seen."""
CHUNK = 1 << 12
"""Pairs looked at in one go, so that they stay near the processor."""
SHORT_CHUNK = 1 << 10
"""The same, of pairs of which each has two dozen numbers."""


@record
class Extents:
    """Lower and upper ends (2**level, K) of the nodes of every level along K directions."""

    low: list[Array]
    high: list[Array]


@record
class PanelTree:
    """A binary tree over the panels of a sheet, the same in all states."""

    faces: Integers  # (F, 4)
    panels: Integers  # (2**depth,), the panel at every place of the lowest level, or -1

    @classmethod
    def over(cls, faces: Integers, places: Array) -> PanelTree:
        """Sort panels (F, 4) by their places (F, 2) or (F, 3) in the sheet."""
        order = np.argsort(_morton(places), kind="stable")
        panels = np.full(1 << max(0, int(np.ceil(np.log2(len(order))))), -1)
        panels[: len(order)] = order
        return cls(faces, panels)

    @property
    def depth(self) -> int:
        """Number of the lowest level; the root is level 0."""
        return len(self.panels).bit_length() - 1

    def enclosing(self, low: Array, high: Array) -> Extents:
        """Extents of all nodes, from the ends (F, K) of what the panels span."""
        filled = self.panels >= 0
        lows = [np.where(filled[:, None], low[self.panels], np.inf)]
        highs = [np.where(filled[:, None], high[self.panels], -np.inf)]
        for _ in range(self.depth):
            lows.append(lows[-1].reshape(-1, 2, low.shape[1]).min(axis=1))
            highs.append(highs[-1].reshape(-1, 2, high.shape[1]).max(axis=1))
        return Extents(lows[::-1], highs[::-1])

    def extents(self, points: Array, over: Array | None = None) -> Extents:
        """The 26-DOPs of all nodes in a state (V, 3).

        ``over`` is what panels with a thickness have on both sides (F, 3): normals as long as it.
        """
        views = (points @ DIRECTIONS.T)[self.faces]
        thick = 0.0 if over is None else np.abs(over @ DIRECTIONS.T)
        return self.enclosing(views.min(axis=1) - thick, views.max(axis=1) + thick)


def common_corners(faces: Integers, first: Integers, second: Integers) -> Booleans:
    """Which corners (P, 4, 4) of two panels (P,), rows of the first, are one vertex."""
    return np.asarray(faces[first][:, :, None] == faces[second][:, None, :])


def child_pairs(pairs: Pairs) -> Pairs:
    """The pairs of children of pairs of nodes, each pair once."""
    first, second = pairs
    apart = first != second
    a, b = first[apart], second[apart]
    same = first[~apart]
    return (
        np.concatenate([2 * a, 2 * a, 2 * a + 1, 2 * a + 1, 2 * same, 2 * same, 2 * same + 1]),
        np.concatenate([2 * b, 2 * b + 1, 2 * b, 2 * b + 1, 2 * same, 2 * same + 1, 2 * same + 1]),
    )


def selected(pairs: Pairs, which: Booleans | Integers) -> Pairs:
    """The pairs (P,) at which ``which`` (P,) is true, or those with these numbers."""
    return pairs[0][which], pairs[1][which]


def joined(pairs: Sequence[Pairs]) -> Pairs:
    """Several lists of pairs as one list."""
    if not pairs:
        return np.empty(0, np.int64), np.empty(0, np.int64)
    return np.concatenate([p[0] for p in pairs]), np.concatenate([p[1] for p in pairs])


def gaps(states: tuple[Extents, Extents], level: int, pairs: Pairs) -> Array:
    """Widest gap (P,) between two nodes along one of the directions in both states."""
    first, last = ((state.low[level], state.high[level]) for state in states)
    return body_gaps([first] if states[0] is states[1] else [first, last], pairs)


def body_gaps(states: Sequence[tuple[Array, Array]], pairs: Pairs) -> Array:
    """Widest gap (P,) between two bodies along one of the directions in both states.

    In each state they have lower and upper ends (B, K).
    """
    # Gaps above the first and below it are sums of two ends, for all directions at once.
    ends = [
        (np.concatenate([-high, low], axis=1), np.concatenate([low, -high], axis=1))
        for low, high in states
    ]

    def of(first: Integers, second: Integers) -> Array:
        found = [ours.take(first, axis=0) + theirs.take(second, axis=0) for ours, theirs in ends]
        nearest = found[0] if len(found) == 1 else np.minimum(*found)
        return np.asarray(nearest.max(axis=1))

    return in_chunks(of, *pairs, size=SHORT_CHUNK)


def in_chunks(
    function: Callable[..., Array], first: Integers, second: Integers, size: int = CHUNK
) -> Array:
    """Run a function of pairs over a few thousand of them at a time."""
    if len(first) <= size:
        return function(first, second)
    return np.concatenate(
        [function(first[k : k + size], second[k : k + size]) for k in range(0, len(first), size)]
    )


def _morton(places: Array) -> NDArray[np.uint64]:
    """Number (F,) of every place along a Z-shaped curve that keeps neighbours together."""
    low = places.min(axis=0)
    size = float(np.ptp(places, axis=0).max())
    bits = 20
    cells = ((places - low) * ((1 << bits) - 1) / (size or 1.0)).astype(np.uint64)
    number = np.zeros(len(places), dtype=np.uint64)
    dimensions = np.uint64(places.shape[1])
    for bit in range(bits):
        for axis in range(places.shape[1]):
            at = (cells[:, axis] >> np.uint64(bit)) & np.uint64(1)
            number |= at << (np.uint64(bit) * dimensions + np.uint64(axis))
    return number
