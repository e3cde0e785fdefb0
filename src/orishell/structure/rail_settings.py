"""The table [structure] rail: a base rail that joins the feet of a row."""

from __future__ import annotations

from typing import Annotated, ClassVar, Self

from pydantic import Field, field_validator, model_validator

from orishell.conventions.quantities import Quantities, conversion
from orishell.conventions.table import Number, Table, misfit
from orishell.structure.materials import Duration, ServiceClass, materials

Side = Annotated[Number, Field(ge=1e-9, le=1e15)]


class BaseRail(Table):
    """Bars of one section that join neighbouring feet of a row, stiffly where they meet."""

    REPORTED: ClassVar = ("material", "width", "height", "wall")

    material: str  # what they are made of, by its name in materials.toml
    width: Side  # across, level (length)
    height: Side  # (length)
    wall: Side | None = None  # thickness of the walls of a hollow section; None if it is solid

    @field_validator("material")
    @classmethod
    def _require_material(cls, material: str) -> str:
        if material not in materials():
            raise misfit(f"one of {', '.join(materials())}", material)
        return material

    @model_validator(mode="after")
    def _check(self) -> Self:
        if self.wall is not None and 2 * self.wall >= min(self.width, self.height):
            raise misfit(
                "less than half of width and height: a solid bar has none", self.wall, "wall"
            )
        return self

    def bears(self, duration: Duration, service: ServiceClass, unit: str) -> float:
        """The stress that it bears under loads of a duration, per square of a unit."""
        return materials()[self.material].bears(duration, service) * conversion(unit, "m") ** 2

    def in_words(self, unit: str) -> str:
        """What it is made of, for one line."""
        said = Quantities(unit)
        sides = f"{said.displacement(self.width)} x {said.displacement(self.height)}"
        walls = "" if self.wall is None else f", walls of {said.displacement(self.wall)}"
        return f"{self.material}, {sides}{walls}"
