"""``orishell structure``: whether a designed shell stands, by its own table [structure]."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from orishell.cli.files import directory
from orishell.cli.printing import say
from orishell.cli.progress import bar
from orishell.cli.structure_summary import summarize_structure
from orishell.conventions.errors import InputError


def structure(
    file: Annotated[Path, typer.Argument(help="The design file (TOML), with a table [structure].")],
    out: Annotated[
        Path | None,
        typer.Option(
            parser=directory,
            help="Directory for structure.html, structure.png and structure.json; made if needed.",
        ),
    ] = None,
    *,
    json_report: Annotated[
        bool, typer.Option("--json", help="Print the report as JSON instead of a summary.")
    ] = False,
) -> None:
    """Analyse a shell as a structure.

    What it finds are displacements, forces, buckling and frequencies under its loads.
    """
    from orishell.design_file import read_design_file
    from orishell.io import OutputDirectory
    from orishell.shell.export import write_structure
    from orishell.shell.make import make_shell
    from orishell.shell.parts import MEASURES

    if out is not None:
        OutputDirectory(out).require_usable()
    asked = read_design_file(file)
    if asked.structure is None:
        raise InputError(
            "there is no structure to analyse",
            where=f"{file}: [structure]",
            remedy="add the table [structure]; orishell new writes a file that shows its keys",
        )
    with bar() as progress:
        shell = make_shell(asked, progress, clash="unexamined", leave_out=(*MEASURES, "stock"))
    report = shell.report.structure
    assert report is not None
    for warning in report.warnings:
        say(f"orishell: warning: {warning}", err=True)
    written = [] if out is None else write_structure(shell, out)
    if json_report:
        say(json.dumps(asdict(report), indent=2, allow_nan=False))
    else:
        say("\n".join(summarize_structure(report, shell.report.unit, written)))
