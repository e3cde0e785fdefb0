"""What a sheet carries as parts of a structure: meshes, sections and masses of strips and plates.

Hinges of strips turn freely, whatever the stiffness of the sheet's creases: on its lines, at its
own crease and between its panels a strip is never held more than it may be.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.deployment import Site
from orishell.design import Design, PanelSpec
from orishell.design.boxes import Box
from orishell.design.carried import CarriedPart
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.boards import Boards
from orishell.motion.carried import Carried
from orishell.motion.grid import Grid, Vertex
from orishell.motion.second_skin import OUTER
from orishell.motion.sleeves import Sleeve
from orishell.numerics.arrays import Array
from orishell.structure.mesh.girders import mesh_across, mesh_strips, stops_of_sleeves
from orishell.structure.mesh.parts import MeshedPart, Plates, number_nodes
from orishell.structure.mesh.sections import Section, panel_sections, whole_section
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.mesh.skins import mesh_skin, stops_of_walls
from orishell.structure.mesh.stops import Stops
from orishell.structure.settings import Structure

LEAST_JOINED = 0.2
"""Strips whose membrane nobody knows are in their plane as stiff as so many boards at least: boards
stand farther from the lines that they hang on than is averaged over, and nothing would hold them
there. It is said of such a structure."""


def between_flaps(carried: tuple[CarriedPart, ...], before: int) -> tuple[Carried, ...]:
    """Strips whose columns are counted without the columns of flaps before the first."""
    found = []
    for each in carried:
        lines, columns = each.strips.lines, each.strips.columns
        shifted = slice(columns.start - before, columns.stop - before)
        found.append(replace(each.strips, lines=replace(lines, columns=shifted)))
    return tuple(found)


def stops_of(grid: Grid, strips: tuple[Carried, ...]) -> Stops:
    """Where strips hang on the sheet, by columns of this grid."""
    sleeves = tuple(each for each in strips if isinstance(each, Sleeve))
    return stops_of_sleeves(grid, sleeves) if sleeves else stops_of_walls(grid, strips[1:], OUTER)


def parts_of(
    sheet: SheetMesh,
    grid: Grid,
    carried: tuple[Carried, ...],
    positions: Array,
    plates: Sequence[Vertex],
) -> tuple[MeshedPart, ...]:
    """The upper and the lower strip of each sleeve, then the plates across each that has some.

    Or a second skin and its walls.

    sheet: The mesh of the sheet, with lines of nodes where strips hang.
    carried: Strips whose columns are those of this grid.
    positions: Vertices (rows, columns, 3) of the sheet.
    plates: The vertices that plates go from.
    """
    sleeves = [each for each in carried if isinstance(each, Sleeve)]
    if not sleeves:
        return mesh_skin(sheet, grid, carried, positions)
    strips: list[MeshedPart] = []
    across: list[MeshedPart] = []
    first = sheet.node_count
    for each in sleeves:
        strips += mesh_strips(sheet, grid, each, each.carried(positions), first)
        first = 1 + int(max(part.nodes.max() for part in strips[-2:]))
    for number, each in enumerate(sleeves):
        columns = np.array([column for row, column in plates if row == each.row], np.int64)
        if len(columns):
            pair = strips[2 * number], strips[2 * number + 1]
            across.append(mesh_across(sheet, grid, each, columns, pair))
            first = number_nodes(across[-1].nodes, first)
    return (*strips, *across)


def plates_across(design: Design, before: int) -> tuple[tuple[Vertex, ...], tuple[str, ...]]:
    """The vertices that plates across boxes go from, without columns of flaps, and their names."""
    found = [part for part in design.attached if part.kind == "plate"]
    at = [part.borne_at[0].tolist() for part in found if part.borne_at is not None]
    return (
        tuple((row, column - before) for row, column in at),
        tuple(part.names[0] for part in found),
    )


def names_of(design: Design) -> tuple[str, ...]:
    """What panels of strips, and plates, are called: in the order of their meshes."""
    strips = [name for part in design.carried for name in part.names]
    return (*strips, *plates_across(design, 0)[1])


@record
class Strips:
    """What one mesh has of a part that the sheet carries."""

    part: CarriedPart
    first: int  # the first of its panels
    count: int  # and how many

    @property
    def boards(self) -> Boards | None:
        """Its boards, as panels of it alone; None if panels have no thickness."""
        boards = self.part.boards
        if boards is None:
            return None
        last = self.first + self.count
        own = boards.chosen((boards.panels >= self.first) & (boards.panels < last))
        return replace(own, panels=own.panels - self.first)

    @property
    def flat(self) -> Array:
        """Corners (F, 4, 2) of its panels in the flat sheet, counter-clockwise."""
        every = panels_laid_flat(self.part.strips)
        return every[self.first : self.first + self.count]


def strips_of(design: Design) -> tuple[Strips, ...]:
    """What meshes of strips have: those of a sleeve are meshed one by one, others together."""
    found = []
    for part in design.carried:
        count = len(part.names)
        size = count // 2 if isinstance(part, Box) else count
        found += [Strips(part, first, size) for first in range(0, count, size)]
    return tuple(found)


def strip_sections(
    structure: Structure,
    build: PanelSpec | None,
    strips: tuple[Strips, ...],
    parts: tuple[MeshedPart, ...],
) -> tuple[Section, ...]:
    """Sections of the triangles of every strip, and of plates across them.

    build: What panels are made of; None if they are of ``structure.thickness``.
    """
    found = []
    for own, part in zip(strips, parts, strict=False):
        assert part.middles is not None
        found.append(
            panel_sections(
                structure, build, own.boards, own.flat, part.middles, joined=LEAST_JOINED
            )
        )
    across = parts[len(strips) :]
    return (*found, *(whole_section(structure, build) for _ in across))


def membrane_warnings(design: Design, structure: Structure) -> Iterator[str]:
    """That what strips hang on is of a stiffness that nobody has given."""
    on_membrane = design.panel is not None and not design.panel.is_solid
    if design.carried and on_membrane and not structure.membrane_modulus:
        yield (
            "what the shell carries hangs on a membrane whose modulus is not given: in its plane "
            "it is taken to be as stiff as a tenth of the boards (membrane_modulus in [structure])"
        )


def strip_masses(
    strips: tuple[Strips, ...], plates: tuple[Plates, ...], build: PanelSpec | None, site: Site
) -> tuple[Array, ...]:
    """Mass of each mesh of strips by nodes of its panels' own (places,) (kg).

    Of its boards if their density is known, or by that of its area.
    """
    found = []
    for own, strip in zip(strips, plates, strict=False):
        boards, panels = own.boards, strip.own.panels
        areas = strip.own.facets.areas()
        whole = np.bincount(panels, areas)
        mass = site.areal_mass * whole
        if boards is not None and build is not None and build.density:
            volume = np.bincount(boards.panels, boards.volumes(), len(whole))
            mass = build.density * site.metres**3 * volume
        third = (mass / whole)[panels] * areas / 3
        found.append(np.zeros(strip.own.nodes.size))
        np.add.at(found[-1], strip.own.places, third[:, None])
    return tuple(found)
