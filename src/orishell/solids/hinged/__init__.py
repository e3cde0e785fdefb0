"""Whole boards on hinges that stand at heights of their own, for sheets that fold flat.

Derived in docs/theory/thickness.md.
"""

from orishell.solids.hinged.heights import find_hinges
from orishell.solids.hinged.meet import meet_target
from orishell.solids.hinged.offset import board_offsets

__all__ = ["board_offsets", "find_hinges", "meet_target"]
