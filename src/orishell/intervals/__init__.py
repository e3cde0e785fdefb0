"""Intervals: what functions and their derivatives can be while their variable is in a range."""

from orishell.intervals.elementary import FUNCTIONS, power_of
from orishell.intervals.enclosure import (
    Enclosure,
    spinning_acceleration,
    turning_acceleration,
)
from orishell.intervals.interval import Interval

__all__ = [
    "FUNCTIONS",
    "Enclosure",
    "Interval",
    "power_of",
    "spinning_acceleration",
    "turning_acceleration",
]
