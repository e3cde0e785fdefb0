"""Which panels touch: in one state, and first along a path of folding.

Derived in docs/theory/locking-and-clash.md.
"""

from orishell.clash.path import PathContact, PathResult, Proof, find_first_contact
from orishell.clash.state import find_contacts

__all__ = ["PathContact", "PathResult", "Proof", "find_contacts", "find_first_contact"]
