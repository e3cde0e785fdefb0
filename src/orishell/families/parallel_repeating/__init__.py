"""Parallel repeating: f swept along g by rows of parallel creases and straight columns.

Derived in docs/theory/parallel-repeating.md.
"""

from orishell.families.parallel_repeating.mechanism import ParallelRepeating
from orishell.families.parallel_repeating.pattern import (
    ParallelRepeatingPattern,
    design_parallel_repeating,
)

__all__ = ["ParallelRepeating", "ParallelRepeatingPattern", "design_parallel_repeating"]
