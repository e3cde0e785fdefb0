"""Own weight, and pressure all over."""

from __future__ import annotations

from orishell.conventions.quantities import GRAVITY
from orishell.structure.loads.cases import Effect, load
from orishell.structure.loads.exposure import UP, Exposure


@load("own weight")
def self_weight(exposure: Exposure, _: bool) -> Effect:
    """Down on panels, and on the nodes that flaps hang on."""
    panels = exposure.on_corners(exposure.areal_mass[:, None] * UP)
    forces = -GRAVITY * (panels + exposure.hung[:, None] * UP)
    return Effect(forces, None, f"mass of panels times {GRAVITY:g} m/s2")


@load("pressure")
def pressure(exposure: Exposure, size: float) -> Effect:
    """Square on the outer face."""
    forces = exposure.on_corners(-size * exposure.outer())
    return Effect(forces, size, "square on the outer face")
