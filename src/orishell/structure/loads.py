"""Loads of a case as forces on the nodes of the mesh, and where each comes from.

The load on a triangle goes to its corners in equal shares, so that nothing of it is lost. A new
load is a field of :class:`~orishell.structure.settings.LoadCase`, and a function here of the same
name.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeVar

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.formatting import in_degrees
from orishell.conventions.quantities import GRAVITY, conversion, plain
from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.triangle import Facets
from orishell.structure.settings import LOADS, LoadCase, PointLoad, Snow, Terrain, Wind

if TYPE_CHECKING:
    LoadKind = str
else:
    LoadKind = Literal[LOADS]
Vector = tuple[float, float, float]
UP = np.array([0.0, 0.0, 1.0])


def vector(values: Array) -> Vector:
    """Three numbers (3,) as files have them."""
    x, y, z = values.tolist()
    return x, y, z


@record
class Exposure:
    """What is loaded, and how it stands."""

    mesh: Facets  # nodes (N, 3) and triangles (T, 3), all panels' cells one way round
    panels: Integers  # the panel (T,) of every triangle, as the grid counts it
    grid: Grid  # the grid of the sheet between its flaps; its vertices are the first nodes
    # number of columns of folded flaps before its first column, which points are counted with
    before: int
    areal_mass: Array  # mass (T,) per area of every triangle (kg per square of the unit)
    hung: Array  # mass (N,) of flaps that hang on nodes (kg)
    unit: str  # the design's unit of length
    ground: float  # height of the ground (length)
    span: float | None  # from foot to foot; None if it does not stand on two feet (length)

    @property
    def rise(self) -> float:
        """Height of its top over the ground (length)."""
        return float(self.mesh.points[:, 2].max()) - self.ground

    def outer(self) -> Array:
        """Unit normals (T, 3) of the outer face: that which looks up, all panels together."""
        normals = self.mesh.axes()[:, 2]
        up = float(self.mesh.areas() @ normals[:, 2])
        return -normals if up < 0 else normals

    def on_corners(self, per_area: Array) -> Array:
        """Loads (T, 3) per area of triangles as forces (N, 3) on nodes."""
        shared = np.zeros_like(self.mesh.points)
        each = (self.mesh.areas()[:, None] * per_area)[:, None] / 3
        np.add.at(shared, self.mesh.triangles, each)
        return shared


@record
class Load:
    """What one kind of load adds to a case."""

    WRITTEN = ("case", "factor", "kind", "pressure", "rule", "force")

    case: str  # the case that has it: another one where that is combined
    factor: float  # by which it is combined
    kind: LoadKind  # what it is
    forces: Array  # on nodes (N, 3), times the factor (N)
    # what it comes from: the pressure, snow on the ground, wind's peak velocity pressure; None for
    # own weight and forces at points
    pressure: float | None
    rule: str  # how it comes from that, in words
    caution: str  # what an engineer should read of it; empty if nothing

    @property
    def force(self) -> Vector:
        """Sum of its forces, times the factor."""
        return vector(self.forces.sum(axis=0))


class Effect(NamedTuple):
    """What a load does; the fields are those of :class:`Load`."""

    forces: Array
    pressure: float | None
    rule: str
    caution: str = ""


EFFECTS: dict[str, Callable[[Exposure, Any], Effect]] = {}
"""What a load does, by the key of a case that asks for it."""
KINDS: dict[str, str] = {}
"""What loads are called, by the same keys."""
Effects = TypeVar("Effects", bound=Callable[..., Effect])


def _called(words: str) -> Callable[[Effects], Effects]:
    """Register what the load of a function's name does, and what it is called."""

    def register(effect: Effects) -> Effects:
        EFFECTS[effect.__name__], KINDS[effect.__name__] = effect, words
        return effect

    return register


def case_loads(exposure: Exposure, case: LoadCase, cases: Sequence[LoadCase]) -> tuple[Load, ...]:
    """All loads of a case, also of those among all ``cases`` that it combines.

    Raises InputError: If a vertex or a row of panels is not there, zones of wind leave one out, or
    snow on a cylinder is asked for where there is no span.
    """
    if case.combine:
        named = {each.name: each for each in cases}
        return tuple(
            replace(load, factor=factor, forces=factor * load.forces)
            for name, factor in case.combine.items()
            for load in case_loads(exposure, named[name], cases)
        )
    try:
        return tuple(
            Load(case.name, 1.0, kind, *effect(exposure, asked))
            for kind, effect in EFFECTS.items()
            if (asked := getattr(case, kind))
        )
    except InputError as error:
        raise error.at_key("load_case", f'[[load_case]] "{case.name}":') from None


def sum_forces(exposure: Exposure, loads: Sequence[Load]) -> Array:
    """Forces (N, 3) of all loads on the nodes (N)."""
    return np.asarray(sum((load.forces for load in loads), np.zeros_like(exposure.mesh.points)))


@_called("own weight")
def self_weight(exposure: Exposure, _: bool) -> Effect:
    """Down on panels, and on the nodes that flaps hang on."""
    panels = exposure.on_corners(exposure.areal_mass[:, None] * UP)
    forces = -GRAVITY * (panels + exposure.hung[:, None] * UP)
    return Effect(forces, None, f"mass of panels times {GRAVITY:g} m/s2")


@_called("pressure")
def pressure(exposure: Exposure, size: float) -> Effect:
    """Square on the outer face."""
    forces = exposure.on_corners(-size * exposure.outer())
    return Effect(forces, size, "square on the outer face")


FULL, NONE = np.deg2rad(30), np.deg2rad(60)
"""Up to the first slope all snow lies that lies on a roof, from the second on none (radians)."""


@_called("snow")
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


@_called("wind")
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


@_called("forces at points")
def points(exposure: Exposure, asked: Sequence[PointLoad]) -> Effect:
    """At single vertices.

    Raises InputError: If one of them is not there.
    """
    forces = np.zeros_like(exposure.mesh.points)
    grid, first = exposure.grid, exposure.before
    for number, each in enumerate(asked):
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
    return Effect(forces, None, f"at vertices {', '.join(str(list(each.at)) for each in asked)}")
