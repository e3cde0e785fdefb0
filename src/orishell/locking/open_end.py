"""Where the motion of a design without a target ends: at the first contact, or at a given stage."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from orishell.design import Design
from orishell.errors import Remedy
from orishell.locking.flaps import clash
from orishell.locking.lock import CONTACT_TOLERANCE, Lock, find_lock
from orishell.metrics import corrugation_depth
from orishell.quoting import inside, rounded

DIGITS = 6
"""Digits of a stage that may be offered."""


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
    ClashError
        If panels of the flat sheet touch, or panels meet before the stage.
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
    error = clash(lock, "stage")
    if contact.clear_until > 0:
        near = inside(float(np.rad2deg(contact.clear_until)), 0.0)
        stages = (rounded(near, DIGITS), "auto")
        error.candidates = [Remedy({"pattern.stage_deg": stage}) for stage in stages]
    raise error
