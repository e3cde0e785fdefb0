"""The command ``orishell``."""

from __future__ import annotations

import os
import sys
import traceback
from pathlib import Path
from typing import Annotated

import typer

from orishell.cli.check import check, convert
from orishell.cli.design import design
from orishell.cli.files import say
from orishell.cli.fold import fold
from orishell.cli.hops import hops
from orishell.cli.kit import kit
from orishell.cli.new import new
from orishell.cli.search import search
from orishell.cli.solve import solve
from orishell.cli.structure import structure
from orishell.cli.studio import studio
from orishell.conventions.errors import OrishellError
from orishell.conventions.version import __version__

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,  # it takes [workshop] for markup, and leaves it out
)
# What stands behind a size in several words, as in 6 x 3, is asked about by the command itself.
app.command(context_settings={"allow_extra_args": True})(new)
for command in (design, kit, structure, search, solve, check, convert, fold, studio, hops):
    app.command()(command)


def _print_version(asked: bool) -> None:
    if asked:
        typer.echo(f"orishell {__version__}")
        raise typer.Exit


@app.callback()
def _main(
    version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_print_version, is_eager=True, help="Show the version and exit."
        ),
    ] = False,
) -> None:
    """Design deployable origami shells: from two curves to a pattern that folds and locks."""


def run() -> None:
    """Run the command line; an error prints one message and sets the exit status."""
    # Read when numpy is first imported. Its matrices are small here: threads only wait for work.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    try:
        app()
    except OrishellError as error:
        notes = getattr(error, "__notes__", [])
        say(f"orishell: {' '.join([str(error), *notes])}", err=True)
        sys.exit(error.exit_status)
    except Exception as error:
        place = traceback.extract_tb(error.__traceback__)[-1]
        say(
            f"orishell: a fault of the program, please report it: {type(error).__name__}: {error} "
            f"({Path(place.filename).name}, line {place.lineno})",
            err=True,
        )
        sys.exit(1)


if __name__ == "__main__":
    run()
