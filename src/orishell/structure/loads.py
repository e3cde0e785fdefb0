"""Loads of a case as forces on the nodes of the mesh.

The load on a triangle goes to its corners in equal shares, so that nothing of it is lost.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from orishell.conventions.formatting import in_one_line
from orishell.conventions.units import GRAVITY, conversion
from orishell.errors import InputError
from orishell.numerics.arrays import Array, Integers
from orishell.sheet.grid import Grid
from orishell.structure.facets import Facets
from orishell.structure.settings import LoadCase, PointLoad, Snow, Terrain, Wind, Zone

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
FULL, NONE = np.deg2rad(30), np.deg2rad(60)
"""Up to the first slope all snow lies that lies on a roof, from the second on none (radians)."""


@dataclass(frozen=True, slots=True, eq=False)
class Exposure:
    """What is loaded, and how it stands.

    Parameters
    ----------
    mesh
        Nodes (N, 3) and triangles (T, 3), all panels' cells one way round.
    panels
        The panel (T,) of every triangle, as the grid counts it.
    grid
        The grid of the sheet with its flaps, also clipped ones; its vertices are the first nodes.
    before
        Number of columns of clipped flaps before the first column of the folding sheet, and behind
        the last.
    areal_mass
        Mass (T,) per area of every triangle (kg per square of the unit).
    unit
        The design's unit of length.
    ground
        Height of the ground (length).
    span
        From foot to foot; None if it does not stand on two feet (length).
    """

    mesh: Facets
    panels: Integers
    grid: Grid
    before: int
    areal_mass: Array
    unit: str
    ground: float
    span: float | None

    __repr__ = in_one_line

    @property
    def rise(self) -> float:
        """Height of its top over the ground (length)."""
        return float(self.mesh.points[:, 2].max()) - self.ground

    def outer(self) -> Array:
        """Unit normals (T, 3) of the outer face: that which looks up, all panels together."""
        normals = self.mesh.axes()[:, 2]
        up = float(self.mesh.areas() @ normals[:, 2])
        return -normals if up < 0 else normals


def case_forces(exposure: Exposure, case: LoadCase, cases: Sequence[LoadCase]) -> Array:
    """Forces (N, 3) on the nodes in one load case (N).

    Parameters
    ----------
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
        parts = [
            factor * case_forces(exposure, named[name], cases) for name, factor in case.combine
        ]
        return np.asarray(np.sum(parts, axis=0))
    where = f'[[load_case]] "{case.name}":'
    areas = exposure.mesh.areas()[:, None]
    per_area = np.zeros((len(areas), 3))  # on every triangle
    if case.self_weight:
        per_area[:, 2] -= GRAVITY * exposure.areal_mass
    if case.pressure:
        per_area -= case.pressure * exposure.outer()
    try:
        if case.snow is not None:
            per_area[:, 2] -= _snow(exposure, case.snow)
        if case.wind is not None:
            pressure = wind_pressure(exposure, case.wind)
            per_area -= (pressure * _coefficients(exposure, case.wind))[:, None] * exposure.outer()
        points = _at_points(exposure, case.points)
    except InputError as error:
        raise error.located(where) from None
    return points + _on_corners(exposure.mesh, per_area * areas)


def peak_pressure(speed: float, terrain: Terrain, height: float) -> float:
    """Peak velocity pressure of EN 1991-1-4, 4.3 to 4.5, over flat ground (N/m^2).

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
    mean = 0.19 * (roughness / TERRAINS["II"][0]) ** 0.07 * logarithm * speed
    return float((1 + 7 / logarithm) * 0.5 * AIR * mean**2)


def wind_pressure(exposure: Exposure, wind: Wind) -> float:
    """Peak velocity pressure at the height that wind is given for (force per area)."""
    metres = conversion(exposure.unit, "m")
    height = exposure.rise if wind.height is None else wind.height
    return peak_pressure(wind.speed, wind.terrain, height * metres) * metres**2


def _snow(exposure: Exposure, snow: Snow) -> Array:
    """Snow (T,) on every triangle (force per its area)."""
    level = np.clip(exposure.outer()[:, 2], 0, 1)
    slope = np.arccos(level)
    if snow.shape == "slope":
        share = 0.8 * np.clip((NONE - slope) / (NONE - FULL), 0, 1)
    elif exposure.span is None:
        raise InputError(
            "there are no feet, so there is no span",
            where="snow shape",
            got='"cylinder"',
            expected="a shell that stands on the two ends of f",
            remedy='shape = "slope"',
        )
    else:
        share = np.where(slope < NONE, min(0.2 + 10 * exposure.rise / exposure.span, 2.0), 0.0)
    return np.asarray(snow.ground * share * level)


def _coefficients(exposure: Exposure, wind: Wind) -> Array:
    """Pressure coefficients (T,)."""
    zones = [each for each in wind.coefficients if isinstance(each, Zone)]
    if not zones:
        angles, sizes = np.array(wind.coefficients, np.float64).T
        against = -np.array([np.cos(wind.direction), np.sin(wind.direction), 0.0])
        facing = np.arccos(np.clip(exposure.outer() @ against, -1, 1))
        return np.asarray(np.interp(facing, angles, sizes))
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


def _at_points(exposure: Exposure, points: Sequence[PointLoad]) -> Array:
    """Forces (N, 3) at single vertices."""
    forces = np.zeros_like(exposure.mesh.points)
    rows, columns = exposure.grid.rows, exposure.grid.columns - 2 * exposure.before
    for number, each in enumerate(points):
        row, column = each.at
        if not (row < rows and column < columns):
            raise InputError(
                "there is no such vertex",
                where=f"points[{number}] at",
                got=f"[{row}, {column}]",
                expected=f"a row from 0 to {rows - 1}, a column from 0 to {columns - 1}",
            )
        forces[row * exposure.grid.columns + column + exposure.before] += each.force
    return forces


def _on_corners(mesh: Facets, forces: Array) -> Array:
    """Forces (T, 3) of triangles shared out to the nodes (N, 3)."""
    shared = np.zeros_like(mesh.points)
    np.add.at(shared, mesh.triangles, forces[:, None] / 3)
    return shared
