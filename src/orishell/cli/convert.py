"""``orishell convert``: writes a FOLD file in another format."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated, cast

import typer

from orishell.cli.files import FILE_HELP, STATE_HELP, shortened, state_named
from orishell.cli.printing import say
from orishell.conventions.errors import InputError
from orishell.conventions.units import MILLIMETRES, Unit


def convert(
    file: Annotated[Path, typer.Argument(help=FILE_HELP)],
    out: Annotated[Path, typer.Argument(help="The file to write; its ending names the format.")],
    state: Annotated[str | None, typer.Option(help=STATE_HELP)] = None,
    workshop: Annotated[
        Path | None,
        typer.Option(help="A TOML file with a table [workshop], for instance a design file."),
    ] = None,
    unit: Annotated[
        str | None,
        typer.Option(help="Unit of length, where the FOLD file names none: mm, cm, m, in, ft."),
    ] = None,
) -> None:
    """Write a FOLD file in another format."""
    from orishell.design_file import read_workshop
    from orishell.io import Settings
    from orishell.io.all_formats import FOLD
    from orishell.shell.export import convert_fold
    from orishell.workshop import DEFAULT

    if unit is not None and unit not in MILLIMETRES:
        raise InputError(
            "there is no such unit",
            where="--unit",
            got=repr(unit),
            expected="one of " + ", ".join(MILLIMETRES),
        )
    if os.path.isdir(file):  # a name that is too long is none
        file /= FOLD.file
    settings = Settings.showing(
        state_named(state), DEFAULT if workshop is None else read_workshop(workshop)
    )
    try:
        written = convert_fold(file, out, settings, cast("Unit | None", unit))
    except InputError as error:
        if error.where.endswith(" unit"):
            error.add_note("--unit says which it is.")
        raise
    for text in shortened(written):
        say(f"wrote {text}")
