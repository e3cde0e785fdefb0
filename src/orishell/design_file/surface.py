"""The table ``[target.surface]``: a surface that a shell is to follow, by formula or as a mesh."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Final, Self

import numpy as np
from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import Unit, conversion
from orishell.conventions.table import Number, Table
from orishell.curves import FormulaOfTwo, parse_formula_of_two
from orishell.design import FormulaSurface, MeshSurface
from orishell.design.mesh_files import read_mesh
from orishell.design_file.target import Ends, beside, numbers, one_source

FITTING: Final = {
    "formula": {"x", "y", "u", "v", "centre", "size", "turn_deg"},
    "mesh": {"unit", "corners"},
    "vertices": {"triangles", "unit", "corners"},
}
"""The sources of a surface, and the keys that have a meaning for each."""
MOST_VERTICES: Final = 100_000
"""Vertices that are listed in a design file, at most."""
RECTANGLE: Final = ("centre", "size", "turn_deg")
ALWAYS: Final = {"scale"}

Pair = Annotated[list[Number], Field(min_length=2, max_length=2)]
Sizes = Annotated[list[Annotated[Number, Field(gt=0)]], Field(min_length=2, max_length=2)]
Three = Annotated[list[str], Field(min_length=3, max_length=3)]
Places = Annotated[
    list[Annotated[list[Number], Field(min_length=3, max_length=3)]],
    Field(min_length=4, max_length=4),
]


Listed = Annotated[
    list[Annotated[list[Number], Field(min_length=3, max_length=3)]],
    Field(min_length=3, max_length=MOST_VERTICES),
]
Triples = Annotated[
    list[Annotated[list[Annotated[int, Field(ge=0)]], Field(min_length=3, max_length=3)]],
    Field(min_length=1, max_length=2 * MOST_VERTICES),
]


class SurfaceTable(Table):
    """A surface: z of x and y, or x, y and z of u and v, or a mesh; and which piece of it.

    A mesh is in a file, or listed by its vertices and triangles, which are numbered from 0.
    """

    formula: str | Three | None = None
    x: Ends | None = None
    y: Ends | None = None
    u: Ends | None = None
    v: Ends | None = None
    centre: Pair | None = None
    size: Sizes | None = None
    turn_deg: Annotated[Number, Field(ge=-360, le=360)] = 0.0
    mesh: str | None = None
    vertices: Listed | None = None
    triangles: Triples | None = None
    unit: Unit | None = None
    corners: Places | None = None
    scale: Annotated[Number, Field(gt=0)] = 1.0

    @model_validator(mode="after")
    def _check(self) -> Self:
        source = one_source(self, FITTING, ALWAYS, "a surface comes from a formula or a mesh")
        if source == "formula":
            self._check_ranges()
        if source == "vertices":
            if self.triangles is None:
                raise PydanticCustomError("source", "vertices need triangles", {"key": "triangles"})
            most = max(map(max, self.triangles))
            if most >= len(self.vertices or []):
                what = f"there is no vertex {most}: they are numbered from 0"
                raise PydanticCustomError("source", what, {"key": "triangles"})
        return self

    def _check_ranges(self) -> None:
        given = [key for key in type(self).model_fields if key in self.model_fields_set]
        three = isinstance(self.formula, list)
        wanted, other = (("u", "v"), ("x", "y")) if three else (("x", "y"), ("u", "v"))
        for key in given:
            if key in other or (three and key in RECTANGLE):
                what = (
                    "this key goes with z(x, y)" if three else "this key goes with three formulas"
                )
                raise PydanticCustomError("source", what, {"key": key})
        if self.size is not None:
            if self.x is not None or self.y is not None:
                what = "a rectangle has either size (and centre), or the ranges x and y"
                raise PydanticCustomError("source", what, {"key": "size"})
            return
        for key in ("centre", "turn_deg"):
            if key in given:
                raise PydanticCustomError("source", "this key goes with size", {"key": key})
        for key in wanted:
            if getattr(self, key) is None:
                what = f"a formula needs its ranges, as in {key} = [-1, 1]"
                raise PydanticCustomError("source", what, {"key": key})

    def surface(self, directory: Path | None, unit: str) -> FormulaSurface | MeshSurface:
        """The surface that the table describes, in ``unit``.

        Without a directory no file may be read. Raises InputError if there is none.
        """
        try:
            made = self._mesh(directory, unit) if self.formula is None else self._formulas()
            _ = made.piece  # refuses what has none
        except InputError as error:
            raise error.at_key("target.surface", "[target.surface]") from None
        return made

    def _formulas(self) -> FormulaSurface:
        texts = [self.formula] if isinstance(self.formula, str) else self.formula or []
        names = ("x", "y") if len(texts) == 1 else ("u", "v")
        formulas = tuple(_formula(text, names) for text in texts)
        if self.size is not None:
            x, y = self.centre or (0.0, 0.0)
            (width, height), turn = self.size, float(np.deg2rad(self.turn_deg))
            first, second = (-0.5 * width, 0.5 * width), (-0.5 * height, 0.5 * height)
            return FormulaSurface(formulas, first, second, (x, y), turn, self.scale)
        ranges = [numbers(name, getattr(self, name)) for name in names]
        for name, (low, high) in zip(names, ranges, strict=True):
            if not low < high:
                raise InputError(
                    "a range runs from a lower to a higher number",
                    keys=(name,),
                    where=name,
                    got=f"{low:g} to {high:g}",
                )
        return FormulaSurface(formulas, ranges[0], ranges[1], scale=self.scale)

    def _mesh(self, directory: Path | None, unit: str) -> MeshSurface:
        path = None if self.mesh is None else _opened(directory, self.mesh)
        vertices, faces = (
            (np.array(self.vertices), np.array(self.triangles)) if path is None else read_mesh(path)
        )
        factor = self.scale * conversion(self.unit or unit, unit)
        corners = None if self.corners is None else np.array(self.corners)
        try:
            return MeshSurface.of(
                factor * vertices, faces, None if corners is None else factor * corners
            )
        except InputError as error:
            raise error if path is None else error.in_file(path) from None

    def without_files(self, directory: Path, unit: str) -> dict[str, Any]:
        """The table with the mesh itself in place of its file's name."""
        table = self.model_dump(exclude_unset=True)
        if self.mesh is not None:
            vertices, triangles = read_mesh(_opened(directory, self.mesh))
            del table["mesh"]
            table |= {"vertices": vertices.tolist(), "triangles": triangles.tolist()}
        return table


def _opened(directory: Path | None, name: str) -> Path:
    if directory is None:
        raise InputError(
            "files are not opened here",
            keys=("mesh",),
            got=repr(name),
            remedy="drop the file onto the page, or list its vertices and triangles",
        )
    return beside(directory, name)


def _formula(text: str, names: tuple[str, str]) -> FormulaOfTwo:
    try:
        return parse_formula_of_two(text, *names)
    except InputError as error:
        raise error.at_key("formula", "formula") from None
