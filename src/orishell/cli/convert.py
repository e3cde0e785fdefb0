"""``orishell convert``: writes a FOLD file in another format."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from orishell.cli.files import STATE_HELP, shortened, state_number
from orishell.cli.printing import say
from orishell.errors import InputError
from orishell.units import MILLIMETRES


def convert(
    file: Annotated[Path, typer.Argument(help="The crease pattern (FOLD), with its frames.")],
    out: Annotated[Path, typer.Argument(help="The file to write; its ending names the format.")],
    state: Annotated[str, typer.Option(help=STATE_HELP)] = "locked",
    workshop: Annotated[
        Path | None,
        typer.Option(help=r"A TOML file with a table \[workshop], for instance a design file."),
    ] = None,
    unit: Annotated[
        str | None,
        typer.Option(help="Unit of length, where the FOLD file names none: mm, cm, m, in, ft."),
    ] = None,
) -> None:
    """Write a crease pattern and its folded states in another format."""
    from orishell.io import Settings
    from orishell.spec import read_workshop
    from orishell.workshop import DEFAULT
    from orishell.writing import convert_fold

    if unit is not None and unit not in MILLIMETRES:
        raise InputError(
            "there is no such unit",
            where="--unit",
            got=repr(unit),
            expected="one of " + ", ".join(MILLIMETRES),
        )
    settings = Settings(
        state=state_number(state),
        workshop=DEFAULT if workshop is None else read_workshop(workshop),
    )
    for text in shortened(convert_fold(file, out, settings, unit)):
        say(f"wrote {text}")
