"""Panels with a thickness: how far boards stand back from their creases.

Derived in docs/theory/thickness.md.
"""

from orishell.solids.boards import build_boards
from orishell.solids.built import (
    BuiltPanels,
    Meetings,
    build_panels,
    find_meetings,
    settled_vertices,
)
from orishell.solids.setbacks import (
    SetBacks,
    drive_for_height,
    find_set_backs,
    largest_folds,
    set_backs_of,
    thickness_between,
)
from orishell.solids.sides import FlapFolds, SideFolds
from orishell.solids.thickness_limit import (
    ThicknessLimit,
    find_stop,
    find_thickness_limit,
    largest_thickness,
    limit_in_words,
    thinner,
    wide_gap,
)

__all__ = [
    "BuiltPanels",
    "FlapFolds",
    "Meetings",
    "SetBacks",
    "SideFolds",
    "ThicknessLimit",
    "build_boards",
    "build_panels",
    "drive_for_height",
    "find_meetings",
    "find_set_backs",
    "find_stop",
    "find_thickness_limit",
    "largest_folds",
    "largest_thickness",
    "limit_in_words",
    "set_backs_of",
    "settled_vertices",
    "thickness_between",
    "thinner",
    "wide_gap",
]
