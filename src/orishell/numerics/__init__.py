"""Interval arithmetic, elementary functions, bisection, and types of arrays."""

from orishell.numerics.elementary import FUNCTIONS, Elementary, Jet, power
from orishell.numerics.enclosure import (
    Enclosure,
    Interval,
    spinning_acceleration,
    turning_acceleration,
)

__all__ = [
    "FUNCTIONS",
    "Elementary",
    "Enclosure",
    "Interval",
    "Jet",
    "power",
    "spinning_acceleration",
    "turning_acceleration",
]
