"""An emergency shelter: whether it has the room, stands on the ground, travels, and holds.

Run it with ``python examples/shelter.py``; the design is in ``shelter.toml`` beside it.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from orishell import Shell, design_shell


def design() -> Shell:
    """Design the shelter, verify its motion, prove that it opens from its pack."""
    return design_shell(Path(__file__).with_suffix(".toml"))


def measure(shell: Shell) -> dict[str, float]:
    """Room, pack and weight of the shelter, in metres, kilograms and newtons."""
    locked = shell.motion.target.positions[:, shell.design.mechanism.inner_columns]
    ground = locked[[0, -1]]  # the rows on which it stands
    above = np.linalg.norm(locked[..., 1:2], axis=-1) < 0.5  # half a metre from the middle
    quantities, deployment = shell.report.quantities, shell.report.deployment
    packed, weight = deployment.packed, deployment.weight
    assert packed is not None
    assert weight is not None
    return {
        "length": float(np.ptp(ground[..., 0])),
        "clear width": float(ground[0, :, 1].min() - ground[1, :, 1].max()),
        "headroom": float((locked[..., 2] - ground[..., 2].mean())[above].min()),
        "uneven": float(np.ptp(ground[..., 2])),
        "sheet": shell.report.sheet.area,
        "boards": quantities.stock.sheets if quantities.stock else 0,
        "mass": quantities.mass_kg or 0.0,
        "pack length": packed.length,
        "pack width": packed.width,
        "pack height": packed.height,
        "layers": packed.layers,
        "closing force": -weight.at_feet,
        "weight": weight.total,
        "ties": sum(tie.slack is True for tie in deployment.ties),
    }


def main() -> None:
    """Print what an engineer asks first."""
    shell = design()
    size = measure(shell)
    print(f"floor {size['clear width']:.2f} m x {size['length']:.2f} m, clear of the walls")
    print(f"headroom {size['headroom']:.2f} m, on ground that is even to {size['uneven']:.0e} m")
    print(
        f"opens from a pack of {size['pack length']:.2f} m x {size['pack width']:.2f} m, "
        f"{size['layers']} panels on each other: {10 * size['layers']} mm of 10 mm boards at least"
    )
    print(
        f"closes with {size['closing force']:.0f} N of {size['weight']:.0f} N, which flaps carry; "
        f"{size['ties']} ties proved to be slack before"
    )
    print(f"{size['sheet']:.1f} m2 of sheet, {size['mass']:.0f} kg, on {size['boards']} boards")


if __name__ == "__main__":
    main()
