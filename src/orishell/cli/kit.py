"""``orishell kit``: what a builder needs of a shell, in folders by trade."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from orishell.cli.files import bar, designed, directory, say, shortened


def kit(
    file: Annotated[Path, typer.Argument(help="The design file (TOML).")],
    out: Annotated[
        Path, typer.Option(parser=directory, help="Directory for the kit; made if needed.")
    ],
    *,
    paper: Annotated[
        bool,
        typer.Option("--paper", help="The kit of a card model at a scale that fits one page."),
    ] = False,
) -> None:
    """Write what a builder needs, in folders by trade.

    They have drawings, tables and a booklet; README.md says what is where.
    """
    from orishell.conventions.quantities import plain
    from orishell.shell.kit import require_kit_place, write_kit

    require_kit_place(out)
    shell = designed(file)
    with bar() as progress:
        made = write_kit(shell, out, paper=paper, progress=progress)
    if paper:
        say(f"scale     1:{plain(1 / made.scale)}")
    for text in shortened(made.files):
        say(f"wrote     {text}")
