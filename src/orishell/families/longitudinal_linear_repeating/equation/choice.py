"""Which solution of (4) a sheet is made of, and the nearest sector angles where there is none."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TypeVar

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import rounded
from orishell.families.longitudinal_linear_repeating.equation.solutions import (
    ANGLE_ROUNDING,
    NAMES,
    Sectors,
    Solution,
    find_solutions,
    is_free,
)
from orishell.families.pattern import Auto
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import bisect

APART = 0.02
"""Solutions are offered if c differs from that of the parallel strip, -1, by this."""
AUTO_SHARES = (1.0, 0.7, 0.5, 0.35, 0.25, 0.17, 0.12, 0.08, 0.05, 0.03, 0.02, 0.01)
"""Sector angles "auto" are the paper's, their deviations from 90 degrees reduced to such a share:
the smaller, the larger are the sheets that exist and the less the radius grows."""
EVEN_ENOUGH = 8.0
"""Sector angles "auto" are those farthest from 90 degrees whose longest inner crease is at most
this many times the shortest."""
AUTO_SECTORS = Remedy({"pattern.sector_deg": "auto"})
SMALLEST_ANGLE = 1e-4
"""Sector angles are looked for no nearer to 0 and 180 (degrees)."""

Made = TypeVar("Made")


def auto_sectors(share: float) -> Sectors:
    """The paper's (85, 80, 95, 100) degrees, with ``share`` times their distances from 90."""
    return Sectors.from_degrees(90 + share * np.array([-5.0, -10.0, 5.0, 10.0]))


def choose_sheet(
    sectors: Sectors | Auto,
    number: int,
    make: Callable[[Solution], Made],
    ratio: Callable[[Made], float],
) -> tuple[Solution, Made]:
    """A solution of given angles, or that farthest from 90 degrees which has a sheet; the sheet.

    ratio: The longest inner crease of a sheet over the shortest.
    """
    if sectors != "auto":
        solution = choose_solution(sectors, number)
        return solution, make(solution)
    failure: DesignError | None = None
    for share in AUTO_SHARES:
        solution = choose_solution(auto_sectors(share))
        try:
            made = make(solution)
        except DesignError as error:
            failure = error
            continue
        if ratio(made) <= EVEN_ENOUGH or share == AUTO_SHARES[-1]:
            return solution, made
    assert failure is not None
    raise failure


def choose_solution(sectors: Sectors, number: int = 0) -> Solution:
    """A solution by its number in :func:`find_solutions`; refuse angles or numbers without one."""
    solutions = find_solutions(sectors)
    if not solutions:
        raise no_solution(sectors)
    if number >= len(solutions):
        raise DesignError(
            f"equation (4) has no solution = {number} for these sector angles",
            keys=("pattern.solution",),
            size="it has one, number 0"
            if len(solutions) == 1
            else f"it has {len(solutions)}, numbers 0 to {len(solutions) - 1}",
            candidates=[Remedy({"pattern.solution": len(solutions) - 1})],
            excess=(number + 1) / len(solutions) - 1,
        )
    return solutions[number]


def no_solution(sectors: Sectors) -> DesignError:
    """The error that says why (4) has no solution, with the nearest angles that have one."""
    shown = ", ".join(f"{angle:.7g}" for angle in sectors.degrees)
    reason = "it has only the degenerate one, a strip of parallel columns"
    outside = find_solutions(sectors, inside=False)
    if outside:
        angles = [f"{angle:.4f}" for angle in outside[0].second.degrees]
        reason += f"; ({', '.join(angles)}) would solve it, but not all are between 0 and 180"
    if abs(sectors.gamma + sectors.delta) <= ANGLE_ROUNDING:
        reason = "gamma + delta = 180: two straight creases cross at an S vertex; only one can fold"
    elif max(abs(sectors.alpha), abs(sectors.beta)) <= ANGLE_ROUNDING:
        reason = "alpha = beta = 90: two straight creases cross at an F vertex; only one can fold"
    elif is_free(sectors):
        reason = "gamma = delta: every delta_2 solves it, so none is singled out"
    elif abs(sectors.gamma - sectors.delta) <= ANGLE_ROUNDING:
        reason = "gamma = delta: column 2 would not fold (c = 0)"
    return DesignError(
        f"equation (4) has no solution for the sector angles ({shown})",
        size=reason,
        candidates=_with_solution(sectors),
    )


def _with_solution(sectors: Sectors) -> Iterator[Remedy]:
    nearest = nearest_with_solution(sectors)
    if nearest:
        yield Remedy({"pattern.sector_deg": [rounded(angle, 7) for angle in nearest]})
    yield AUTO_SECTORS


def nearer_to_90(sectors: Array) -> Iterator[Remedy]:
    """Sector angles of smaller deviations (4,) to try, because larger sheets of them exist."""
    for share in (0.7, 0.5, 0.25, 0.1):
        angles = 90 + share * np.rad2deg(sectors)
        yield Remedy({"pattern.sector_deg": [rounded(float(angle), 6) for angle in angles]})
    yield AUTO_SECTORS


def nearest_with_solution(sectors: Sectors) -> list[float] | None:
    """The nearest sector angles (degrees) with a solution that differ in one angle only."""
    best: tuple[float, list[float]] | None = None
    start = np.clip(np.round(sectors.degrees, 4), SMALLEST_ANGLE, 180 - SMALLEST_ANGLE)
    for index in range(len(NAMES)):
        for sign in (1, -1):
            change = _smallest_change(start, index, sign, best[0] if best else 90.0)
            if change is not None:
                angles = start.copy()
                angles[index] += sign * change
                best = change, [float(angle) for angle in np.round(angles, 4)]
    return best[1] if best else None


def _smallest_change(start: np.ndarray, index: int, sign: int, limit: float) -> float | None:
    """The smallest change (degrees, below the limit) of one angle that gives a solution."""

    def works(change: float) -> bool:
        angles = start.copy()
        angles[index] = np.round(angles[index] + sign * change, 4)
        if not 0.01 < angles[index] < 179.99:
            return False
        solutions = find_solutions(Sectors.from_degrees(angles))
        return any(abs(solution.c + 1) > APART for solution in solutions)

    bad, good = 0.0, 0.01
    while not works(good):
        bad, good = good, 1.6 * good
        if good >= limit:
            return None
    good = bisect(works, good, bad, relative=1e-3, absolute=1e-4)
    return float(np.ceil(good * 1e4) / 1e4) if works(np.ceil(good * 1e4) / 1e4) else good
