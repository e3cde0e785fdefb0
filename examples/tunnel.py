"""A covered way round a bend: one sheet that folds into a curved tunnel.

Run it with ``python examples/tunnel.py``; the design is in ``tunnel.toml`` beside it.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from orishell import Shell, design_shell


def design() -> Shell:
    """Design the tunnel, verify its motion, prove that it locks."""
    return design_shell(Path(__file__).with_suffix(".toml"))


def measure(shell: Shell) -> dict[str, float]:
    """Sizes of the tunnel, in metres."""
    locked = shell.motion.target.positions[:, shell.design.mechanism.inner_columns]
    away = np.linalg.norm(locked[..., :2] - [0, -8], axis=-1)  # from the bend's centre
    middle = locked[len(locked) // 2, :, :2]
    return {
        "width": float(np.ptp(away[[0, -1]], axis=0).min()),
        "length": float(np.linalg.norm(np.diff(middle, axis=0), axis=1).sum()),
        "headroom": float(np.interp(8, away[::-1, 0], locked[::-1, 0, 2]) - locked[0, 0, 2]),
        "turn_deg": float(np.rad2deg(np.ptp(np.arctan2(middle[:, 1] + 8, middle[:, 0])))),
        "uneven": float(np.ptp(locked[[0, -1], :, 2])),
        "from f": shell.design.closeness["f"].max,
    }


def main() -> None:
    """Print its sizes."""
    shell = design()
    size = measure(shell)
    print(f"{size['length']:.2f} m long round {size['turn_deg']:.1f} degrees")
    print(f"{size['width']:.2f} m wide, headroom {size['headroom']:.2f} m at the middle")
    print(f"stands on ground that is even to {size['uneven']:.0e} m")
    print(f"f is met to {size['from f']:.3f} m")
    print(f"locks by its {shell.report.lock.cause}")


if __name__ == "__main__":
    main()
