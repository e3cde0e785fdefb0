"""How the motion ends, and panels with a thickness, in the report."""

from __future__ import annotations

import numpy as np

from orishell.clash import ProofRecord
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.record import record
from orishell.design import Construction, Design
from orishell.locking import Cause, Contact, Kind, Lock
from orishell.solids import BuiltPanels, find_meetings, find_set_backs

Panel = tuple[int, int]
BOUND = (
    "between two states a vector between two vertices stays within step**2/8 times a bound of its "
    "acceleration of the straight line"
)


@record
class ContactReport:
    """Two panels that touch."""

    drive_deg: float  # the drive angle at which they touch
    clear_until_deg: float  # up to here no panels touch, proved; 0 if the path was not examined
    panels: tuple[Panel, Panel]  # the two panels
    kind: Kind  # which parts of the sheet they belong to
    corrugation_depth: float  # depth of the corrugation there
    # which boards of the panels touch, "top", "bottom" or, where panels are solid, "panel"; None if
    # panels without a thickness do
    sides: tuple[str, str] | None
    # how far one reaches into the other, if they were looked at in one state only; None if they
    # touch on the way
    overlap: float | None


@record
class PathReport:
    """How contact was excluded along the whole path."""

    # numbers of states computed, ranges of the drive proved clear, and pairs of panels compared
    states: int
    ranges: int
    tests: int
    # the longest and the shortest of these ranges
    largest_step_deg: float
    smallest_step_deg: float
    contact_tolerance: float  # distance at which panels touch (length)
    bound: str  # what the proof rests on, in words


@record
class LockReport:
    """How the motion ends."""

    drive_deg: float | None  # where it ends; None if nothing ends it
    cause: Cause | None  # what ends it
    target_drive_deg: float  # where the shell meets its target
    # mean distance of inner vertices from the line between those above and below, at the target
    corrugation_depth: float
    first_contact: ContactReport | None  # the panels that touch first, if any do
    # pairs of panels that touch at the end of the motion and are not meant to
    touching_at_end: tuple[tuple[Panel, Panel], ...]
    # what flaps that are clipped on at the target meet there; None if nothing, or if there are none
    clipped_contact: ContactReport | None
    path: PathReport | None  # how contact was looked for; None if it was not


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


@record
class MeetingReport:
    """Where boards of flaps meet at the target."""

    creases: int  # number of row creases of flaps about which two boards meet
    # along how much of a crease they meet at least, and of all together
    shortest: float
    total: float
    largest_play: float  # how far apart they are at most, where a gap sets them farther back
    largest_turn_deg: float  # by how much a flap could fold further at most until they meet


@record
class PanelReport:
    """Panels as they are built."""

    # what they are made of
    construction: Construction
    thickness: float
    membrane: float
    gap: float
    stop_deg: float  # by how much flaps stop short of folding flat
    set_back_for_deg: float  # the drive up to which boards are set back
    largest_fold_deg: float  # the largest fold angle of a crease on the way there
    largest_setback: float  # how far boards stand back at most
    boards: int  # their number, those of clipped flaps included
    # number of vertices at which corners of boards are cut off, and how far at most
    corners_cut: int
    largest_cut: float
    # where boards of flaps meet at the target; None if there are none
    meeting: MeetingReport | None
    path: PathReport | None  # how contact of boards was looked for; None if it was not


def describe_panels(design: Design, lock: Lock) -> PanelReport | None:
    """Panels as they are built; None if they have no thickness."""
    built = lock.built
    if built is None:
        return None
    build = built.build
    back = find_set_backs(built.folds, build.height, build.gap)
    longest = np.concatenate([back.top, back.bottom])
    return PanelReport(
        construction=build.construction,
        thickness=build.thickness,
        membrane=build.membrane,
        gap=build.gap,
        stop_deg=_stop_deg(design),
        set_back_for_deg=tidy_degrees(built.limit),
        largest_fold_deg=tidy_degrees(float(np.abs(built.folds.on_edges()).max())),
        largest_setback=float(longest[np.isfinite(longest)].max()),
        boards=len(built.boards) + (len(built.flaps) if built.flaps is not None else 0),
        corners_cut=int((built.reliefs > 0).sum()),
        largest_cut=float(built.reliefs.max()),
        meeting=_meeting(design, built),
        path=describe_path(lock.boards_proof),
    )


def _meeting(design: Design, built: BuiltPanels) -> MeetingReport | None:
    sheet, folds, boards = design.mechanism, built.folds, built.boards
    if design.clipped is not None and built.flaps is not None:
        sheet, boards = design.clipped, built.flaps
        folds = sheet.fold_angles(sheet.target_drive)
    found = find_meetings(sheet, built.build, folds, boards)
    if not len(found.rows):
        return None
    return MeetingReport(
        creases=len(found.rows),
        shortest=float(found.lengths.min()),
        total=float(found.lengths.sum()),
        largest_play=float(np.maximum(found.plays, 0.0).max()),
        largest_turn_deg=tidy_degrees(float(np.maximum(found.angles, 0.0).max())),
    )


def _stop_deg(design: Design) -> float:
    stop = design.parameters.get("stop_deg", 0.0)
    assert isinstance(stop, float | int)
    return stop
