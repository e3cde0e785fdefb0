"""How a design is ended: refused, stopped, or with narrower flaps, where panels meet too early."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.formatting import in_degrees, inside, rounded
from orishell.conventions.progress import Progress, unwatched
from orishell.design import Design
from orishell.errors import ClashError, DesignError, Remedy
from orishell.locking.crossing import require_uncrossed
from orishell.locking.flap_widths import flap_width, widest_flap
from orishell.locking.lock import CONTACT_TOLERANCE, find_lock
from orishell.locking.request import Request
from orishell.locking.result import Contact, Lock
from orishell.motion import corrugation_depth
from orishell.solids import build_panels

NO_PACK = 1e-3
"""A motion that goes on beyond the target by less than this share is of no use."""
DIGITS = 6
"""Digits of a drive that may be offered for the target state."""


def end_motion(
    design: Design,
    request: Request | None = None,
    *,
    allow_clash: bool = False,
    progress: Progress = unwatched,
) -> tuple[Design, Lock]:
    """Return the design, its flaps narrowed or its motion cut short if need be, and how it ends.

    If panels meet before the target state, a design whose motion nothing else ends is stopped
    there: where it is proved to be free of contact, up to 2^-36 of the path before panels first
    touch. Flaps of no given width are made narrower.

    Parameters
    ----------
    request
        What the design was made from: says when panels touch, and whether flaps may be narrowed.
    allow_clash
        Return the design even if panels meet before its target state.

    Raises
    ------
    DesignError
        If f crosses itself.
    ClashError
        If panels of the flat sheet touch, or panels meet before the target state.
    """
    if not allow_clash:
        require_uncrossed(design)
    tolerance = CONTACT_TOLERANCE if request is None else request.tolerance
    lock = find_lock(design, tolerance=tolerance, progress=progress)
    contact = lock.first_contact
    if not lock.early or contact is None:
        return design, lock
    if design.ending_at is not None and contact.clear_until > 0:
        design = design.ended_at(contact.clear_until)
        if design.panel is not None and lock.built is None:
            # Panels meet there, boards perhaps before.
            return end_motion(design, request, allow_clash=allow_clash, progress=progress)
        end = design.mechanism.target_drive
        depth = corrugation_depth(design.mechanism.positions(end))
        return design, replace(lock, target=end, depth=depth)
    if request is not None and request.target is not None and request.pattern.flap == "auto":
        width = widest_flap(request, design, boards=contact.sides is not None)
        if width is not None:
            design = request.changed(Remedy({"pattern.flap": width})).designed()
            lock = find_lock(design, tolerance=tolerance, progress=progress)
    if lock.early and not allow_clash:
        raise _clash(design, lock)
    if lock.built is None and design.panel is not None:
        # Panels meet before: nobody has looked at boards.
        lock = replace(lock, built=build_panels(design, lock.target))
    return design, lock


def require_pack(design: Design, lock: Lock) -> None:
    """Refuse a shell that is to be opened from a pack, and does not close beyond its target.

    Raises
    ------
    DesignError
        If it does not.
    """
    if lock.pack > lock.target * (1 + NO_PACK):
        return
    contact = lock.first_contact
    # From the flat sheet, flaps are part of it unless something else is said.
    clipped = {} if design.clipped is None else {"deployment.flap_attachment": "clipped"}
    further = [Remedy({"deployment.largest_fold_deg": 180.0})] if lock.cause == "hinges" else []
    raise DesignError(
        "the shell does not close beyond its target, so that it cannot be opened from a pack",
        keys=("deployment.from",),
        size="" if contact is None else f"panels meet there ({contact.kind})",
        candidates=[*further, Remedy({"deployment.from": "flat", **clipped})],
        excess=1 - (lock.pack / lock.target - 1) / NO_PACK,
    )


def _clash(design: Design, lock: Lock) -> ClashError:
    """The error for panels that meet before the target state."""
    contact = lock.first_contact
    assert contact is not None
    if contact.sides is not None:
        return _clash_of_boards(contact, contact.sides, lock.target)
    first, second = (list(panel) for panel in contact.panels)
    if contact.drive == 0:
        return ClashError(
            "panels of the flat sheet touch",
            place=f"panels {first} and {second}",
            excess=1.0,
        )
    aim = "stage" if design.swept is None else "target"
    at, target = in_degrees(contact.drive), in_degrees(lock.target)
    error = ClashError(
        f"panels {first} and {second} meet before the shell reaches its {aim} ({contact.kind})",
        place=f"at drive {at} of {target} degrees",
        size=f"the corrugation is {contact.depth:.4g} deep there, {lock.depth:.4g} at the {aim}",
        excess=1 - contact.drive / lock.target,
        flap=flap_width(design) if "flap" in contact.kind else 0.0,
    )
    if design.swept is None and contact.clear_until > 0:
        near = inside(float(np.rad2deg(contact.clear_until)), 0.0)
        stages = (rounded(near, DIGITS), "auto")
        error.candidates = [Remedy({"pattern.stage_deg": stage}) for stage in stages]
    return error


def _clash_of_boards(contact: Contact, sides: tuple[str, str], target: float) -> ClashError:
    """The error for boards that meet before the target state."""
    first, second = (
        f"the {side} board of panel {list(panel)}"
        if side in {"top", "bottom"}
        else f"panel {list(panel)}"
        for panel, side in zip(contact.panels, sides, strict=True)
    )
    return ClashError(
        f"{first} and {second} meet before the shell reaches its target",
        place=f"at drive {in_degrees(contact.drive)} of {in_degrees(target)} degrees",
        size="panels without a thickness do not",
        excess=1 - contact.drive / target,
        thick=True,
    )
