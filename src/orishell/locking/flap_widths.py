"""How wide flaps may be: as wide as meet nothing before the target state."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from orishell.conventions.formatting import rounded
from orishell.design import Design
from orishell.errors import DesignError, Remedy
from orishell.locking.clipped import flap_width
from orishell.locking.lock import find_lock
from orishell.locking.request import Request
from orishell.numerics.bisection import largest_below

NARROWEST = 1e-3
"""Flaps narrower than this share of what was asked for are of no use."""
FINE = 1e-3
"""Accuracy of the widest flaps, relative to their width."""


def reaches_target(request: Request, *, flaps_only: bool = False) -> bool:
    """Return whether a shell can be designed and no panels meet before its target state.

    Parameters
    ----------
    flaps_only
        Look for contacts of the flaps only.
    """
    try:
        design = request.designed()
    except DesignError:
        return False
    return not find_lock(
        design, tolerance=request.tolerance, flaps_only=flaps_only, beyond=False
    ).early


def widest_flap(request: Request, design: Design, *, boards: bool = False) -> float | None:
    """Return the largest width, below that of a design's flaps, at which no flap meets anything.

    Parameters
    ----------
    request, design
        What is asked for, and what was made of it.
    boards
        Look for contacts of all boards and panels, not of panels of the flaps only.
    """
    asked = flap_width(design)
    if asked <= 0:
        return None

    def works(width: float) -> bool:
        narrower = request.changed(Remedy({"pattern.flap": width}))
        return reaches_target(narrower, flaps_only=not boards)

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
    unit = 10.0 ** (np.floor(np.log10(good)) - 3)
    tidy = rounded(np.floor(good / unit) * unit)
    return tidy if works(tidy) else good
