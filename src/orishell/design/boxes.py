"""Box girders of a design: sleeves that close rows of its sheet, as parts that it carries."""

from __future__ import annotations

from typing import cast

import numpy as np

from orishell.conventions.record import record
from orishell.design.carried import CarriedPart
from orishell.design.hung import HungLines
from orishell.motion import find_assignment
from orishell.motion.layout import points_of
from orishell.motion.sleeves import Q, R, Sleeve

STRIPS = "upper", "lower"
"""Strips of a sleeve: hung on the panels above its row, and on those below."""


@record
class Box(CarriedPart):
    """A sleeve over a row of the sheet, with its boards."""

    @classmethod
    def of(cls, sleeve: Sleeve) -> Box:
        """The part that a sleeve is; it has no boards yet."""
        row, columns = sleeve.row, range(sleeve.columns.start, sleeve.columns.stop)
        return cls(
            strips=sleeve,
            title=f"Box girder of row {row}",
            kind="girder",
            names=tuple(f"box {row} {strip} {k}" for strip in STRIPS for k in columns[:-1]),
            hung_on=tuple((above, k) for above in (row - 1, row) for k in columns[:-1]),
            borne_at=np.array([(row, k) for k in columns]),
            hung=_hung(sleeve),
        )

    @property
    def sleeve(self) -> Sleeve:
        """Its strips."""
        return cast("Sleeve", self.strips)


def _hung(sleeve: Sleeve) -> HungLines:
    """Both lines of a sleeve, on the side to which panels of its row fold together."""
    row, across, count = sleeve.row, sleeve.sheet.grid.columns, len(sleeve.above)
    columns = np.arange(sleeve.columns.start, sleeve.columns.stop)
    own = points_of(sleeve, 0.0)[:, :2].reshape(3, count, 2)[[Q, R]]
    x = points_of(sleeve.sheet, 0.0)[row * across + columns, :2]
    panels = (np.array([[row - 1], [row]]) * (across - 1) + columns[:-1]).ravel()
    # Its own crease folds to the other side than those that it is over.
    side = -int(np.sign(find_assignment(sleeve).row[0, 0]))
    return HungLines.between(
        (f"box {row}",) * len(panels), panels, side, own, np.linalg.norm(own - x, axis=-1)
    )
