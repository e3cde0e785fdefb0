"""The command ``orishell``."""

from __future__ import annotations

import os
import sys
import traceback
from pathlib import Path

import typer

from orishell.cli.check import check
from orishell.cli.convert import convert
from orishell.cli.design import design
from orishell.cli.new import new
from orishell.cli.solve import solve
from orishell.cli.studio import studio
from orishell.errors import OrishellError

app = typer.Typer(
    help="Design deployable origami shells: from two curves to a pattern that folds and locks.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)
app.command()(new)
app.command()(design)
app.command()(solve)
app.command()(check)
app.command()(convert)
app.command()(studio)


def run() -> None:
    """Run the command line: one message and the contract's exit status for every error."""
    # Read when numpy is first imported. Its matrices are small here: threads only wait for work.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    try:
        app()
    except OrishellError as error:
        print(f"orishell: {error}", file=sys.stderr)
        sys.exit(error.exit_status)
    except Exception as error:
        place = traceback.extract_tb(error.__traceback__)[-1]
        print(
            f"orishell: a fault of the program, please report it: {type(error).__name__}: {error} "
            f"({Path(place.filename).name}, line {place.lineno})",
            file=sys.stderr,
        )
        sys.exit(1)


if __name__ == "__main__":
    run()
