"""What is known of a sheet before contact is looked for, and what contacts in it are called."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.clash import PathContact, ProofRecord, find_contacts
from orishell.conventions.record import record
from orishell.design import Design
from orishell.locking.result import Cause, Contact, Kind, Lock
from orishell.motion import Mechanism, corrugation_depth, drive_at_fold
from orishell.motion.boards import SIDES, Boards
from orishell.motion.grid import Panel
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.solids import drive_for_height

SHORT_OF_END = 1e-6
"""Where creases are folded flat at the end, the path is proved up to this share before it."""
FOLDED_FLAT = 1e-9
"""A crease whose fold angle is this near to pi is folded flat (radians)."""


@record
class Sheet:
    """What is known of a sheet before any contact is looked for."""

    mechanism: Mechanism
    target: float
    end: float
    folded_flat: Panel | None
    """Row and column of the panel above a row crease that is folded flat at the end."""
    stop: Cause | None
    """What stops the motion before a crease is folded flat."""
    meeting: Panel | None
    """Row and column of the panel above a row crease about which panels, or boards, meet there."""
    left: int = 0
    """Columns of panels left of column 0: flaps that are clipped on there."""

    @classmethod
    def of(cls, design: Design) -> Sheet:
        """The folding sheet of a design, flaps that are clipped on left out."""
        mechanism = design.mechanism.still
        end = drive_at_fold(mechanism, design.largest_fold)
        stop: Cause | None = "hinges" if end < mechanism.end_drive else None
        target, build = mechanism.target_drive, design.panel
        if mechanism.flap_columns and target < mechanism.end_drive and target <= end:
            # Boards of the flaps meet at the target, where the others have room.
            end, stop = target, "flaps"
        elif build is not None:
            limit = target
            if design.opens_from_pack:
                limit = drive_for_height(mechanism, build, end)
            end, stop = (limit, "boards") if limit < end else (end, stop)
        folds = np.abs(mechanism.fold_angles(end).row)
        if stop == "flaps":
            on_flap = np.isin(np.arange(folds.shape[1]), mechanism.flap_columns)
            meeting = np.where(on_flap, folds, 0.0).argmax()
            row, column = divmod(int(meeting), folds.shape[1])
            return cls(mechanism, target, end, None, stop, (row, column))
        places = np.argwhere(folds >= np.pi - FOLDED_FLAT)
        first = None if not len(places) else (int(places[0][0]), int(places[0][1]))
        return cls(mechanism, target, end, first, stop, first)

    def with_flaps(self, clipped: Mechanism) -> Sheet:
        """The sheet with the flaps that are clipped on at its target; its panels keep their names.

        Parameters
        ----------
        clipped
            The sheet with its flaps.
        """
        left = clipped.inner_columns.start
        return replace(self, mechanism=clipped, target=clipped.target_drive, left=left)

    @property
    def columns(self) -> int:
        """Number of columns of panels."""
        return self.mechanism.grid.columns - 1

    @property
    def path_end(self) -> float:
        """Up to where its path is examined (radians)."""
        return self.end if self.folded_flat is None else self.end * (1 - SHORT_OF_END)

    def lock(
        self,
        drive: float | None,
        cause: Cause | None,
        contact: Contact | None,
        proof: ProofRecord | None,
        touching: tuple[tuple[Panel, Panel], ...] = (),
    ) -> Lock:
        """How its motion ends."""
        depth = corrugation_depth(self.mechanism.positions(self.target))
        return Lock(drive, cause, contact, self.target, depth, touching, proof)

    def contact(self, found: PathContact) -> Contact:
        """The contact of two panels."""
        depth = corrugation_depth(self.mechanism.positions(found.drive))
        panels, kind = self.panels(found.panels), self.kind(found.panels)
        return Contact(found.drive, found.clear_until, panels, kind, depth)

    def contact_of_boards(self, found: PathContact, boards: Boards) -> Contact:
        """The contact of two boards."""
        assert found.bodies is not None
        panels, _, sides = zip(
            *sorted(
                (self.panel(number), body, SIDES[int(boards.sides[body])])
                for number, body in zip(found.panels, found.bodies, strict=True)
            ),
            strict=True,
        )
        depth = corrugation_depth(self.mechanism.positions(found.drive))
        return Contact(found.drive, found.clear_until, panels, "boards", depth, sides)

    def panel(self, number: int) -> Panel:
        """Row and column of a panel."""
        row, column = divmod(number, self.columns)
        return row, column - self.left

    def panels(self, numbers: tuple[int, int]) -> tuple[Panel, Panel]:
        """Row and column of two panels, in ascending order."""
        first, second = sorted(map(self.panel, numbers))
        return first, second

    def designed(self, pairs: tuple[Integers, Integers]) -> Booleans:
        """Pairs with a flap, of its own column or the next: they meet at lock by design."""
        first, second = (numbers % self.columns for numbers in pairs)
        return np.asarray(self.flapped(pairs) & (np.abs(first - second) <= 1))

    def flapped(self, pairs: tuple[Integers, Integers]) -> Booleans:
        """Pairs (P,) with a flap."""
        flaps = self.mechanism.flap_columns
        return np.asarray(
            np.isin(pairs[0] % self.columns, flaps) | np.isin(pairs[1] % self.columns, flaps)
        )

    def kind(self, numbers: tuple[int, int]) -> Kind:
        """What parts of the sheet two panels are."""
        places = [divmod(number, self.columns) for number in numbers]
        rows = self.mechanism.grid.rows - 1
        on_flap = [j in self.mechanism.flap_columns for _, j in places]
        if all(on_flap):
            return "flap on flap" if places[0][1] == places[1][1] else "opposite flaps"
        if any(on_flap):
            return "flap on panel"
        if any(i in (0, rows - 1) or j in (0, self.columns - 1) for i, j in places):
            return "at the sheet's edge"
        return "distant panels"

    def touching(self, tolerance: float) -> tuple[tuple[Panel, Panel], ...]:
        """Pairs of panels that touch at the target without being meant to."""
        faces = self.mechanism.grid.faces_vertices()
        pairs = find_contacts(self.points_at_target(), faces, tolerance)
        shared = (faces[pairs[:, 0]][:, :, None] == faces[pairs[:, 1]][:, None]).any(axis=(1, 2))
        pairs = pairs[~shared & ~self.designed((pairs[:, 0], pairs[:, 1]))]
        return tuple(self.panels((int(first), int(second))) for first, second in pairs)

    def points_at_target(self) -> Array:
        """Vertices (V, 3) at the target."""
        return self.mechanism.positions(self.target).reshape(-1, 3)
