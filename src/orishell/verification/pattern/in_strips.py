"""How a shell folds that is made in strips: in the closed form of the family it was known by."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from orishell.clash import PathResult, find_first_contact
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.quantities import quantity
from orishell.conventions.record import record
from orishell.conventions.row import Row
from orishell.io import ReadPattern
from orishell.motion.following.dofs import Freedom, least_count
from orishell.motion.following.followed import FREEDOM_AT
from orishell.motion.following.hinge_gaps import COORDINATE_ROUNDING
from orishell.motion.gridding import grid_creases
from orishell.motion.quads import corner_distances, diagonal_gaps
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_largest
from orishell.verification.pattern.motion import CLEAR_UNTIL, STATES, TOUCHING
from orishell.verification.pattern.on_grid import OnGrid
from orishell.verification.pattern.rows import of_freedom, reaches_as_proved
from orishell.verification.strips import Strips, find_strips

ENDS = "a row crease is folded flat; the other way edges of columns are level"
"""How its motion ends."""


@record
class FoldingStrips:
    """The motion of a shell in strips, from where edges of its columns are level."""

    strips: Strips
    tolerance: float  # allowed error of lengths (length)
    unit: str
    change: float  # by how much distances of a panel's corners change in its states (length)
    freedom: tuple[Freedom, ...]  # degrees of freedom in some of them
    proof: PathResult  # what is proved of contact, panels by their numbers in the file
    # by how much the file's own states change these, and bend panels, at most (length)
    kept: Array

    @property
    def degrees_of_freedom(self) -> int | None:
        """The least of all states looked at; None if they differ, or no gap tells."""
        return least_count(self.freedom)

    @property
    def proved_clear(self) -> float:
        """The drive up to which it is proved that no panels meet (radians)."""
        contact = self.proof.contact
        return CLEAR_UNTIL if contact is None else contact.clear_until

    def rows(self) -> Iterator[Row]:
        """All rows."""
        known = self.strips.known
        yield Row("holds", "sheet", self.strips.sheet)
        yield Row("says", "family", self.strips.family)
        said = f"distances of corners stay to {self._share(self.change)} in {STATES} states"
        if known.miss <= COORDINATE_ROUNDING * self.strips.diagonal:
            yield Row("holds", "folds", f"rigidly, exactly as t-hedral shells do: {said}")
        else:
            miss = quantity(known.miss, self.unit, 2)
            near = f"as the t-hedral shell does whose vertices are within {miss}"
            yield Row("holds", "folds", f"rigidly, to the tolerance: {near}; there {said}")
        yield of_freedom(self.freedom)
        yield reaches_as_proved(
            float(np.pi), ENDS, self.proved_clear, self.proof.contact, self.unit
        )
        if len(self.kept) > 1:
            worst = first_largest(self.kept)
            most = quantity(float(self.kept[worst]), self.unit, 2)
            many = f"{len(self.kept)} states"
            if self.kept[worst] <= self.tolerance:
                yield Row("holds", "shape", f"panels keep theirs in {many}, to {most}")
            else:
                said = f"panels change theirs: in state {worst + 1} of {many} by {most}"
                yield Row("fails", "shape", said)

    def as_dict(self) -> dict[str, Any]:
        """The figures of its motion, as reports have them."""
        contact = self.proof.contact
        return {
            "strips": self.strips.known.strips,
            "family": "t-hedral",
            "miss": self.strips.known.miss,
            "change": self.change,
            "now_deg": tidy_degrees(self.strips.known.mechanism.target_drive),
            "proved_clear_to_deg": tidy_degrees(self.proved_clear),
            "first_contact": [] if contact is None else list(contact.panels),
        }

    def _share(self, length: float) -> str:
        return f"{length / self.strips.diagonal:.1g} of the diagonal"


def find_folding_strips(
    read: ReadPattern, tolerance: float, progress: Progress = no_progress
) -> FoldingStrips | None:
    """Find how a file's panels fold that have no flat sheet; None if they are no strips we know.

    Parameters
    ----------
    tolerance
        Allowed error of lengths, as a share of the diagonal.
    """
    states = [state.positions for state in read.states]
    strips = find_strips(states, read.faces, read.edges, read.edge_faces, tolerance)
    if strips is None:
        return None
    sheet, pattern = strips.known.mechanism, strips.pattern
    corners = pattern.points[pattern.faces]
    begun = corner_distances(corners)
    moved = [
        corner_distances(strips.places(drive)[pattern.faces])
        for drive in np.linspace(0.0, sheet.end_drive, STATES)
    ]
    own = corner_distances(strips.places(sheet.target_drive)[pattern.faces])
    size = TOUCHING * strips.diagonal
    proof = find_first_contact(sheet.least_turning, CLEAR_UNTIL, size, progress=progress)
    if proof.contact is not None:
        grid = OnGrid(pattern, strips.known.numbers, *grid_creases(pattern, strips.known.numbers))
        first, second = grid.panels[list(proof.contact.panels)].tolist()
        proof = replace(proof, contact=replace(proof.contact, panels=(first, second)))
    kept = [
        max(
            np.abs(corner_distances(each[pattern.faces]) - begun).max(),
            diagonal_gaps(each[pattern.faces]).max(),
        )
        for each in states
    ]
    return FoldingStrips(
        strips=strips,
        tolerance=tolerance * strips.diagonal,
        unit=read.unit,
        change=float(np.abs(np.array(moved) - own).max()),
        freedom=tuple(
            strips.freedom_at(strips.places(share * sheet.end_drive)) for share in FREEDOM_AT
        ),
        proof=proof,
        kept=np.array(kept),
    )
