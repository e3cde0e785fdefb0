"""The paper's Figure 3 from Python: a shell whose radius grows along a line.

Run it with ``python examples/figure3.py``; the design file beside it gives the same shell on the
command line.
"""

from __future__ import annotations

import numpy as np

from orishell import Design, FoldingMotion, curve_from_formulas, measure_residuals, parse_formula
from orishell.families.longitudinal_linear_repeating import (
    LongitudinalPattern,
    Sectors,
    design_longitudinal_linear_repeating,
    find_solutions,
)

SECTORS = Sectors.from_degrees([85, 80, 95, 100])


def design() -> Design:
    """Sweep an arc along a line, column 1 with equal lengths."""
    f = curve_from_formulas(parse_formula("cos(t)"), parse_formula("sin(t)"), 0.3, 2.8416)
    g = curve_from_formulas(None, parse_formula("0*x"), 0, 2.93)
    return design_longitudinal_linear_repeating(
        f,
        g,
        LongitudinalPattern(
            rows=7, columns=9, sector_deg=SECTORS.degrees, column_lengths=[1.0] * 8
        ),
    )


def main() -> None:
    """Print the solutions of equation (4) and what the design is like."""
    for solution in find_solutions(SECTORS):
        angles = ", ".join(f"{angle:.2f}" for angle in solution.second.degrees)
        print(f"{solution.version} version: ({angles}), c = {solution.c:.6f}")
    shell = design()
    first, last = np.array(shell.parameters["radius"], dtype=float)
    print(f"v_1 = {shell.parameters['stage_deg']:.4f} degrees at the stage")
    print(f"f is met to {shell.closeness['f'].max:.4f}, the radius grows to {first / last:.2f} r")
    motion = FoldingMotion(shell.mechanism, frames=25)
    residuals, _ = measure_residuals(motion, motion.flat)
    print(f"panels keep their lengths to {residuals.panel_length:.1e} of the sheet's diagonal")


if __name__ == "__main__":
    main()
