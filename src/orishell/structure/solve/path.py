"""The path of equilibria under a growing load, by arc length: through limit points, too.

E. Riks, "An incremental approach to the solution of snapping and buckling problems", International
Journal of Solids and Structures 15 (1979); steps are measured by displacements alone, and
corrected on the plane that is square to the step as it is (E. Ramm, 1981).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.structure.mesh.corotational import Moved
from orishell.structure.solve.moving import Moving, Tangent

BALANCED = 1e-8
"""Forces in balance miss at most this share of the loads."""
TURNS, AIM = 14, 4
"""Newton's steps within a step of the path at most, and about how many tangents are wanted."""
KEPT = 0.1
"""A tangent, but not the first, which is at a guess, is used again as long as what is missing falls
to this share of what it was."""
NOISY = 1e-3
"""Step by step of the load, rounding excuses no more than this share of it."""
GROWTH, SHORTEST_STEP = 2.0, 1e-4
"""A step is at most so much longer than the last, and no shorter than this share of the first."""
TOUCHING = 1e-6
"""What bears at the start bears that of this factor of the loads."""
SETTLING = 30
"""Times that what bears without giving is taken over at the end, at most."""


@record
class Point:
    """A point of the path."""

    factor: float  # of the loads
    moved: Moved  # where the structure is
    negative: int  # in how many ways it would move on by itself
    residual: float  # what is missing in balance, as a share of the loads
    moving: Moving  # the structure, with what it remembers of the way there
    nudged: bool = False  # whether there is a nudge beside the loads


@record
class _Ahead:
    """Where a point is sought."""

    factor: float
    step: Array  # from the point before, of free dofs (n,)
    moved: Moved
    expected: list[Array | None]


def trace(
    moving: Moving,
    loads: Array,
    *,
    first: float,
    start: Point | None = None,
    nudge: Array | None = None,
    until: float = 1.0,
    done: Callable[[Sequence[Point]], bool] = lambda _: False,
    longest: float = np.inf,
) -> list[Point]:
    """Follow the path of a growing load to a factor of it.

    loads: Loads (D,) on all dofs, times 1.
    first: The factor that the first step is aimed at.
    start: Where the path is known to; None for the structure as designed.
    nudge: Loads (D,) beside these, with the same factor, that take the path off from those that are
    not stable; at its end they are left out. None for none.
    until: The factor at which the path ends.
    done: Whether the points so far are enough, though it has not come there.
    longest: A step is no longer than the first would be for so large a factor.
    Returns the points. The last has another factor than asked for if they were enough before, or
    Newton's steps end nowhere.
    """
    pull = (loads if nudge is None else loads + nudge)[moving.free]
    if start is None:
        start = Point(0.0, moving.start(), 0, 0.0, moving)
    points = [start]
    _, tangent = moving.tangent(start.moved)
    before = tangent.solve(pull)
    slope, tangent = before, tangent.unfactorised()
    unit = float(np.linalg.norm(before[moving.straight]))
    length = first * unit
    while not done(points):
        here = points[-1]
        stood = here.moving.settled(here.moved) if here.factor else moving
        way, found = _along(moving, slope, before), None
        while found is None and length > SHORTEST_STEP * first * unit:
            share = way * length
            moving = stood.grown((here.factor + share) / (here.factor or TOUCHING))
            step = share * slope
            ahead = _Ahead(
                here.factor + share, step, moving.after(here.moved, step), tangent.expected(step)
            )
            found = _corrected(moving, ahead, pull)
            if found is None:
                length *= 0.5
        if found is None:
            break
        point, gone, reached, tangents = found
        point = replace(point, nudged=nudge is not None)
        if here.factor < until <= point.factor:
            part = (until - here.factor) / (point.factor - here.factor)
            near = moving.after(here.moved, part * gone)
            last = settle(moving.grown(until / point.factor), near, loads, until)
            if last is None and length > SHORTEST_STEP * first * unit:
                length *= 0.5  # what bears changes on the way there: from nearer by
                continue
            points.append(last or point)
            break
        before, tangent = gone, reached
        points.append(point)
        slope, tangent = tangent.solve(pull), tangent.unfactorised()
        length = min(length * min(GROWTH, np.sqrt(AIM / tangents)), longest * unit)
    return points


