"""Panels with a thickness, in the report."""

from __future__ import annotations

import numpy as np

from orishell.clash import ProofRecord
from orishell.conventions.record import Angle, record
from orishell.design import Construction, Design, Sides
from orishell.design.fittings import SHORT
from orishell.locking.result import Lock
from orishell.motion import Mechanism, area_of
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.boards import ARM, Boards
from orishell.motion.hinges import Hinges
from orishell.motion.layout import Layout
from orishell.motion.quads import signed_areas
from orishell.solids import BuiltPanels, FlapFolds, SideFolds, find_meetings, set_backs_of
from orishell.solids.hinged import board_offsets
from orishell.solids.hinged.joints import joint_openings
from orishell.solids.hinged.play import Play, find_play
from orishell.workshop.boards import chamfer_angles


@record
class MeetingReport:
    """Where boards of flaps meet at the target."""

    creases: int  # number of row creases of flaps about which two boards meet
    # along how much of a crease they meet at least, and of all together
    shortest: float
    total: float
    largest_play: float  # how far apart they are at most, where a gap sets them farther back
    largest_turn: Angle  # by how much a flap could fold further at most until they meet


@record
class PieceReport:
    """A piece that folds by itself."""

    # its first and last row of panels
    first_row: int
    last_row: int
    longest_arm: float


@record
class JointReport:
    """Where pieces are joined at the target."""

    creases: int  # number of creases along which there are joints, and no hinges
    largest_cut: float  # how far boards are cut back from them at most
    # how far boards are apart there, on the faces on which they close
    open_max: float
    open_rms: float


@record
class PlayReport:
    """What hinges beside their places ask of the others, in lengths by length of their errors."""

    target: Play  # at the target
    end: Play  # where boards fold no further: at the target, or in the pack


@record
class HingedReport:
    """Whole boards, their hinges and arms."""

    board_share: float  # the share of the sheet that boards cover
    # how far a hinge stands off a board at most, and on the mean of those that do
    longest_arm: float
    mean_arm: float
    arms: int  # number of fins that carry hinges
    arm_width: float  # how thick they are
    # how far corners of boards, half way up, lie at the target from those of the panels that meet
    # it, at most and root mean square; without a target from the sheet without a thickness
    offset_max: float
    offset_rms: float
    pieces: tuple[PieceReport, ...]  # one if the sheet is whole
    joints: JointReport | None  # None if the sheet is whole
    play: PlayReport  # what errors of hinges ask of the others


@record
class PanelReport:
    """Panels as they are built."""

    # what they are made of
    construction: Construction
    thickness: float
    membrane: float
    gap: float
    sides: Sides  # the faces of the flat sheet that boards of a membrane are on
    stop_deg: float  # by how much flaps stop short of folding flat
    set_back_for: Angle  # the drive up to which boards are set back
    largest_fold: Angle  # the largest fold angle of a crease on the way there
    largest_setback: float  # how far boards stand back at most
    # the least share of a panel that a board covers, on the face on which that is least; flaps that
    # are clipped on are left out
    least_share: float
    # how far a chamfer of solid panels leans from a square cut at most; None if there is none
    steepest_chamfer: Angle | None
    boards: int  # their number, those of clipped flaps and of strips of box girders included
    # number of vertices at which corners of boards are cut off, and how far at most
    corners_cut: int
    largest_cut: float
    # where boards of flaps meet at the target; None if there are none
    meeting: MeetingReport | None
    path: ProofRecord | None  # how contact of boards was looked for; None if it was not
    hinged: HingedReport | None = None  # whole boards on hinges; None for others


