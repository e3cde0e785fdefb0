"""Panels with a thickness: how far boards stand back from their creases."""

from orishell.solids.boards import build_boards
from orishell.solids.limits import drive_for_height, largest_height
from orishell.solids.setbacks import SetBacks, find_set_backs, largest_folds

__all__ = [
    "SetBacks",
    "build_boards",
    "drive_for_height",
    "find_set_backs",
    "largest_folds",
    "largest_height",
]
