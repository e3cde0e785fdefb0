"""First contact of boards of a sheet with those of its sleeves, proved that there is none before.

Boards of a strip are clear of those of the panel that they hang on by how far they stand off it
(:mod:`~orishell.solids.carried`), and boards of a sheet, or of a sleeve, of each other by proofs of
their own. All others are looked at.
"""

from __future__ import annotations

import numpy as np

from orishell.clash.bodies import Bodies
from orishell.clash.body_path import BodySearch
from orishell.clash.broad_phase import Pairs, selected
from orishell.clash.ranges import PathResult
from orishell.conventions.progress import Progress, no_progress
from orishell.motion.complex import Complex


def find_first_contact_of_parts(
    whole: Complex,
    ends: tuple[float, float],
    tolerance: float,
    bodies: Bodies,
    progress: Progress = no_progress,
) -> PathResult:
    """Return where boards of two parts of a complex first come within a tolerance.

    Parameters
    ----------
    ends
        The drives between which the path leads (radians).
    tolerance
        Distance at which boards touch (length).
    bodies
        All boards, on the panels of the complex.
    """
    return PartSearch(whole, ends, tolerance, bodies).run(progress)


class PartSearch(BodySearch):
    """A search for the first contact of boards of different parts, hinged panels left out."""

    def __init__(
        self, whole: Complex, ends: tuple[float, float], tolerance: float, bodies: Bodies
    ) -> None:
        self.part_of = whole.part_of
        own, on = whole.hinged
        self.keys = np.sort(on * len(self.part_of) + own)
        super().__init__(whole, ends[1], tolerance, bodies, self.part_of > 0, start=ends[0])

    def _panels(self, pairs: Pairs) -> Pairs:
        first, second = np.sort([self.tree.panels[nodes] for nodes in pairs], axis=0)
        first, second = selected((first, second), first >= 0)
        apart = self.part_of[first] != self.part_of[second]
        key = first * len(self.part_of) + second
        place = np.minimum(np.searchsorted(self.keys, key), len(self.keys) - 1)
        return selected((first, second), apart & (self.keys[place] != key))
