"""Crease patterns that are dropped onto the page, and what the page says of them."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import plain
from orishell.conventions.row import Row
from orishell.design_file.drawing import read_drawing, table_of
from orishell.families.recognised import recognise
from orishell.io.patterns.read import ENDINGS
from orishell.motion.drawing import Drawing
from orishell.studio.api import DroppedTarget
from orishell.studio.dropped import dropped_file

LIKE = 1e-3
"""A family is named that sectors miss by less, and by how much (radians)."""


def read_dropped_pattern(name: str, content: str, unit: str, weld: object) -> DroppedTarget:
    """The table of a drawn sheet in the file of a crease pattern, and notes on how it was read.

    The content is in base64. Raises InputError if it holds no grid of panels; with ``changes`` to
    ``weld`` where that helps.
    """
    if weld is not None and (isinstance(weld, bool) or not isinstance(weld, int | float)):
        raise InputError("weld is no number above 0", got=repr(weld)[:40])
    with dropped_file(name, content, ENDINGS, "a crease pattern") as path:
        drawing, own = read_drawing(path, None, weld)
    table = table_of(drawing) | ({} if own is None else {"unit": own})
    said = (f"read from {name}, in {own or unit}", *drawing.notes)
    return {"table": table, "note": "; ".join(said)}


def describe_drawing(drawing: Drawing, unit: str) -> tuple[Row, ...]:
    """What a drawn sheet is: its panels, its size, its family, letters that are missing."""
    rows, columns = (each - 1 for each in drawing.flat.shape[:2])
    across, down = np.ptp(drawing.flat, axis=(0, 1))
    size = f"{plain(float(across), 3)} x {plain(float(down), 3)} {unit}"
    sheet = Row("says", "sheet", f"{rows} x {columns} panels, {size}")
    known = recognise(drawing.flat, drawing.signs, LIKE)
    none = Row("says", "family", f"none that is known, to {LIKE:g} rad")
    creases = np.concatenate([drawing.signs.row.ravel(), drawing.signs.column.ravel()])
    missing = int(np.isnan(creases).sum())
    letters = Row("says", "letters", f"{missing} of {creases.size} creases have none")
    return (sheet, none if known is None else known.row, *([letters] if missing else []))
