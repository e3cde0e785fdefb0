"""Which sheets, columns and rows may have box girders."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.errors import DesignError, InputError, Remedy
from orishell.design import Design
from orishell.motion import find_assignment
from orishell.motion.layout import SlitFlaps


def box_columns(design: Design) -> slice:
    """The columns of vertices that box girders reach over.

    A flap that is shut is in the plane of the two edges of the column beside it, where the end of a
    box would be: beside flaps they end a column before.

    Raises InputError if there are none.
    """
    mechanism, count = design.mechanism, design.mechanism.grid.columns
    start, stop = 0, count
    if mechanism.flap_columns or design.clipped is not None:
        inner = mechanism.inner_columns
        start, stop = inner.start + 1, inner.stop - 1
    if stop - start < 2:
        raise InputError(
            "flaps take the place of box girders at their sides, and there are no columns between",
            keys=("stiffeners", "pattern.flap"),
            remedy="flap = 0, or more columns",
        )
    return slice(start, stop)


def require_creases(design: Design) -> None:
    """Refuse whole boards, whose hinges are not in creases, and flaps that are slit."""
    if design.has_whole_boards:
        raise InputError(
            "box girders hang on creases, and whole boards have their hinges beside these",
            keys=("stiffeners", "panel.construction"),
            got='"hinged"',
            expected='"sandwich" or "bevel"',
        )
    if isinstance(design.mechanism, SlitFlaps):
        raise InputError(
            "box girders need a sheet without flaps that are slit from each other",
            keys=("stiffeners", "deployment.flap_attachment"),
            remedy='flap_attachment = "clipped" in [deployment]',
        )


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
