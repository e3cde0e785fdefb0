"""Where the motion ends and what touches first: the proof that a shell locks as designed.

Why it is one: docs/theory/locking-and-clash.md.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from orishell.clash import (
    PathContact,
    PathResult,
    ProofRecord,
    find_contacts,
    find_first_contact,
)
from orishell.conventions.progress import Progress, unwatched
from orishell.design import Design
from orishell.locking.boards import prove_boards
from orishell.locking.result import Cause, Contact, Kind, Lock, Panel
from orishell.motion import Mechanism, corrugation_depth, diagonal, drive_at_fold
from orishell.numerics.arrays import Booleans, Integers
from orishell.sheet.boards import SIDES, Boards
from orishell.sheet.grid import Grid
from orishell.solids import build_panels, drive_for_height

CONTACT_TOLERANCE = 1e-9
"""Distance at which panels touch, relative to the diagonal of the flat sheet."""
SHORT_OF_END = 1e-6
"""Where creases are folded flat at the end, the path is proved up to this share before it."""
LATE, NARROW = 1 - 1e-3, 1e-4
"""A contact in this last part of the path is looked at with this share of the tolerance: panels
that still do not touch meet at the end, not before."""
FOLDED_FLAT = 1e-9
"""A crease whose fold angle is this near to pi is folded flat (radians)."""


def find_lock(
    design: Design,
    *,
    tolerance: float = CONTACT_TOLERANCE,
    flaps_only: bool = False,
    beyond: bool = True,
    progress: Progress = unwatched,
) -> Lock:
    """Return where a design's motion ends, and the first contact on the way there.

    Parameters
    ----------
    tolerance
        Distance at which panels touch, relative to the diagonal of the flat sheet.
    flaps_only
        Look for contacts of the flaps only.
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
    lock = _lock_of_panels(design, tolerance, flaps_only, beyond, progress)
    if design.panel is None or lock.early or flaps_only:
        return lock
    mechanism = design.mechanism.still
    size = tolerance * diagonal(mechanism.positions(0.0))
    end = lock.pack if beyond else min(lock.pack, lock.target)
    built, path = prove_boards(design, end, size, progress)
    lock = replace(lock, built=built, boards_proof=path.proof)
    if path.contact is None:
        return lock
    found = _Sheet.of(design).contact_of_boards(path.contact, built.boards)
    return replace(lock, drive=found.drive, cause="boards", first_contact=found)


