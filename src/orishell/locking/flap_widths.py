"""How wide flaps may be: as wide as meet nothing before the target state."""

from __future__ import annotations

from collections.abc import Callable

from orishell.conventions.errors import DesignError
from orishell.conventions.formatting import rounded_down
from orishell.design import Design
from orishell.locking.clipped import flap_width
from orishell.locking.lock import find_lock
from orishell.numerics.bisection import largest_below

NARROWEST = 1e-3
"""Flaps narrower than this share of what was asked for are of no use."""
FINE = 1e-3
"""Accuracy of the widest flaps, relative to their width."""


def reaches_target(design: Design, tolerance: float, *, flaps_only: bool = False) -> bool:
    """Return whether no panels of a design meet before its target state.

    Parameters
    ----------
    tolerance
        Distance at which panels touch, relative to the diagonal of the flat sheet.
    flaps_only
        Look for contacts of the flaps only.
    """
    return not find_lock(design, tolerance=tolerance, flaps_only=flaps_only, beyond=False).early


def widest_flap(
    design: Design, narrower: Callable[[float], Design], tolerance: float, *, boards: bool = False
) -> float | None:
    """Return the largest width, below that of a design's flaps, at which no flap meets anything.

    Parameters
    ----------
    narrower
        Makes the design with flaps of another width (length); raises DesignError where it cannot.
    tolerance
        Distance at which panels touch, relative to the diagonal of the flat sheet.
    boards
        Look for contacts of all boards and panels, not of panels of the flaps only.
    """
    asked = flap_width(design)
    if asked <= 0:
        return None

    def works(width: float) -> bool:
        try:
            made = narrower(width)
        except DesignError:
            return False
        return reaches_target(made, tolerance, flaps_only=not boards)

    return largest_quotable(works, asked, NARROWEST, FINE)


def largest_quotable(
    works: Callable[[float], bool], most: float, smallest: float, accuracy: float
) -> float | None:
    """Return the largest value below ``most`` that works; None if none is found.

    It has the four digits that messages show, rounded down, if that works too.

    Parameters
    ----------
    works
        Whether a value works.
    most
        A value that does not.
    smallest
        The smallest share of it that is tried.
    accuracy
        To this share the value is found.
    """
    good = largest_below(works, most, smallest=smallest, relative=accuracy)
    if good is None:
        return None
    tidy = rounded_down(good)
    return tidy if works(tidy) else good
