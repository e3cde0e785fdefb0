"""Which panels touch in one state, and which touch first as the sheet folds.

Derived in docs/theory/locking-and-clash.md.
"""

from orishell.clash.path import find_first_contact
from orishell.clash.ranges import PathContact, PathResult, ProofRecord
from orishell.clash.state import find_contacts, overlap_depths

__all__ = [
    "PathContact",
    "PathResult",
    "ProofRecord",
    "find_contacts",
    "find_first_contact",
    "overlap_depths",
]
