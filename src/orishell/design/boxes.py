"""Box girders of a design: sleeves that close rows of its sheet, and the boards on them."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.design.hung import HungLines
from orishell.motion import find_assignment
from orishell.motion.boards import Boards
from orishell.motion.grid import Panel
from orishell.motion.layout import points_of
from orishell.motion.sleeves import Q, R, Sleeve

STRIPS = "upper", "lower"
"""Strips of a sleeve: hung on the panels above its row, and on those below."""


@record
class Box:
    """A sleeve over a row of the sheet, with its boards."""

    sleeve: Sleeve
    boards: Boards | None = None  # as panels of the sleeve; None if panels have no thickness
    joined_from: float = 0.0  # the drive from which on it is joined to the sheet (radians)

    def __repr__(self) -> str:
        return f"Box(row {self.sleeve.row}, {self.sleeve!r})"

    @property
    def names(self) -> tuple[str, ...]:
        """What its panels are called, strip by strip, by the columns of the sheet's panels."""
        row = self.sleeve.row
        return tuple(f"box {row} {strip} {column}" for strip in STRIPS for column in self._columns)

    @property
    def hung_on(self) -> tuple[Panel, ...]:
        """Row and column of the panel of the sheet that each of its panels hangs on."""
        row = self.sleeve.row
        return tuple((above, column) for above in (row - 1, row) for column in self._columns)

    @property
    def _columns(self) -> range:
        return range(self.sleeve.columns.start, self.sleeve.columns.stop - 1)

    @property
    def hung(self) -> HungLines:
        """Both of its lines, on the side to which panels of its row fold together."""
        sleeve, row = self.sleeve, self.sleeve.row
        across, count = sleeve.sheet.grid.columns, len(sleeve.above)
        columns = np.arange(sleeve.columns.start, sleeve.columns.stop)
        own = points_of(sleeve, 0.0)[:, :2].reshape(3, count, 2)[[Q, R]]
        x = points_of(sleeve.sheet, 0.0)[row * across + columns, :2]
        away = np.linalg.norm(own - x, axis=-1)
        panels = (np.array([[row - 1], [row]]) * (across - 1) + columns[:-1]).ravel()
        # Its own crease folds to the other side than those that it is over.
        side = -int(np.sign(find_assignment(sleeve).row[0, 0]))
        return HungLines(
            names=(f"box {row}",) * len(panels),
            panels=panels,
            sides=np.full(len(panels), side),
            ends=np.stack([own[:, :-1], own[:, 1:]], axis=2).reshape(-1, 2, 2),
            away=np.stack([away[:, :-1], away[:, 1:]], axis=2).reshape(-1, 2),
        )
