"""Wind: its pressure by speed, terrain and height, and what of it acts on panels."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.units import conversion
from orishell.numerics.arrays import Array
from orishell.structure.exposure import Exposure
from orishell.structure.settings import Terrain, Wind

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

    Parameters
    ----------
    speed
        Basic wind speed (m/s).
    terrain
        The category of the terrain.
    height
        Over the ground (metres).
    """
    roughness, least = TERRAINS[terrain]
    logarithm = float(np.log(max(height, least) / roughness))
    rough = (roughness / TERRAINS["II"][0]) ** 0.07
    return float(0.19 * rough * logarithm * speed), 1 / logarithm


def peak_pressure(speed: float, terrain: Terrain, height: float) -> float:
    """Peak velocity pressure over flat ground, EN 1991-1-4, 4.5 (N/m^2).

    Parameters
    ----------
    speed
        Basic wind speed (m/s).
    terrain
        The category of the terrain.
    height
        Over the ground (metres).
    """
    mean, turbulence = gusts(speed, terrain, height)
    return (1 + 7 * turbulence) * 0.5 * AIR * mean**2


def wind_height(exposure: Exposure, wind: Wind) -> float:
    """The height over the ground that wind is given for (length)."""
    return exposure.rise if wind.height is None else wind.height


def wind_pressure(exposure: Exposure, wind: Wind) -> float:
    """Peak velocity pressure at the height that wind is given for (force per area)."""
    metres = conversion(exposure.unit, "m")
    height = wind_height(exposure, wind) * metres
    return peak_pressure(wind.speed, wind.terrain, height) * metres**2


def wind_load(exposure: Exposure, wind: Wind) -> Array:
    """Wind (T, 3) on every triangle (force per area).

    Raises
    ------
    InputError
        If zones leave a row of panels out, or take one twice.
    """
    pressure = wind_pressure(exposure, wind) * _coefficients(exposure, wind)
    return np.asarray(-pressure[:, None] * exposure.outer())


def _coefficients(exposure: Exposure, wind: Wind) -> Array:
    """Pressure coefficients (T,)."""
    zones = wind.zones
    if not zones:
        angles, sizes = np.array(wind.coefficients, np.float64).T
        against = -np.array([np.cos(wind.direction), np.sin(wind.direction), 0.0])
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
