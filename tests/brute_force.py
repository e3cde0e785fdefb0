"""Brute force, independent of the program: which panels cross, by libigl's exact predicates."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np

from orishell.motion import Mechanism
from orishell.motion.grid import Grid


def exact_contacts(positions: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Pairs (P, 2) of panels without a common vertex that cross or touch: no tolerance.

    Every panel is two triangles; libigl decides on all pairs of triangles in exact arithmetic.
    """
    import igl.predicates

    triangles = np.concatenate([faces[:, [0, 1, 2]], faces[:, [0, 2, 3]]])
    points = np.ascontiguousarray(positions.reshape(-1, 3))
    _, found, _ = igl.predicates.find_self_intersections(points, triangles)
    pairs = np.unique(np.sort(np.asarray(found).reshape(-1, 2) % len(faces), axis=1), axis=0)
    shared = (faces[pairs[:, 0]][:, :, None] == faces[pairs[:, 1]][:, None]).any(axis=(1, 2))
    return np.asarray(pairs[~shared])


def crosses(mechanism: Mechanism, drive: float, counts: Callable[[np.ndarray], np.ndarray]) -> bool:
    """Whether panels touch in a state; ``counts`` says which pairs (P, 2) are looked at."""
    pairs = exact_contacts(mechanism.positions(drive), mechanism.grid.faces_vertices())
    return bool(counts(pairs).any())


def first_crossing(
    mechanism: Mechanism,
    end: float,
    steps: int,
    counts: Callable[[np.ndarray], np.ndarray] = lambda pairs: np.ones(len(pairs), np.bool_),
) -> float | None:
    """Drive of the first crossing seen at so many steps, bisected to the last digits."""
    drives = np.linspace(0.0, end, steps + 1)
    for before, after in pairwise(drives):
        if crosses(mechanism, after, counts):
            low, high = float(before), float(after)
            while high - low > 1e-12 * end:
                middle = 0.5 * (low + high)
                low, high = (low, middle) if crosses(mechanism, middle, counts) else (middle, high)
            return high
    return None


def not_designed(grid: Grid) -> Callable[[np.ndarray], np.ndarray]:
    """Pairs other than a flap with its own column or the one beside it."""
    last = grid.columns - 2

    def counts(pairs: np.ndarray) -> np.ndarray:
        column = np.sort(pairs % (last + 1), axis=1)
        flap = (column[:, 0] == 0) | (column[:, 1] == last)
        return np.asarray(~(flap & (np.diff(column, axis=1)[:, 0] <= 1)))

    return counts


def distance_of_panels(one: np.ndarray, other: np.ndarray) -> float:
    """Least distance of two plane convex quads (4, 3), by minimisation over both.

    A convex quadratic program in the weights of the corners, solved by non-negative least squares
    (the sums of weights are held to 1 by a heavy row): nothing of the program's own is used.
    """
    from scipy.optimize import nnls

    size = max(np.ptp(one, axis=0).max(), np.ptp(other, axis=0).max())
    shift = one.mean(axis=0)
    a, b = (one - shift) / size, (other - shift) / size
    heavy = 1e4
    rows = np.concatenate([np.concatenate([a, -b]).T, heavy * np.repeat(np.eye(2), 4, axis=1)])
    weights, _ = nnls(rows, np.array([0.0, 0.0, 0.0, heavy, heavy]))
    first, second = weights[:4] / weights[:4].sum(), weights[4:] / weights[4:].sum()
    return float(size * np.linalg.norm(first @ a - second @ b))
