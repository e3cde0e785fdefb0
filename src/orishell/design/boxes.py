"""Box girders of a design: sleeves that close rows of its sheet, and the boards on them."""

from __future__ import annotations

from orishell.conventions.record import record
from orishell.motion.boards import Boards
from orishell.motion.sleeves import Sleeve

STRIPS = "upper", "lower"
"""Strips of a sleeve: hung on the panels above its row, and on those below."""


@record
class Box:
    """A sleeve over a row of the sheet, with its boards."""

    sleeve: Sleeve
    boards: Boards | None = None  # as panels of the sleeve; None if panels have no thickness

    def __repr__(self) -> str:
        return f"Box(row {self.sleeve.row}, {self.sleeve!r})"

    @property
    def names(self) -> tuple[str, ...]:
        """What its panels are called, strip by strip, by the columns of the sheet's panels."""
        columns = range(self.sleeve.columns.start, self.sleeve.columns.stop - 1)
        row = self.sleeve.row
        return tuple(f"box {row} {strip} {column}" for strip in STRIPS for column in columns)
