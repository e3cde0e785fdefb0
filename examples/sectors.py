"""Sector angles and lengths without a target: what surface comes? The paper's Figure 3 asks so.

Run it with ``python examples/sectors.py``; the design file beside it gives the first of the two
sheets on the command line. The second is of the sine version of equation (4), which folds its S
rows to both sides and follows no curve.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from orishell import FoldingMotion, Shell, design_shell, measure_residuals
from orishell.families.longitudinal_linear_repeating import (
    LongitudinalPattern,
    design_longitudinal_linear_repeating,
)
from orishell.locking import Lock, end_motion


def cosine() -> Shell:
    """The sheet of the design file."""
    return design_shell(Path(__file__).with_suffix(".toml"))


def sine() -> tuple[FoldingMotion, Lock]:
    """The same sector angles in the sine version, 2 x 2 vertices, as even as they may be."""
    sheet = design_longitudinal_linear_repeating(
        None, None, LongitudinalPattern(rows=2, columns=2, sector_deg=[85, 80, 95, 100], solution=1)
    )
    design, lock = end_motion(sheet)
    return FoldingMotion(design.mechanism, frames=25), lock


def main() -> None:
    """Print what comes of either version."""
    report = cosine().report
    first, last = np.asarray(report.parameters["radius"], float)
    print(f"cosine version: rolls up, radius {first:.3f} at column 1, {last:.3f} at column 9")
    meet = np.rad2deg(report.lock.drive or np.nan)
    print(f"panels first touch at {meet:.4f} degrees of v_1: the last frame")
    motion, end = sine()
    residuals, _ = measure_residuals(motion, motion.flat)
    print(f"sine version: panels keep their lengths to {residuals.panel_length:.1e}")
    degrees = np.rad2deg(motion.mechanism.target_drive)
    print(f"it goes on to {degrees:.4f} degrees, where it is ended by a {end.cause}")


if __name__ == "__main__":
    main()
