"""A base rail: bars that join the feet of a row, in stiffness, mass and stress."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import conversion, plain
from orishell.conventions.record import record
from orishell.motion.grid import Grid, VertexPair
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import SOLVED, first_largest
from orishell.structure.materials import Duration, materials
from orishell.structure.mesh.frames import Bar, Frame
from orishell.structure.rail_settings import BaseRail
from orishell.structure.settings import StructureTable


def bar_of(asked: BaseRail, unit: str) -> Bar:
    """The section of a rail, in a design's unit."""
    made, area = materials()[asked.material], conversion(unit, "m") ** 2
    return Bar(
        modulus=made.modulus * area,
        shear=made.modulus * area / (2 * (1 + made.poisson)),
        width=asked.width,
        height=asked.height,
        wall=asked.wall or 0.5 * min(asked.width, asked.height),
    )


def mass_by_length(asked: BaseRail, unit: str) -> float:
    """The mass of a rail by its length (kg per unit)."""
    cubic = conversion(unit, "m") ** 3
    return materials()[asked.material].density * bar_of(asked, unit).area * cubic


@record
class AtRail:
    """Where the stress of a base rail is largest."""

    size: float  # how large it is
    between: VertexPair  # the feet beside it


def lay_rails(
    asked: BaseRail | None, feet: Integers | None, points: Array, sheet: tuple[Grid, int], unit: str
) -> tuple[Frame, ...]:
    """The rails along the rows of feet; none if none is asked for.

    feet: Vertices (F,) that are feet; None if the shell does not stand.
    points: Where nodes are (N, 3).
    sheet: The grid, and the number of columns of folded flaps before its first one.
    Raises InputError: If there are no two feet in a row, or bars are deeper than long.
    """
    if asked is None:
        return ()
    grid, before = sheet
    rows: dict[int, list[int]] = {}
    for foot in sorted(() if feet is None else feet.tolist()):
        rows.setdefault(foot // grid.columns, []).append(foot)
    lines = [np.array(row) for row in rows.values() if len(row) > 1]
    if not lines:
        raise InputError(
            "there are no feet that a base rail could join",
            where="[structure] rail",
            keys=("structure.rail",),
            got="no feet" if feet is None else "one foot in a row",
            expected="a shell that stands on the two ends of f, on several vertices each",
        )
    bar, columns = bar_of(asked, unit), grid.columns
    rails = tuple(
        Frame(
            line,
            points[line],
            bar,
            tuple((foot // columns, foot % columns + before) for foot in line.tolist()),
        )
        for line in lines
    )
    longest = max(float(rail.lengths.max()) for rail in rails)
    if max(bar.width, bar.height) > longest:
        raise InputError(
            "a base rail is deeper than it is long from foot to foot, and no bar",
            where="[structure] rail",
            keys=("structure.rail",),
            got=f"{plain(max(bar.width, bar.height))} {unit}",
            expected=f"at most {plain(longest)} {unit}",
        )
    return rails


def rail_masses(asked: BaseRail | None, rails: tuple[Frame, ...], count: int, unit: str) -> Array:
    """Masses (N,) of rails at so many nodes: half of each bar at either end (kg)."""
    found = np.zeros(count)
    by_length = 0.0 if asked is None else mass_by_length(asked, unit)
    for rail in rails:
        half = 0.5 * by_length * rail.lengths
        np.add.at(found, rail.nodes[:-1], half)
        np.add.at(found, rail.nodes[1:], half)
    return found


def worst_rail(rails: tuple[Frame, ...], displacements: Array) -> AtRail | None:
    """Where the stress of rails is largest, by displacements (N, 3); None without rails."""
    if not rails:
        return None
    stresses = np.concatenate([rail.stresses(displacements[rail.nodes]) for rail in rails])
    ends = [pair for rail in rails for pair in pairwise(rail.vertices)]
    worst = first_largest(stresses, SOLVED)
    return AtRail(float(stresses[worst]), ends[worst])


def used_rail(
    worst: AtRail | None, structure: StructureTable, duration: Duration, unit: str
) -> float | None:
    """The share of what a rail bears under loads of a duration; None without one."""
    if worst is None or structure.rail is None:
        return None
    return worst.size / structure.rail.bears(duration, structure.service_class, unit)
