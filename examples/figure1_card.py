"""Figure 1 in paper and card: whether a sheet of each will do, and what is cut from them.

Run it with ``python examples/figure1_card.py [DIRECTORY]``, which writes the drawings to cut; the
design is in ``figure1_card.toml`` beside it.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from orishell import FoldingMotion, Mechanism
from orishell.design import PanelBuild
from orishell.design_file import DesignFile, read_design_file
from orishell.document import Document
from orishell.document.from_design import document_of_motion
from orishell.io.formats.svg import write_svg
from orishell.io.settings import Settings
from orishell.sheet.boards import Boards
from orishell.solids import build_boards, largest_folds
from orishell.workshop.board_parts import board_parts
from orishell.workshop.quantities import measure_quantities


def read() -> DesignFile:
    """The design file."""
    return read_design_file(Path(__file__).with_suffix(".toml"))


def document(file: DesignFile) -> Document:
    """The sheet with its boards, which let it fold as far as its target."""
    design = file.pattern.design(file.f, file.g).with_clipped_flaps()
    assert design.clipped is not None
    assert file.panel is not None
    return document_of_motion(
        FoldingMotion(design.mechanism, file.frames),
        file.unit,
        title="Figure 1 in card",
        curves=design.targets,
        clipped=design.clipped,
        panel=file.panel,
        boards=boards_of(design.mechanism, file.panel),
        flaps=boards_of(design.clipped, file.panel),
    )


def boards_of(sheet: Mechanism, build: PanelBuild) -> Boards:
    """Boards set back for all folds from the flat sheet to the target."""
    folds = largest_folds(sheet, sheet.target_drive)
    return build_boards(sheet.positions(0.0), sheet.grid, build, folds)


def measure(file: DesignFile, model: Document) -> dict[str, float]:
    """Sizes in millimetres, mass in grams."""
    import shapely

    quantities = measure_quantities(model, file.workshop)
    built, paper = quantities.built, quantities.stock
    assert built is not None
    assert paper is not None
    assert built.stock_sheets is not None
    assert built.mass_kg.total is not None
    outlines = [shapely.Polygon(part.outline) for part in board_parts(model)]
    width, height = np.ptp(model.require_flat(), axis=0).tolist()
    return {
        "width": width,
        "height": height,
        "paper": paper.sheets,
        "card": built.stock_sheets,
        "boards": built.boards.top + built.boards.bottom,
        "narrowest": 2 * min(shapely.maximum_inscribed_circle(each).length for each in outlines),
        "mass": 1000 * built.mass_kg.total,
        "largest fold": float(np.abs(model.fold_angles_deg).max()),
    }


def main() -> None:
    """Print what it takes; write the drawings if a directory is named."""
    file = read()
    model = document(file)
    size = measure(file, model)
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
        write_svg(directory / "pattern.svg", model, Settings(workshop=file.workshop))


if __name__ == "__main__":
    main()
