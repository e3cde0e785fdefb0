"""How a design is ended where panels meet too early: refused, stopped, or with narrower flaps."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from orishell.conventions.errors import ClashError, DesignError, Remedy
from orishell.conventions.formatting import in_degrees, inside, rounded, rounded_down
from orishell.conventions.progress import Progress, no_progress
from orishell.design import Design
from orishell.locking.clipped import refuse_clipped, require_uncrossed
from orishell.locking.lock import find_lock
from orishell.locking.result import Contact, Lock
from orishell.motion import corrugation_depth, largest_fold
from orishell.motion.sizes import CONTACT_TOLERANCE
from orishell.numerics.bisection import largest_below
from orishell.solids import build_panels

NARROWEST = 1e-3
"""Flaps narrower than this share of what was asked for are of no use."""
FINE, OF_BOARDS = 1e-3, 1e-2
"""Accuracy of the widest flaps, relative to their width, without and with a thickness."""


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
    design: Design, narrower: Callable[[float], Design], tolerance: float
) -> float | None:
    """Return the largest width, below that of a design's flaps, at which no flap meets anything.

    Their boards neither, where panels have a thickness.

    Parameters
    ----------
    narrower
        Makes the design with flaps of another width (length); raises DesignError where it cannot.
    tolerance
        Distance at which panels touch, relative to the diagonal of the flat sheet.
    """
    asked = design.flap
    if asked <= 0:
        return None

    def works(width: float) -> bool:
        try:
            made = narrower(width)
        except DesignError:
            return False
        return reaches_target(made, tolerance, flaps_only=True)

    fine = FINE if design.panel is None else OF_BOARDS
    return largest_quotable(works, asked, NARROWEST, fine)


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


NO_PACK = 1e-3
"""A motion that goes on beyond the target by less than this share is of no use."""
DIGITS = 6
"""Digits of a drive that may be offered for the target state."""


def end_motion(
    design: Design,
    *,
    tolerance: float = CONTACT_TOLERANCE,
    narrower: Callable[[float], Design] | None = None,
    allow_clash: bool = False,
    progress: Progress = no_progress,
) -> tuple[Design, Lock]:
    """Return the design, its flaps narrowed or its motion cut short if need be, and how it ends.

    If panels meet before the target state, a design whose motion nothing else ends is stopped
    there: where it is proved to be free of contact, up to 2^-36 of the path before panels first
    touch. Flaps of no given width are made narrower, clipped ones also where they have no room at
    the target.

    Parameters
    ----------
    tolerance
        Distance at which panels touch, relative to the diagonal of the flat sheet.
    narrower
        Makes the design with flaps of another width (length); None where their width is given.
    allow_clash
        Return the design even if panels meet before its target state.

    Raises
    ------
    DesignError
        If f crosses itself.
    ClashError
        If panels of the flat sheet touch, panels meet before the target state or are not proved
        not to, or clipped flaps meet panels there.
    """
    if not allow_clash:
        require_uncrossed(design)
    lock = find_lock(design, tolerance=tolerance, progress=progress)
    contact = lock.obstacle
    if contact is None:
        return design, lock
    if design.ending_at is not None and contact.clear_until > 0:
        design = design.ended_at(contact.clear_until)
        if design.panel is not None and lock.built is None:
            # Panels meet there, boards perhaps before.
            return end_motion(
                design, tolerance=tolerance, allow_clash=allow_clash, progress=progress
            )
        end = design.mechanism.target_drive
        depth = corrugation_depth(design.mechanism.positions(end))
        return design, replace(lock, target_drive=end, corrugation_depth=depth)
    if narrower is not None:
        width = widest_flap(design, narrower, tolerance)
        if width is not None:
            design = narrower(width)
            lock = find_lock(design, tolerance=tolerance, progress=progress)
    if lock.early and not allow_clash:
        raise _clash(design, lock)
    if lock.built is None and design.panel is not None:
        # Panels meet before: nobody has looked at boards.
        lock = replace(lock, built=build_panels(design, lock.target_drive))
    return design, lock


def require_pack(design: Design, lock: Lock) -> None:
    """Refuse a shell that is to be opened from a pack, and closes hardly beyond its target, if so.

    Raises
    ------
    DesignError
        If it does not.
    """
    if lock.closes_to > lock.target_drive * (1 + NO_PACK):
        return
    target, end = lock.target_drive, lock.closes_to
    beyond = f"it closes from {in_degrees(target)} to {in_degrees(end)} degrees: " * (end > target)
    # From the flat sheet, flaps are part of it unless something else is said.
    clipped = {} if design.clipped is None else {"deployment.flap_attachment": "clipped"}
    further = [Remedy({"deployment.largest_fold_deg": 180.0})] if lock.cause == "hinges" else []
    raise DesignError(
        f"the shell {'hardly closes' if end > target else 'does not close'} beyond its target, so "
        "that it cannot be opened from a pack",
        keys=("deployment.from",),
        size=beyond + _ends(lock) if lock.cause else "",
        candidates=[*further, Remedy({"deployment.from": "flat", **clipped})],
        excess=1 - (lock.closes_to / lock.target_drive - 1) / NO_PACK,
    )


def _ends(lock: Lock) -> str:
    """What keeps a motion from going on."""
    contact = lock.first_contact
    if contact is None:
        return "its hinges close no further" if lock.cause == "hinges" else "boards leave no room"
    first, second = contact.names
    if contact.apart is not None:
        return f"beyond, {first} and {second} are not proved not to meet"
    if lock.cause == "crease":
        return f"there {first} and {second} are folded onto each other"
    return f"there {first} and {second} meet ({contact.kind})"


def _clash(design: Design, lock: Lock) -> ClashError:
    """The error for panels that meet before the target state."""
    contact = lock.obstacle
    assert contact is not None
    if contact is lock.clipped_contact:
        return refuse_clipped(design, contact)
    aim = "stage" if design.swept is None else "target"
    if contact.apart is not None:
        return _not_proved(contact, contact.apart, lock.target_drive, aim)
    if contact.sides is not None:
        return _clash_of_boards(contact, lock.target_drive)
    first, second = (list(panel) for panel in contact.panels)
    if contact.drive == 0:
        return ClashError(
            "panels of the flat sheet touch",
            place=f"panels {first} and {second}",
            excess=1.0,
        )
    at, target = in_degrees(contact.drive), in_degrees(lock.target_drive)
    error = ClashError(
        f"panels {first} and {second} meet before the shell reaches its {aim} ({contact.kind})",
        place=f"at drive {at} of {target} degrees",
        size=f"the corrugation is {contact.corrugation_depth:.4g} deep there, "
        f"{lock.corrugation_depth:.4g} at the {aim}",
        excess=1 - contact.drive / lock.target_drive,
        flap=design.flap if "flap" in contact.kind else 0.0,
    )
    if design.swept is None and contact.clear_until > 0:
        clear = contact.clear_until
        if design.folded_by == "fold_deg":
            clear = float(largest_fold(design.mechanism, np.array([clear]))[0])
        key = f"pattern.{design.folded_by}"
        near = inside(float(np.rad2deg(clear)), 0.0)
        error.candidates = [Remedy({key: value}) for value in (rounded(near, DIGITS), "auto")]
    return error


def _not_proved(contact: Contact, apart: float, target: float, aim: str) -> ClashError:
    """The error where the proof ends before the target state, and no contact is seen."""
    first, second = contact.names
    clear, whole = in_degrees(contact.clear_until), in_degrees(target)
    return ClashError(
        f"it is not proved that the shell reaches its {aim} without contact: {first} and {second} "
        "may meet",
        place=f"beyond drive {clear} of {whole} degrees",
        size=f"they are {apart:.4g} apart there",
        excess=1 - contact.clear_until / target,
        thick=contact.sides is not None,
    )


def _clash_of_boards(contact: Contact, target: float) -> ClashError:
    """The error for boards that meet before the target state."""
    first, second = contact.names
    return ClashError(
        f"{first} and {second} meet before the shell reaches its target",
        place=f"at drive {in_degrees(contact.drive)} of {in_degrees(target)} degrees",
        size="panels without a thickness do not",
        excess=1 - contact.drive / target,
        thick=True,
    )
