"""``orishell kit``: what a builder needs of a shell, in folders by trade."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from orishell.cli.files import FORCE_HELP, bar, designed, directory, say, shortened, warn_of_unused

NARROW_MM = 5.0
"""Narrower panels of card are hard to score and to fold by hand: a fold takes twice its thickness,
and fingers about as much beside it."""
WIDER = "larger paper or a larger paper_scale, on several pages, in [workshop]"


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
    from orishell.conventions.quantities import plain, size
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
    if made.narrowest is not None and made.narrowest < NARROW_MM:
        narrow = size(made.narrowest, "mm", digits=2)
        say(f"panels    as narrow as {narrow}, which is hard to fold: {WIDER}")
    for text in shortened(made.files):
        say(f"wrote     {text}")
