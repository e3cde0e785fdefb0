"""A second skin and its walls: sheets of panels that hang on a meshed sheet, and on each other.

The skin is meshed as the sheet is, with the same lines of nodes across columns, and has nodes of
its own. A wall's nodes along its two lines are those of the panels there, one on the sheet and one
on the skin, whose translations it shares; its rotations are its own, so that it is hinged there.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.errors import InputError
from orishell.motion.carried import Carried
from orishell.motion.grid import Grid
from orishell.motion.second_skin import INNER, OUTER
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.girders import line_at, shares_along
from orishell.structure.mesh.lines import centres_of, lines_down
from orishell.structure.mesh.parts import MeshedPart, number_nodes
from orishell.structure.mesh.sheet import SheetMesh, mesh_panels
from orishell.structure.mesh.stops import Stops


def stops_of_walls(grid: Grid, walls: Sequence[Carried], part: int) -> Stops:
    """Where walls hang on the sheet, or on the skin, by columns of its grid.

    Raises InputError: If more than two hang on one row of panels.
    """
    found = Stops.none(grid)
    lines = [(wall.columns, each) for wall in walls for each in wall.hung if each.part == part]
    for over, each in sorted(lines, key=lambda both: float(both[1].at[0])):
        columns = over if part == OUTER else slice(0, grid.columns)
        down, up = found.down[each.panels, columns], found.up[each.panels, columns]
        if np.isnan(down).all():
            down[:] = each.at
        elif np.isnan(up).all():
            up[:] = 1 - each.at
        else:
            raise InputError(
                "more than two walls hang on one row of panels of a second skin",
                where=f"in row {each.panels} of its panels",
                keys=("stiffeners.walls", "target.inner"),
                remedy="leave out walls",
            )
    return found


def mesh_skin(
    sheet: SheetMesh, grid: Grid, strips: Sequence[Carried], positions: Array
) -> tuple[MeshedPart, ...]:
    """Mesh a second skin, then each of its walls.

    sheet: The mesh of the sheet, with lines of nodes where walls hang.
    strips: The skin and its walls, whose columns are those of this grid.
    positions: Vertices (rows, columns, 3) of the sheet.
    """
    skin, *walls = strips
    cells, across = sheet.nodes.shape[1] - 1, grid.columns - 1
    between = np.arange(skin.columns.start, skin.columns.stop - 1)
    right = shares_along(sheet.facets.points[sheet.nodes[between, 0]])

    def meshed(strip: Carried, rows: Integers, stops: Stops | None) -> MeshedPart:
        """Strips beside these rows of panels of the sheet, whose nodes have no number yet."""
        places = strip.carried(positions)
        down = lines_down(places, cells, stops)
        own = mesh_panels(places, strip.grid, down, right)
        panels = (rows[:, None] * across + between).ravel()
        beside = panels[:, None] * 2 * cells**2 + np.arange(2 * cells**2)
        none = np.full(own.node_count, -1)
        return MeshedPart(own, none, beside.ravel(), centres_of(down, right))

    below = meshed(skin, skin.parallel, stops_of_walls(skin.grid, walls, INNER))
    first = number_nodes(below.nodes, sheet.node_count)
    points = {OUTER: sheet.facets.points, INNER: below.own.facets.points}
    panels = {
        OUTER: sheet.nodes.reshape(-1, across, cells + 1, cells + 1)[:, between],
        INNER: below.own.nodes.reshape(-1, len(between), cells + 1, cells + 1),
    }
    numbers = {OUTER: np.arange(sheet.node_count), INNER: below.nodes}
    found = [below]
    for wall in walls:
        row = next(each.panels for each in wall.hung if each.part == OUTER)
        part, places = meshed(wall, np.array([row]), None), wall.carried(positions)
        for each in wall.hung:
            on = panels[each.part][each.panels]
            line = line_at(points[each.part][on[:, :, 0]], places[each.line, :-1])
            own = part.own.nodes[:, 0 if each.line == 0 else -1]
            part.nodes[own] = numbers[each.part][on[:, line]]
        first = number_nodes(part.nodes, first)
        found.append(part)
    return tuple(found)
