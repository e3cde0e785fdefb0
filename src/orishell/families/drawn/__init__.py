"""Drawn: sheets of quadrilaterals from their flat vertices, mountains and valleys.

Not in the paper. Derived in docs/theory/vertex.md.
"""

from orishell.families.drawn.decided import Decided, decide
from orishell.families.drawn.mechanism import DrawnSheet
from orishell.families.drawn.sheet import drawn_sheet

__all__ = ["Decided", "DrawnSheet", "decide", "drawn_sheet"]
