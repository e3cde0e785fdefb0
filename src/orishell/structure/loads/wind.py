"""Wind, EN 1991-1-4."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.formatting import in_degrees
from orishell.conventions.quantities import conversion, plain
from orishell.numerics.arrays import Array
from orishell.structure.load_settings import Terrain, Wind
from orishell.structure.loads.cases import Effect, called
from orishell.structure.loads.exposure import Exposure

TERRAINS: dict[Terrain, tuple[float, float]] = {
    "0": (0.003, 1.0),
    "I": (0.01, 1.0),
    "II": (0.05, 2.0),
    "III": (0.3, 5.0),
    "IV": (1.0, 10.0),
}
"""Roughness z_0 and least height z_min of EN 1991-1-4, table 4.1 (metres)."""
AIR = 1.25
"""Density of air (kg/m^3)."""


def gusts(speed: float, terrain: Terrain, height: float) -> tuple[float, float]:
    """Mean wind (m/s) and its turbulence over flat ground, EN 1991-1-4, 4.3 and 4.4.

    speed: Basic wind speed (m/s).
    height: Over the ground (metres).
    """
    roughness, least = TERRAINS[terrain]
    logarithm = float(np.log(max(height, least) / roughness))
    rough = (roughness / TERRAINS["II"][0]) ** 0.07
    return float(0.19 * rough * logarithm * speed), 1 / logarithm


def peak_pressure(mean: float, turbulence: float) -> float:
    """Peak velocity pressure of a mean wind (m/s), EN 1991-1-4, 4.5 (N/m^2)."""
    return (1 + 7 * turbulence) * 0.5 * AIR * mean**2


@called("wind")
def wind(exposure: Exposure, asked: Wind) -> Effect:
    """Square on panels, EN 1991-1-4.

    Raises InputError: If zones leave a row of panels out, or take one twice.
    """
    metres = conversion(exposure.unit, "m")
    height = exposure.rise if asked.height is None else asked.height
    mean, turbulence = gusts(asked.speed, asked.terrain, height * metres)
    peak = peak_pressure(mean, turbulence) * metres**2
    kind = "by the angle between each panel and the wind"
    if asked.is_of_no_code:
        kind += ", of no code"
    elif asked.zones:
        kind = "by rows of panels"
    rule = (
        f"{asked.speed:g} m/s towards {in_degrees(asked.direction)} degrees from x, terrain "
        f"{asked.terrain}, {plain(height)} {exposure.unit} over the ground: mean wind "
        f"{plain(mean)} m/s, turbulence {plain(turbulence, 3)} (EN 1991-1-4); pressure "
        f"coefficients {kind}"
    )
    sizes = peak * _coefficients(exposure, asked)
    forces = exposure.on_corners(-sizes[:, None] * exposure.outer())
    return Effect(forces, peak, rule, OF_NO_CODE if asked.is_of_no_code else "")


OF_NO_CODE = "pressure coefficients of wind are of no code: give those of yours"


def _coefficients(exposure: Exposure, asked: Wind) -> Array:
    """Pressure coefficients (T,)."""
    zones = asked.zones
    if not zones:
        angles, sizes = np.array(asked.coefficients, np.float64).T
        against = -np.array([np.cos(asked.direction), np.sin(asked.direction), 0.0])
        facing = np.arccos(np.clip(exposure.outer() @ against, -1, 1))
        return np.asarray(np.interp(facing, np.deg2rad(angles), sizes))
    of_rows = np.full(exposure.grid.rows - 1, np.nan)
    count = np.zeros(len(of_rows), np.int64)
    for zone in zones:
        first, last = zone.rows
        of_rows[first : last + 1] = zone.coefficient
        count[first : last + 1] += 1
    beyond = max(zone.rows[1] for zone in zones) >= len(of_rows)
    if beyond or (count != 1).any():
        raise InputError(
            "zones do not take every row of panels once",
            where="wind zones",
            got=", ".join(f"{first} to {last}" for first, last in (zone.rows for zone in zones)),
            expected=f"rows 0 to {len(of_rows) - 1}",
        )
    return np.asarray(of_rows[exposure.panels // (exposure.grid.columns - 1)])
