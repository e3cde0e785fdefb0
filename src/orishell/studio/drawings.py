"""Crease patterns that are dropped onto the page, and what the page says of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import plain
from orishell.conventions.record import as_table
from orishell.conventions.row import Row
from orishell.design_file.drawing import read_drawing, table_of
from orishell.families.drawn.faults import find_faults
from orishell.families.recognised import recognise
from orishell.io.patterns.graph import GapError
from orishell.io.patterns.read import ENDINGS, read_lines, read_pattern
from orishell.motion.crease_pattern import CreasePattern, Mark
from orishell.motion.drawing import Drawing
from orishell.motion.gridding import find_irregular
from orishell.numerics.arrays import Array
from orishell.studio.api import DroppedTarget, RefusedDrawing
from orishell.studio.dropped import dropped_file
from orishell.studio.refusals import RefusalError, describe_error

MOST_LINES, MOST_MARKS = 20_000, 200
"""Of a drawing that is refused, so many lines are shown, and so many places."""
LIKE = 1e-3
"""A family is named that sectors miss by less, and by how much (radians)."""


def read_dropped_pattern(name: str, content: str, unit: str, weld: object) -> DroppedTarget:
    """The table of a drawn sheet in the file of a crease pattern, and notes on how it was read.

    The content is in base64. Raises InputError if it is no such file, and RefusalError, which has
    the drawing, if it holds no grid of panels; with changes to ``weld`` where that helps.
    """
    if weld is not None and (isinstance(weld, bool) or not isinstance(weld, int | float)):
        raise InputError("weld is no number above 0", got=repr(weld)[:40])
    refused: RefusedDrawing | None = None
    try:
        with dropped_file(name, content, ENDINGS, "a crease pattern") as path:
            try:
                drawing, own = read_drawing(path, None, weld)
            except InputError as error:
                refused = _refused_file(path, weld, error)
                raise
    except InputError as error:
        if refused is None:
            raise
        raise RefusalError({**describe_error(error), "drawing": refused}) from None
    table = table_of(drawing) | ({} if own is None else {"unit": own})
    said = (f"read from {name}, in {own or unit}", *drawing.notes)
    return {"table": table, "note": "; ".join(said)}


def looks_like_pattern(name: str, content: str) -> bool:
    """Whether a file draws mountains, valleys and a border, or a cut: then it is no curve.

    Our own drawings have a cut in its place. The content is in base64.
    """
    try:
        with dropped_file(name, content, ENDINGS, "a crease pattern") as path:
            lines = read_lines(path)
    except InputError:
        return False
    if lines is None:
        return True
    drawn = {*lines.letters.tolist()}
    return {"M", "V"} <= drawn and not drawn.isdisjoint({"B", "C"})


def refused_sheet(drawing: Drawing) -> RefusedDrawing | None:
    """A drawn sheet that does not fold, and where."""
    return _shown(drawing.pattern, find_faults(drawing))


def _refused_file(path: Path, weld: float | None, error: InputError) -> RefusedDrawing | None:
    """What is drawn in a file that holds no grid, and where it is wrong; None if nothing is."""
    try:
        found = read_pattern(path, weld=weld).flat
    except InputError:
        found = None
    if found is not None:
        return _shown(found, tuple(find_irregular(found)))
    try:
        lines = read_lines(path)
    except InputError:
        return None
    if lines is None:
        return None
    marks = error.marks if isinstance(error, GapError) else ()
    return _drawn(lines.ends, "".join(lines.letters.tolist()), marks)


def _shown(pattern: CreasePattern, marks: tuple[Mark, ...]) -> RefusedDrawing | None:
    ends = pattern.vertices[pattern.edges]
    return _drawn(ends, "".join(pattern.letters.tolist()), marks)


def _drawn(ends: Array, letters: str, marks: tuple[Mark, ...]) -> RefusedDrawing | None:
    """Lines (N, 2, 2) with their letters; None of more than a page draws."""
    if not 0 < len(ends) <= MOST_LINES:
        return None
    lines = [(a, b, c, d) for (a, b), (c, d) in ends.tolist()]
    return {"lines": lines, "letters": letters, "marks": as_table(marks[:MOST_MARKS])}


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
