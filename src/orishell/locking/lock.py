"""Where the motion ends and what touches first: the proof that a shell locks as designed.

Why it is one: docs/theory/locking-and-clash.md.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.clash import PathContact, PathResult, ProofRecord, find_first_contact
from orishell.clash.bodies import opposite_panels
from orishell.clash.state import deepest_between
from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress, no_progress
from orishell.design import Design
from orishell.locking.boards import Corners, Met, cut_corners, prove_boards
from orishell.locking.clipped import clip_boards, find_crossing
from orishell.locking.in_pieces import first_contact_of_pieces
from orishell.locking.result import Cause, Contact, Lock
from orishell.locking.sheet import SHORT_OF_END, Sheet
from orishell.motion import corrugation_depth, diagonal
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.grid import Panel
from orishell.motion.hinges import piece_numbers
from orishell.motion.sizes import CONTACT_TOLERANCE
from orishell.numerics.arrays import Booleans
from orishell.solids import BuiltPanels, build_panels


def join_pieces(design: Design, built: BuiltPanels, tolerance: float) -> BuiltPanels:
    """Boards of pieces, corners at joints cut off so that they are apart where all are joined.

    built: The boards, proved to be apart in each piece: smaller ones are, too.
    tolerance: Distance at which boards touch (length).

    Raises DesignError if boards of two pieces reach into each other there.
    """
    rows = list(built.boards.hinges.joint_rows)
    if not rows:
        return built
    sheet = Sheet.of(design)
    mechanism, points = sheet.mechanism, sheet.points_at_target()
    elsewhere = np.ones((mechanism.grid.rows - 2, mechanism.grid.columns - 2), np.bool_)
    elsewhere[rows] = False
    opposite, vertices = opposite_panels(sheet.layout, elsewhere)
    corners = Corners(
        mechanism,
        slice(None),
        opposite,
        vertices,
        [sheet.target],
        panels_laid_flat(mechanism),
        lambda each: each.boards,
    )

    def look(built: BuiltPanels) -> Met:
        bodies = corners.bodies(built)
        found = deepest_between(bodies, points, tolerance, piece_numbers(built.boards))
        return Met.of(found, sheet.target, bodies)

    built, met = cut_corners(design, built, tolerance, look, lambda _: corners)
    if met.contact is not None and met.depth > tolerance:
        names = sheet.contact_of_boards(met.contact, built.boards).names
        raise _refused(built, names, met.depth)
    return built


WIDER = (1.1, 2.0)
"""By how much of what boards reach into each other the gap is made wider in what is offered."""


def _refused(built: BuiltPanels, names: tuple[str, str], depth: float) -> DesignError:
    gap = built.build.gap
    return DesignError(
        f"{names[0]} and {names[1]} reach into each other where their pieces are joined",
        place="at the target",
        keys=("panel.pieces",),
        size=f"by {depth:.4g}",
        candidates=[Remedy({"panel.gap": rounded(gap + share * depth)}) for share in WIDER],
        excess=depth / built.build.thickness,
    )


LATE, NARROW = 1 - 1e-3, 1e-4
"""A contact in this last part of the path is looked at with this share of the tolerance: panels
that still do not touch meet at the end, not before."""


def find_lock(
    design: Design,
    *,
    tolerance: float = CONTACT_TOLERANCE,
    flaps_only: bool = False,
    beyond: bool = True,
    progress: Progress = no_progress,
) -> Lock:
    """Return where a design's motion ends, and the first contact on the way there.

    Parameters
    ----------
    tolerance
        Distance at which panels touch, relative to the diagonal of the flat sheet.
    flaps_only
        Look for contacts of the flaps and their boards only.
    beyond
        Look for contacts beyond the target as well. Otherwise only :attr:`Lock.early` counts.

    Notes
    -----
    Where creases are folded flat at the end, panels beside them come as near as one likes before
    it: there the path is proved up to a millionth of it, and flaps count as touching within a
    ten-thousandth of the tolerance. So do other panels that come within the tolerance in the last
    thousandth only; if they touch at the end, they are named as touching there. Panels that so
    meet at the target end the motion there.
    """
    sheet = Sheet.of(design)
    size = tolerance * diagonal(sheet.mechanism.positions(0.0))
    if flaps_only and design.clipped is not None:
        lock = _end_without_clash(sheet, design, None, ())
    else:
        lock = _lock_of_panels(
            sheet, design, size, flaps_only=flaps_only, beyond=beyond, progress=progress
        )
    if design.clipped is not None and not lock.early:
        met = find_crossing(sheet.with_flaps(design.clipped), size)
        lock = replace(lock, clipped_contact=met and _at_target(met, lock))
    if design.panel is None or lock.early:
        return lock
    end = lock.closes_to if beyond else min(lock.closes_to, lock.target_drive)
    if flaps_only and design.clipped is not None:
        built = build_panels(design, end)
    else:
        only = _flap_panels(sheet) if flaps_only else None
        built, path = prove_boards(design, end, size, progress, only=only)
        lock = replace(lock, boards_proof=path.proof)
        if path.contact is not None:
            found = sheet.contact_of_boards(path.contact, built.bodies)
            lock = replace(lock, drive=found.drive, cause=_cause(found), first_contact=found)
    lock = replace(lock, built=built)
    if lock.early:
        return lock
    lock = replace(lock, built=join_pieces(design, built, size))
    if design.clipped is None:
        return lock
    built, met = clip_boards(design, sheet.with_flaps(design.clipped), built, size)
    return replace(lock, built=built, clipped_contact=met and _at_target(met, lock))


def _at_target(found: Contact, lock: Lock) -> Contact:
    """A contact of clipped flaps, whose sheet has another drive at the target than the shell's."""
    return replace(
        found,
        drive=lock.target_drive,
        clear_until=lock.target_drive,
        corrugation_depth=lock.corrugation_depth,
    )


