"""Panels with a thickness: how far boards stand back from their creases."""

from orishell.solids.boards import build_boards
from orishell.solids.built import Built, build_panels
from orishell.solids.limits import drive_for_height, largest_height
from orishell.solids.setbacks import SetBacks, find_set_backs, largest_folds

__all__ = [
    "Built",
    "SetBacks",
    "build_boards",
    "build_panels",
    "drive_for_height",
    "find_set_backs",
    "largest_folds",
    "largest_height",
]
