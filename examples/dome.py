"""Domes, saddles and free roofs that fold flat: what fits them, and what a builder asks first.

Run it with ``python examples/dome.py``, or with the name of another design (``saddle``,
``free_roof``); the designs are in ``dome.toml``, ``saddle.toml`` and ``free_roof.toml`` beside it.
"""

from __future__ import annotations

import sys
from pathlib import Path

from orishell import Shell, design_shell


def design(name: str = "dome") -> Shell:
    """Fit the shell and verify its motion; prove that no boards meet from pack to flat sheet."""
    return design_shell(Path(__file__).with_name(f"{name}.toml"))


def measure(shell: Shell) -> dict[str, float]:
    """How near it is to its surface, its boards and its pack, in the unit of the file."""
    report = shell.report
    panel, packed, deviation = report.panel, report.deployment.packed, report.deviation
    assert panel is not None
    assert packed is not None
    assert deviation is not None
    assert deviation.surface is not None
    assert deviation.crests is not None
    assert deviation.valleys is not None
    return {
        "distance": deviation.surface.max,
        "vertices": max(deviation.crests.max, deviation.valleys.max),
        "boards": panel.boards,
        "set-back": panel.largest_setback,
        "pack length": packed.length,
        "pack width": packed.width,
        "pack height": packed.height,
    }


def main() -> None:
    """Print them."""
    shell = design(*sys.argv[1:2])
    size = measure(shell)
    print(
        f"within {size['distance']:.3f} m of the surface, vertices within {size['vertices']:.3f} m "
        "of where crests and valleys should lie"
    )
    print(f"{size['boards']} boards, set back by up to {1000 * size['set-back']:.0f} mm")
    print(
        f"a pack of {size['pack length']:.2f} m x {size['pack width']:.2f} m x "
        f"{size['pack height']:.2f} m"
    )


if __name__ == "__main__":
    main()