def _lock_of_panels(
    sheet: Sheet,
    design: Design,
    size: float,
    *,
    flaps_only: bool,
    beyond: bool,
    progress: Progress,
) -> Lock:
    mechanism = sheet.mechanism

    def search(end: float, distance: float) -> PathResult:
        if design.in_pieces:
            return first_contact_of_pieces(mechanism, design.hinges, end, distance, progress)
        return find_first_contact(
            mechanism,
            end,
            distance,
            lenient=sheet.designed if sheet.folded_flat else None,
            only=_flap_panels(sheet) if flaps_only else None,
            progress=progress,
        )

    path = search(sheet.path_end if beyond else min(sheet.path_end, sheet.target), size)
    for meeting in (sheet.target, sheet.end):
        near = path.contact
        if near is None or not LATE * meeting < near.drive <= meeting:
            continue
        # Panels that meet there, however slowly, come within any tolerance before it.
        clear = meeting * (1 - SHORT_OF_END)
        closer = search(clear, NARROW * size)
        if closer.contact is None and meeting == sheet.end:
            path = closer
        elif closer.contact is None and (touching := sheet.touching(size)):
            found = sheet.contact(PathContact(meeting, clear, near.panels))
            return sheet.lock(meeting, "clash", found, closer.proof, touching)
    early = path.contact is not None and path.contact.drive < sheet.target
    flapped = sheet if design.clipped is None else sheet.with_flaps(design.clipped)
    touching = () if early else flapped.touching(size)
    if path.contact is None:
        return lock_without_clash(design, path.proof, touching)
    found = sheet.contact(path.contact)
    return sheet.lock(found.drive, _cause(found), found, path.proof, touching)


def _cause(found: Contact) -> Cause:
    """What ends a motion where two panels, or their boards, touch or are not proved apart."""
    if found.apart is not None:
        return "unproved"
    return "clash" if found.sides is None else "boards"


def lock_without_clash(
    design: Design,
    proof: ProofRecord | None = None,
    touching: tuple[tuple[Panel, Panel], ...] = (),
) -> Lock:
    """Return how the motion ends if no panels clash before: where a crease is folded flat.

    Parameters
    ----------
    proof
        How the path was examined, if it was.
    touching
        Pairs of panels that touch at lock without being meant to.
    """
    sheet = Sheet.of(design)
    lock = _end_without_clash(sheet, design, proof, touching)
    if design.panel is None or proof is not None:
        return lock
    return replace(lock, built=build_panels(design, lock.closes_to))


def _end_without_clash(
    sheet: Sheet,
    design: Design,
    proof: ProofRecord | None,
    touching: tuple[tuple[Panel, Panel], ...],
) -> Lock:
    if sheet.meeting is None:
        drive = None if sheet.stop is None else sheet.end
        return sheet.lock(drive, sheet.stop, None, proof, touching)
    flaps = bool(sheet.layout.flaps[sheet.meeting[0]])
    found = Contact(
        sheet.end,
        0.0 if proof is None else sheet.path_end,
        sheet.panels(sheet.meeting),
        "flap on flap" if flaps else "neighbours",
        corrugation_depth(design.mechanism.positions(sheet.end)),
    )
    return sheet.lock(sheet.end, "flaps" if flaps else "crease", found, proof, touching)


def _flap_panels(sheet: Sheet) -> Booleans:
    """Flaps (F,), and panels of the first and last column."""
    column = sheet.layout.names[:, 1]
    ends = (column == 0) | (column == sheet.mechanism.grid.columns - 2)
    return np.asarray(ends | sheet.layout.flaps)
