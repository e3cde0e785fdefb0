"""The paper's Figure 2 from Python: an orthodiagonal shell that stands on level ground.

Run it with ``python examples/figure2.py``; the design file beside it gives the same shell on the
command line.
"""

from __future__ import annotations

import numpy as np

from orishell import (
    Design,
    DesignError,
    FoldingMotion,
    curve_from_formulas,
    measure_residuals,
    parse_formula,
)
from orishell.families.orthodiagonal import OrthodiagonalPattern, design_orthodiagonal


def design(heading_deg: float = 90.0) -> Design:
    """Sweep f = -x**2 along g = 0.25 sin(pi x/2)."""
    f = curve_from_formulas(None, parse_formula("-x**2"), -1, 1)
    g = curve_from_formulas(None, parse_formula("0.25*sin(pi*x/2)"), 0, 4)
    return design_orthodiagonal(
        f,
        g,
        OrthodiagonalPattern(rows=9, columns=13, depth=0.12, heading_deg=heading_deg, flap=0.15),
    )


def main() -> None:
    """Print what the design is like, and what is said of one that cannot be made."""
    shell = design()
    motion = FoldingMotion(shell.mechanism, frames=25)
    residuals, _ = measure_residuals(motion, motion.flat)
    ground = motion.target.positions[[0, -1], :, 2]
    print(f"f is met to {shell.closeness['f'].max:.4f}, g to {shell.closeness['g'].max:.4f}")
    print(f"its ends stand on the ground to {np.ptp(ground):.0e}")
    print(f"panels keep their lengths to {residuals.panel_length:.1e} of the sheet's diagonal")
    try:
        design(heading_deg=60)
    except DesignError as error:
        print(error)


if __name__ == "__main__":
    main()
