"""Longitudinal linear repeating: a convex f swept along a line, its radius growing or shrinking.

Derived in docs/theory/longitudinal-linear-repeating.md.

Limit: the longitudinal family approaches a section whose radius grows along the line, not a
cylinder. It reaches only sheets whose rows do not meet; ``orishell solve`` names the largest.
"""

from orishell.families.longitudinal_linear_repeating.equation.solutions import (
    Sectors,
    Solution,
    find_solutions,
)
from orishell.families.longitudinal_linear_repeating.motion.mechanism import (
    LongitudinalLinearRepeating,
)
from orishell.families.longitudinal_linear_repeating.pattern import (
    LongitudinalPattern,
    design_longitudinal_linear_repeating,
)
from orishell.families.longitudinal_linear_repeating.solve import SEARCHED, describe_solutions
from orishell.families.longitudinal_linear_repeating.tessellation.columns import Coupling, RowKind

__all__ = [
    "SEARCHED",
    "Coupling",
    "LongitudinalLinearRepeating",
    "LongitudinalPattern",
    "RowKind",
    "Sectors",
    "Solution",
    "describe_solutions",
    "design_longitudinal_linear_repeating",
    "find_solutions",
]
