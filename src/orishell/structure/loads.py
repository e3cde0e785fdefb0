"""Loads of a case as forces on the nodes of the mesh.

The load on a triangle goes to its corners in equal shares, so that nothing of it is lost.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.conventions.units import GRAVITY
from orishell.numerics.arrays import Array
from orishell.structure.exposure import Exposure
from orishell.structure.settings import LoadCase, PointLoad, Snow
from orishell.structure.wind import wind_load

LoadKind = Literal["self_weight", "pressure", "snow", "wind", "points"]
"""The keys of a case that are loads."""
UP = np.array([0.0, 0.0, 1.0])
FULL, NONE = np.deg2rad(30), np.deg2rad(60)
"""Up to the first slope all snow lies that lies on a roof, from the second on none (radians)."""


@record
class Load:
    """What one kind of load adds to a case.

    Parameters
    ----------
    case
        The case that has it: another one where that is combined.
    factor
        By which it is combined.
    kind
        What it is.
    forces
        On nodes (N, 3), times the factor (N).
    """

    case: LoadCase
    factor: float
    kind: LoadKind
    forces: Array


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
        raise error.located(f'[[load_case]] "{case.name}":') from None


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
