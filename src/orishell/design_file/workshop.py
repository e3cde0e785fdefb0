"""The table [workshop] of any TOML file."""

from __future__ import annotations

from pathlib import Path

from pydantic import ValidationError

from orishell.conventions.errors import InputError
from orishell.conventions.toml_file import read_toml
from orishell.design_file.faults import explain
from orishell.workshop import Workshop


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
        keys = list(Workshop.model_fields)
        raise explain(path, raw, error, lambda _: keys, ("workshop",)) from None
    try:
        return table.beside(path.parent)
    except InputError as error:
        raise error.located(f"{path}:") from None
