"""Whole boards on hinges that stand at heights of their own, for sheets that fold flat.

Derived in docs/theory/thickness.md.
"""

from orishell.solids.hinged.heights import find_hinges

__all__ = ["find_hinges"]
