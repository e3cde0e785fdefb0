"""Plates in box girders: parallelograms across a box at its columns, when the shell stands.

At a column the cross-section of a sleeve is the plane parallelogram x, q = x + a u, w = q + b v and
r = x + b v. A plate there keeps the angle between u and v. Along all four sides it stands off
the panels beside it: those of the sheet at x q and r x, those of strips at q w and w r, by as much
as gussets do (:mod:`~orishell.solids.plates`).
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.record import record
from orishell.design import Design, PanelSpec
from orishell.design.boxes import Box
from orishell.design.part import Part
from orishell.motion.boards import Boards
from orishell.motion.grid import Grid
from orishell.motion.sleeves import Q, R, W
from orishell.numerics.arrays import Array, Integers
from orishell.solids.boards import inset_panels
from orishell.solids.plates import angle_about, lying, plate_parts, stand_off, upright_boards


@record
class BoxPlates:
    """Plates of one box girder at the target, in the frame of the sheet."""

    box: Box
    columns: Integers  # (G,), of the sheet's vertices
    corners: Array  # x, q, w and r (G, 4, 3)
    off: Array  # how far they stand off sides (G, 4), each from a corner to the next (length)
    build: PanelSpec | None  # what they are made of; None if they have no thickness

    @classmethod
    def of(cls, design: Design, box: Box, columns: Integers) -> BoxPlates:
        """Plates at columns (G,) of the sheet's vertices, made of what panels are made of."""
        sleeve, build = box.sleeve, design.panel
        points = design.mechanism.positions(design.mechanism.target_drive)
        own = columns - sleeve.columns.start
        lines = sleeve.carried(points)[:, own]
        x = points[sleeve.row, columns]
        corners = np.stack([x, lines[Q], lines[W], lines[R]], axis=1)
        half = 0.0 if build is None else build.height
        along = np.roll(corners, -1, axis=1) - corners
        inwards = -np.roll(along, 1, axis=1)  # back along the side before, away from this one
        off = np.zeros((len(columns), 4))
        for side in (-1, 1):
            there = (own + side >= 0) & (own + side < len(sleeve.above))
            across = points[sleeve.row, columns[there] + side] - x[there]
            for number in range(4):
                angle = angle_about(along[there, number], inwards[there, number], across)
                off[there, number] = np.maximum(off[there, number], stand_off(angle, half, half))
        return cls(box, columns, corners, off, build)

    def __len__(self) -> int:
        return len(self.columns)

    @property
    def names(self) -> tuple[str, ...]:
        """What each is called: by row and column of its vertex."""
        return tuple(f"plate {self.box.sleeve.row},{each}" for each in self.columns.tolist())

    def lying(self) -> Array:
        """Corners (G, 4, 2) of each in its own plane, its vertex in the origin."""
        return lying(self.corners)

    def cut(self) -> Array:
        """Corners (G, 4, 2) of plates in their own planes, off all sides.

        Raises
        ------
        DesignError
            If nothing is left of one.
        """
        return inset_panels(self.lying(), self.off, Grid(2, len(self) + 1))

    def boards(self, flat: Array, levels: int) -> Boards:
        """Their boards, as panels of their own whose first corners lie at places (G, 2).

        levels: At how many heights boards have outlines.
        """
        assert self.build is not None
        return upright_boards(self.cut() + flat[:, None], self.build, levels)


def box_plate_parts(design: Design, plates: BoxPlates, levels: int) -> Iterator[Part]:
    """Plates as parts, each beside the vertex of the flat sheet that it stands at.

    levels: At how many heights boards have outlines.
    """
    sleeve = plates.box.sleeve
    own = plates.columns - sleeve.columns.start
    a, b = 0.5 * sleeve.above[own], 0.5 * sleeve.below[own]
    at = np.stack([np.full(len(plates), sleeve.row), plates.columns], axis=1)
    return plate_parts(design, plates, at, np.stack([1 - (a + b), a, b], axis=1), levels)
