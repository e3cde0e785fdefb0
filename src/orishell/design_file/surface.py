"""The table ``[target.surface]``: a surface that a shell is to follow, by formula or as a mesh."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any, ClassVar, Final, Literal, Self

import numpy as np
from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import Unit, conversion
from orishell.conventions.table import Number, Table
from orishell.curves import FormulaOfTwo, parse_formula_of_two
from orishell.design import FormulaSurface, MeshSurface, PlanRectangle
from orishell.design.mesh_files import Axis, MeshFile, read_mesh, turned_up
from orishell.design.mesh_surface import lies_on_its_side
from orishell.design_file.target import (
    Ends,
    Factor,
    beside,
    numbers,
    one_source,
    require_heads,
)

FITTING: Final = {
    "formula": {"x", "y", "u", "v", "centre", "size", "turn_deg"},
    "mesh": {"unit", "up", "corners", "x", "y", "centre", "size", "turn_deg"},
    "vertices": {"triangles", "unit", "up", "corners", "x", "y", "centre", "size", "turn_deg"},
}
"""The sources of a surface, and the keys that have a meaning for each."""
MOST_VERTICES: Final = 200_000
"""Vertices that are listed in a design file, at most."""
RECTANGLE: Final = ("centre", "size", "turn_deg")
"""The keys of a rectangle that may be turned."""
TURNS: Final = (0.0, 30.0, 60.0, 90.0, 120.0, 150.0)
"""Turns of a rectangle that are tried where the file leaves them open (degrees)."""
ALWAYS: Final = {"scale"}
LYING: Final = (
    "the mesh lies on its side: its mean normal is along y. Turn it where y points up "
    'in it (up = "y" in [target.surface]), or say that it is meant so (up = "z")'
)

Pair = Annotated[list[Number], Field(min_length=2, max_length=2)]
Sizes = Annotated[list[Annotated[Number, Field(gt=0)]], Field(min_length=2, max_length=2)]
Three = Annotated[list[str], Field(min_length=3, max_length=3)]
Places = Annotated[
    list[Annotated[list[Number], Field(min_length=3, max_length=3)]],
    Field(min_length=4, max_length=4),
]


Factors = Annotated[list[Factor], Field(min_length=3, max_length=3)]
"""Of lengths along x, y and z."""
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

    SAMPLE: ClassVar = {"formula": "x**2 - y**2", "x": [-1, 1], "y": [-1, 1]}

    formula: str | Three | None = None
    x: Ends | None = None
    y: Ends | None = None
    u: Ends | None = None
    v: Ends | None = None
    centre: Pair | None = None
    size: Sizes | None = None
    turn_deg: Annotated[Number, Field(ge=-360, le=360)] | Literal["auto"] = 0.0
    mesh: str | None = None
    vertices: Listed | None = None
    triangles: Triples | None = None
    unit: Unit | None = None
    up: Axis | None = None
    corners: Places | None = None
    scale: Factor | Factors = 1.0

    @model_validator(mode="after")
    def _check(self) -> Self:
        source = one_source(self, FITTING, ALWAYS, "a surface comes from a formula or a mesh")
        if source == "formula":
            self._check_formula()
        else:
            self._check_part()
        if source == "vertices":
            if self.triangles is None:
                raise PydanticCustomError("source", "vertices need triangles", {"key": "triangles"})
            most = max(map(max, self.triangles))
            if most >= len(self.vertices or []):
                what = f"there is no vertex {most}: they are numbered from 0"
                raise PydanticCustomError("source", what, {"key": "triangles"})
        return self

    def _check_formula(self) -> None:
        three = isinstance(self.formula, list)
        wanted, other = (("u", "v"), ("x", "y")) if three else (("x", "y"), ("u", "v"))
        for key in self._given():
            if key in other or (three and key in RECTANGLE):
                what = (
                    "this key goes with z(x, y)" if three else "this key goes with three formulas"
                )
                raise PydanticCustomError("source", what, {"key": key})
        if not self._turnable():
            self._require(wanted, "a formula needs its ranges, as in {key} = [-1, 1]")

    def _check_part(self) -> None:
        turnable = self._turnable()
        if not turnable and self.x is None and self.y is None:
            return
        if self.corners is not None:
            what = "the corners of a rectangle are its own"
            raise PydanticCustomError("source", what, {"key": "corners"})
        if not turnable:
            self._require(("x", "y"), "a rectangle has both ranges, as in {key} = [-1, 1]")

    def _turnable(self) -> bool:
        """Whether there is a rectangle by its size, and all its keys go together."""
        if self.size is not None:
            if self.x is not None or self.y is not None:
                what = "a rectangle has either size (and centre), or the ranges x and y"
                raise PydanticCustomError("source", what, {"key": "size"})
            return True
        for key in ("centre", "turn_deg"):
            if key in self.model_fields_set:
                raise PydanticCustomError("source", "this key goes with size", {"key": key})
        return False

    def _require(self, keys: tuple[str, str], what: str) -> None:
        for key in keys:
            if getattr(self, key) is None:
                raise PydanticCustomError("source", what.format(key=key), {"key": key})

    def _given(self) -> list[str]:
        return [key for key in type(self).model_fields if key in self.model_fields_set]

    @property
    def open_turns(self) -> tuple[float, ...]:
        """Turns that are to be tried (degrees), fewer of a square; none if the file says one."""
        if self.turn_deg != "auto":
            return ()
        assert self.size is not None
        return TURNS[: len(TURNS) // 2] if self.size[0] == self.size[1] else TURNS

    def surface(self, directory: Path | None, unit: str) -> FormulaSurface | MeshSurface:
        """The surface that the table describes, in ``unit``.

        Without a directory no file may be read. Raises InputError if there is none.
        """
        try:
            return self._made(directory, unit)
        except InputError as error:
            raise error.at_key("target.surface", "[target.surface]") from None

    def _made(self, directory: Path | None, unit: str) -> FormulaSurface | MeshSurface:
        if self.turn_deg != "auto":
            made = self._mesh(directory, unit) if self.formula is None else self._formulas()
            _ = made.piece  # refuses what has none
            return made
        # The first that there is stands for all until the nearest is found.
        first: InputError | None = None
        for turn in self.open_turns:
            try:
                return self.model_copy(update={"turn_deg": turn})._made(directory, unit)
            except InputError as error:
                first = first or error
        assert first is not None
        raise first

    def _formulas(self) -> FormulaSurface:
        texts = [self.formula] if isinstance(self.formula, str) else self.formula or []
        names = ("x", "y") if len(texts) == 1 else ("u", "v")
        formulas = tuple(_formula(text, names) for text in texts)
        require_heads(formulas, "z" if len(texts) == 1 else "xyz")
        if self.size is not None:
            part = self._rectangle()
            first, second = ((-0.5 * size, 0.5 * size) for size in part.size)
            return FormulaSurface(formulas, first, second, part.centre, part.turn, self._scale)
        first, second = self._ranges(names)
        return FormulaSurface(formulas, first, second, scale=self._scale)

    def _ranges(self, names: tuple[str, str]) -> list[tuple[float, float]]:
        ranges = [numbers(name, getattr(self, name)) for name in names]
        for name, (low, high) in zip(names, ranges, strict=True):
            if not low < high:
                raise InputError(
                    "a range runs from a lower to a higher number",
                    keys=(name,),
                    where=name,
                    got=f"{low:g} to {high:g}",
                )
        return ranges

    @property
    def _scale(self) -> float | tuple[float, float, float]:
        """The factor of all lengths, or those along x, y and z."""
        if not isinstance(self.scale, list):
            return self.scale
        x, y, z = self.scale
        return x, y, z

    def _rectangle(self) -> PlanRectangle:
        if self.size is None:
            (a, b), (c, d) = self._ranges(("x", "y"))
            return PlanRectangle((0.5 * (a + b), 0.5 * (c + d)), (b - a, d - c))
        (x, y), (wide, high) = self.centre or (0.0, 0.0), self.size
        assert self.turn_deg != "auto"
        return PlanRectangle((x, y), (wide, high), float(np.deg2rad(self.turn_deg)))

    def _mesh(self, directory: Path | None, unit: str) -> MeshSurface:
        path = None if self.mesh is None else _opened(directory, self.mesh)
        file = self._listed() if path is None else read_mesh(path, self.up)
        try:
            return self._surface_of(file, unit)
        except InputError as error:
            self._offer_up(error, file, unit)
            raise error if path is None else error.in_file(path) from None

    def _listed(self) -> MeshFile:
        """The mesh whose vertices and triangles are listed."""
        vertices = turned_up(np.array(self.vertices), self.up or "z")
        return MeshFile(vertices, np.array(self.triangles), "", None)

    def _surface_of(self, file: MeshFile, unit: str) -> MeshSurface:
        vertices, faces = file.vertices, file.triangles
        factor = conversion(self.unit or file.unit or unit, unit) * np.array(self._scale)
        if self.size is not None or self.x is not None:
            made = MeshSurface.over(self._rectangle(), vertices, faces, factor)
        else:
            corners = None if self.corners is None else factor * np.array(self.corners)
            with np.errstate(over="ignore"):  # what overflows is refused
                made = MeshSurface.of(factor * vertices, faces, corners)
        made = replace(made, unit=self.unit or file.unit or "")
        if (self.up or file.up) is None and lies_on_its_side(made.piece):
            return replace(made, notes=(LYING,))
        return made

    def _offer_up(self, error: InputError, file: MeshFile, unit: str) -> None:
        """Say in a refusal that the mesh may lie on its side, if it does when it stands."""
        if (self.up or file.up) is not None:
            return
        standing = replace(file, vertices=turned_up(file.vertices, "y"), up="y")
        try:
            self._surface_of(standing, unit)
        except InputError:
            return
        error.remedy = f'up = "y" if y points up in it, or {error.remedy}'.removesuffix(", or ")

    def without_files(self, directory: Path, unit: str) -> dict[str, Any]:
        """The table with the mesh itself in place of its file's name."""
        table = self.model_dump(exclude_unset=True)
        if self.mesh is not None:
            file = read_mesh(_opened(directory, self.mesh), self.up)
            del table["mesh"]
            table |= {"vertices": file.vertices.tolist(), "triangles": file.triangles.tolist()}
            axis = self.up or file.up
            table |= {"up": "z"} if axis is not None else {}  # as it is listed
            table |= {"unit": self.unit or file.unit or unit}
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
