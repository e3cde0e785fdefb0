"""Own weight, and pressure all over."""

from __future__ import annotations

from orishell.conventions.quantities import GRAVITY
from orishell.structure.loads.cases import Effect, Scale, load, no_doubt
from orishell.structure.loads.exposure import UP, Exposure

PRESSURE = (5.0, 100e3)
"""Half a millimetre of water; twenty times a crowd (N/m2)."""


@load("own weight", no_doubt)
def self_weight(exposure: Exposure, _: bool) -> Effect:
    """Down on panels, and on the nodes that flaps hang on."""
    panels = exposure.on_corners(exposure.areal_mass[:, None] * UP)
    forces = -GRAVITY * (panels + exposure.hung[:, None] * UP)
    return Effect(forces, None, f"mass of panels times {GRAVITY:g} m/s2")


def _doubt(size: float, scale: Scale) -> str:
    if PRESSURE[0] <= abs(size) / scale.area <= PRESSURE[1]:
        return ""
    return f"a pressure of {size:g} is {scale.per_area(size)}"


@load("pressure", _doubt)
def pressure(exposure: Exposure, size: float) -> Effect:
    """Square on the outer face."""
    forces = exposure.on_corners(-size * exposure.outer())
    return Effect(forces, size, "square on the outer face")
