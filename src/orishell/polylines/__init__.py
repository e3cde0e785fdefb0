"""Polylines that follow curves: staircases, zigzags, chords."""

from orishell.curves.nearest import Closeness
from orishell.polylines.chords import Chords, Placement, Spacing, measure_chords, place_chords
from orishell.polylines.closeness import (
    distances_to_polyline,
    measure_closeness,
    warn_of_coarse_row,
)
from orishell.polylines.staircase import Staircase, fit_staircase
from orishell.polylines.staircase_angles import (
    choose_theta,
    choose_xi,
    theta_interval,
    widest_angle,
    xi_limit,
)
from orishell.polylines.zigzag import (
    Zigzag,
    alternating,
    choose_depth,
    place_zigzag,
    place_zigzags,
    smallest_radius,
)

__all__ = [
    "Chords",
    "Closeness",
    "Placement",
    "Spacing",
    "Staircase",
    "Zigzag",
    "alternating",
    "choose_depth",
    "choose_theta",
    "choose_xi",
    "distances_to_polyline",
    "fit_staircase",
    "measure_chords",
    "measure_closeness",
    "place_chords",
    "place_zigzag",
    "place_zigzags",
    "smallest_radius",
    "theta_interval",
    "warn_of_coarse_row",
    "widest_angle",
    "xi_limit",
]
