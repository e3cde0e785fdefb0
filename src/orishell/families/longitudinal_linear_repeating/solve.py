"""What four sector angles fold: all solutions of equation (4), their motions, sizes of sheets."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice
from typing import Any

from orishell.conventions.formatting import tidy_degrees
from orishell.families.longitudinal_linear_repeating.equation.choice import (
    no_solution,
)
from orishell.families.longitudinal_linear_repeating.equation.solutions import (
    Sectors,
    find_solutions,
)
from orishell.families.longitudinal_linear_repeating.motion.mechanism import crease_end
from orishell.families.longitudinal_linear_repeating.tessellation.columns import repeat_columns
from orishell.families.longitudinal_linear_repeating.tessellation.even_lengths import largest_square

SEARCHED = 60
"""Square sheets are looked for up to this size."""


def describe_solutions(sector_deg: Sequence[float]) -> dict[str, Any]:
    """List all solutions of equation (4) for alpha_1, beta_1, gamma_1, delta_1 in degrees.

    Parameters
    ----------
    sector_deg
        The four angles (degrees).

    Returns
    -------
    dict
        ``sector_deg`` and ``solutions``, each with version, second_sector_deg, c, motion_end_deg,
        largest_square (at most :data:`SEARCHED`, whose longest inner crease is at most a thousand
        times the shortest) and ``searched_up_to``.

    Raises
    ------
    InputError
        If an angle is not between 0 and 180 degrees.
    DesignError
        If there is no solution: with the nearest sector angles that have one.

    Examples
    --------
    >>> describe_solutions([85, 80, 95, 100])["solutions"][0]["largest_square"]
    35
    """
    sectors = Sectors.from_degrees(sector_deg)
    solutions = find_solutions(sectors)
    if not solutions:
        refusal = no_solution(sectors)
        refusal.remedies = tuple(islice(refusal.candidates, 1))  # these have a solution
        raise refusal
    entries = []
    for solution in solutions:
        columns = repeat_columns(solution, SEARCHED)
        entries.append(
            {
                "version": solution.version,
                "second_sector_deg": solution.second.degrees,
                "c": solution.c,
                "motion_end_deg": tidy_degrees(crease_end(columns, 2, "F")),
                "largest_square": largest_square(columns, "F", SEARCHED),
            }
        )
    return {
        "sector_deg": [float(angle) for angle in sector_deg],
        "searched_up_to": SEARCHED,
        "solutions": entries,
    }
