"""Box girders of a design as parts of a structure: their meshes, their sections and masses.

Hinges of strips turn freely, whatever the stiffness of the sheet's creases: on its lines, at its
own crease and between its panels a strip is never held more than it may be.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from orishell.deployment import Site
from orishell.design import Design, PanelSpec
from orishell.design.boxes import Box
from orishell.motion.boards import Boards
from orishell.motion.grid import Grid, Vertex
from orishell.motion.sleeves import Sleeve
from orishell.numerics.arrays import Array
from orishell.structure.mesh.girders import mesh_across, mesh_strips
from orishell.structure.mesh.parts import MeshedPart, Plates, number_nodes
from orishell.structure.mesh.sections import Section, panel_sections, whole_section
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.settings import Structure


def sleeves_between_flaps(boxes: tuple[Box, ...], before: int) -> tuple[Sleeve, ...]:
    """Sleeves whose columns are counted without the columns of flaps before the first."""
    found = []
    for each in boxes:
        lines, columns = each.sleeve.lines, each.sleeve.columns
        shifted = slice(columns.start - before, columns.stop - before)
        found.append(replace(each.sleeve, lines=replace(lines, columns=shifted)))
    return tuple(found)


def parts_of(
    sheet: SheetMesh,
    grid: Grid,
    sleeves: tuple[Sleeve, ...],
    positions: Array,
    plates: Sequence[Vertex],
) -> tuple[MeshedPart, ...]:
    """The upper and the lower strip of each sleeve, then the plates across each that has some.

    sheet: The mesh of the sheet, with lines of nodes where strips hang.
    sleeves: Whose columns are those of this grid.
    positions: Vertices (rows, columns, 3) of the sheet.
    plates: The vertices that plates go from.
    """
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
    strips = [name for box in design.boxes for name in box.names]
    return (*strips, *plates_across(design, 0)[1])


def strip_sections(
    structure: Structure,
    build: PanelSpec | None,
    boxes: tuple[Box, ...],
    parts: tuple[MeshedPart, ...],
) -> tuple[Section, ...]:
    """Sections of the triangles of every strip, and of plates across them.

    build: What panels are made of; None if they are of ``structure.thickness``.
    """
    found = []
    for number, strip in enumerate(parts):
        if strip.middles is None:
            found.append(whole_section(structure, build))
            continue
        box, lower = boxes[number // 2], number % 2
        count = len(strip.own.nodes)
        own = lower * count + np.arange(count)
        faces = box.sleeve.grid.faces_vertices()[own]
        flat = box.sleeve.positions(0.0).reshape(-1, 3)[faces, :2]
        boards = None if box.boards is None else _of_strip(box.boards, lower * count, count)
        found.append(panel_sections(structure, build, boards, flat, strip.middles))
    return tuple(found)


def _of_strip(boards: Boards, first: int, count: int) -> Boards:
    """Boards of one strip, as panels of that alone."""
    own = boards.chosen((boards.panels >= first) & (boards.panels < first + count))
    return replace(own, panels=own.panels - first)


def strip_masses(
    boxes: tuple[Box, ...], plates: tuple[Plates, ...], build: PanelSpec | None, site: Site
) -> tuple[Array, ...]:
    """Mass of each strip by nodes of its panels' own (places,) (kg).

    Of its boards if their density is known, or by that of its area.
    """
    found = []
    for number, strip in enumerate(plates[: 2 * len(boxes)]):
        boards, panels = boxes[number // 2].boards, strip.own.panels
        areas = strip.own.facets.areas()
        whole = np.bincount(panels, areas)
        mass = site.areal_mass * whole
        if boards is not None and build is not None and build.density:
            first = (number % 2) * len(whole)
            own = _of_strip(boards, first, len(whole))
            volume = np.bincount(own.panels, own.volumes(), len(whole))
            mass = build.density * site.metres**3 * volume
        third = (mass / whole)[panels] * areas / 3
        found.append(np.zeros(strip.own.nodes.size))
        np.add.at(found[-1], strip.own.places, third[:, None])
    return tuple(found)
