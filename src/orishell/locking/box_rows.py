"""Which sheets, columns and rows may have box girders."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.errors import DesignError, InputError, Remedy
from orishell.design import Design
from orishell.locking.fold_rows import between_flaps
from orishell.locking.plates import require_creases
from orishell.motion import find_assignment
from orishell.motion.layout import SlitFlaps


def box_columns(design: Design, what: str = "box girders") -> slice:
    """The columns of vertices that box girders, or what else is carried, reach over.

    A flap that is shut is in the plane of the two edges of the column beside it, where the end of a
    box would be: beside flaps they end a column before.

    Raises InputError if there are none, panels are whole boards, or flaps are slit from each other.
    """
    require_creases(design, what)
    if isinstance(design.mechanism, SlitFlaps):
        raise InputError(
            f"flaps that are slit from each other leave no room for {what}",
            keys=("stiffeners", "deployment.flap_attachment"),
            remedy='flap_attachment = "clipped" in [deployment]',
        )
    every = slice(0, design.mechanism.grid.columns)
    columns = between_flaps(design, every, 2, what)
    return slice(columns.start, columns.stop)


def require_one_side(design: Design, rows: Sequence[int], columns: slice) -> None:
    """Refuse rows whose creases fold to both sides: a sleeve would run through the sheet."""
    signs = find_assignment(design.mechanism).row[:, columns.start : columns.stop - 1]
    for row in rows:
        own = signs[row - 1]
        if np.ptp(own) or not own[0]:
            raise DesignError(
                "a box girder is on one side of the sheet, and creases of its row fold to both",
                place=f"at row {row}",
                keys=("stiffeners.rows",),
                size=f"{int((own > 0).sum())} valleys and {int((own < 0).sum())} mountains",
                candidates=[
                    Remedy({"stiffeners.rows": "valleys"}),
                    Remedy({"stiffeners.rows": "crests"}),
                ],
            )
