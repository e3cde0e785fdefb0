"""``orishell structure``: whether a designed shell stands, and the summary that it prints."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from orishell.cli.carry import make_it_carry
from orishell.cli.files import (
    CHECK_HELP,
    FORCE_HELP,
    bar,
    directory,
    lines_of,
    require_carried,
    say,
    shortened,
    warn_of_unused,
)

if TYPE_CHECKING:
    from orishell.structure.results import Analysis


def summarize_structure(
    report: Analysis, unit: str, written: list[Path], remedy: str = ""
) -> Iterator[str]:
    """Lines that say whether it carries its loads, what was analysed, and what was written."""
    from orishell.conventions.row import Row
    from orishell.io.sections import section_lines
    from orishell.structure.pages.sections import answer, structure_sections

    yield from lines_of(Row(report.sign, "stands", report.in_words(), remedy))
    yield from section_lines([answer(report, unit), *structure_sections(report, unit)])
    yield from (f"wrote     {text}" for text in shortened(written))


def structure(
    file: Annotated[Path, typer.Argument(help="The design file (TOML), with a table [structure].")],
    out: Annotated[
        Path | None,
        typer.Option(
            parser=directory,
            help="Directory for structure.html, structure.png, structure.json, creases.csv, "
            "anchors.csv and forces.csv; made if needed.",
        ),
    ] = None,
    *,
    carry: Annotated[
        bool,
        typer.Option(
            "--make-it-carry",
            help="Find designs that carry all load cases instead, the lightest first; --out writes "
            "them as design files. Status 1 if there is none.",
        ),
    ] = False,
    json_report: Annotated[
        bool, typer.Option("--json", help="Print the report as JSON instead of a summary.")
    ] = False,
    check: Annotated[bool, typer.Option("--check", help=CHECK_HELP)] = False,
    force: Annotated[bool, typer.Option("--force", help=FORCE_HELP)] = False,
) -> None:
    """Analyse a shell as a structure: whether it carries its loads.

    What it finds are displacements, forces, buckling and frequencies under its loads.
    """
    from orishell.conventions.record import as_table
    from orishell.design_file import read_design_file
    from orishell.io import OutputDirectory
    from orishell.shell.analyse import require_structure
    from orishell.shell.export import write_structure
    from orishell.shell.make import make_shell
    from orishell.shell.steps import MEASURES
    from orishell.structure.pages.files import FILES

    asked = read_design_file(file)
    require_structure(asked)
    if carry:
        make_it_carry(asked, out, json_report=json_report, force=force)
        return
    if out is not None:
        OutputDirectory(out, inputs=asked.inputs, force=force).require_usable(FILES)
    with bar() as progress:
        shell = make_shell(asked, progress, clash="unexamined", skip=(*MEASURES, "stock"))
    report = shell.report.structure
    assert report is not None
    remedy = next(each.remedy for each in shell.report.verdict if each.subject == "stands")
    for warning in report.warnings:
        say(f"orishell: warning: {warning}", err=True)
    written = [] if out is None else write_structure(shell, out, force=force)
    warn_of_unused(asked.keys.unused(beside=("motion", "search", "workshop")))
    if json_report:
        say(json.dumps(as_table(report), indent=2, allow_nan=False))
    else:
        say("\n".join(summarize_structure(report, shell.report.unit, written, remedy)))
    require_carried(report, check=check)
