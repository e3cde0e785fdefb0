"""``orishell kit``: what a builder needs of a shell, in folders by trade."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from orishell.cli.files import FORCE_HELP, bar, designed, directory, say, shortened, warn_of_unused


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
    force: Annotated[bool, typer.Option("--force", help=FORCE_HELP)] = False,
) -> None:
    """Write what a builder needs, in folders by trade.

    They have drawings, tables and a booklet; README.md says what is where.
    """
    from orishell.conventions.quantities import plain
    from orishell.design_file import read_design_file
    from orishell.shell.kit import require_kit_place, write_kit

    asked = read_design_file(file)
    require_kit_place(asked, out, paper=paper, force=force)
    shell = designed(asked, card=paper)
    with bar() as progress:
        made = write_kit(shell, out, paper=paper, progress=progress, force=force)
    warn_of_unused(made.unused)
    if paper:
        say(f"scale     1:{plain(1 / made.scale)}")
    for text in shortened(made.files):
        say(f"wrote     {text}")
