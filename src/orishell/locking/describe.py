"""How a motion ends, in the words and units of the report."""

from __future__ import annotations

from typing import Any

from orishell.locking.lock import Contact, Lock
from orishell.quoting import in_degrees, tidy_degrees

BOUND = (
    "between two states a vector between two vertices stays within step**2/8 times a bound of its "
    "acceleration of the straight line"
)


def describe_lock(lock: Lock) -> dict[str, Any]:
    """The table ``lock`` of ``report.json``.

    Parameters
    ----------
    lock
        How the motion ends.
    """
    return {
        "drive_deg": None if lock.drive is None else tidy_degrees(lock.drive),
        "cause": lock.cause,
        "target_drive_deg": tidy_degrees(lock.target),
        "corrugation_depth": lock.depth,
        "first_contact": None if lock.first_contact is None else _describe(lock.first_contact),
        "touching_at_end": [[list(panel) for panel in pair] for pair in lock.touching],
        "path": None
        if lock.proof is None
        else {
            "states": lock.proof.states,
            "ranges": lock.proof.ranges,
            "tests": lock.proof.tests,
            "largest_step_deg": tidy_degrees(lock.proof.largest_step),
            "smallest_step_deg": tidy_degrees(lock.proof.smallest_step),
            "contact_tolerance": lock.proof.tolerance,
            "bound": BOUND,
        },
    }


def _describe(contact: Contact) -> dict[str, Any]:
    return {
        "drive_deg": tidy_degrees(contact.drive),
        "clear_until_deg": tidy_degrees(contact.clear_until),
        "panels": [list(panel) for panel in contact.panels],
        "kind": contact.kind,
        "corrugation_depth": contact.depth,
    }


def warn_of_lock(lock: Lock) -> list[str]:
    """Sentences a user should read: a clash before the target, or panels that touch at lock.

    Parameters
    ----------
    lock
        How the motion ends.
    """
    contact = lock.first_contact
    if lock.early and contact is not None:
        first, second = (list(panel) for panel in contact.panels)
        return [
            f"panels {first} and {second} meet at drive {in_degrees(contact.drive)} of "
            f"{in_degrees(lock.target)} degrees: the shell stops there, short of its target"
        ]
    if lock.touching:
        first, second = (list(panel) for panel in lock.touching[0])
        return [
            f"{len(lock.touching)} pairs of panels touch in the locked state that are not meant "
            f"to, for example {first} and {second}"
        ]
    return []
