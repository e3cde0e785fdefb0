"""Sheets with boards: small shells in millimetres, of card or of solid panels."""

from __future__ import annotations

from functools import cache

import numpy as np

from documents import boarded
from orishell import curve_from_formulas, parse_formula
from orishell.design import PanelSpec
from orishell.document import Document
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating

CARD = PanelSpec(
    thickness=4.2, construction="sandwich", membrane=0.2, density=650, membrane_density=800
)
SOLID = PanelSpec(thickness=4.2, construction="bevel", gap=0.4, density=650)
BUILDS = {"sandwich": CARD, "bevel": SOLID}


@cache
def boarded_document(
    construction: str = "sandwich", *, clipped: bool = False, relief: float = 0.0
) -> Document:
    """Half of Figure 1's shell, 250 mm long, with boards that let it fold to its target.

    With a ``relief`` the corners of its boards at vertex (2, 2) are cut off so far from it.
    """
    f = curve_from_formulas(None, parse_formula("-x**2/25"), -25, 25)
    g = curve_from_formulas(None, parse_formula("125*sin(pi*x/250)"), 0, 250)
    design = design_parallel_repeating(
        f, g, ParallelRepeatingPattern(rows=5, columns=5, xi_deg=50, flap=10.0 if clipped else 0.0)
    )
    if clipped:
        design = design.with_clipped_flaps()
    build = BUILDS[construction]
    reliefs = np.zeros((7, 5))
    reliefs[2, 2] = relief
    return boarded(
        design,
        build,
        "mm",
        frames=3,
        title="card",
        reliefs=reliefs if relief else None,
    )
