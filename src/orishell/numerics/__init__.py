"""Interval arithmetic, bisection, and types of arrays."""

from orishell.numerics.elementary import FUNCTIONS, power_of
from orishell.numerics.enclosure import (
    Enclosure,
    Interval,
    spinning_acceleration,
    turning_acceleration,
)

__all__ = [
    "FUNCTIONS",
    "Enclosure",
    "Interval",
    "power_of",
    "spinning_acceleration",
    "turning_acceleration",
]
