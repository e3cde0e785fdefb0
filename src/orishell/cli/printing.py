"""Printing with control characters escaped, so that no file can send them to the terminal."""

from __future__ import annotations

import typer

from orishell.conventions.errors import printable


def say(text: str, *, err: bool = False) -> None:
    """Print lines, with all control characters but line breaks escaped.

    Parameters
    ----------
    text
        The lines.
    err
        Whether on standard error.
    """
    typer.echo("\n".join(map(printable, text.split("\n"))), err=err)
