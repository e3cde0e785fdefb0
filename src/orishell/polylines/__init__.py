"""Polylines that follow curves: numbers only."""

from orishell.polylines.chords import Spacing, place_vertices
from orishell.polylines.closeness import Closeness, measure_closeness
from orishell.polylines.staircase import Staircase, fit_staircase
from orishell.polylines.staircase_angles import choose_theta, choose_xi, theta_interval, xi_limit

__all__ = [
    "Closeness",
    "Spacing",
    "Staircase",
    "choose_theta",
    "choose_xi",
    "fit_staircase",
    "measure_closeness",
    "place_vertices",
    "theta_interval",
    "xi_limit",
]
