"""What is wrong with a design file, and where in it."""

from __future__ import annotations

from itertools import takewhile
from pathlib import Path
from typing import Any, Final

from pydantic import ValidationError

from orishell.conventions.errors import InputError
from orishell.conventions.faults import Place, first_fault
from orishell.conventions.table_keys import Location, TableKeys
from orishell.conventions.toml_file import read_toml

LISTS = ("load_case",)
"""Tables of which there may be several."""


OTHERS: Final = {
    **dict.fromkeys(
        (".obj", ".stl", ".ply", ".glb", ".gltf"),
        "a design file names it: orishell new canopy --mesh {name} writes one",
    ),
    **dict.fromkeys(
        (".svg", ".dxf"),
        'a design file names it: {key} = "{name}" in [target.f]; a crease pattern is for orishell '
        "check and fold",
    ),
    ".csv": 'a design file names it: points = "{name}" in [target.f]',
    ".fold": "orishell check, fold and convert read FOLD files",
    **dict.fromkeys(
        (".3dm", ".dwg", ".step", ".stp", ".igs", ".ifc", ".skp", ".blend"),
        "export what is meant from there, as DXF or SVG a curve, as OBJ a mesh",
    ),
    **dict.fromkeys(
        (".docx", ".odt", ".rtf", ".pdf", ".xlsx"),
        "a design file is plain text: orishell new shelter writes one",
    ),
}
"""What files are for that are no design files, by their endings."""


def read_tables(path: Path) -> dict[str, Any]:
    """The tables of a design file, not checked; what is none is refused with what it is for."""
    try:
        return read_toml(path, "design file", "orishell new shelter writes one to begin with")
    except InputError as error:
        ending = path.suffix.lower()
        if ending not in OTHERS or error.what.endswith("does not exist"):
            raise
        remedy = OTHERS[ending].format(name=path.name, key=ending[1:])
        raise InputError("this is no design file", file=path, remedy=remedy) from None


def explain(
    path: Path,
    raw: dict[str, Any],
    error: ValidationError,
    keys: TableKeys,
    inside: tuple[str, ...] = (),
) -> InputError:
    """One message for the first fault; the others follow, a line each."""

    def place(location: Location) -> Place:
        table = takewhile(lambda part: isinstance(part, str), location)
        return {"file": path, "where": _spell(location), "keys": (".".join(map(str, table)),)}

    return first_fault(raw, error, place, keys, inside)


def _spell(location: Location) -> str:
    """("target", "f", "range", 0) as "[target.f] range[0]", of lists "[[table]][0] key"."""
    names = [part[:60] if isinstance(part, str) else part for part in location]
    table, *rest = names
    if table == "target" and rest:
        table, *rest = f"target.{rest[0]}", *rest[1:]
    head = f"[[{table}]]" if table in LISTS else f"[{table}]"
    return head + "".join(f"[{part}]" if isinstance(part, int) else f" {part}" for part in rest)
