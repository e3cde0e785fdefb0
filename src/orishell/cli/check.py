"""Commands on crease patterns: ``orishell check`` and ``orishell convert``."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, cast

import typer

from orishell.cli.files import (
    FILE_HELP,
    FORCE_HELP,
    STATE_HELP,
    WELD_HELP,
    bar,
    lines_of,
    say,
    shortened,
    state_named,
    weld_as_option,
)
from orishell.conventions.errors import InputError
from orishell.conventions.meant import no_such
from orishell.conventions.quantities import MILLIMETRES, Unit, counted, plain

if TYPE_CHECKING:
    from orishell.conventions.progress import Progress
    from orishell.conventions.row import Row
    from orishell.io import ReadPattern
    from orishell.verification import Inspection
    from orishell.verification.pattern import PatternVerdict

CHECKED_HELP = (
    "A FOLD, SVG, DXF, CP or OBJ file, or the directory that `orishell design` wrote FOLD to."
)
DRAWINGS = (".svg", ".dxf", ".cp", ".obj")

MANY_EDGES = 5000
"""Of sheets with more edges what is known is said before their motion is found."""
LENGTH_TOLERANCE = 1e-6
"""That of :data:`orishell.verification.LENGTH_TOLERANCE`, not imported for ``--help``."""


def check(
    file: Annotated[Path, typer.Argument(help=CHECKED_HELP)],
    tolerance: Annotated[
        float,
        typer.Option(help="Allowed error of lengths, relative to the diagonal of the flat sheet."),
    ] = LENGTH_TOLERANCE,
    weld: Annotated[float | None, typer.Option(help=WELD_HELP)] = None,
    *,
    json_report: Annotated[
        bool, typer.Option("--json", help="Print the report as JSON instead of a summary.")
    ] = False,
    nearby: Annotated[
        Path | None,
        typer.Option(help="A FOLD file to write: a sheet nearby that folds, if there is one."),
    ] = None,
    force: Annotated[bool, typer.Option("--force", help=FORCE_HELP)] = False,
) -> None:
    """Check a crease pattern and its folded states.

    Says whether it folds, in how many ways, how far, and what meets first. Folded states of a FOLD
    file are examined: lengths, planes, fold angles, contact in each.
    """
    from orishell.io import OutputDirectory
    from orishell.io.formats.fold import FORMAT as FOLD
    from orishell.io.manifest import require_one_run

    if os.path.isdir(file):  # a name that is too long is none
        file /= FOLD.file
    require_one_run(file)
    if nearby is not None:
        OutputDirectory(nearby.parent, inputs=(file,), force=force).require_usable([nearby.name])
    try:
        with bar() as progress, weld_as_option():
            inspection, verdict = _examined(file, tolerance, weld, progress)
    except InputError as error:
        if "tolerance" in error.keys:
            error.where = "--tolerance"
        raise
    if json_report:
        report = inspection.as_dict() if inspection else {}
        if verdict is not None:
            report = report | ({"pattern": verdict.as_dict()} if inspection else verdict.as_dict())
            report["degrees_of_freedom"] = verdict.degrees_of_freedom
        say(json.dumps(report, indent=2, allow_nan=False))
    elif inspection is not None:
        _print_summary(inspection, verdict)
    elif verdict is not None:
        _print_verdict(verdict)
    if nearby is not None:
        _write_nearby(verdict, nearby, force=force)
    if not all(each.passed for each in (inspection, verdict) if each is not None):
        raise typer.Exit(1)


def _examined(
    file: Path, tolerance: float, weld: float | None, progress: Progress
) -> tuple[Inspection | None, PatternVerdict | None]:
    """What is found of the states of a file, if it has such panels, and of how its sheet folds.

    The second is None where there are folded states beside the flat one, to be examined instead.
    """
    from orishell.io import read_pattern
    from orishell.io.fold_frames import read_frames
    from orishell.io.fold_reader import fold_of_frames
    from orishell.io.patterns.read import pattern_of_frames
    from orishell.verification import inspect_fold, require_tolerance

    require_tolerance(tolerance)
    if file.suffix.lower() in DRAWINGS or weld is not None:
        return None, _judged(read_pattern(file, weld=weld), tolerance, progress)
    frames = None
    try:
        frames = read_frames(file)
        states = fold_of_frames(file, frames)
    except InputError:  # what is wrong with it is said, if it is no pattern either
        read = read_pattern(file) if frames is None else pattern_of_frames(file, frames)
        return None, _judged(read, tolerance, progress)
    inspection = inspect_fold(states, tolerance, progress)
    if inspection.folded and inspection.sheet.flat:
        return inspection, None
    try:
        pattern = pattern_of_frames(file, frames)
    except InputError:  # what is wrong with it is said by the inspection
        return inspection, None
    return inspection, _judged(pattern, tolerance, progress, inspected=True)


def _judged(
    read: ReadPattern, tolerance: float, progress: Progress, *, inspected: bool = False
) -> PatternVerdict:
    """What is found of how a sheet folds; of a large one what is known is said at once."""
    from orishell.verification.pattern import judge_pattern

    def so_far(rows: tuple[Row, ...]) -> None:
        if len(read.edges) > MANY_EDGES:
            said = [counted(len(read.faces), "panel"), counted(len(read.edges), "edge")]
            say(f"so far: {', '.join(said)}", err=True)
            for row in rows:
                say("\n".join(lines_of(row)), err=True)

    return judge_pattern(
        read, tolerance=tolerance, inspected=inspected, progress=progress, so_far=so_far
    )


def _write_nearby(verdict: PatternVerdict | None, target: Path, *, force: bool) -> None:
    from orishell.shell.nearby import write_nearby

    if verdict is None:
        raise InputError(
            "nothing nearby is looked for where a file has folded states, or no flat sheet",
            where="--nearby",
        )
    write_nearby(verdict, target, force=force)
    say(f"wrote {target}", err=True)


def _print_verdict(verdict: PatternVerdict) -> None:
    read, found = verdict.read, verdict.findings
    parts = [counted(len(read.faces), "panel"), counted(len(read.edges), "edge")]
    if found is not None:
        parts.append(counted(len(found.pattern.inner), "inner vertex", "inner vertices"))
    say(f"{read.path}: {', '.join(parts)}")
    for row in verdict.rows:
        say("\n".join(lines_of(row)))
    for note in read.notes:
        say(f"note: {note}")
    if verdict.nearby is not None:
        say("note: --nearby FILE writes the sheet nearby that folds")


def _print_summary(inspection: Inspection, verdict: PatternVerdict | None) -> None:
    from orishell.verification.pattern.rows import of_freedom

    file, flat = inspection.file, inspection.flat_frame
    parts = [
        counted(len(file.mesh.faces), "panel"),
        counted(inspection.creases, "crease"),
        counted(inspection.inner_vertices, "inner vertex", "inner vertices"),
    ]
    say(f"{file.path}: {', '.join(parts)}")
    say(
        f"frames    {len(file.frames)}, "
        + ("none of them flat" if flat is None else f"flat sheet in frame {flat}")
        + f", diagonal {plain(inspection.sheet.diagonal)} {file.unit}"
    )
    if inspection.turned_panels:
        say(f"turned    {inspection.turned_panels} panels listed the other way round")
    width = max(len(check.name) for check in inspection.checks)
    for each in inspection.checks:
        outcome = "PASS" if each.passed else "FAIL"
        name = each.name.replace("_", " ")
        say(f"{outcome}  {name:{width}}  {each.text}")
    if inspection.freedom and (verdict is None or verdict.strips is None):
        say("\n".join(lines_of(of_freedom(inspection.freedom))))
    for row in () if verdict is None else verdict.rows:
        say("\n".join(lines_of(row)))
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
    *,
    force: Annotated[bool, typer.Option("--force", help=FORCE_HELP)] = False,
) -> None:
    """Write a FOLD file in another format."""
    from orishell.design_file import read_workshop
    from orishell.io import OutputDirectory, Settings
    from orishell.io.formats.fold import FORMAT as FOLD
    from orishell.shell.export import convert_fold

    if unit is not None and unit not in MILLIMETRES:
        raise no_such("there is no such unit", unit, MILLIMETRES, where="--unit")
    if os.path.isdir(file):  # a name that is too long is none
        file /= FOLD.file
    read = (file,) if workshop is None else (file, workshop)
    OutputDirectory(out.parent, inputs=read, force=force).require_usable([out.name])
    cutting = () if workshop is None else (read_workshop(workshop),)
    settings = Settings.showing(state_named(state), *cutting)
    try:
        written = convert_fold(file, out, settings, cast("Unit | None", unit), force=force)
    except InputError as error:
        if error.where.endswith(" unit"):
            error.add_note("--unit says which it is.")
        raise
    for text in shortened(written):
        say(f"wrote {text}")
