"""Where the motion of a design without a target ends: at the first contact, or at a given stage."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from orishell.design import Design
from orishell.errors import DesignError
from orishell.locking.lock import CONTACT_TOLERANCE, Lock, find_lock
from orishell.metrics import corrugation_depth
from orishell.quoting import in_degrees

DIGITS = 6
"""Digits of a stage that is offered, rounded down."""


def end_motion(
    design: Design,
    *,
    tolerance: float = CONTACT_TOLERANCE,
    allow_clash: bool = False,
    advanced: Callable[[float], None] | None = None,
) -> tuple[Design, Lock]:
    """Find how the motion of a design without a target ends, and end it there.

    Parameters
    ----------
    design
        The design.
    tolerance
        Distance at which panels touch, relative to the diagonal of the flat sheet.
    allow_clash
        Return a design whose panels meet before its stage, too.
    advanced
        Called with the share of the path that is done.

    Returns
    -------
    tuple
        The design, its motion ending where it is proved to be free of contact, up to 2^-36 of the
        path before panels first touch, if no stage was given; and how its motion ends.

    Raises
    ------
    DesignError
        If panels of the flat sheet touch, or panels meet before the stage: with the stage that
        can be reached.
    """
    lock = find_lock(design, tolerance=tolerance, advanced=advanced)
    contact = lock.first_contact
    if not lock.early or contact is None:
        return design, lock
    if design.stopped is not None and contact.clear_until > 0:
        design = design.stopped(contact.clear_until)
        end = design.mechanism.lock_drive
        depth = corrugation_depth(design.mechanism.positions(end))
        return design, replace(lock, target=end, depth=depth)
    if allow_clash:
        return design, lock
    first, second = (list(panel) for panel in contact.panels)
    if contact.clear_until == 0:
        raise DesignError(
            "panels of the flat sheet touch",
            place=f"panels {first} and {second}",
            nearest="a smaller contact_tolerance, or longer creases",
        )
    raise DesignError(
        f"panels {first} and {second} meet before the stage ({contact.kind})",
        place=f"at drive {in_degrees(contact.drive)} of {in_degrees(lock.target)} degrees",
        nearest=f'stage_deg = {_below(float(np.rad2deg(contact.clear_until)))}, or "auto"; '
        "--allow-clash writes it as it is",
    )


def _below(value: float) -> str:
    """A positive number rounded down to :data:`DIGITS` digits."""
    unit = 10.0 ** (np.floor(np.log10(value)) - DIGITS + 1)
    return f"{np.floor(value / unit) * unit:.{DIGITS}g}"
