"""A design file with what its target's files draw in it: it needs no other file then."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from orishell.conventions.toml_file import read_toml
from orishell.design_file.drawing import DrawingTable
from orishell.design_file.file import read_design_file
from orishell.design_file.surface import SurfaceTable
from orishell.design_file.target import Target


def embedded(path: Path) -> dict[str, Any]:
    """The tables of a design file, with what files of its target draw in place of their names.

    Parameters
    ----------
    path
        The design file.

    Raises
    ------
    InputError
        As when it is read.
    """
    read_design_file(path)
    tables = read_toml(path)
    kinds: dict[str, type[SurfaceTable | DrawingTable | Target]]
    kinds = {"surface": SurfaceTable, "pattern": DrawingTable}
    kinds |= dict.fromkeys(("f", "g", "inner"), Target)
    for name, table in tables.get("target", {}).items():
        if name not in kinds:
            continue  # sizes, which no file has
        named = {"file": table} if isinstance(table, str) else table
        target = kinds[name].model_validate(named)
        tables["target"][name] = target.without_files(path.parent, tables["shell"]["unit"])
    return tables
