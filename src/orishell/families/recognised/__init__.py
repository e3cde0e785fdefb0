"""Which family a flat sheet of quadrilaterals belongs to, told from its sector angles alone."""

from orishell.families.recognised.family import NAMES, Recognised, misses, recognise

__all__ = ["NAMES", "Recognised", "misses", "recognise"]
