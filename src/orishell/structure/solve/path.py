"""The path of equilibria under a growing load, by arc length: through limit points, too.

E. Riks, "An incremental approach to the solution of snapping and buckling problems", International
Journal of Solids and Structures 15 (1979); steps are measured by displacements alone, and
corrected on a plane square to the last correction's direction (E. Ramm, 1981).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.structure.mesh.corotational import Moved
from orishell.structure.solve.moving import Factors, Moving

BALANCED = 1e-8
"""Forces in balance miss at most this share of the loads."""
TURNS, AIM = 12, 5
"""Newton's steps within a step of the path at most, and about how many are wanted."""
GROWTH, SMALLEST = 2.0, 1e-4
"""A step is at most so much longer than the last, and no shorter than this share of the first."""


@record
class Point:
    """A point of the path."""

    factor: float  # of the loads
    moved: Moved  # where the structure is
    negative: int  # in how many ways it would move on by itself
    residual: float  # what is missing in balance, as a share of the loads


def trace(
    moving: Moving,
    loads: Array,
    *,
    first: float,
    done: Callable[[Sequence[Point]], bool],
    longest: float = np.inf,
) -> list[Point]:
    """Follow the path from the structure as designed.

    loads: Loads (D,) on all dofs, times 1.
    first: The factor that the first step is aimed at.
    done: Whether the points so far are enough.
    longest: A step is no longer than that of so large a factor from the start.
    Returns the points: it ends before it is enough where Newton's steps end nowhere.
    """
    pull = loads[moving.free]
    scale = moving.size(pull)
    start = moving.start()
    _, tangent = moving.tangent(start)
    points = [Point(0.0, start, tangent.negative, 0.0)]
    before = tangent.solve(pull)
    unit = float(np.linalg.norm(before[moving.straight]))
    length = first * unit
    while not done(points):
        here = points[-1]
        _, tangent = moving.tangent(here.moved)
        slope = tangent.solve(pull)
        way = _along(moving, slope, before)
        found = None
        while found is None and length > SMALLEST * first * unit:
            step, share = way * length * slope, way * length
            ahead = moving.after(here.moved, step), tangent.expected(step)
            found = _corrected(moving, ahead, (here.factor + share, step), pull, scale)
            if found is None:
                length *= 0.5
        if found is None:
            break
        point, before, turns = found
        points.append(point)
        length = min(length * min(GROWTH, np.sqrt(AIM / turns)), longest * unit)
    return points


def _along(moving: Moving, slope: Array, before: Array) -> float:
    """1 over the length of a slope (n,), with the sign that goes on from a step (n,) before."""
    own = slope[moving.straight]
    sign = 1.0 if own @ before[moving.straight] >= 0 else -1.0
    return float(sign / np.linalg.norm(own))


def _corrected(
    moving: Moving,
    ahead: tuple[Moved, list[Array | None]],
    by: tuple[float, Array],
    pull: Array,
    scale: float,
) -> tuple[Point, Array, int] | None:
    """The next point, the step (n,) there and Newton's steps; None if they do not end.

    ahead: Where it is sought from, and forces expected there.
    by: Its factor, and the step (n,) there.
    """
    (moved, expected), (factor, step) = ahead, by
    worst = np.inf
    for turn in range(1, TURNS + 1):
        forces, factors = moving.tangent(moved, expected)
        rest = factor * pull - forces[moving.free]
        missing = moving.size(rest) / scale
        if missing <= BALANCED * abs(factor) + moving.noise(moved) / scale:
            return Point(factor, moved, factors.negative, missing), step, turn
        if not np.isfinite(missing) or (turn > TURNS // 2 and missing > worst):
            return None
        worst = min(worst, missing)
        both = factors.solve(np.stack([rest, pull], axis=1))
        across = step[moving.straight]
        along = across @ both[moving.straight, 1]
        change = -(across @ both[moving.straight, 0]) / along if along else 0.0
        correction = both[:, 0] + change * both[:, 1]
        factor, step = factor + change, step + correction
        moved, expected = moving.after(moved, correction), factors.expected(correction)
    return None


def settle(
    moving: Moving, near: Moved, loads: Array, factor: float, most: int = 2 * TURNS
) -> Point | None:
    """Equilibrium under a factor of the loads, from nearby; None if Newton's steps do not end."""
    pull = loads[moving.free]
    scale, moved, expected = moving.size(pull), near, None
    for _ in range(most):
        forces, factors = moving.tangent(moved, expected)
        rest = factor * pull - forces[moving.free]
        missing = moving.size(rest) / scale
        if not np.isfinite(missing):
            return None
        if missing <= BALANCED * abs(factor) + moving.noise(moved) / scale:
            return Point(factor, moved, factors.negative, missing)
        step = factors.solve(rest)
        moved, expected = moving.after(moved, step), factors.expected(step)
    return None
