"""The command ``orishell``."""

from __future__ import annotations

import sys

import typer

from orishell.cli.design import design
from orishell.cli.new import new
from orishell.errors import OrishellError

app = typer.Typer(
    help="Design deployable origami shells: from two curves to a pattern that folds and locks.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)
app.command()(new)
app.command()(design)


def run() -> None:
    """Run the command line: one message and the contract's exit status for every error."""
    try:
        app()
    except OrishellError as error:
        print(f"orishell: {error}", file=sys.stderr)
        sys.exit(error.exit_status)


if __name__ == "__main__":
    run()
