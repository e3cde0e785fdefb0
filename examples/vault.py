"""A vault whose section grows along its length: the third family, which no flap locks.

Run it with ``python examples/vault.py``; the design is in ``vault.toml`` beside it.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from orishell import Shell, design_shell


def design() -> Shell:
    """Design the vault, verify its motion, find how it ends."""
    return design_shell(Path(__file__).with_suffix(".toml"))


def measure(shell: Shell) -> dict[str, float]:
    """Sizes of the vault, in metres."""
    inner = shell.motion.target.positions[:, shell.design.mechanism.inner_columns]
    first, last = np.asarray(shell.report.parameters["radius"], float)
    return {
        "length": float(np.ptp(inner[len(inner) // 2, :, 0])),
        "largest radius": first,
        "smallest radius": last,
        "growth": first / last,
        "span": float(np.linalg.norm(inner[-1, 0] - inner[0, 0])),
        "stage_deg": np.rad2deg(shell.report.lock.target_drive),
        "contact_deg": np.rad2deg(shell.report.lock.drive or np.nan),
    }


def main() -> None:
    """Print its sizes, and how its motion ends."""
    shell = design()
    size = measure(shell)
    print(f"{size['length']:.2f} m long, spans {size['span']:.2f} m at its wide end")
    print(
        f"radius {size['smallest radius']:.2f} to {size['largest radius']:.2f} m, "
        f"{size['growth']:.2f} times as large"
    )
    print(
        f"meets f at {size['stage_deg']:.3f} degrees, touches itself at {size['contact_deg']:.3f}"
    )


if __name__ == "__main__":
    main()
