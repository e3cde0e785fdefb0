"""Crease patterns in files of other programs: FOLD, SVG and DXF."""

from orishell.io.patterns.pattern_file import PatternState, ReadPattern
from orishell.io.patterns.read import read_pattern

__all__ = ["PatternState", "ReadPattern", "read_pattern"]