def describe_panels(design: Design, lock: Lock) -> PanelReport | None:
    """Panels as they are built; None if they have no thickness."""
    built = lock.built
    if built is None:
        return None
    build = built.build
    sides = SideFolds.of(Layout.of(design.mechanism), built.folds, built.beside)
    # Whole boards stand back by the gap alone.
    heights = (0.0, 0.0) if design.set_back is None else build.heights
    back = set_backs_of(sides, heights, build.gap)
    faces = zip((1, -1), (back.top, back.bottom), strict=True)
    longest = np.concatenate([found for face, found in faces if build.has_boards(face)])
    return PanelReport(
        construction=build.construction,
        thickness=build.thickness,
        membrane=build.membrane,
        gap=build.gap,
        sides=build.sides,
        stop_deg=design.stop_deg,
        set_back_for=built.limit,
        largest_fold=float(sides.largest.max()),
        largest_setback=float(longest[np.isfinite(longest)].max()),
        least_share=least_share(design.mechanism, built.boards),
        steepest_chamfer=steepest_chamfer(built),
        boards=sum(
            int((~each.arms).sum())
            for each in (built.boards, built.flaps, *(part.boards for part in design.carried))
            if each is not None
        ),
        corners_cut=int((built.reliefs > 0).sum()),
        largest_cut=float(built.reliefs.max()),
        meeting=_meeting(design, built),
        path=lock.boards_proof,
        hinged=_hinged(design, built),
    )


def least_share(mechanism: Mechanism, boards: Boards) -> float:
    """The least share of a panel that a board covers, at the height at which that is least."""
    boards = boards.chosen(~boards.arms)
    panels = signed_areas(panels_laid_flat(mechanism))[boards.panels]
    return float((signed_areas(boards.outlines[..., :2]).min(axis=1) / panels).min())


def steepest_chamfer(built: BuiltPanels) -> float | None:
    """How far a chamfer leans from a square cut at most (radians); None if there is none."""
    if built.build.construction != "bevel":
        return None
    each = [chamfer_angles(boards) for boards in (built.boards, built.flaps) if boards is not None]
    return float(np.deg2rad(np.concatenate(each).max(initial=0.0)))


def _hinged(design: Design, built: BuiltPanels) -> HingedReport | None:
    hinges = built.boards.hinges
    if not isinstance(hinges, Hinges):
        return None
    mechanism, arms = design.mechanism, built.boards.arms
    covered = float(built.boards.chosen(~arms).areas().sum())
    target = mechanism.positions(mechanism.target_drive)
    offsets = board_offsets(hinges, target, design.meant)
    long = np.concatenate([each.ravel() for each in hinges.arms])
    long = long[long - hinges.knuckle > SHORT * hinges.thickness]
    return HingedReport(
        board_share=covered / area_of(mechanism),
        longest_arm=hinges.longest_arm,
        mean_arm=float(long.mean()) if len(long) else 0.0,
        arms=int((built.boards.sides == ARM).sum()),
        arm_width=built.build.fin,
        offset_max=float(offsets.max()),
        offset_rms=float(np.sqrt((offsets**2).mean())),
        pieces=tuple(
            PieceReport(rows.start, rows.stop - 1, hinges.of_piece(rows).longest_arm)
            for rows in hinges.pieces
        ),
        joints=_joints(mechanism, built.boards),
        play=PlayReport(
            find_play(target, hinges.pieces),
            find_play(mechanism.positions(built.limit), hinges.pieces),
        ),
    )


def _joints(mechanism: Mechanism, boards: Boards) -> JointReport | None:
    if not boards.hinges.joint_rows:
        return None
    apart = joint_openings(mechanism, boards)
    return JointReport(
        creases=apart.size,
        largest_cut=float(np.max(boards.hinges.cut_back)),
        open_max=float(apart.max()),
        open_rms=float(np.sqrt((apart**2).mean())),
    )


def _meeting(design: Design, built: BuiltPanels) -> MeetingReport | None:
    sheet, folds, boards, beside = design.mechanism, built.folds, built.boards, built.beside
    if design.clipped is not None and built.flaps is not None:
        sheet, boards = design.clipped, built.flaps
        folds, beside = (
            sheet.fold_angles(sheet.target_drive),
            FlapFolds.at(sheet, sheet.target_drive),
        )
    found = find_meetings(sheet, built.build, folds, boards, beside)
    if not len(found.rows):
        return None
    return MeetingReport(
        creases=len(found.rows),
        shortest=float(found.lengths.min()),
        total=float(found.lengths.sum()),
        largest_play=float(np.maximum(found.plays, 0.0).max()),
        largest_turn=float(np.maximum(found.angles, 0.0).max()),
    )
