"""Loads of a case as forces on the nodes of the mesh; wind by speed, terrain and height.

The load on a triangle goes to its corners in equal shares, so that nothing of it is lost.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import GRAVITY, conversion
from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.structure.results import Exposure
from orishell.structure.settings import LoadCase, PointLoad, Snow, Terrain, Wind

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


LoadKind = Literal["self_weight", "pressure", "snow", "wind", "points"]
"""The keys of a case that are loads."""
UP = np.array([0.0, 0.0, 1.0])
FULL, NONE = np.deg2rad(30), np.deg2rad(60)
"""Up to the first slope all snow lies that lies on a roof, from the second on none (radians)."""


@record
class Load:
    """What one kind of load adds to a case."""

    case: LoadCase  # the case that has it: another one where that is combined
    factor: float  # by which it is combined
    kind: LoadKind  # what it is
    forces: Array  # on nodes (N, 3), times the factor (N)


def case_loads(exposure: Exposure, case: LoadCase, cases: Sequence[LoadCase]) -> tuple[Load, ...]:
    """All loads of a case, also of those that it combines.

    Parameters
    ----------
    case
        The case.
    cases
        All cases, for those that it combines.

    Raises
    ------
    InputError
        If a vertex or a row of panels is not there, zones of wind leave one out, or snow on a
        cylinder is asked for where there is no span.
    """
    if case.combine:
        named = {each.name: each for each in cases}
        return tuple(
            replace(load, factor=factor, forces=factor * load.forces)
            for name, factor in case.combine.items()
            for load in case_loads(exposure, named[name], cases)
        )
    try:
        return tuple(Load(case, 1.0, *part) for part in _parts(exposure, case))
    except InputError as error:
        raise error.at_key("load_case", f'[[load_case]] "{case.name}":') from None


def case_forces(exposure: Exposure, case: LoadCase, cases: Sequence[LoadCase]) -> Array:
    """Forces (N, 3) on the nodes in one load case (N).

    Parameters
    ----------
    case
        The case.
    cases
        All cases, for those that it combines.

    Raises
    ------
    InputError
        As :func:`case_loads` does.
    """
    nothing = np.zeros_like(exposure.mesh.points)
    return np.asarray(sum((load.forces for load in case_loads(exposure, case, cases)), nothing))


def cylinder_coefficient(exposure: Exposure) -> float:
    """The coefficient mu_3 of snow on a cylinder, by rise and span, EN 1991-1-3, 5.3.5.

    Raises
    ------
    InputError
        If there is no span.
    """
    if exposure.span is None:
        raise InputError(
            "there are no feet, so there is no span",
            where="snow shape",
            got='"cylinder"',
            expected="a shell that stands on the two ends of f",
            remedy='shape = "slope"',
        )
    return min(0.2 + 10 * exposure.rise / exposure.span, 2.0)


def _parts(exposure: Exposure, case: LoadCase) -> Iterator[tuple[LoadKind, Array]]:
    """The loads that a case has itself: their kinds, and forces (N, 3) on the nodes."""
    if case.self_weight:
        panels = _on_corners(exposure, exposure.areal_mass[:, None] * UP)
        yield "self_weight", -GRAVITY * (panels + exposure.hung[:, None] * UP)
    if case.pressure:
        yield "pressure", _on_corners(exposure, -case.pressure * exposure.outer())
    if case.snow is not None:
        yield "snow", _on_corners(exposure, -_snow(exposure, case.snow)[:, None] * UP)
    if case.wind is not None:
        yield "wind", _on_corners(exposure, wind_load(exposure, case.wind))
    if case.points:
        yield "points", _at_points(exposure, case.points)


def _snow(exposure: Exposure, snow: Snow) -> Array:
    """Snow (T,) on every triangle (force per its area)."""
    level = np.clip(exposure.outer()[:, 2], 0, 1)
    slope = np.arccos(level)
    if snow.shape == "slope":
        share = 0.8 * np.clip((NONE - slope) / (NONE - FULL), 0, 1)
    else:
        share = np.where(slope < NONE, cylinder_coefficient(exposure), 0.0)
    return np.asarray(snow.ground * share * level)


def _at_points(exposure: Exposure, points: Sequence[PointLoad]) -> Array:
    """Forces (N, 3) at single vertices."""
    forces = np.zeros_like(exposure.mesh.points)
    grid, first = exposure.grid, exposure.before
    for number, each in enumerate(points):
        row, column = each.at
        if not (row < grid.rows and first <= column < first + grid.columns):
            raise InputError(
                "there is no such vertex between the flaps",
                where=f"points[{number}] at",
                got=f"[{row}, {column}]",
                expected=f"a row from 0 to {grid.rows - 1}, "
                f"a column from {first} to {first + grid.columns - 1}",
            )
        forces[row * grid.columns + column - first] += each.force
    return forces


def _on_corners(exposure: Exposure, per_area: Array) -> Array:
    """Loads (T, 3) per area of triangles as forces (N, 3) on nodes."""
    mesh = exposure.mesh
    shared = np.zeros_like(mesh.points)
    np.add.at(shared, mesh.triangles, (mesh.areas()[:, None] * per_area)[:, None] / 3)
    return shared
