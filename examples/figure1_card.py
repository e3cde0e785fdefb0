"""Figure 1 in paper and card: whether a sheet of each will do, and what is cut from them.

Run it with ``python examples/figure1_card.py [DIRECTORY]``, which writes the drawings to cut; the
design is in ``figure1_card.toml`` beside it.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from orishell import Shell, design_shell
from orishell.io.format import Settings
from orishell.io.formats.svg import write_svg
from orishell.workshop.board_sheets import board_parts


def design() -> Shell:
    """Design the shell, prove that its boards meet nowhere on the way to the target."""
    return design_shell(Path(__file__).with_suffix(".toml"))


def measure(shell: Shell) -> dict[str, float]:
    """Sizes in millimetres, mass in grams."""
    import shapely

    built, paper = shell.report.quantities.built, shell.report.quantities.stock
    assert built is not None
    assert paper is not None
    assert built.stock_sheets is not None
    assert built.mass_kg.total is not None
    outlines = [shapely.Polygon(part.outline) for part in board_parts(shell.document)]
    width, height = np.ptp(shell.document.require_flat(), axis=0).tolist()
    return {
        "width": width,
        "height": height,
        "paper": paper.sheets,
        "card": built.stock_sheets,
        "boards": built.boards.top + built.boards.bottom,
        "narrowest": 2 * min(shapely.maximum_inscribed_circle(each).length for each in outlines),
        "mass": 1000 * built.mass_kg.total,
        "largest fold": float(np.abs(shell.document.fold_angles_deg).max()),
    }


def main() -> None:
    """Print what it takes; write the drawings if a directory is named."""
    shell = design()
    size = measure(shell)
    print(
        f"{size['width']:.0f} mm x {size['height']:.0f} mm of paper on {size['paper']} sheet of A3"
    )
    print(
        f"{size['boards']} boards on {size['card']} sheet of card, "
        f"the narrowest {size['narrowest']:.1f} mm wide"
    )
    print(f"{size['mass']:.0f} g; it folds by {size['largest fold']:.1f} degrees at most")
    if len(sys.argv) > 1:
        directory = Path(sys.argv[1])
        directory.mkdir(parents=True, exist_ok=True)
        settings = Settings(workshop=shell.file.workshop)
        write_svg(directory / "pattern.svg", shell.document, settings)


if __name__ == "__main__":
    main()