def climb(
    moving: Moving,
    loads: Array,
    along: Array,
    *,
    first: float,
    until: float = 1.0,
    longest: float = np.inf,
) -> list[Point]:
    """Follow the path step by step of the load, where it depends on what went before: friction.

    along: How far it moves (n,) by linear theory.
    Other parameters are as for :func:`trace`. What does not give is taken over at every point.
    Returns the points, which end before a load that nothing was found in balance with.
    """
    points = [Point(0.0, moving.start(), 0, 0.0, moving)]
    step = first
    while points[-1].factor < until and step > SHORTEST_STEP * first:
        here = points[-1]
        factor = min(here.factor + step, until)
        stood = here.moving.settled(here.moved) if here.factor else moving
        grown = stood.grown(factor / (here.factor or TOUCHING))
        ahead = (factor - here.factor) * along
        expected = grown.tangent(here.moved)[1].expected(ahead)
        point = settle(grown, moving.after(here.moved, ahead), loads, factor, expected)
        if point is None:
            step *= 0.25
            continue
        points.append(point)
        step = min(GROWTH * step, longest)
    return points


def _along(moving: Moving, slope: Array, before: Array) -> float:
    """1 over the length of a slope (n,), with the sign that goes on from a step (n,) before."""
    own = slope[moving.straight]
    sign = 1.0 if own @ before[moving.straight] >= 0 else -1.0
    return float(sign / np.linalg.norm(own))


def _corrected(
    moving: Moving, ahead: _Ahead, pull: Array
) -> tuple[Point, Array, Tangent, int] | None:
    """The next point, the step (n,) and tangent there, and how many were; None without end."""
    scale, worst, used, before, tangents = moving.size(pull), np.inf, None, 0.0, 1
    for turn in range(1, TURNS + 1):
        forces, tangent = moving.tangent(ahead.moved, ahead.expected)
        rest = ahead.factor * pull - forces[moving.free]
        missing = (moving.size(rest) + tangent.other) / scale
        if missing <= BALANCED * abs(ahead.factor) + moving.noise(ahead.moved) / scale:
            point = Point(ahead.factor, ahead.moved, tangent.negative, missing, moving)
            return point, ahead.step, tangent, tangents
        if not np.isfinite(missing) or (turn > TURNS // 2 and missing > worst):
            return None
        if used is None or turn == 2 or missing > KEPT * before:
            used, tangents = tangent, tangents + 1
        worst, before = min(worst, missing), missing
        both = used.solve(np.stack([rest, pull], axis=1))
        across = ahead.step[moving.straight]
        along = across @ both[moving.straight, 1]
        change = -(across @ both[moving.straight, 0]) / along if along else 0.0
        correction = both[:, 0] + change * both[:, 1]
        ahead = _Ahead(
            ahead.factor + change,
            ahead.step + correction,
            moving.after(ahead.moved, correction),
            tangent.expected(correction),
        )
    return None


def settle(
    moving: Moving,
    near: Moved,
    loads: Array,
    factor: float,
    expected: list[Array | None] | None = None,
) -> Point | None:
    """Equilibrium under a factor of the loads, from nearby; None if Newton's steps do not end.

    What bears without giving is taken over until nothing gives.

    expected: Forces that parts are expected to have nearby.
    """
    least = BALANCED * abs(factor) * moving.size(loads[moving.free])
    point = _settled(moving, near, loads, factor, expected)
    for _ in range(SETTLING):
        if point is None or moving.missing(point.moved) <= least + moving.noise(point.moved):
            return point
        moving = moving.taken_over(point.moved)
        point = _settled(moving, point.moved, loads, factor, None)
    return None


def _settled(
    moving: Moving,
    moved: Moved,
    loads: Array,
    factor: float,
    expected: list[Array | None] | None,
) -> Point | None:
    pull = loads[moving.free]
    scale, before, used = moving.size(pull), 0.0, None
    for turn in range(1, 2 * TURNS + 1):
        forces, tangent = moving.tangent(moved, expected)
        rest = factor * pull - forces[moving.free]
        missing = (moving.size(rest) + tangent.other) / scale
        if not np.isfinite(missing):
            return None
        noise = min(moving.noise(moved) / scale, NOISY * abs(factor))
        if missing <= BALANCED * abs(factor) + noise:
            return Point(factor, moved, tangent.negative, missing, moving)
        if used is None or turn == 2 or missing > KEPT * before:
            used = tangent
        before, step = missing, used.solve(rest)
        moved, expected = moving.after(moved, step), tangent.expected(step)
    return None
