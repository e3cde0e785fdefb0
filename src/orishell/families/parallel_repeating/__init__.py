"""Parallel repeating: f swept along g by rows of parallel creases and straight columns.

Derived in docs/theory/parallel-repeating.md.
"""

from orishell.families.parallel_repeating.design import design_parallel_repeating
from orishell.families.parallel_repeating.mechanism import ParallelRepeating

__all__ = ["ParallelRepeating", "design_parallel_repeating"]
