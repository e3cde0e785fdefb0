"""``orishell design``: from a design file to a verified shell and its files."""

from __future__ import annotations

import contextlib
import json
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from orishell.cli.files import STATE_HELP, WRITE_HELP, directory, shortened, state_number
from orishell.cli.printing import say
from orishell.errors import ClashError, InputError

if TYPE_CHECKING:
    from orishell.io.registry import Format
    from orishell.motion import FoldedState, FoldingMotion
    from orishell.report import Shell

QUIET_BELOW = 1_000_000
"""Vertices times states below which no progress bar is worth showing (less than a second)."""


def design(
    file: Annotated[Path, typer.Argument(help="The design file (TOML).")],
    out: Annotated[
        Path, typer.Option(parser=directory, help="Directory for the files; made if needed.")
    ],
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
    from orishell.io import OutputDirectory, Settings
    from orishell.io.formats.html import BUILD_PAGES
    from orishell.io.registry import ALL, FORMATS
    from orishell.report import ClashTest, design_shell
    from orishell.writing import write_shell

    OutputDirectory(out).require_usable()
    formats, number = _formats(write), state_number(state)
    if ALL in write.split(","):
        for each in FORMATS:
            if each not in formats:
                say(f"orishell: warning: {each.file} is left out: {BUILD_PAGES}", err=True)
    with (
        _bar("choosing rows and columns") as searched,
        _bar("looking for contact") as advanced,
        _bar("looking for what works") as mended,
    ):
        clash_test = ClashTest(no_clash_test, allow_clash, advanced, mended)
        try:
            shell = design_shell(file, _watched, clash_test, searched)
        except ClashError as error:
            error.add_note("--allow-clash writes it as it is.")
            raise
    for warning in shell.report["warnings"]:
        say(f"orishell: warning: {warning}", err=True)
    settings = Settings(state=number, workshop=shell.file.workshop)
    earlier = OutputDirectory(out).of_earlier_run()
    written = write_shell(shell, out, formats, settings, _watched)
    if json_report:
        say(json.dumps({**shell.report, "seconds": shell.seconds}, indent=2))
    else:
        _print_summary(shell, written, [path for path in earlier if not path.exists()])


def _formats(names: str) -> tuple[Format, ...]:
    from orishell.io.registry import find_formats

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


def _print_summary(shell: Shell, written: list[Path], removed: list[Path]) -> None:
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
        *_standing_lines(shell),
        *_deviation_lines(shell),
        f"rigid     panel lengths to {residuals['panel_length']:.1e}, fold angles to "
        f"{residuals['fold_angle_rad']:.1e} rad over {len(shell.motion)} states",
        *_lock_lines(shell),
        *(f"wrote     {text}" for text in shortened(written)),
        *(f"removed   {text}, of an earlier run" for text in shortened(removed)),
    ]
    for line in lines:
        say(line)


def _standing_lines(shell: Shell) -> list[str]:
    stands, unit = shell.report["stands"], shell.file.unit
    if shell.file.target is None:
        return []
    if stands is None:
        return [
            "stands    nowhere: f's ends are not its lowest part, so g is left in the plane z = 0"
        ]
    rows = "rows {} and {}".format(*stands["rows"])
    if stands["level"]:
        return [f"stands    level on z = {stands['z']:.4g} on {rows}"]
    return [
        f"stands    on {rows}, from z = {stands['z']:.4g} up to {stands['uneven']:.4g} {unit} above"
    ]


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
    if deviation is None:
        return ["no target: nothing to compare the shell with"]
    surface, approached = deviation["surface"], deviation["approached"]
    lines = [
        f"deviation f {deviation['f']['max']:.4g} {unit}, g {deviation['g']['max']:.4g} {unit}",
        f"surface   max {surface['max']:.4g} {unit} (known to {surface['sample_spacing']:.1g}), "
        f"rms {surface['rms']:.4g} {unit}",
    ]
    if approached is not None:
        size = approached["max"]
        found = "" if size is None else f"; max {size:.4g} {unit} from that"
        lines.append(f"approach  {approached['what']}{found}")
    return lines


def _lock_lines(shell: Shell) -> list[str]:
    from orishell.quoting import in_degrees

    lock, contact = shell.lock, shell.lock.first_contact
    if lock.proof is None:
        return ["not checked: " + "; ".join(shell.report["not_checked"])]
    proved = f"proved over the whole path from {lock.proof.states} states"
    if lock.drive is None or contact is None:
        return [f"lock      none; no panels touch before {in_degrees(lock.target)} deg, {proved}"]
    if lock.cause == "clash":
        first, second = (list(panel) for panel in contact.panels)
        aim = "target" if shell.design.swept is not None else "stage"
        beyond = not lock.early and shell.design.stopped is None
        met = f", beyond the {aim} at {in_degrees(lock.target)} deg" if beyond else ""
        return [
            f"lock      at {in_degrees(lock.drive)} deg{met}: panels {first} and {second} clash "
            f"({contact.kind}), none before: {proved}"
        ]
    what = "by its flaps" if lock.cause == "flaps" else "by a crease folded flat"
    return [f"lock      at {in_degrees(lock.drive)} deg {what}, no contact before: {proved}"]
