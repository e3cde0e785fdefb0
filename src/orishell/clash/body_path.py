"""First contact of boards along a path of folding, with a proof that there is none before.

Boards of panels that share a crease are on either side of the plane that bisects it. Those of
panels that are opposite each other at a vertex are looked at by themselves
(:mod:`~orishell.clash.opposite`), all others as panels are (:mod:`~orishell.clash.path`).
"""

from __future__ import annotations

import numpy as np

from orishell.clash.acceleration_bounds import NormalBounds
from orishell.clash.bodies import Bodies
from orishell.clash.body_phase import examine_bodies, near_slabs
from orishell.clash.broad_phase import Pairs, joined
from orishell.clash.narrow_phase import Findings
from orishell.clash.opposite import OppositeBoards
from orishell.clash.path import Part, PathSearch
from orishell.clash.ranges import search_ranges
from orishell.clash.result import PathContact, PathResult, ProofRecord
from orishell.conventions.progress import Progress, no_progress, stretch
from orishell.motion import Mechanism
from orishell.motion.quads import grid_corners
from orishell.numerics.arrays import Array, Booleans, Integers

OPPOSITE = 0.7
"""Share of the progress, as of the time, that opposite boards take."""


def find_first_body_contact(
    mechanism: Mechanism,
    end: float,
    tolerance: float,
    bodies: Bodies,
    *,
    settled: Booleans,
    progress: Progress = no_progress,
) -> PathResult:
    """Return where two boards of panels without a common crease first come within a tolerance.

    Parameters
    ----------
    end
        The path goes from the flat sheet to this drive (radians).
    tolerance
        Distance at which boards count as touching (length).
    bodies
        The boards.
    settled
        Inner vertices (rows-2, columns-2) about which boards of opposite panels are known to be
        apart.
    """
    search = _BodySearch(mechanism, end, tolerance, bodies)
    opposite = search.opposite(settled)
    found, clear = search_ranges(
        opposite.examine, opposite.everything, stretch(progress, 0.0, OPPOSITE)
    )
    contact = None
    if found is not None:
        ends = search.states.drive(found[0]), search.states.drive(clear)
        contact = PathContact(*ends, bodies.carriers(found[1]), found[1])
        search = _BodySearch(mechanism, ends[0], tolerance, bodies)
    result = search.run(stretch(progress, OPPOSITE, 1.0))
    record = result.proof
    proof = ProofRecord(
        record.states,
        record.ranges + opposite.ranges,
        record.tests + opposite.tests,
        record.largest_step,
        record.smallest_step,
        record.tolerance,
    )
    if result.contact is not None:
        first = result.contact
        until = (
            first.clear_until if contact is None else min(first.clear_until, contact.clear_until)
        )
        contact = PathContact(first.drive, until, bodies.carriers(first.panels), first.panels)
    return PathResult(contact, proof)


class _BodySearch(PathSearch):
    """A search for the first contact of boards whose panels have no common vertex."""

    def __init__(self, mechanism: Mechanism, end: float, tolerance: float, bodies: Bodies) -> None:
        super().__init__(mechanism, end, tolerance, bodies=bodies)
        self.grid, self.bodies = mechanism.grid, bodies
        self.normals = NormalBounds(grid_corners(mechanism.positions(0.0)))

    def opposite(self, settled: Booleans) -> OppositeBoards:
        """What is left out here: boards of panels that are opposite each other at a vertex."""
        bounds = self.bounds, self.normals
        tolerance = self.tolerance + self.rounding
        return OppositeBoards(
            self.grid, self.bodies, self.states, bounds, tolerance=tolerance, settled=settled
        )

    def _swung(self, part: Part) -> float:
        return 2 * float(self._swings(part).max())

    def _narrow_phase(self, part: Part, near: Pairs) -> Findings:
        swings = self._swings(part)

        def chord_error(first: Integers, second: Integers) -> Array:
            between = part.bounds.between_panels(first, second)
            return np.asarray(part.step**2 / 8 * (between + swings[first] + swings[second]))

        ends, tolerance = (part.start, part.stop), self.tolerance + self.rounding
        slabs = self.states.slabs(part.start), self.states.slabs(part.stop)
        near = near_slabs(slabs, near, tolerance + chord_error(*near))
        pairs = joined([part.open, self.bodies.pairs_of(near)[0]])
        self.tests += len(pairs[0])
        states = [self.states.bodies_of(self.bodies, tick) for tick in ends]
        panels = (self.bodies.panels[pairs[0]], self.bodies.panels[pairs[1]])
        return examine_bodies((states[0], states[1]), pairs, tolerance, chord_error(*panels))

    def _swings(self, part: Part) -> Array:
        """Bounds (F,) of the accelerations of corners of boards over their panels."""
        return self.bodies.height * self.normals.within(*part.bounds.steps)
