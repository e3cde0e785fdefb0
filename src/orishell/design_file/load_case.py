"""The tables [[load_case]] of a design file: what loads the shell."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Literal, Self

import numpy as np
from pydantic import Field, field_validator, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.errors import InputError
from orishell.conventions.table import Number, Table
from orishell.design_file.deployment import Index, Vertex
from orishell.structure.settings import (
    NO_CODE,
    LoadCase,
    PointLoad,
    Snow,
    Terrain,
    Wind,
    Zone,
)

MOST = 1e12
"""Loads are smaller than this: what is computed from larger ones would overflow in the end."""
Load = Annotated[Number, Field(ge=-MOST, le=MOST)]
Coefficient = Annotated[Number, Field(ge=-10, le=10)]
Pair = Annotated[list[Number], Field(min_length=2, max_length=2)]
LONGEST = 60
"""Characters of a name."""
LOADS = ("self_weight", "pressure", "snow", "wind", "points")


class SnowTable(Table):
    """Snow on the ground, and how the shell gathers it."""

    ground: Annotated[Number, Field(gt=0, le=MOST)]
    shape: Literal["slope", "cylinder"] = "slope"

    def settings(self) -> Snow:
        """The snow."""
        return Snow(self.ground, self.shape)


class ZoneTable(Table):
    """Rows of panels with one pressure coefficient."""

    rows: Annotated[list[Index], Field(min_length=2, max_length=2)]
    coefficient: Coefficient

    @model_validator(mode="after")
    def _check(self) -> Self:
        if self.rows[0] > self.rows[1]:
            raise PydanticCustomError(
                "rows", "the first row, then the last", {"key": "rows", "got": self.rows}
            )
        return self


class WindTable(Table):
    """Wind by its speed, its terrain and pressure coefficients."""

    speed: Annotated[Number, Field(gt=0, le=200)]
    terrain: Terrain
    direction_deg: Annotated[Number, Field(ge=-360, le=360)]
    coefficients: list[Pair] | None = None
    zones: Annotated[list[ZoneTable], Field(min_length=1)] | None = None
    height: Annotated[Number, Field(gt=0, le=MOST)] | None = None

    @model_validator(mode="after")
    def _check(self) -> Self:
        if self.coefficients is None:
            return self
        if self.zones is not None:
            raise PydanticCustomError(
                "two_kinds", "either coefficients or zones", {"key": "zones", "got": "both"}
            )
        angles = [angle for angle, _ in self.coefficients]
        if angles != sorted(set(angles)) or angles[:1] + angles[-1:] != [0, 180]:
            raise PydanticCustomError(
                "angles",
                "pairs of an angle and a coefficient, angles ascending from 0 to 180 degrees",
                {"key": "coefficients", "got": self.coefficients},
            )
        return self

    def settings(self) -> Wind:
        """The wind."""
        coefficients: tuple[tuple[float, float], ...] | tuple[Zone, ...] = NO_CODE
        if self.coefficients is not None:
            coefficients = tuple((float(np.deg2rad(at)), size) for at, size in self.coefficients)
        elif self.zones is not None:
            coefficients = tuple(
                Zone((each.rows[0], each.rows[1]), each.coefficient) for each in self.zones
            )
        direction = float(np.deg2rad(self.direction_deg))
        return Wind(self.speed, self.terrain, direction, coefficients, self.height)


class PointTable(Table):
    """A force at a vertex."""

    at: Vertex
    force: Annotated[list[Load], Field(min_length=3, max_length=3)]

    def settings(self) -> PointLoad:
        """The force."""
        x, y, z = self.force
        return PointLoad((self.at[0], self.at[1]), (x, y, z))


class LoadCaseTable(Table):
    """Loads that act together, or factors of other cases."""

    name: str
    self_weight: bool = False
    pressure: Load = 0.0
    snow: SnowTable | None = None
    wind: WindTable | None = None
    points: list[PointTable] = Field(default_factory=list)
    combine: dict[str, Annotated[Number, Field(ge=-1e3, le=1e3)]] = Field(default_factory=dict)

    @field_validator("name")
    @classmethod
    def _require_line(cls, name: str) -> str:
        if not (name.strip() and name.isprintable() and len(name) <= LONGEST):
            raise PydanticCustomError(
                "name", "one line of 1 to {longest} characters", {"longest": LONGEST}
            )
        return name

    @model_validator(mode="after")
    def _check(self) -> Self:
        loads = [name for name in LOADS if getattr(self, name)]
        if loads and self.combine:
            raise PydanticCustomError(
                "loads_and_factors",
                "no combine beside {loads}: give these loads a case of their own, and combine that",
                {"key": "combine", "got": self.combine, "loads": ", ".join(loads)},
            )
        if not loads and not any(self.combine.values()):
            raise PydanticCustomError(
                "no_load",
                "a load, one of {loads}; or combine, factors of other cases",
                {"loads": ", ".join(LOADS)},
            )
        return self

    def settings(self) -> LoadCase:
        """The case."""
        return LoadCase(
            self.name,
            self.self_weight,
            self.pressure,
            None if self.snow is None else self.snow.settings(),
            None if self.wind is None else self.wind.settings(),
            tuple(each.settings() for each in self.points),
            tuple(self.combine.items()),
        )


def load_cases(tables: Sequence[LoadCaseTable]) -> tuple[LoadCase, ...]:
    """The load cases that tables ask for.

    Raises
    ------
    InputError
        If two have one name, or one combines what is not there or combines others itself.
    """
    cases = tuple(each.settings() for each in tables)
    for number, case in enumerate(cases):
        if case.name in [each.name for each in cases[:number]]:
            raise InputError(
                "two load cases have one name",
                where=f"[[load_case]][{number}] name",
                got=repr(case.name),
            )
    loaded = [case.name for case in cases if not case.combine]
    for number, case in enumerate(cases):
        for name, _ in case.combine:
            if name not in loaded:
                raise InputError(
                    "there is no such load case that has loads of its own",
                    where=f"[[load_case]][{number}] combine",
                    got=repr(name),
                    expected="one of " + ", ".join(map(repr, loaded)) if loaded else "",
                    remedy="" if loaded else "add the cases that are to be combined",
                )
    return cases
