"""What is measured of a shell and its drawing does not show: sizes, packs, mass, feet."""

from __future__ import annotations

import numpy as np

from orishell.conventions.quantities import MILLIMETRES
from orishell.conventions.record import record
from orishell.motion.freedom import FreedomOfSheet
from orishell.motion.grid import Vertex
from orishell.numerics.arrays import Array

HAND_SIZED_MM = 1000.0
"""A shell smaller than this stands on a table or hangs from a ceiling, as lampshades and models."""


def is_hand_sized(points: Array, unit: str) -> bool:
    """Whether a shell of vertices (..., 3) is so small that threads tie it and no anchor holds it.

    unit: Of length.
    """
    return float(np.ptp(points.reshape(-1, 3), axis=0).max()) * MILLIMETRES[unit] < HAND_SIZED_MM


@record
class SheetReport:
    """Size of the flat sheet, or of the strips that it is made of."""

    # its bounding box, or that of the largest strip
    width: float
    height: float
    area: float  # area of all panels
    strips: int = 0  # how many strips there are; 0 for one sheet


@record
class BoxReport:
    """Bounding box of a state."""

    # along x, y and z
    width: float
    depth: float
    height: float

    @property
    def sides(self) -> tuple[float, float, float]:
        """All of them."""
        return self.width, self.depth, self.height


@record
class Measures:
    """What is measured of a shell, in its own unit, also where its document is that of a model."""

    unit: str  # of length
    columns: int  # of inner vertices
    starts_packed: bool  # whether it opens from a pack, or else is folded from the flat sheet
    shuts: bool  # whether its flaps are folded flat at the target and keep it from closing
    # the box around what folds, and around that and what is clipped on
    deployed: BoxReport
    outside: BoxReport
    # sides of the packs of all pieces, the longest first, and how many panels lie on each other
    # there, at most; none where they were not measured
    packs: tuple[tuple[float, float, float], ...]
    layers: int
    mass: float | None  # of all that is built (kg); None where it is not known
    # the two rows of vertices that it stands on, and the vertices, if not on whole rows; None
    # where it cannot stand
    feet: tuple[int, int] | None
    points: tuple[Vertex, ...]
    freedom: FreedomOfSheet  # how many motions its sheet has
    # lengths of the strings that tie end walls to it, from its vertices to their inner faces
    strings: tuple[float, ...] = ()
