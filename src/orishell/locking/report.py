"""How the motion ends, in the report."""

from __future__ import annotations

from orishell.clash import ProofRecord
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.record import record
from orishell.locking import Cause, Contact, Kind, Lock

Panel = tuple[int, int]
BOUND = (
    "between two states a vector between two vertices stays within step**2/8 times a bound of its "
    "acceleration of the straight line"
)


@record
class ContactReport:
    """Two panels that touch.

    Parameters
    ----------
    drive_deg
        The drive angle at which they touch.
    clear_until_deg
        Up to here no panels touch, proved; 0 if the path was not examined.
    panels
        The two panels.
    kind
        Which parts of the sheet they belong to.
    corrugation_depth
        Depth of the corrugation there.
    sides
        Which boards of the panels touch, "top", "bottom" or, where panels are solid, "panel"; None
        if panels without a thickness do.
    overlap
        How far one reaches into the other, if they were looked at in one state only; None if they
        touch on the way.
    """

    drive_deg: float
    clear_until_deg: float
    panels: tuple[Panel, Panel]
    kind: Kind
    corrugation_depth: float
    sides: tuple[str, str] | None
    overlap: float | None


@record
class PathReport:
    """How contact was excluded along the whole path.

    Parameters
    ----------
    states, ranges, tests
        Numbers of states computed, ranges of the drive proved clear, and pairs of panels compared.
    largest_step_deg, smallest_step_deg
        The longest and the shortest of these ranges.
    contact_tolerance
        Distance at which panels touch (length).
    bound
        What the proof rests on, in words.
    """

    states: int
    ranges: int
    tests: int
    largest_step_deg: float
    smallest_step_deg: float
    contact_tolerance: float
    bound: str


@record
class LockReport:
    """How the motion ends.

    Parameters
    ----------
    drive_deg
        Where it ends; None if nothing ends it.
    cause
        What ends it.
    target_drive_deg
        Where the shell meets its target.
    corrugation_depth
        Mean distance of inner vertices from the line between those above and below, at the target.
    first_contact
        The panels that touch first, if any do.
    touching_at_end
        Pairs of panels that touch at the end of the motion and are not meant to.
    clipped_contact
        What flaps that are clipped on at the target meet there; None if nothing, or if there are
        none.
    path
        How contact was looked for; None if it was not.
    """

    drive_deg: float | None
    cause: Cause | None
    target_drive_deg: float
    corrugation_depth: float
    first_contact: ContactReport | None
    touching_at_end: tuple[tuple[Panel, Panel], ...]
    clipped_contact: ContactReport | None
    path: PathReport | None


def describe_lock(lock: Lock) -> LockReport:
    """How the motion ends."""
    return LockReport(
        drive_deg=None if lock.drive is None else tidy_degrees(lock.drive),
        cause=lock.cause,
        target_drive_deg=tidy_degrees(lock.target),
        corrugation_depth=lock.depth,
        first_contact=_describe(lock.first_contact),
        touching_at_end=lock.touching,
        clipped_contact=_describe(lock.clipped_contact),
        path=describe_path(lock.proof),
    )


def describe_path(proof: ProofRecord | None) -> PathReport | None:
    """How contact was looked for; None if it was not."""
    if proof is None:
        return None
    return PathReport(
        states=proof.states,
        ranges=proof.ranges,
        tests=proof.tests,
        largest_step_deg=tidy_degrees(proof.largest_step),
        smallest_step_deg=tidy_degrees(proof.smallest_step),
        contact_tolerance=proof.tolerance,
        bound=BOUND,
    )


def _describe(contact: Contact | None) -> ContactReport | None:
    if contact is None:
        return None
    return ContactReport(
        drive_deg=tidy_degrees(contact.drive),
        clear_until_deg=tidy_degrees(contact.clear_until),
        panels=contact.panels,
        kind=contact.kind,
        corrugation_depth=contact.depth,
        sides=contact.sides,
        overlap=contact.overlap,
    )
