"""Drawn: sheets of quadrilaterals from their flat vertices, mountains and valleys.

Not in the paper. Derived in docs/theory/vertex.md.
"""

from orishell.families.drawn.mechanism import DrawnSheet
from orishell.families.drawn.sheet import drawn_sheet

__all__ = ["DrawnSheet", "drawn_sheet"]
