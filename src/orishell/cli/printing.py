"""All that commands say goes through here: no file's text gives orders to the terminal."""

from __future__ import annotations

import typer

from orishell.errors import printable


def say(text: str, *, err: bool = False) -> None:
    """Print lines, every other control character as an escape.

    Parameters
    ----------
    text
        The lines.
    err
        Whether on standard error.
    """
    typer.echo("\n".join(map(printable, text.split("\n"))), err=err)
