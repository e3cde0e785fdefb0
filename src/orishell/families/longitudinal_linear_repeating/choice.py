"""Which solution of (4) a sheet is made of, and the nearest sector angles where there is none."""

from __future__ import annotations

from functools import cache

import numpy as np

from orishell.errors import DesignError
from orishell.families.longitudinal_linear_repeating.sectors import NAMES, Sectors
from orishell.families.longitudinal_linear_repeating.solutions import Solution, find_solutions

QUICK = 2001
"""Points of the scan while searching for inputs that have a solution."""
APART = 0.02
"""Solutions are offered if c differs from that of the parallel strip, -1, by this."""
AUTO_SHARES = (1.0, 0.7, 0.5, 0.35, 0.25, 0.17, 0.12, 0.08, 0.05, 0.03, 0.02, 0.01)
"""Sector angles "auto" are the paper's, their deviations from 90 degrees reduced to such a share:
the smaller, the larger are the sheets that exist and the less the radius grows."""

SMALLEST_ANGLE = 1e-4
"""Sector angles are looked for no nearer to 0 and 180 (degrees)."""


def auto_sectors(share: float) -> Sectors:
    """The paper's (85, 80, 95, 100) degrees, nearer to 90 by a share."""
    return Sectors.from_degrees(90 + share * np.array([-5.0, -10.0, 5.0, 10.0]))


@cache
def auto_solution(share: float) -> Solution:
    """The first solution for the sector angles that a share gives."""
    return choose_solution(auto_sectors(share))


def choose_solution(sectors: Sectors, number: int = 0) -> Solution:
    """A solution by its number in :func:`find_solutions`.

    Raises
    ------
    DesignError
        If there is no such solution: with the nearest sector angles that have one.
    """
    solutions = find_solutions(sectors)
    if not solutions:
        raise no_solution(sectors)
    if number >= len(solutions):
        raise DesignError(
            f"equation (4) has no solution = {number} for these sector angles",
            size="it has one, number 0"
            if len(solutions) == 1
            else f"it has {len(solutions)}, numbers 0 to {len(solutions) - 1}",
            nearest=f"solution = {len(solutions) - 1}",
        )
    return solutions[number]


def no_solution(sectors: Sectors) -> DesignError:
    """Why these sector angles fold nothing, and the nearest ones that fold."""
    shown = ", ".join(f"{angle:.7g}" for angle in sectors.degrees)
    alpha, beta, gamma, delta = np.abs(np.array(sectors.degrees))
    reason = "it has only the degenerate one, a strip of parallel columns"
    outside = find_solutions(sectors, inside=False)
    if outside:
        angles = [f"{angle:.4f}" for angle in outside[0].second.degrees]
        reason += f"; ({', '.join(angles)}) would solve it, but such sums close no panel"
    if abs(gamma + delta - 180) < 1e-6:
        reason = "gamma + delta = 180: both creases of an S vertex are straight and fold alone"
    elif abs(alpha + beta - 180) < 1e-6 and abs(alpha - beta) < 1e-6:
        reason = "alpha = beta = 90: both creases of an F vertex are straight and fold alone"
    elif max(alpha, beta, gamma, delta) - min(alpha, beta, gamma, delta) < 1e-6:
        reason = "all four are equal, so that every delta_2 solves it and none is singled out"
    nearest = nearest_with_solution(sectors)
    return DesignError(
        f"equation (4) has no solution for the sector angles ({shown})",
        size=reason,
        nearest="sector_deg = [" + ", ".join(f"{angle:.7g}" for angle in nearest) + "]"
        if nearest
        else "sector_deg = [85, 80, 95, 100]",
    )


def nearest_with_solution(sectors: Sectors) -> list[float] | None:
    """The angles (degrees) that differ least, and in one angle only, and have a solution."""
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
        solutions = find_solutions(Sectors.from_degrees(angles), points=QUICK)
        return any(abs(solution.c + 1) > APART for solution in solutions)

    bad, good = 0.0, 0.01
    while not works(good):
        bad, good = good, 1.6 * good
        if good >= limit:
            return None
    while good - bad > 1e-3 * good + 1e-4:
        middle = 0.5 * (good + bad)
        bad, good = (bad, middle) if works(middle) else (middle, good)
    return float(np.ceil(good * 1e4) / 1e4) if works(np.ceil(good * 1e4) / 1e4) else good
