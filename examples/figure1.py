"""The paper's Figure 1 from Python: design, one state, its fold angles.

Run it with ``python examples/figure1.py``; the design file beside it gives the same shell on the
command line.
"""

from __future__ import annotations

import numpy as np

from orishell import (
    Design,
    FoldingMotion,
    ParallelRepeatingPattern,
    curve_from_formulas,
    design_parallel_repeating,
    measure_residuals,
    parse_formula,
)


def design() -> Design:
    """Sweep f = -x**2 along g = 5 sin(pi x/10)."""
    f = curve_from_formulas(None, parse_formula("-x**2"), -1, 1)
    g = curve_from_formulas(None, parse_formula("5*sin(pi*x/10)"), 0, 20)
    return design_parallel_repeating(
        f, g, ParallelRepeatingPattern(rows=9, columns=11, xi_deg=50, flap=0.3)
    )


def main() -> None:
    """Print what the design is like."""
    shell = design()
    motion = FoldingMotion(shell.mechanism, frames=25)
    residuals, _ = measure_residuals(motion, motion.flat)
    half_folded = shell.mechanism.positions(np.pi / 2)
    print(f"{half_folded.shape[0]} x {half_folded.shape[1]} vertices")
    print(f"f is met to {shell.closeness['f'].max:.4f}, g to {shell.closeness['g'].max:.4f}")
    print(f"panels keep their lengths to {residuals.panel_length:.1e} of the sheet's diagonal")


if __name__ == "__main__":
    main()
