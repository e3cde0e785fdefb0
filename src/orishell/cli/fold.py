"""``orishell fold``: from a crease pattern to its folded states."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated, cast

import typer

from orishell.cli.files import (
    FORCE_HELP,
    WELD_HELP,
    bar,
    directory,
    lines_of,
    say,
    shortened,
    weld_as_option,
)
from orishell.conventions.errors import InputError
from orishell.conventions.meant import no_such
from orishell.conventions.quantities import MILLIMETRES, Unit

MOST_FRAMES = 1000
"""Frames, at most: each is a state of the whole sheet in files and memory."""
LOOSEST = 0.5
"""Degrees."""


def fold(
    file: Annotated[Path, typer.Argument(help="The crease pattern (FOLD, SVG, DXF, CP or OBJ).")],
    out: Annotated[
        Path, typer.Option(parser=directory, help="Directory for the files; made if needed.")
    ],
    *,
    angle: Annotated[
        float | None,
        typer.Option(help="Stop where the largest fold angle is this (degrees, up to 180)."),
    ] = None,
    frames: Annotated[int, typer.Option(help="States to write, the flat one included.")] = 25,
    unit: Annotated[
        str | None,
        typer.Option(help="Unit of length, if the file names none or a wrong one."),
    ] = None,
    tolerance: Annotated[
        float | None,
        typer.Option(help="By how much vertices may miss closing (degrees, up to 0.5; 0.0006)."),
    ] = None,
    weld: Annotated[float | None, typer.Option(help=WELD_HELP)] = None,
    choice: Annotated[
        int, typer.Option(help="Which of the ways to fold it, where letters are missing.")
    ] = 1,
    force: Annotated[bool, typer.Option("--force", help=FORCE_HELP)] = False,
) -> None:
    """Fold a crease pattern, and write its states.

    They are written as FOLD, as glTF and as a page that shows the motion. Panels may have any
    number of corners. Mountains and valleys fold as their letters or colours say; where they are
    missing they are found.
    """
    from orishell.io import OutputDirectory
    from orishell.shell.folded import FORMATS, fold_pattern, write_folded

    output = OutputDirectory(out, inputs=(file,), force=force)
    output.require_usable([each.file for each in FORMATS if each.ready()], replacing=True)
    if unit is not None and unit not in MILLIMETRES:
        raise no_such("there is no such unit", unit, MILLIMETRES, where="--unit")
    if angle is not None and not 0 < angle <= 180:
        raise InputError(
            "this is no fold angle",
            where="--angle",
            got=f"{angle:g}",
            expected="above 0 and at most 180 (degrees)",
        )
    if not 2 <= frames <= MOST_FRAMES:
        raise InputError(
            "these are no frames of a motion",
            where="--frames",
            got=str(frames),
            expected=f"from 2 to {MOST_FRAMES}",
        )
    if tolerance is not None and not 0 < tolerance <= LOOSEST:
        raise InputError(
            "this is no tolerance",
            where="--tolerance",
            got=f"{tolerance:g}",
            expected=f"above 0 and at most {LOOSEST} (degrees)",
        )
    turned = None if angle is None else math.radians(angle)
    own = {} if tolerance is None else {"tolerance": math.radians(tolerance)}
    with bar() as progress, weld_as_option():
        folded = fold_pattern(
            file,
            angle=turned,
            frames=frames,
            unit=cast("Unit | None", unit),
            weld=weld,
            choice=choice,
            progress=progress,
            **own,
        )
    written, missing = write_folded(folded, out, force=force)
    for each in missing:
        say(f"orishell: warning: {each.file} is not written: {each.remedy}", err=True)
    pattern = folded.pattern
    lines = [f"{file}: {len(pattern.faces)} panels, {int(pattern.crease.sum())} creases", ""]
    for row in folded.rows():
        lines += lines_of(row)
    say("\n".join([*lines, "", "wrote " + ", ".join(shortened(written))]))
