"""The table ``[target.pattern]``: a drawn sheet, from a file or by its vertices and creases."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any, Final, Self

import numpy as np
from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import Unit, conversion
from orishell.conventions.table import Number, Table
from orishell.design_file.target import Factor, Point, beside, one_source
from orishell.motion.drawing import Drawing, drawing_of
from orishell.motion.grid import CreaseValues
from orishell.motion.quads import grid_corners, signed_areas
from orishell.numerics.arrays import Array

FITTING: Final = {
    "file": {"unit", "weld"},
    "vertices": {"unit", "row_creases", "column_creases"},
}
"""The sources of a drawn sheet, and the keys that have a meaning for each."""
ALWAYS: Final = {"scale"}
MOST_VERTICES: Final = 1001
"""Vertices in a row, and in a column, that a design file lists."""
SIGNS: Final = {"M": -1.0, "V": 1.0, "F": 0.0, "U": np.nan}
"""Signs by letter; of U nothing is said."""

Row = Annotated[list[Point], Field(min_length=3, max_length=MOST_VERTICES)]
Letters = Annotated[str, Field(pattern="^[MVFU]+$")]
LetterLines = Annotated[list[Letters], Field(min_length=1, max_length=MOST_VERTICES)]


class DrawingTable(Table):
    """A drawn sheet: a file, or its vertices row by row with a letter for every crease."""

    file: str | None = None
    unit: Unit | None = None
    weld: Annotated[Number, Field(gt=0)] | None = None
    vertices: Annotated[list[Row], Field(min_length=3, max_length=MOST_VERTICES)] | None = None
    # M, V, F or U: of inner rows from left to right, and of inner columns from top to bottom
    row_creases: LetterLines | None = None
    column_creases: LetterLines | None = None
    scale: Factor = 1.0

    @model_validator(mode="after")
    def _check(self) -> Self:
        what = "a drawn pattern comes from a file or its vertices"
        if one_source(self, FITTING, ALWAYS, what) == "vertices":
            assert self.vertices is not None
            rows, columns = len(self.vertices), len(self.vertices[0])
            if any(len(row) != columns for row in self.vertices):
                what = "rows must have as many vertices as the first one"
                raise PydanticCustomError("source", what, {"key": "vertices"})
            self._require_letters("row_creases", rows - 2, columns - 1)
            self._require_letters("column_creases", columns - 2, rows - 1)
        return self

    def _require_letters(self, key: str, lines: int, creases: int) -> None:
        given = getattr(self, key) or []
        if [len(line) for line in given] != [creases] * lines:
            what = f"these vertices need {lines} words of {creases} letters here"
            raise PydanticCustomError("source", what, {"key": key})

    def drawing(self, directory: Path | None, unit: str) -> Drawing:
        """The sheet that the table describes, in ``unit``.

        Without a directory no file may be read. Raises InputError if there is no grid of panels.
        """
        try:
            with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused
                return self._made(directory, unit)
        except InputError as error:
            raise error.at_key("target.pattern", "[target.pattern]") from None

    def _made(self, directory: Path | None, unit: str) -> Drawing:
        if self.file is not None:
            return self._read(beside(directory, self.file), unit)
        flat = self.scale * conversion(self.unit or unit, unit) * np.array(self.vertices)
        _require_panels(flat)
        rows, columns = (_signs(each) for each in (self.row_creases, self.column_creases))
        return Drawing(flat, CreaseValues(rows, columns.T))

    def _read(self, path: Path, unit: str) -> Drawing:
        drawn, own = read_drawing(path, self.unit, self.weld)
        # Without a unit of its own the file is in the design's.
        factor = conversion(own or unit, unit)
        return replace(drawn, flat=self.scale * factor * drawn.flat)

    def without_files(self, directory: Path, unit: str) -> dict[str, Any]:
        """The table with the sheet itself, in ``unit``, in place of its file's name."""
        if self.file is None:
            return self.model_dump(exclude_unset=True)
        made = self.replace_unchecked(scale=1.0)._made(directory, unit)
        table = self.model_dump(exclude_unset=True, include={"scale"})
        return {**table, **table_of(made)}


def read_drawing(path: Path, unit: str | None, weld: float | None) -> tuple[Drawing, str | None]:
    """A drawn sheet in a file, and the unit of its coordinates, if that is known.

    unit, weld: As :func:`~orishell.io.read_pattern` takes them. Raises InputError if there is no
    grid of panels.
    """
    from orishell.io.patterns import read_pattern

    found = read_pattern(path, unit=unit, weld=weld)
    if found.flat is None:
        raise InputError(found.not_flat, where=str(path))
    try:
        drawn = drawing_of(found.flat)
    except InputError as error:
        raise error.located(f"{path}:") from None
    drawn = replace(drawn, notes=found.notes)
    return drawn, None if found.unit == "unit" else found.unit


def table_of(drawing: Drawing) -> dict[str, Any]:
    """The table of a drawing in the design's unit.

    drawing: The sheet.
    """
    letters = {sign: letter for letter, sign in SIGNS.items()}

    def words(signs: Array) -> list[str]:
        return ["".join(letters.get(sign, "U") for sign in line) for line in signs.tolist()]

    return {
        "vertices": drawing.flat.tolist(),
        "row_creases": words(drawing.signs.row),
        "column_creases": words(drawing.signs.column.T),
    }


def _signs(lines: list[str] | None) -> Array:
    return np.array([[SIGNS[letter] for letter in line] for line in lines or []])


def _require_panels(flat: Array) -> None:
    """Refuse panels without an area, seen from behind, or with two corners in one place."""
    corners = grid_corners(flat)
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=-2), axis=-1).min(axis=-1)
    whole = (signed_areas(corners) > 0) & (sides > 0)
    if whole.all():
        return
    row, column = np.argwhere(~whole)[0]
    short = sides[row, column] == 0
    lacks = "with a side of no length" if short else "turned over or without an area"
    raise InputError(
        "rows must run from left to right, and one below the other",
        keys=("vertices",),
        where="vertices",
        got=f"panel {row + 1}, {column + 1} {lacks}",
    )
