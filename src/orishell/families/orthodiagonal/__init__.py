"""Orthodiagonal: f swept along g by straight parallel columns and rows in planes square to them.

Derived in docs/theory/orthodiagonal.md.
"""

from orishell.families.orthodiagonal.design import design_orthodiagonal
from orishell.families.orthodiagonal.mechanism import Orthodiagonal

__all__ = ["Orthodiagonal", "design_orthodiagonal"]
