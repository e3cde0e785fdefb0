"""What commands share: printing, the progress bar, options for formats and directories."""

from __future__ import annotations

import contextlib
import re
import sys
import time
from collections.abc import Collection, Iterable, Iterator
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Final

import typer

from orishell.conventions.errors import InputError, printable
from orishell.conventions.meant import no_such
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.quantities import SPACE
from orishell.io.formats import ALL, format_modules

if TYPE_CHECKING:
    from orishell.conventions.row import About, Row
    from orishell.design_file import DesignFile
    from orishell.shell.make import Shell
    from orishell.shell.steps import ClashPolicy
    from orishell.structure.results import Analysis


def say(text: str, *, err: bool = False) -> None:
    """Print lines, with all control characters but line breaks escaped."""
    text = text.replace(SPACE, " ")  # that of pages, before units
    typer.echo("\n".join(map(printable, text.split("\n"))), err=err)


def lines_of(row: Row) -> Iterator[str]:
    """A row of the verdict, and what mends it."""
    from orishell.conventions.row import MARKS

    yield f"{MARKS[row.sign]} {row.subject:<9} {row.finding}"
    if row.remedy:
        yield f"            -> {row.remedy}"


CHECK_HELP = "End with status 1 if it is not known to carry all its load cases."
FORCE_HELP = (
    "Write over files that orishell did not write, or that were changed since; never over what "
    "this command reads."
)


def require_loads(asked: DesignFile) -> None:
    """Refuse to check, before any work is done, what a design file asks no loads of.

    Raises InputError.
    """
    if asked.structure is None:
        raise InputError(
            "there are no loads to check",
            file=asked.path,
            where="--check",
            remedy="add the tables [structure] and [[load_case]]",
        )


def require_carried(report: Analysis | None, *, check: bool) -> None:
    """End with status 1, if that is asked for, where a shell does not carry its load cases."""
    if check and (report is None or not report.carries):
        raise typer.Exit(1)


WAIT = 1.0
"""Work that takes less time than this shows no bar (seconds)."""


@contextlib.contextmanager
def bar() -> Iterator[Progress]:
    """A progress bar on a terminal, for whatever takes longer than a second."""
    if not sys.stderr.isatty():
        yield no_progress
        return
    from rich.console import Console
    from rich.progress import Progress as Bars

    bars = Bars(console=Console(stderr=True), transient=True)
    task = bars.add_task("", total=1.0)
    begin: dict[str, float] = {}

    def progress(share: float, what: str) -> None:
        begin.setdefault(what, time.monotonic())
        if time.monotonic() - begin[what] > WAIT and not bars.live.is_started:
            bars.start()
        bars.update(task, completed=share, description=what)
        if share == 1.0:
            begin.pop(what)
            bars.stop()

    try:
        yield progress
    finally:
        bars.stop()


@contextlib.contextmanager
def weld_as_option() -> Iterator[None]:
    """What is refused with a tolerance that helps names the option of the command."""
    try:
        yield
    except InputError as error:
        if "weld" in error.changes:
            error.remedy = f"--weld {error.changes['weld']:g} joins them"
        raise


OF_BUILDING: Final[frozenset[About | None]] = frozenset(
    {
        *("board", "roll", "stock", "opens", "chamfers", "play"),
        *("points", "patch", "pulled", "weight", "cells", "linear"),
    }
)
"""What notes are about that are of no use to a model of card: boards, ties, feet on the ground."""


def designed(asked: DesignFile, clash: ClashPolicy = "refused", *, card: bool = False) -> Shell:
    """The shell of a design file; its warnings are printed.

    card: Whether a model of card is made of it, so that those of building it are left out.
    """
    from orishell.shell.make import make_shell

    # First what is known before any work, which may take minutes.
    for note in asked.notes:
        say(f"orishell: warning: {note}", err=True)
    with bar() as progress:
        shell = make_shell(asked, progress, clash=clash)
    for warning in shell.report.warnings:
        if warning in asked.notes or (card and getattr(warning, "about", None) in OF_BUILDING):
            continue
        say(f"orishell: warning: {warning}", err=True)
    return shell


def warn_of_unused(keys: Collection[str]) -> None:
    """Name keys of a design file that nothing has asked for."""
    if keys:
        say(f"orishell: warning: nothing here uses {', '.join(keys)}", err=True)


WRITE_HELP = f"Further formats, separated by commas: {', '.join(format_modules())}; or {ALL}."

FILE_HELP = "The FOLD file, or the directory that `orishell design` wrote it to."

STATES = ("flat", "target", "pack", "open")
WELD_HELP = (
    "Points of the pattern that are nearer to each other than this are one (a length in the file's "
    "unit)."
)
STATE_HELP = (
    f"State for formats that show only one: {', '.join(STATES)}, or a frame's number. Without it: "
    "target, but flat for what is printed (3mf)."
)


def directory(text: str) -> Path:
    """The path of the output directory; refuses an empty name, which would be this directory."""
    if not text:
        raise InputError("the name is empty", where="--out", expected="the name of a directory")
    return Path(text)


def state_named(text: str | None) -> int | str | None:
    """The state that ``--state`` asks for: a name or a number; None if it asks for none."""
    if text is None or text in STATES:
        return text
    if text.isascii() and text.isdecimal() and len(text) < 10:
        return int(text)
    expected = f"{', '.join(STATES)}, or the number of a frame from 0"
    raise no_such("there is no such state", text, STATES, where="--state", expected=expected)


def shortened(paths: Iterable[Path]) -> list[str]:
    """Paths to print; of three or more numbered files only the first and the last."""

    def kind(path: Path) -> tuple[str, str, bool]:
        stem = re.sub(r"-[0-9]+$", "", path.stem)
        return stem, path.suffix, stem != path.stem

    listed = []
    for (_, _, numbered), group in groupby(sorted(paths, key=kind), key=kind):
        files = sorted(group, key=lambda path: (len(path.name), path.name))
        if numbered and len(files) > 2:
            listed.append(f"{files[0]} ... {files[-1].name} ({len(files)} files)")
        else:
            listed += map(str, files)
    return listed