def _lock_of_panels(
    design: Design, tolerance: float, flaps_only: bool, beyond: bool, progress: Progress
) -> Lock:
    sheet = _Sheet.of(design)
    mechanism = sheet.mechanism
    size = tolerance * diagonal(mechanism.positions(0.0))

    def search(end: float, distance: float) -> PathResult:
        return find_first_contact(
            mechanism,
            end,
            distance,
            lenient=sheet.designed if sheet.folded_flat else None,
            only=_flap_panels(mechanism.grid) if flaps_only else None,
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
        elif closer.contact is None and (touching := sheet.touching(None, size)):
            found = sheet.contact(PathContact(meeting, clear, near.panels))
            return sheet.lock(meeting, "clash", found, closer.proof, touching)
    early = path.contact is not None and path.contact.drive < sheet.target
    touching = () if early else sheet.touching(design.clipped, size)
    if path.contact is None:
        return lock_without_clash(design, path.proof, touching)
    found = sheet.contact(path.contact)
    return sheet.lock(found.drive, "clash", found, path.proof, touching)


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
    sheet = _Sheet.of(design)
    lock = _end_without_clash(sheet, design, proof, touching)
    if design.panel is None or proof is not None:
        return lock
    return replace(lock, built=build_panels(design, lock.pack))


def _end_without_clash(
    sheet: _Sheet,
    design: Design,
    proof: ProofRecord | None,
    touching: tuple[tuple[Panel, Panel], ...],
) -> Lock:
    if sheet.folded_flat is None:
        drive = None if sheet.stop is None else sheet.end
        return sheet.lock(drive, sheet.stop, None, proof, touching)
    row, column = sheet.folded_flat
    flaps = column in sheet.mechanism.flap_columns
    found = Contact(
        sheet.end,
        0.0 if proof is None else sheet.path_end,
        ((row, column), (row + 1, column)),
        "flap on flap" if flaps else "neighbours",
        corrugation_depth(design.mechanism.positions(sheet.end)),
    )
    return sheet.lock(sheet.end, "flaps" if flaps else "crease", found, proof, touching)


@dataclass(frozen=True, slots=True, eq=False)
class _Sheet:
    """What is known of a sheet before any contact is looked for."""

    mechanism: Mechanism
    target: float
    end: float
    folded_flat: Panel | None
    """Row and column of the panel above a row crease that is folded flat at the end."""
    stop: Cause | None
    """What stops the motion before a crease is folded flat."""

    @classmethod
    def of(cls, design: Design) -> _Sheet:
        mechanism = design.mechanism.still
        end = drive_at_fold(mechanism, design.largest_fold)
        stop: Cause | None = "hinges" if end < mechanism.end_drive else None
        if design.panel is not None:
            limit = mechanism.target_drive
            if design.panel.reach == "pack":
                limit = drive_for_height(mechanism, design.panel.height, end)
            end, stop = (limit, "boards") if limit < end else (end, stop)
        flat = np.abs(mechanism.fold_angles(end).row) >= np.pi - FOLDED_FLAT
        places = np.argwhere(flat)
        first = None if not len(places) else (int(places[0][0]), int(places[0][1]))
        return cls(mechanism, mechanism.target_drive, end, first, stop)

    @property
    def columns(self) -> int:
        """Number of columns of panels."""
        return self.mechanism.grid.columns - 1

    @property
    def path_end(self) -> float:
        return self.end if self.folded_flat is None else self.end * (1 - SHORT_OF_END)

    def lock(
        self,
        drive: float | None,
        cause: Cause | None,
        contact: Contact | None,
        proof: ProofRecord | None,
        touching: tuple[tuple[Panel, Panel], ...] = (),
    ) -> Lock:
        depth = corrugation_depth(self.mechanism.positions(self.target))
        return Lock(drive, cause, contact, self.target, depth, touching, proof)

    def contact(self, found: PathContact) -> Contact:
        depth = corrugation_depth(self.mechanism.positions(found.drive))
        panels, kind = self.panels(found.panels), self.kind(found.panels)
        return Contact(found.drive, found.clear_until, panels, kind, depth)

    def contact_of_boards(self, found: PathContact, boards: Boards) -> Contact:
        """The contact of two boards."""
        assert found.bodies is not None
        panels, _, sides = zip(
            *sorted(
                (divmod(number, self.columns), body, SIDES[int(boards.sides[body])])
                for number, body in zip(found.panels, found.bodies, strict=True)
            ),
            strict=True,
        )
        depth = corrugation_depth(self.mechanism.positions(found.drive))
        return Contact(found.drive, found.clear_until, panels, "boards", depth, sides)

    def panels(self, numbers: tuple[int, int]) -> tuple[Panel, Panel]:
        first, second = sorted(divmod(number, self.columns) for number in numbers)
        return first, second

    def designed(self, pairs: tuple[Integers, Integers]) -> Booleans:
        """Pairs with a flap, of its own column or the next: they meet at lock by design."""
        first, second = (numbers % self.columns for numbers in pairs)
        flaps = self.mechanism.flap_columns
        flap = np.isin(first, flaps) | np.isin(second, flaps)
        return np.asarray(flap & (np.abs(first - second) <= 1))

    def kind(self, numbers: tuple[int, int]) -> Kind:
        panels = self.panels(numbers)
        rows = self.mechanism.grid.rows - 1
        on_flap = [j in self.mechanism.flap_columns for _, j in panels]
        if all(on_flap):
            return "flap on flap" if panels[0][1] == panels[1][1] else "opposite flaps"
        if any(on_flap):
            return "flap on panel"
        if any(i in (0, rows - 1) or j in (0, self.columns - 1) for i, j in panels):
            return "at the sheet's edge"
        return "distant panels"

    def touching(
        self, boards: Mechanism | None, tolerance: float
    ) -> tuple[tuple[Panel, Panel], ...]:
        """Pairs of panels that touch at the target without being meant to, with its flaps."""
        if boards is not None:
            flapped = replace(self, mechanism=boards, target=boards.target_drive)
            return flapped.touching(None, tolerance)
        faces = self.mechanism.grid.faces_vertices()
        points = self.mechanism.positions(self.target).reshape(-1, 3)
        pairs = find_contacts(points, faces, tolerance)
        shared = (faces[pairs[:, 0]][:, :, None] == faces[pairs[:, 1]][:, None]).any(axis=(1, 2))
        pairs = pairs[~shared & ~self.designed((pairs[:, 0], pairs[:, 1]))]
        return tuple(self.panels((int(first), int(second))) for first, second in pairs)


def _flap_panels(grid: Grid) -> Booleans:
    """Panels (F,) of the first and last column."""
    flags = np.zeros((grid.rows - 1, grid.columns - 1), np.bool_)
    flags[:, [0, -1]] = True
    return flags.ravel()
