"""The tables of a design file."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Annotated, Any, Literal, Self

from pydantic import BaseModel, Field, ValidationInfo, field_validator, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.faults import Location
from orishell.conventions.table import Number, Table
from orishell.conventions.units import Unit
from orishell.design_file.deployment import DeploymentTable
from orishell.design_file.load_case import LoadCaseTable
from orishell.design_file.panel import PanelTable, SetbackTable
from orishell.design_file.search import SearchTable, search_table_at
from orishell.design_file.structure import StructureTable, table_at
from orishell.design_file.target import Target, Targets
from orishell.design_file.workshop import WorkshopTable
from orishell.families.registry import FAMILIES
from orishell.locking import CONTACT_TOLERANCE

Ground = Literal["z0", "as-drawn"]
"""Where a shell that can stand is put: its feet on z = 0, or g in the plane z = 0."""


class ShellTable(Table):
    """What is designed."""

    family: str
    unit: Unit
    ground: Ground = "z0"


class MotionTable(Table):
    """States that are written, and what counts as contact."""

    frames: Annotated[int, Field(ge=2, le=1000)] = 25
    contact_tolerance: Annotated[Number, Field(gt=0, le=1e-4)] = CONTACT_TOLERANCE


class ToleranceTable(Table):
    """How near the shell is to be to its surface."""

    surface: Annotated[Number, Field(gt=0)]
    panel_min: Annotated[Number, Field(ge=0)] = 0.0
    panel_max: Annotated[float, Field(gt=0)] = math.inf

    @model_validator(mode="after")
    def _check(self) -> Self:
        if not self.panel_min < self.panel_max:
            raise PydanticCustomError(
                "panel_sizes",
                "a value above panel_min ({low})",
                {"low": self.panel_min, "key": "panel_max", "got": self.panel_max},
            )
        return self


class FileTable(Table):
    """All tables of a design file; those of the family's pattern are checked by the family."""

    shell: ShellTable
    target: Annotated[Targets | None, Field(validate_default=True)] = None
    pattern: dict[str, Any] = Field(default_factory=dict)
    tolerance: ToleranceTable | None = None
    motion: MotionTable = MotionTable()
    deployment: DeploymentTable = DeploymentTable()
    panel: PanelTable = PanelTable()
    structure: StructureTable | None = None
    load_case: list[LoadCaseTable] = Field(default_factory=list)
    workshop: WorkshopTable = WorkshopTable()
    search: SearchTable | None = None

    @field_validator("target")
    @classmethod
    def _require_target(cls, target: Targets | None, info: ValidationInfo) -> Targets | None:
        shell = info.data.get("shell")
        family = FAMILIES.get(shell.family) if shell is not None else None
        if target is None and (family is None or family.pattern.needs_target):
            raise PydanticCustomError("missing", "Field required")
        return target


def keys_of(model: type[BaseModel]) -> Callable[[Location], list[str]]:
    """The keys that each table of the file may hold, given the family's pattern.

    Parameters
    ----------
    model
        The table [pattern] of the family.
    """
    tables: dict[str, type[BaseModel]] = {
        "shell": ShellTable,
        "tolerance": ToleranceTable,
        "motion": MotionTable,
        "deployment": DeploymentTable,
        "panel": PanelTable,
        "pattern": model,
        "workshop": WorkshopTable,
    }

    def keys(location: Location) -> list[str]:
        match location:
            case (_,):
                table: type[BaseModel] = FileTable
            case ("target", _):
                table = Targets
            case ("target", *_):
                table = Target
            case ("panel", "largest_setback", *_):
                table = SetbackTable
            case ("structure" | "load_case", *_):
                table = table_at(location)
            case ("search", *_):
                table = search_table_at(location)
            case _:
                table = tables[str(location[0])]
        return [field.alias or name for name, field in table.model_fields.items()]

    return keys
