"""``orishell design``: from a design file to a verified shell and its files."""

from __future__ import annotations

import contextlib
import json
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Annotated

import typer

from orishell.cli.files import STATE_HELP, WRITE_HELP, shortened, state_number
from orishell.errors import InputError
from orishell.io import OutputDirectory, Settings
from orishell.io.registry import ALL, FORMATS, Format, find_formats
from orishell.motion import FoldedState, FoldingMotion
from orishell.quoting import in_degrees
from orishell.report import ClashTest, Shell, design_shell
from orishell.writing import write_shell

BUILD = "make studio builds the viewer"
QUIET_BELOW = 1_000_000
"""Vertices times states below which no progress bar is worth showing (less than a second)."""


def design(
    file: Annotated[Path, typer.Argument(help="The design file (TOML).")],
    out: Annotated[Path, typer.Option(help="Directory for the files; made if needed.")],
    *,
    json_report: Annotated[
        bool, typer.Option("--json", help="Print the report as JSON instead of a summary.")
    ] = False,
    allow_clash: Annotated[
        bool,
        typer.Option("--allow-clash", help="Write a shell whose panels meet before it locks, too."),
    ] = False,
    no_clash_test: Annotated[
        bool,
        typer.Option("--no-clash-test", help="Do not look for contact (for very fine sheets)."),
    ] = False,
    write: Annotated[str, typer.Option(help=WRITE_HELP)] = "",
    state: Annotated[str, typer.Option(help=STATE_HELP)] = "locked",
) -> None:
    """Design a shell, verify its motion, write shell.fold, report.json and two pictures."""
    OutputDirectory(out).require_usable()
    formats, number = _formats(write), state_number(state)
    if ALL in write.split(","):
        for each in FORMATS:
            if each not in formats:
                typer.echo(f"orishell: warning: {each.file} is left out: {BUILD}", err=True)
    with _bar("choosing rows and columns") as searched, _bar("looking for contact") as advanced:
        clash_test = ClashTest(skipped=no_clash_test, allowed=allow_clash, advanced=advanced)
        shell = design_shell(file, _watched, clash_test, searched)
    for warning in shell.report["warnings"]:
        typer.echo(f"orishell: warning: {warning}", err=True)
    settings = Settings(state=number, workshop=shell.file.workshop)
    written = write_shell(shell, out, formats, settings, _watched)
    if json_report:
        typer.echo(json.dumps({**shell.report, "seconds": shell.seconds}, indent=2))
    else:
        _print_summary(shell, written)


def _formats(names: str) -> tuple[Format, ...]:
    try:
        return find_formats(name for name in names.split(",") if name.strip())
    except InputError as error:
        raise error.located("--write:") from None


def _watched(motion: FoldingMotion, what: str) -> Iterator[FoldedState]:
    """Show a progress bar on standard error while the states go by."""
    if len(motion) * motion.mechanism.grid.vertex_count < QUIET_BELOW or not sys.stderr.isatty():
        yield from motion
        return
    from rich.console import Console
    from rich.progress import track

    yield from track(motion, description=what, console=Console(stderr=True), transient=True)


@contextlib.contextmanager
def _bar(what: str) -> Iterator[Callable[[float], None] | None]:
    """A progress bar on standard error for a search, if it takes a second."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import Progress

    bar = Progress(console=Console(stderr=True), transient=True)
    task = bar.add_task(what, total=1.0)
    begin: list[float] = []

    def advanced(share: float) -> None:
        bar.update(task, completed=share)
        if share == 1.0:
            bar.stop()
            return
        begin.append(time.monotonic())
        if begin[-1] - begin[0] > 1 and not bar.live.is_started:
            bar.start()

    try:
        yield advanced
    finally:
        bar.stop()


def _print_summary(shell: Shell, written: list[Path]) -> None:
    report, unit = shell.report, shell.file.unit
    sheet, deployed, residuals = report["sheet"], report["deployed"], report["residuals"]
    grid = shell.motion.mechanism.grid
    lines = [
        f"{report['family']}: {report['rows']} x {report['columns']} inner vertices, "
        f"{grid.panel_count} panels",
        *_choice_lines(shell),
        f"sheet     {sheet['width']:.4g} x {sheet['height']:.4g} {unit}, "
        f"area {sheet['area']:.4g} {unit}2",
        f"deployed  {deployed['width']:.4g} x {deployed['depth']:.4g} x "
        f"{deployed['height']:.4g} {unit}",
        _standing_line(shell),
        f"deviation f {report['deviation']['f']['max']:.4g} {unit}, "
        f"g {report['deviation']['g']['max']:.4g} {unit}",
        *_deviation_lines(shell),
        f"rigid     panel lengths to {residuals['panel_length']:.1e}, fold angles to "
        f"{residuals['fold_angle_rad']:.1e} rad over {len(shell.motion)} states",
        *_lock_lines(shell),
        *(f"wrote     {text}" for text in shortened(written)),
    ]
    for line in lines:
        typer.echo(line)


def _standing_line(shell: Shell) -> str:
    stands, unit = shell.report["stands"], shell.file.unit
    if stands is None:
        return (
            "stands    nowhere: f's ends are not its lowest part, so g is left in the plane z = 0"
        )
    rows = "rows {} and {}".format(*stands["rows"])
    if stands["level"]:
        return f"stands    level on z = {stands['z']:.4g} on {rows}"
    return (
        f"stands    on {rows}, from z = {stands['z']:.4g} up to {stands['uneven']:.4g} {unit} above"
    )


def _choice_lines(shell: Shell) -> list[str]:
    if shell.choice is None or shell.file.tolerance is None:
        return []
    limit = shell.file.tolerance.surface
    return [
        f"chosen    for {limit:g} {shell.file.unit} from the surface, with the fewest panels of "
        f"{shell.choice.tried} designs tried"
    ]


def _deviation_lines(shell: Shell) -> list[str]:
    deviation, unit = shell.report["deviation"], shell.file.unit
    surface, approached = deviation["surface"], deviation["approached"]
    lines = [
        f"surface   max {surface['max']:.4g} {unit} (known to {surface['sample_spacing']:.1g}), "
        f"rms {surface['rms']:.4g} {unit}"
    ]
    if approached is not None:
        size = approached["max"]
        found = "" if size is None else f"; max {size:.4g} {unit} from that"
        lines.append(f"approach  {approached['what']}{found}")
    return lines


def _lock_lines(shell: Shell) -> list[str]:
    lock, contact = shell.lock, shell.lock.first_contact
    if lock.proof is None:
        return ["not checked: " + "; ".join(shell.report["not_checked"])]
    proved = f"proved over the whole path from {lock.proof.states} states"
    if lock.drive is None or contact is None:
        return [f"lock      none; no panels touch before {in_degrees(lock.target)} deg, {proved}"]
    if lock.cause == "clash":
        first, second = (list(panel) for panel in contact.panels)
        met = "" if lock.early else f", beyond the target at {in_degrees(lock.target)} deg"
        return [
            f"lock      at {in_degrees(lock.drive)} deg{met}: panels {first} and {second} clash "
            f"({contact.kind}), none before: {proved}"
        ]
    what = "by its flaps" if lock.cause == "flaps" else "by a crease folded flat"
    return [f"lock      at {in_degrees(lock.drive)} deg {what}, no contact before: {proved}"]
