"""The tables of a design file, and what they ask of each other."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal

from pydantic import BaseModel, Field, ValidationError, ValidationInfo, field_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.errors import InputError
from orishell.conventions.meant import no_such
from orishell.conventions.quantities import Unit, conversion
from orishell.conventions.table import Number, Several, Table
from orishell.conventions.table_keys import TableKeys
from orishell.conventions.toml_file import read_toml
from orishell.deployment import FROM_FLAT, Deployment
from orishell.design import PanelSpec
from orishell.design.end_walls import EndWall
from orishell.design.stiffeners import Stiffeners
from orishell.design_file.constructions import require_a_core, require_one_thickness
from orishell.design_file.faults import LISTS, explain
from orishell.design_file.search import Search
from orishell.design_file.targets import Targets
from orishell.families.pattern import AnyPattern
from orishell.families.registry import FAMILIES
from orishell.families.tolerance import Tolerance
from orishell.motion.drawing import Drawing
from orishell.motion.sizes import CONTACT_TOLERANCE
from orishell.structure.load_settings import OWN_WEIGHT, LoadCase
from orishell.structure.materials import materials
from orishell.structure.settings import Structure, StructureTable
from orishell.workshop import DEFAULT, Workshop

Values = dict[str, Any]
"""What keys of the design file have, by key, the tables in front of it."""


def value_at(tables: Any, key: str) -> Any:
    """What tables have at a dotted key; None if they have nothing there."""
    for part in key.split("."):
        if isinstance(tables, list) and part.isdecimal() and int(part) < len(tables):
            tables = tables[int(part)]
        elif isinstance(tables, dict):
            tables = tables.get(part)
        else:
            return None
    return tables


def with_values(tables: Any, values: Mapping[str, Any]) -> Any:
    """Tables with other values at dotted keys, in lists a number from 0; None removes a key.

    What a key names need not exist. Raises LookupError if it names an entry that a list does not
    have, or stands in what is no table.
    """
    for key, value in values.items():
        tables = _with_value(tables, key.split("."), value)
    return tables


def _with_value(tables: Any, keys: list[str], value: Any) -> Any:
    if not keys:
        return value
    first, *rest = keys
    match tables:
        case list():
            if not (first.isascii() and first.isdecimal() and int(first) < len(tables)):
                raise LookupError(first)
            inner = _with_value(tables[int(first)], rest, value)
            return [*tables[: int(first)], inner, *tables[int(first) + 1 :]]
        case dict():
            if value is None and not rest:
                return {key: inner for key, inner in tables.items() if key != first}
            return {**tables, first: _with_value(tables.get(first, {}), rest, value)}
    raise LookupError(first)


def read_workshop(path: Path) -> Workshop:
    """The table [workshop] of a TOML file, which may hold others: a design file will do.

    Raises
    ------
    InputError
        Naming the file, the key, what was found and what is expected.
    """
    raw = read_toml(path, "workshop file")
    if "workshop" not in raw:
        raise InputError("this file has no table [workshop]", where=str(path))
    try:
        table = Workshop.model_validate(raw["workshop"])
    except ValidationError as error:
        raise explain(path, raw, error, keys_of(), ("workshop",)) from None
    try:
        return table.beside(path.parent)
    except InputError as error:
        raise error.in_file(path) from None


def structure_of(
    table: StructureTable | None,
    cases: tuple[LoadCase, ...],
    panel: PanelSpec | None,
    unit: str,
) -> Structure | None:
    """The structure that a design file asks for, by default under own weight; None without table.

    Raises InputError if load cases or the thickness of panels do not fit.
    """
    if table is None:
        if cases:
            raise InputError(
                "load cases need a structure that they load",
                where="[[load_case]]",
                keys=("load_case",),
                remedy="add the table [structure], or remove the load cases",
            )
        return None
    require_one_thickness(table, panel)
    _require_names(cases)
    structure = table.filled(unit).under(cases or (OWN_WEIGHT,))
    require_a_core(structure, panel)
    _require_one_name_each(structure)
    return structure


def weighed(
    table: StructureTable | None, panel: PanelSpec | None, workshop: Workshop, unit: str
) -> tuple[PanelSpec | None, Workshop]:
    """Panels, or the sheet if they have no thickness, with the material's density if none is given.

    unit: Of length.
    """
    if table is None or table.material is None or workshop.areal_density:
        return panel, workshop
    made, metres = materials()[table.material], conversion(unit, "m")
    if panel is not None:
        density = panel.density or made.density_of(panel.board * metres)
        return panel.replace_unchecked(density=density), workshop
    thickness = (table.thickness or 0.0) * metres
    density = made.density_of(thickness)
    return None, workshop.replace_unchecked(areal_density=density * thickness)


def _require_one_name_each(structure: Structure) -> None:
    """Refuse cases whose arrangements or combinations have the name of another."""
    names = [case.name for case in structure.arranged]
    twice = [name for name, count in Counter(names).items() if count > 1]
    if twice:
        raise InputError(
            "a load case has the name of an arrangement, or of a combination, of others",
            where="[[load_case]] name",
            keys=("load_case",),
            got=repr(twice[0]),
        )


def _require_names(cases: tuple[LoadCase, ...]) -> None:
    """Refuse two cases of one name, and combinations of what is not there or combines itself."""
    for number, case in enumerate(cases):
        if case.name in [each.name for each in cases[:number]]:
            raise InputError(
                "two load cases have one name",
                where=f"[[load_case]][{number}] name",
                keys=("load_case",),
                got=repr(case.name),
            )
    loaded = [case.name for case in cases if not case.combine]
    for number, case in enumerate(cases):
        for name in case.combine:
            if name not in loaded:
                said = {
                    "where": f"[[load_case]][{number}] combine",
                    "keys": ("load_case",),
                    "expected": "one of " + ", ".join(map(repr, loaded)) if loaded else "",
                    **({} if loaded else {"remedy": "add the cases that are to be combined"}),
                }
                what = "there is no such load case that has loads of its own"
                raise no_such(what, name, loaded, **said)


Ground = Literal["z0", "as-drawn"]
"""Where a shell that can stand is put: its feet on z = 0, or g in the plane z = 0."""


class ShellTable(Table):
    """What is designed."""

    SAMPLE: ClassVar = {"family": "auto", "unit": "m"}

    family: str
    unit: Unit
    ground: Ground = "z0"


class MotionTable(Table):
    """States that are written, and what counts as contact."""

    frames: Annotated[int, Field(ge=2, le=1000)] = 25
    contact_tolerance: Annotated[Number, Field(gt=0, le=1e-4)] = CONTACT_TOLERANCE


ANY_SIZE = (1, 2)
"""Rows and columns of a pattern whose size is still to be chosen."""


class FileTable(Table):
    """All tables of a design file; those of the family's pattern are checked by the family."""

    shell: ShellTable
    target: Annotated[Targets | None, Field(validate_default=True)] = None
    pattern: dict[str, Any] = Field(default_factory=dict)
    tolerance: Tolerance | None = None
    motion: MotionTable = MotionTable()
    deployment: Deployment = FROM_FLAT
    panel: PanelSpec = PanelSpec()
    stiffeners: Stiffeners | None = None
    end_wall: Several[EndWall] = ()
    structure: StructureTable | None = None
    load_case: Several[LoadCase] = ()
    workshop: Workshop = DEFAULT
    search: Search | None = None

    @field_validator("target")
    @classmethod
    def _require_target(cls, target: Targets | None, info: ValidationInfo) -> Targets | None:
        shell = info.data.get("shell")
        family = FAMILIES.get(shell.family) if shell is not None else None
        drawn = family is not None and "drawing" in family.pattern.aims()
        if target is None and drawn:
            what = "this family makes a shell of a drawn sheet"
            what += ': write pattern = "sheet.svg" in [target]'
            raise PydanticCustomError("source", what, {"key": "target.pattern"})
        if target is None and (family is None or family.pattern.needs_target()):
            raise PydanticCustomError("missing", "Field required")
        if target is not None and drawn != (target.pattern is not None):
            if drawn:
                what = "this family makes a shell of a drawn sheet: give target.pattern alone"
                raise PydanticCustomError("source", what, {"key": "f" if target.f else "surface"})
            what = 'a drawn sheet asks for family = "pattern"'
            raise PydanticCustomError("source", what, {"key": "pattern"})
        swept = family is not None and not family.pattern.follows_surfaces()
        if target is not None and target.surface is not None and swept:
            able = [each.name for each in FAMILIES.values() if each.pattern.follows_surfaces()]
            what = "f and g, which this family sweeps; a surface asks for family = {able}"
            raise PydanticCustomError("source", what, {"able": " or ".join(able), "key": "surface"})
        return target


