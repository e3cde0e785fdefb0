"""Wind, EN 1991-1-4.

Limit: combinations, snow and gusts of wind follow EN 1990 and EN 1991, without the values of a
country. Pressure coefficients of wind are those that you give; without any they are of no code, and
a warning says so.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.formatting import in_degrees
from orishell.conventions.quantities import conversion, plain
from orishell.numerics.arrays import Array, Booleans
from orishell.structure.load_settings import Terrain, Wind, Zone
from orishell.structure.loads.cases import Effect, Scale, load
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


BEYOND = (0.05, 0.5)
"""Ratios of rise to span between which figure 7.11 has coefficients."""
ALONG = np.sqrt(0.5)
"""Zones of vaults are for wind across them, up to 45 degrees; the cosine of that."""

SPEEDS = (5.0, 75.0)
"""A gentle breeze; more than any code's basic wind speed (m/s)."""


def _doubt(asked: Wind, _: Scale) -> str:
    if SPEEDS[0] <= asked.speed <= SPEEDS[1]:
        return ""
    hourly = plain(3.6 * asked.speed, 3)
    return f"wind speed = {asked.speed:g} is in metres per second: {hourly} km/h"


@load("wind", _doubt)
def wind(exposure: Exposure, asked: Wind) -> Effect:
    """Square on panels, and along them.

    Raises InputError: If zones leave a row of panels out, or take one twice, or there is no vault,
    or the wind blows along it.
    """
    metres = conversion(exposure.unit, "m")
    height = exposure.rise if asked.height is None else asked.height
    mean, turbulence = gusts(asked.speed, asked.terrain, height * metres)
    peak = peak_pressure(mean, turbulence) * metres**2
    coefficients, words, caution = _coefficients(exposure, asked)
    rule = (
        f"{asked.speed:g} m/s towards {in_degrees(asked.direction)} degrees from x, terrain "
        f"{asked.terrain}, {plain(height)} {exposure.unit} over the ground: mean wind "
        f"{plain(mean)} m/s, turbulence {plain(turbulence, 3)} (EN 1991-1-4, 4.3 to 4.5); pressure "
        f"coefficients {words}"
    )
    if asked.internal:
        coefficients = coefficients - asked.internal[0]
        rule += f", less {asked.internal[0]:g} inside (5.2, 7.2.9)"
    per_area = -(peak * coefficients)[:, None] * exposure.outer()
    if asked.friction:
        swept, distance = _swept(exposure, asked.direction)
        drag = peak * asked.friction * _blows(asked.direction)
        per_area[swept, :2] += drag
        area = float(exposure.mesh.areas()[swept].sum())
        rule += (
            f"; friction {asked.friction:g} on {plain(area)} {exposure.unit}2, which is what lies "
            f"more than {plain(distance)} {exposure.unit} behind the windward end (7.5)"
        )
    return Effect(exposure.on_corners(per_area), peak, rule, caution)


OF_NO_CODE = "pressure coefficients of wind are of no code: give those of yours"


def _blows(direction: float) -> Array:
    """Where the wind blows to: a unit vector (2,)."""
    return np.array([np.cos(direction), np.sin(direction)])


def _coefficients(exposure: Exposure, asked: Wind) -> tuple[Array, str, str]:
    """External pressure coefficients (T,), how they come about, and what is to be said of them."""
    if asked.vault is not None:
        return _vault(exposure, asked, np.array(asked.vault))
    if asked.zones:
        return _by_rows(exposure, asked.zones), "by rows of panels", ""
    angles, sizes = np.array(asked.coefficients, np.float64).T
    against = -np.append(_blows(asked.direction), 0.0)
    facing = np.arccos(np.clip(exposure.outer() @ against, -1, 1))
    words = "by the angle between each panel and the wind"
    found = np.interp(facing, np.deg2rad(angles), sizes)
    if asked.is_of_no_code:
        return np.asarray(found), f"{words}, of no code", OF_NO_CODE
    return np.asarray(found), words, ""


def _vault(exposure: Exposure, asked: Wind, zones: Array) -> tuple[Array, str, str]:
    """By zones of vaulted roofs, 7.2.8 and figure 7.11, wherever panels look.

    zones: Coefficients of A, the quarter of the width to windward, B, the half in the middle, and
    C, the quarter to leeward.
    """
    across, way = exposure.across()
    along = way @ _blows(asked.direction)
    if abs(along.mean()) < ALONG - 1e-9:
        raise InputError(
            "zones of a vault are for wind that blows across it",
            where="wind vault",
            got=f"direction_deg = {asked.direction_deg:g}",
            expected="at most 45 degrees off the way from foot to foot",
            remedy="zones of rows, or coefficients by angles, for wind along it",
        )
    from_windward = np.where(along > 0, across, 1 - across)
    assert exposure.span is not None
    ratio = exposure.rise / exposure.span
    words = (
        f"{zones[0]:g}, {zones[1]:g}, {zones[2]:g} in zones A, B, C of a vault, by quarters of its "
        f"width (7.2.8; figure 7.11 is to be read at f/d = {plain(ratio, 3)}, h/d = 0)"
    )
    caution = ""
    if not BEYOND[0] <= ratio <= BEYOND[1]:
        caution = (
            f"figure 7.11 of EN 1991-1-4 has no pressure coefficients for vaults of f/d = "
            f"{plain(ratio, 3)}, only from {BEYOND[0]:g} to {BEYOND[1]:g}"
        )
    return np.asarray(zones[np.digitize(from_windward, [0.25, 0.75])]), words, caution


def _by_rows(exposure: Exposure, zones: Sequence[Zone]) -> Array:
    """Coefficients (T,) by zones of rows."""
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
    return np.asarray(of_rows[exposure.rows])


def _swept(exposure: Exposure, direction: float) -> tuple[Booleans, float]:
    """Triangles (T,) that the air rubs along, 7.5, and how far behind the windward end they begin.

    That is the smaller of 2 b and 4 h: b is the width across the wind, h the height.
    """
    x, y = _blows(direction)
    plan = exposure.mesh.points[exposure.mesh.triangles, :2].reshape(-1, 2)
    distance = min(2 * float(np.ptp(plan @ [-y, x])), 4 * exposure.rise)
    behind = exposure.centroids()[:, :2] @ [x, y] - (plan @ [x, y]).min()
    return behind > distance, distance
