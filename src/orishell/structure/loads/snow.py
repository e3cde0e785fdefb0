"""Snow, EN 1991-1-3."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import plain
from orishell.structure.load_settings import Snow
from orishell.structure.loads.cases import Effect, called
from orishell.structure.loads.exposure import UP, Exposure

FULL, NONE = np.deg2rad(30), np.deg2rad(60)
"""Up to the first slope all snow lies that lies on a roof, from the second on none (radians)."""


@called("snow")
def snow(exposure: Exposure, asked: Snow) -> Effect:
    """Down on the plan of panels, EN 1991-1-3.

    Raises InputError: If a cylinder has no span.
    """
    level = np.clip(exposure.outer()[:, 2], 0, 1)
    slope = np.arccos(level)
    if asked.shape == "slope":
        share = 0.8 * np.clip((NONE - slope) / (NONE - FULL), 0, 1)
        rule = "mu_1 by the slope of each panel"
    else:
        rise, span = exposure.rise, exposure.span
        if span is None:
            raise InputError(
                "there are no feet, so there is no span",
                where="snow shape",
                got='"cylinder"',
                expected="a shell that stands on the two ends of f",
                remedy='shape = "slope"',
            )
        coefficient = min(0.2 + 10 * rise / span, 2.0)  # mu_3 of 5.3.5
        share = np.where(slope < NONE, coefficient, 0.0)
        rule = (
            f"mu_3 = {plain(coefficient)} by a rise of {plain(rise)} and a span of {plain(span)} "
            f"{exposure.unit}, to a slope of 60 degrees"
        )
    forces = exposure.on_corners(-(asked.ground * share * level)[:, None] * UP)
    return Effect(forces, asked.ground, f"{rule}, on plan areas (EN 1991-1-3)")
