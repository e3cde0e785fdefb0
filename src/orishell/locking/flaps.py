"""How a design's motion ends, with flaps as wide as meet nothing."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import numpy as np

from orishell.design import Design
from orishell.errors import ClashError, DesignError, Remedy
from orishell.locking.lock import Lock, find_lock
from orishell.locking.request import Request
from orishell.quoting import in_degrees

Progress = Callable[[float], None]

NARROWEST = 1e-3
"""Flaps narrower than this share of what was asked for are of no use."""
FINE = 1e-3
"""To this share the widest flaps are found."""


def fit_flaps(
    request: Request,
    design: Design,
    *,
    allow_clash: bool = False,
    advanced: Progress | None = None,
) -> tuple[Design, Lock]:
    """Find how a design's motion ends, with narrower flaps if these may be chosen and must be.

    Parameters
    ----------
    request
        What is asked for.
    design
        What was made of it.
    allow_clash
        Return the design even if panels meet before it locks.
    advanced
        Called with the share of the path that is done.

    Raises
    ------
    ClashError
        If panels meet before it locks: which, and where.
    """
    lock = find_lock(design, tolerance=request.tolerance, advanced=advanced)
    if lock.early and request.pattern.flap == "auto":
        width = widest_flap(request, design)
        if width is not None:
            design = request.changed(Remedy({"pattern.flap": width})).designed()
            lock = find_lock(design, tolerance=request.tolerance, advanced=advanced)
    if lock.early and not allow_clash:
        raise clash(lock, "target", _width(design))
    return design, lock


def locks(request: Request, *, flaps_only: bool = False) -> bool:
    """Whether a shell can be made and meets nothing before its target.

    Parameters
    ----------
    request
        What is asked for.
    flaps_only
        Look for contacts of the flaps only.
    """
    try:
        design = request.designed()
    except DesignError:
        return False
    return not find_lock(design, tolerance=request.tolerance, flaps_only=flaps_only).early


def widest_flap(request: Request, design: Design) -> float | None:
    """The widest flaps below those of a design that meet nothing themselves.

    Parameters
    ----------
    request, design
        What is asked for, and what was made of it.
    """
    asked = _width(design)
    if asked <= 0:
        return None

    def works(width: float) -> bool:
        return locks(request.changed(Remedy({"pattern.flap": width})), flaps_only=True)

    return largest(works, asked, NARROWEST, FINE)


def largest(
    works: Callable[[float], bool], most: float, smallest: float, step: float
) -> float | None:
    """The largest value below the most that works, None if none down to a share of it does.

    Rounded down to the four digits that messages show if that works too.

    Parameters
    ----------
    works
        Whether a value works.
    most
        A value that does not.
    smallest
        The smallest share of it that is tried.
    step
        To this share the value is found.
    """
    good, bad = 0.5 * most, most
    while not works(good):
        good, bad = 0.5 * good, good
        if good < smallest * most:
            return None
    while bad - good > step * good:
        middle = 0.5 * (good + bad)
        good, bad = (middle, bad) if works(middle) else (good, middle)
    unit = 10.0 ** (np.floor(np.log10(good)) - 3)
    tidy = float(f"{np.floor(good / unit) * unit:.4g}")
    return tidy if works(tidy) else good


def _width(design: Design) -> float:
    width = design.parameters["flap"]
    assert isinstance(width, float | int)
    return float(width)


def clash(lock: Lock, aim: Literal["target", "stage"], flap: float = 0.0) -> ClashError:
    """The refusal of a motion that panels end.

    Parameters
    ----------
    lock
        How it ends.
    aim
        What it does not come to.
    flap
        Width of the flaps.
    """
    contact = lock.first_contact
    assert contact is not None
    first, second = (list(panel) for panel in contact.panels)
    if contact.drive == 0:
        return ClashError(
            "panels of the flat sheet touch",
            place=f"panels {first} and {second}",
        )
    at, target = in_degrees(contact.drive), in_degrees(lock.target)
    return ClashError(
        f"panels {first} and {second} meet before the shell reaches its {aim} ({contact.kind})",
        place=f"at drive {at} of {target} degrees",
        size=f"the corrugation is {contact.depth:.4g} deep there, {lock.depth:.4g} at the {aim}",
        flap=flap if "flap" in contact.kind else 0.0,
    )
