"""``orishell new``: a design file to begin with."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from orishell.cli.files import say
from orishell.conventions.errors import InputError


def new(
    family: Annotated[
        str | None, typer.Argument(help="The family; without one they are listed.")
    ] = None,
    file: Annotated[Path | None, typer.Argument(help="The file to write [FAMILY.toml].")] = None,
) -> None:
    """Write a starter design file."""
    from orishell.design_file import starter_file
    from orishell.families.registry import FAMILIES

    if family is None:
        raise InputError(
            "no family is named",
            remedy="orishell new FAMILY, with one of these",
            detail="\n".join(f"    {name:31}{each.what}" for name, each in FAMILIES.items()),
        )
    text = starter_file(family)
    path = file if file is not None else Path(f"{family}.toml")
    try:
        with path.open("x", encoding="utf-8") as stream:
            stream.write(text)
    except FileExistsError:
        raise InputError(
            "the file exists already", where=str(path), remedy="choose another name"
        ) from None
    except OSError as error:
        raise InputError(
            "the file cannot be written", where=str(path), got=error.strerror or str(error)
        ) from None
    say(f"wrote {path}")
    say(f"next: orishell design {path} --out {path.stem}")
