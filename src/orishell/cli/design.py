"""``orishell design``: from a design file to a verified shell, its files and its summary."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from orishell.cli.files import (
    CHECK_HELP,
    FORCE_HELP,
    STATE_HELP,
    WRITE_HELP,
    bar,
    designed,
    directory,
    lines_of,
    require_carried,
    require_loads,
    say,
    shortened,
    state_named,
    warn_of_unused,
)
from orishell.conventions.errors import ClashError, InputError

if TYPE_CHECKING:
    from orishell.shell.make import Shell
    from orishell.shell.steps import ClashPolicy


def summarize(shell: Shell, written: list[Path], removed: list[Path]) -> Iterator[str]:
    """Lines that say what was designed, what was found, and which files were written."""
    report = shell.report
    bill = report.quantities
    walls = sum(each.panels for each in report.end_walls)
    on = bill.clipped - walls
    clipped = f", {on} of them clipped on" * (on > 0) + f", {walls} in end walls" * (walls > 0)
    yield (
        f"{report.family}: {report.rows} x {report.columns} inner vertices, "
        f"{bill.panels} panels{clipped}"
    )
    if report.chosen is not None:
        yield (
            f"chosen for {report.chosen.tolerance:g} {report.unit} from the surface, with the "
            f"fewest panels of {report.chosen.designs_tried} designs tried{_on_stock(shell)}"
        )
    for row in report.verdict:
        yield from lines_of(row)
    yield from (f"wrote     {text}" for text in shortened(written))
    yield from (f"removed   {text}, from an earlier run" for text in shortened(removed))


def _on_stock(shell: Shell) -> str:
    """That panels were chosen to fit the stock, without its margins."""
    workshop = shell.file.workshop
    if workshop.stock is None:
        return ""
    wide, high = workshop.usable_stock
    unit = shell.report.unit
    return f" whose panels fit {wide:g} x {high:g} {unit}, the stock without its margins"


MAKING = ("cut", "paper", "kit")
"""Tasks of formats that are what [workshop] is for: else that table is not asked for."""


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
        typer.Option(
            "--allow-clash", help="Write the files even if panels meet before the target."
        ),
    ] = False,
    no_clash_test: Annotated[
        bool,
        typer.Option("--no-clash-test", help="Do not look for contact (for very fine sheets)."),
    ] = False,
    write: Annotated[str, typer.Option(help=WRITE_HELP)] = "",
    state: Annotated[str | None, typer.Option(help=STATE_HELP)] = None,
    check: Annotated[bool, typer.Option("--check", help=CHECK_HELP)] = False,
    force: Annotated[bool, typer.Option("--force", help=FORCE_HELP)] = False,
) -> None:
    """Design a shell, verify its motion and write its files.

    They are shell.fold, report.json and pictures, and what --write names.
    """
    from orishell.design_file import read_design_file
    from orishell.io import OutputDirectory, Settings
    from orishell.io.formats import formats_for
    from orishell.shell.export import write_shell

    sure = _sure_files(write)
    shown = state_named(state)
    clash: ClashPolicy = "unexamined" if no_clash_test else "allowed" if allow_clash else "refused"
    asked = read_design_file(file)
    if check:
        require_loads(asked)
    output = OutputDirectory(out, inputs=asked.inputs, force=force)
    output.require_usable(sure, replacing=True)
    try:
        shell = designed(asked, clash)
    except ClashError as error:
        error.add_note("--allow-clash writes the files all the same.")
        raise
    chosen, missing = formats_for(write.split(","), shell.document)
    for each in missing:
        say(f"orishell: warning: {each.file} is not written: {each.remedy}", err=True)
    settings = Settings.showing(shown, shell.file.workshop)
    earlier = output.of_earlier_run()
    with bar() as progress:
        written = write_shell(shell, out, chosen, settings, progress, force=force)
    beside = ("search",) if any(each.task in MAKING for each in chosen) else ("search", "workshop")
    warn_of_unused(asked.keys.unused(beside))
    if json_report:
        say(json.dumps({**shell.report.as_dict(), "seconds": shell.seconds}, indent=2))
    else:
        removed = [path for path in earlier if not path.exists()]
        say("\n".join(summarize(shell, written, removed)))
    require_carried(shell.report.structure, check=check)


def _sure_files(names: str) -> list[str]:
    """Files that will be written, as far as that is known before the shell is.

    Refuses unknown formats, and named ones that cannot be written here.
    """
    from orishell.io.formats import find_formats
    from orishell.shell.export import ALWAYS

    asked = names.split(",")
    try:
        found = find_formats(asked)
        for each in found:
            each.require_ready()
    except InputError as error:
        raise error.located("--write:") from None
    return [*ALWAYS, *(each.file for each in found if each.name in asked or each.fits_all)]
