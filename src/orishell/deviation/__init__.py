"""How close a shell is to a surface, both ways.

Derived in docs/theory/deviation.md.
"""

from orishell.deviation.locked import drawn_shell, locked_shell
from orishell.deviation.measure import (
    COARSE,
    SAMPLES,
    Deviation,
    Distances,
    find_excess,
    measure_approach,
    measure_deviation,
    measure_distance,
)
from orishell.deviation.signed import SignedDistances, measure_points, measure_signed

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
