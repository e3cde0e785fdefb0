"""The tables of a design file."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Annotated, Any, Literal, get_args

from pydantic import BaseModel, Field, ValidationInfo, field_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.faults import Location
from orishell.conventions.table import Number, Several, Table
from orishell.conventions.units import Unit
from orishell.deployment import FROM_FLAT, Deployment
from orishell.design import PanelSpec
from orishell.design_file.search import Search
from orishell.design_file.target import Targets
from orishell.families.pattern import Tolerance
from orishell.families.registry import FAMILIES
from orishell.locking import CONTACT_TOLERANCE
from orishell.structure.settings import LoadCase, StructureTable
from orishell.workshop import DEFAULT, Workshop

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


class FileTable(Table):
    """All tables of a design file; those of the family's pattern are checked by the family."""

    shell: ShellTable
    target: Annotated[Targets | None, Field(validate_default=True)] = None
    pattern: dict[str, Any] = Field(default_factory=dict)
    tolerance: Tolerance | None = None
    motion: MotionTable = MotionTable()
    deployment: Deployment = FROM_FLAT
    panel: PanelSpec = PanelSpec()
    structure: StructureTable | None = None
    load_case: Several[LoadCase] = ()
    workshop: Workshop = DEFAULT
    search: Search | None = None

    @field_validator("target")
    @classmethod
    def _require_target(cls, target: Targets | None, info: ValidationInfo) -> Targets | None:
        shell = info.data.get("shell")
        family = FAMILIES.get(shell.family) if shell is not None else None
        if target is None and (family is None or family.pattern.needs_target):
            raise PydanticCustomError("missing", "Field required")
        return target


def keys_of(pattern: type[BaseModel]) -> Callable[[Location], list[str]]:
    """The keys that may stand beside the last one of a location.

    Parameters
    ----------
    pattern
        The table [pattern] of the family.
    """

    def keys(location: Location) -> list[str]:
        table: type[BaseModel] = FileTable
        for key in location[:-1]:
            if table is FileTable and key == "pattern":
                table = pattern
            elif key in table.model_fields:
                table = next(_tables_in(table.model_fields[str(key)].annotation), table)
        return [field.alias or name for name, field in table.model_fields.items()]

    return keys


def _tables_in(annotation: Any) -> Iterator[type[BaseModel]]:
    """The tables among the types that a value may have."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for each in get_args(annotation):
        yield from _tables_in(each)
