"""The shelter as a kit of boards: how they stand back, what it weighs, and how small it packs.

Run it with ``python examples/shelter_boards.py``; the design is in ``shelter_boards.toml`` beside
it.
"""

from __future__ import annotations

import math
from pathlib import Path

from orishell import Shell, design_shell


def design() -> Shell:
    """Design the shelter, prove that no boards meet between its pack and the flat sheet."""
    return design_shell(Path(__file__).with_suffix(".toml"))


def measure(shell: Shell) -> dict[str, float]:
    """Boards, mass and pack of the shelter, in metres, degrees and kilograms."""
    panel, built = shell.report.panel, shell.report.quantities.built
    packed = shell.report.deployment.packed
    assert panel is not None
    assert panel.meeting is not None
    assert built is not None
    assert built.stock_sheets is not None
    assert built.mass_kg.boards is not None
    assert built.mass_kg.membrane is not None
    assert packed is not None
    return {
        "boards": panel.boards,
        "largest fold": math.degrees(panel.largest_fold),
        "largest set-back": panel.largest_setback,
        "stop of flaps": panel.stop_deg,
        "corners cut": panel.corners_cut,
        "flaps bear": panel.meeting.total,
        "pack length": packed.length,
        "pack width": packed.width,
        "pack height": packed.height,
        "layers": packed.layers,
        "board area": built.board_area,
        "fabric area": built.membrane_area,
        "hinges": built.hinge_length,
        "mass of boards": built.mass_kg.boards,
        "mass of fabric": built.mass_kg.membrane,
        "sheets of board": built.stock_sheets,
    }


def main() -> None:
    """Print what a builder asks first."""
    size = measure(design())
    print(
        f"{size['boards']} boards, set back by up to {1000 * size['largest set-back']:.0f} mm from "
        f"creases that fold by up to {size['largest fold']:.1f} degrees"
    )
    print(
        f"a pack of {size['pack length']:.2f} m x {size['pack width']:.2f} m x "
        f"{size['pack height']:.2f} m, {size['layers']} panels on each other"
    )
    print(
        f"{size['mass of boards']:.0f} kg of boards from {size['sheets of board']} sheets, "
        f"{size['mass of fabric']:.0f} kg of fabric, {size['hinges']:.0f} m of hinges"
    )
    print(
        f"flaps stop {size['stop of flaps']:.2f} degrees short of folding flat, and bear "
        f"on {size['flaps bear']:.1f} m of edges"
    )


if __name__ == "__main__":
    main()
