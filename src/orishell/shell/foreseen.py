"""What is known to be too large for its stock before a sheet is fitted, which takes long.

The sheet of a fit has a share of the surface's area at least, so its largest panel has the mean
panel's share of that. If this is more than the stock, the panel does not fit it, however it is
turned.
"""

from __future__ import annotations

import math
from typing import Any

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import area
from orishell.design_file import DesignFile
from orishell.design_file.doubts import in_plan, likely_unit
from orishell.workshop.fitting import SLACK


def require_room_for_panels(file: DesignFile) -> None:
    """Refuse stock, or a roll, that cannot hold every panel of a sheet over the file's surface.

    Where sizes, rows or a turn are still to be found nothing is known.

    Raises
    ------
    InputError
        With the panels, rows and columns that are needed at least, or the unit that may have been
        meant.
    """
    least = _least_panel(file)
    if not least:
        return
    on_roll = file.panel is not None and file.workshop.roll is not None
    workshop = file.workshop.for_membrane() if file.panel is not None else file.workshop
    if workshop.stock is None:
        return
    width, height = workshop.usable_stock
    room = (1 + SLACK) * width * height
    if least <= room:
        return
    assert file.surface is not None
    sold = "roll" if on_roll else "stock"
    panels = math.ceil(file.panel_count * least / room)
    finer = math.sqrt(panels / file.panel_count)
    sides = file.pattern.rows + 1, file.pattern.columns + 1
    rows, columns = (math.ceil(finer * each) - 1 for each in sides)
    raise InputError(
        f"the {sold} is too small for panels over a target of {in_plan(file.surface, file.unit)}: "
        f"the largest of {file.panel_count} panels has {area(least, file.unit)} or more",
        keys=(f"workshop.{sold}",),
        got="{:.6g} x {:.6g}".format(*workshop.stock),
        **_meant(
            file,
            f"a larger {sold}, or {panels} panels or more: rows = {rows} with columns = {columns} "
            "at the least",
        ),
    )


def _least_panel(file: DesignFile) -> float:
    """The area that a panel of the sheet has at least; 0 where none is known."""
    solid = file.panel is not None and file.panel.is_solid  # then no sheet is cut
    still_open = file.fit is not None or file.tolerance is not None or file.turns
    if file.surface is None or solid or still_open:
        return 0.0
    return file.pattern.largest_panel(file.surface)


def _meant(file: DesignFile, else_: str) -> dict[str, Any]:
    """What mends it: the unit of the mesh, where it was tried, or something else."""
    unit = likely_unit(file.surface, file.unit)
    if unit is None:
        return {"remedy": else_}
    changes = {"target.surface.unit": unit}
    meant = file.tried(changes)
    try:
        require_room_for_panels(meant)
    except InputError:
        return {"remedy": else_}
    assert meant.surface is not None
    words = f'unit = "{unit}" in [target.surface], if the mesh was drawn in {unit}: then it is '
    words += in_plan(meant.surface, meant.unit)
    return {"remedy": words, "changes": changes}
