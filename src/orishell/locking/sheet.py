"""What is known of a sheet before contact is looked for, and what contacts in it are called."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.clash import PathContact, ProofRecord
from orishell.clash.state import find_distant_contacts
from orishell.conventions.record import record
from orishell.design import Design
from orishell.locking.result import Cause, Contact, Kind, Lock
from orishell.motion import Mechanism, corrugation_depth, drive_at_fold
from orishell.motion.boards import SIDES, Boards
from orishell.motion.convex import ConvexParts
from orishell.motion.grid import Panel
from orishell.motion.layout import Layout, SlitFlaps, points_of
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.equals import first_largest
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
    folded_flat: bool
    """Whether a row crease is folded flat at the end."""
    stop: Cause | None
    """What stops the motion before a crease is folded flat."""
    meeting: tuple[int, int] | None
    """Numbers of the panels about a row crease that meet there, or whose boards do."""
    layout: Layout
    left: int = 0
    """Columns of panels left of column 0: flaps that are clipped on there."""

    @classmethod
    def of(cls, design: Design) -> Sheet:
        """The folding sheet of a design, flaps that are clipped on left out."""
        mechanism = design.mechanism.least_turning
        end = drive_at_fold(mechanism, design.largest_fold)
        stop: Cause | None = "hinges" if end < mechanism.end_drive else None
        target, build, layout = mechanism.target_drive, design.set_back, Layout.of(mechanism)
        if layout.flaps.any() and target < mechanism.end_drive and target <= end:
            # Boards of the flaps meet at the target, where the others have room.
            end, stop = target, "flaps"
        elif build is not None:
            limit = target
            if design.opens_from_pack:
                limit = drive_for_height(mechanism, build, end)
            end, stop = (limit, "boards") if limit < end else (end, stop)
        folds, pairs = _row_creases(mechanism, layout, end)
        if stop == "flaps":
            meeting = first_largest(np.where(layout.flaps[pairs[:, 0]], folds, 0.0))
            return cls(mechanism, target, end, False, stop, _both(pairs[meeting]), layout)
        flat = np.flatnonzero(folds >= np.pi - FOLDED_FLAT)
        first = _both(pairs[flat[0]]) if len(flat) else None
        return cls(mechanism, target, end, first is not None, stop, first, layout)

    def with_flaps(self, clipped: Mechanism) -> Sheet:
        """The sheet with the flaps that are clipped on at its target; its panels keep their names.

        Parameters
        ----------
        clipped
            The sheet with its flaps.
        """
        left = clipped.inner_columns.start
        target, layout = clipped.target_drive, Layout.of(clipped)
        return replace(self, mechanism=clipped, target=target, left=left, layout=layout)

    @property
    def path_end(self) -> float:
        """Up to where its path is examined (radians)."""
        return self.end * (1 - SHORT_OF_END) if self.folded_flat else self.end

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
        return Contact(found.drive, found.clear_until, panels, kind, depth, apart=found.apart)

    def contact_of_boards(self, found: PathContact, boards: Boards) -> Contact:
        """The contact of two boards."""
        assert found.bodies is not None
        panels, _, sides = zip(
            *sorted(
                (self.panel(number), body, boards.called(body) or SIDES[0])
                for number, body in zip(found.panels, found.bodies, strict=True)
            ),
            strict=True,
        )
        depth = corrugation_depth(self.mechanism.positions(found.drive))
        ends = found.drive, found.clear_until
        return Contact(*ends, panels, "boards", depth, sides, apart=found.apart)

    def panel(self, number: int) -> Panel:
        """Row and column of a panel."""
        row, column = self.layout.names[number].tolist()
        return row, column - self.left

    def panels(self, numbers: tuple[int, int]) -> tuple[Panel, Panel]:
        """Row and column of two panels, in ascending order."""
        first, second = sorted(map(self.panel, numbers))
        return first, second

    def designed(self, pairs: tuple[Integers, Integers]) -> Booleans:
        """Pairs with a flap, of its own column or the next: they meet at lock by design."""
        first, second = (self.layout.names[numbers, 1] for numbers in pairs)
        return np.asarray(self.flapped(pairs) & (np.abs(first - second) <= 1))

    def flapped(self, pairs: tuple[Integers, Integers]) -> Booleans:
        """Pairs (P,) with a flap."""
        return np.asarray(self.layout.flaps[pairs[0]] | self.layout.flaps[pairs[1]])

    def kind(self, numbers: tuple[int, int]) -> Kind:
        """What parts of the sheet two panels are."""
        places = self.layout.names[list(numbers)].tolist()
        last = self.mechanism.grid.rows - 2, self.mechanism.grid.columns - 2
        on_flap = self.layout.flaps[list(numbers)]
        if all(on_flap):
            return "flap on flap" if places[0][1] == places[1][1] else "opposite flaps"
        if any(on_flap):
            return "flap on panel"
        if any(i in (0, last[0]) or j in (0, last[1]) for i, j in places):
            return "at the sheet's edge"
        return "distant panels"

    def touching(self, tolerance: float) -> tuple[tuple[Panel, Panel], ...]:
        """Pairs of panels that touch at the target without being meant to."""
        parts = ConvexParts.of(self.mechanism)
        found = parts.panels[find_distant_contacts(self.points_at_target(), parts, tolerance)]
        pairs = np.unique(np.sort(found, axis=1), axis=0)
        pairs = pairs[~self.designed((pairs[:, 0], pairs[:, 1]))]
        return tuple(self.panels((int(first), int(second))) for first, second in pairs)

    def points_at_target(self) -> Array:
        """Vertices (V, 3) at the target."""
        return points_of(self.mechanism, self.target)


def _row_creases(mechanism: Mechanism, layout: Layout, drive: float) -> tuple[Array, Integers]:
    """Sizes of the fold angles (K,) of all row creases, and the panels (K, 2) about each."""
    folds = np.abs(mechanism.fold_angles(drive).row).ravel()
    across = mechanism.grid.columns - 1
    above = np.arange(len(folds))
    pairs = np.stack([above, above + across], axis=-1)
    if isinstance(mechanism, SlitFlaps):
        folds = np.concatenate([folds, np.abs(mechanism.flap_folds(drive))])
        pairs = np.concatenate([pairs, layout.pairs])
    return folds, pairs


def _both(pair: Integers) -> tuple[int, int]:
    first, second = pair.tolist()
    return first, second
