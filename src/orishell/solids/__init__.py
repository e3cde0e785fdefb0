"""Panels with a thickness: how far boards stand back from their creases.

Derived in docs/theory/thickness.md.
"""

from orishell.solids.boards import build_boards
from orishell.solids.built import BuiltPanels, build_panels, settled_vertices
from orishell.solids.limits import drive_for_height, largest_height
from orishell.solids.meeting import Meetings, find_meetings
from orishell.solids.setbacks import SetBacks, find_set_backs, largest_folds
from orishell.solids.stop import find_stop, largest_thickness
from orishell.solids.thickness_limit import (
    ThicknessLimit,
    find_thickness_limit,
    limit_in_words,
    thinner,
    wide_gap,
)

__all__ = [
    "BuiltPanels",
    "Meetings",
    "SetBacks",
    "ThicknessLimit",
    "build_boards",
    "build_panels",
    "drive_for_height",
    "find_meetings",
    "find_set_backs",
    "find_stop",
    "find_thickness_limit",
    "largest_folds",
    "largest_height",
    "largest_thickness",
    "limit_in_words",
    "settled_vertices",
    "thinner",
    "wide_gap",
]
