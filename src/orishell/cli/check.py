"""``orishell check``: verifies a crease pattern and its folded states."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from orishell.cli.printing import say

if TYPE_CHECKING:
    from orishell.inspection import Inspection
    from orishell.io import FoldFrame

TOLERANCE = 1e-6
"""That of :data:`orishell.inspection.TOLERANCE`, which ``--help`` is not to import."""
QUIET_BELOW = 30_000
"""Vertices times frames below which no progress bar is worth showing (less than a second)."""


def check(
    file: Annotated[
        Path,
        typer.Argument(help="The crease pattern (FOLD), with its frames; or where design wrote."),
    ],
    tolerance: Annotated[
        float,
        typer.Option(help="Allowed error of lengths, relative to the diagonal of the flat sheet."),
    ] = TOLERANCE,
    json_report: Annotated[
        bool, typer.Option("--json", help="Print the report as JSON instead of a summary.")
    ] = False,
) -> None:
    """Verify a quadrilateral crease pattern: developable, rigid, fold angles, signs, contact."""
    from orishell.inspection import inspect_fold
    from orishell.io import read_fold
    from orishell.io.manifest import require_one_run
    from orishell.io.registry import FOLD

    if os.path.isdir(file):  # a name that is too long is none
        file /= FOLD.file
    require_one_run(file)
    inspection = inspect_fold(read_fold(file), tolerance, _watched)
    if json_report:
        say(json.dumps(inspection.as_dict(), indent=2, allow_nan=False))
    else:
        _print_summary(inspection)
    if not inspection.passed:
        raise typer.Exit(1)


def _watched(frames: Sequence[FoldFrame], what: str) -> Iterator[FoldFrame]:
    """Show a progress bar on standard error while the frames go by."""
    if len(frames) * len(frames[0].positions) < QUIET_BELOW or not sys.stderr.isatty():
        yield from frames
        return
    from rich.console import Console
    from rich.progress import track

    yield from track(frames, description=what, console=Console(stderr=True), transient=True)


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
        + f", diagonal {report['diagonal']:.4g} {report['unit']}"
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
