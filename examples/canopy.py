"""A ring canopy about an open court, from one sheet that is hardly more than half a ring.

Run it with ``python examples/canopy.py``; the design is in ``canopy.toml`` beside it.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from orishell import Shell, design_shell


def design() -> Shell:
    """Design the canopy, verify its motion, prove that it locks."""
    return design_shell(Path(__file__).with_suffix(".toml"))


def measure(shell: Shell) -> dict[str, float]:
    """Sizes of the canopy, in metres, and how far the ring opens when it is flat."""
    flat, locked = (
        state.positions[:, shell.design.mechanism.inner_columns]
        for state in (shell.motion.flat, shell.motion.target)
    )
    radii = np.linalg.norm(locked[..., :2], axis=-1)
    return {
        "inner radius": float(radii.min()),
        "outer radius": float(radii.max()),
        "rise": float(np.ptp(locked[..., 2])),
        "turn_deg": turn_deg(locked),
        "flat_turn_deg": turn_deg(flat),
    }


def turn_deg(positions: NDArray[np.float64]) -> float:
    """By how much the columns turn from the first to the last."""
    along = (positions[-1] - positions[0]) @ [1, 1j, 0]  # their directions seen from above
    return float(np.rad2deg(np.abs(np.angle(along[1:] / along[:-1]).sum())))


def main() -> None:
    """Print its sizes."""
    shell = design()
    size = measure(shell)
    print(f"ring from {size['inner radius']:.2f} to {size['outer radius']:.2f} m")
    print(f"rises by {size['rise']:.2f} m")
    print(f"turns by {size['turn_deg']:.1f} degrees, flat by {size['flat_turn_deg']:.1f}")
    print(f"locks by its {shell.report.lock.cause}")


if __name__ == "__main__":
    main()
