"""Panels with a thickness, in the report."""

from __future__ import annotations

import numpy as np

from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.record import record
from orishell.design import Construction, Design
from orishell.locking import Lock
from orishell.locking.report import PathReport, describe_path
from orishell.solids import BuiltPanels, find_meetings, find_set_backs


@record
class MeetingReport:
    """Where boards of flaps meet at the target.

    Parameters
    ----------
    creases
        Number of row creases of flaps about which two boards meet.
    shortest, total
        Along how much of a crease they meet at least, and of all together.
    largest_play
        How far apart they are at most, where a gap sets them farther back.
    largest_turn_deg
        By how much a flap could fold further at most until they meet.
    """

    creases: int
    shortest: float
    total: float
    largest_play: float
    largest_turn_deg: float


@record
class PanelReport:
    """Panels as they are built.

    Parameters
    ----------
    construction, thickness, membrane, gap
        What they are made of.
    stop_deg
        By how much flaps stop short of folding flat.
    set_back_for_deg
        The drive up to which boards are set back.
    largest_fold_deg
        The largest fold angle of a crease on the way there.
    largest_setback
        How far boards stand back at most.
    boards
        Their number, those of clipped flaps included.
    corners_cut, largest_cut
        Number of vertices at which corners of boards are cut off, and how far at most.
    meeting
        Where boards of flaps meet at the target; None if there are none.
    path
        How contact of boards was looked for; None if it was not.
    """

    construction: Construction
    thickness: float
    membrane: float
    gap: float
    stop_deg: float
    set_back_for_deg: float
    largest_fold_deg: float
    largest_setback: float
    boards: int
    corners_cut: int
    largest_cut: float
    meeting: MeetingReport | None
    path: PathReport | None


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
