"""What can be said of a crease pattern at once: vertices, motion, freedom, contact."""

from orishell.verification.pattern.in_strips import FoldingStrips
from orishell.verification.pattern.motion import FoldingMotion, Still
from orishell.verification.pattern.verdict import Findings, PatternVerdict, judge_pattern
from orishell.verification.pattern.vertices import VertexConditions

__all__ = [
    "Findings",
    "FoldingMotion",
    "FoldingStrips",
    "PatternVerdict",
    "Still",
    "VertexConditions",
    "judge_pattern",
]
