"""Commands on FOLD files: ``orishell check`` and ``orishell convert``."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, cast

import typer

from orishell.cli.files import FILE_HELP, STATE_HELP, bar, say, shortened, state_named
from orishell.conventions.errors import InputError
from orishell.conventions.quantities import MILLIMETRES, Unit, plain

if TYPE_CHECKING:
    from orishell.verification import Inspection

TOLERANCE = 1e-6
"""The same as :data:`orishell.verification.TOLERANCE`, without importing it for ``--help``."""


def check(
    file: Annotated[
        Path,
        typer.Argument(help=FILE_HELP),
    ],
    tolerance: Annotated[
        float,
        typer.Option(help="Allowed error of lengths, relative to the diagonal of the flat sheet."),
    ] = TOLERANCE,
    json_report: Annotated[
        bool, typer.Option("--json", help="Print the report as JSON instead of a summary.")
    ] = False,
) -> None:
    """Check a FOLD file: flat sheet, rigidity, creases, contact.

    All its panels must be quadrilaterals; further vertices may lie on their sides.
    """
    from orishell.io import read_fold
    from orishell.io.formats.fold import FORMAT as FOLD
    from orishell.io.output import require_one_run
    from orishell.verification import inspect_fold

    if os.path.isdir(file):  # a name that is too long is none
        file /= FOLD.file
    require_one_run(file)
    pattern = read_fold(file)
    try:
        with bar() as progress:
            inspection = inspect_fold(pattern, tolerance, progress)
    except InputError as error:
        if "tolerance" in error.keys:
            error.where = "--tolerance"
        raise
    if json_report:
        say(json.dumps(inspection.as_dict(), indent=2, allow_nan=False))
    else:
        _print_summary(inspection)
    if not inspection.passed:
        raise typer.Exit(1)


def _print_summary(inspection: Inspection) -> None:
    report = inspection.as_dict()
    flat, frames = report["flat_frame"], len(report["frames"])
    say(
        f"{report['file']}: {report['panels']} panels, {report['creases']} creases, "
        f"{report['inner_vertices']} inner vertices"
    )
    say(
        f"frames    {frames}, "
        + ("none of them flat" if flat is None else f"flat sheet in frame {flat}")
        + f", diagonal {plain(report['diagonal'])} {report['unit']}"
    )
    if report["turned_panels"]:
        say(f"turned    {report['turned_panels']} panels listed the other way round")
    width = max(len(check.name) for check in inspection.checks)
    for each in inspection.checks:
        verdict = "PASS" if each.passed else "FAIL"
        name = each.name.replace("_", " ")
        say(f"{verdict}  {name:{width}}  {each.text}")
    for text in inspection.not_checked:
        say(f"not checked: {text}")


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
    from orishell.io.formats.fold import FORMAT as FOLD
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
