"""Orthodiagonal: f swept along g by straight parallel columns and rows in planes square to them.

Derived in docs/theory/orthodiagonal.md.

Limit: the orthodiagonal family follows g in its middle row only. As a whole it approaches the
cylinder over f; ``deviation.approached`` in the report says how far the shell is from that, as
where f's plane is oblique.
"""

from orishell.families.orthodiagonal.mechanism import Orthodiagonal
from orishell.families.orthodiagonal.pattern import OrthodiagonalPattern, design_orthodiagonal

__all__ = ["Orthodiagonal", "OrthodiagonalPattern", "design_orthodiagonal"]