def sized(path: Path, file: FileTable, drawing: Drawing | None) -> dict[str, Any]:
    """The table [pattern] with rows and columns where a drawing or a tolerance says them."""
    if drawing is not None:
        size, why = drawing.inner, "rows and columns are those of the drawn sheet"
        remove = ""
        if file.tolerance is not None:
            raise InputError(why, file=path, keys=("tolerance",), remedy="remove the table")
    elif file.tolerance is not None:
        if file.target is None:
            raise InputError(
                "a tolerance needs a target to be measured from",
                file=path,
                keys=("tolerance",),
                remedy="add [target.f] and [target.g], or remove the table [tolerance] and give "
                "rows and columns",
            )
        size, why = ANY_SIZE, "rows and columns are chosen where there is a tolerance"
        remove = ", or the table [tolerance]"
    else:
        return file.pattern
    for key in ("rows", "columns"):
        if key in file.pattern:
            raise InputError(
                why,
                file=path,
                keys=(f"pattern.{key}",),
                got=repr(file.pattern[key]),
                remedy=f"remove {key}{remove}",
            )
    return {**file.pattern, "rows": size[0], "columns": size[1]}


def keys_of(pattern: type[BaseModel] = AnyPattern) -> TableKeys:
    """The keys of a design file of a family with this pattern."""
    return TableKeys(FileTable, {"pattern": pattern}, LISTS)
