"""How close a shell is to a surface, both ways.

Derived in docs/theory/deviation.md.
"""

from orishell.deviation.measure import (
    COARSE,
    SAMPLES,
    Deviation,
    Distances,
    drawn_shell,
    find_excess,
    locked_shell,
    measure_approach,
    measure_deviation,
    measure_distance,
)
from orishell.deviation.of_boards import SignedDistances, measure_points, measure_signed

__all__ = [
    "COARSE",
    "SAMPLES",
    "Deviation",
    "Distances",
    "SignedDistances",
    "drawn_shell",
    "find_excess",
    "locked_shell",
    "measure_approach",
    "measure_deviation",
    "measure_distance",
    "measure_points",
    "measure_signed",
]
