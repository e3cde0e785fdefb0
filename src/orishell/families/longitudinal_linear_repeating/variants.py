"""What four sector angles fold: all solutions of equation (4), their motions, sizes of sheets.

Only column 1 is made here: how near it comes to f does not depend on the columns beside it.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice
from typing import Any

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.conventions.formatting import tidy_degrees
from orishell.curves import Curve, trace_curve
from orishell.families.longitudinal_linear_repeating.equation.choice import (
    AUTO_SHARES,
    auto_sectors,
    choose_solution,
    no_solution,
)
from orishell.families.longitudinal_linear_repeating.equation.solutions import (
    Sectors,
    find_solutions,
)
from orishell.families.longitudinal_linear_repeating.motion.mechanism import crease_end
from orishell.families.longitudinal_linear_repeating.target import Profile
from orishell.families.longitudinal_linear_repeating.target_state import (
    TargetState,
    find_target_state,
)
from orishell.families.longitudinal_linear_repeating.tessellation.columns import repeat_columns
from orishell.families.longitudinal_linear_repeating.tessellation.even_lengths import largest_square
from orishell.polylines import measure_closeness

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


STAGE_SHARES = (1.1, 0.9, 1.2, 0.8, 1.05, 0.95, 1.3, 0.7, 1.4, 0.6)
"""Stages that are tried, as shares of the one at which column 1 turns as much as f."""


def open_sectors() -> list[list[float]]:
    """Sector angles (degrees) that "auto" chooses from: very near to 90, half way, the others."""
    apart = AUTO_SHARES[-3::-4]
    shares = (*apart, *(share for share in AUTO_SHARES if share not in apart))
    return [[float(angle) for angle in auto_sectors(share).degrees] for share in shares]


def open_stages(f: Curve, asked: dict[str, Any]) -> list[float]:
    """Stages to try (degrees); none where column 1 has no stage of its own."""
    try:
        own = _column(f, asked)[1].drive
    except DesignError:
        return []
    return [float(np.rad2deg(share * own)) for share in STAGE_SHARES]


def distance_from_f(f: Curve, asked: dict[str, Any]) -> float:
    """Distance of column 1 from f; refuse angles of which no column follows f."""
    profile, state = _column(f, asked)
    return measure_closeness(profile.trace, state.polygon).max


def _column(f: Curve, asked: dict[str, Any]) -> tuple[Profile, TargetState]:
    """Column 1 for arguments of the function that designs, sector angles among them."""
    profile = Profile.of(trace_curve(f, "f").in_own_frame())
    sectors, stage, lengths = (asked[key] for key in ("sectors", "stage", "column_lengths"))
    assert isinstance(sectors, Sectors)
    return profile, find_target_state(
        profile,
        repeat_columns(choose_solution(sectors, asked["solution"]), 2),
        asked["rows"],
        asked["first_row"],
        drive=None if stage == "auto" else stage,
        lengths=None if lengths == "auto" else np.array(lengths),
    )
