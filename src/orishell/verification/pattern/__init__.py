"""What can be said of a crease pattern at once: vertices, motion, freedom, contact."""

from orishell.verification.pattern.motion import FoldingMotion
from orishell.verification.pattern.verdict import PatternVerdict, judge_pattern
from orishell.verification.pattern.vertices import VertexConditions

__all__ = ["FoldingMotion", "PatternVerdict", "VertexConditions", "judge_pattern"]
