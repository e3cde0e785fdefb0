"""A sheet with what stiffens it: one mesh of both, and what it is made of and weighs.

Gussets are plates on edges of columns, box girders strips that hang on panels and plates across
them, a second skin a sheet on walls that hang on panels. All of them are hinged on the sheet: they
share nodes with it, and have rotations of their own.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from orishell.conventions.record import record
from orishell.deployment import Site
from orishell.design import Design
from orishell.design.part import Part
from orishell.motion.carried import Carried
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array
from orishell.structure.carried import (
    between_flaps,
    parts_of,
    plates_across,
    stops_of,
    strip_masses,
    strip_sections,
    strips_of,
)
from orishell.structure.mesh.parts import MeshedPart, Plates, join_parts
from orishell.structure.mesh.plate_edges import at_edges
from orishell.structure.mesh.plates import LEAST_STANDING, mesh_plates
from orishell.structure.mesh.sections import Section, whole_section
from orishell.structure.mesh.sheet import SheetMesh, mesh_sheet
from orishell.structure.mesh.stops import Stops, plate_line
from orishell.structure.settings import Structure


@record
class Stiffened:
    """A sheet between its flaps, and what stiffens it, if anything does."""

    design: Design
    structure: Structure  # what is asked of it
    site: Site  # what it weighs
    grid: Grid  # of the sheet without its flaps
    before: int  # columns of folded flaps before the first column of that grid
    positions: Array  # its vertices (rows, columns, 3) at the target
    cells: int  # cells along every side of a panel

    @property
    def is_bare(self) -> bool:
        """Whether nothing stiffens it."""
        return not (self.design.plates or self.design.carried)

    @property
    def has_plates(self) -> bool:
        """Whether there are gussets, or plates across box girders."""
        return bool(self.plate_parts)

    @property
    def plate_parts(self) -> tuple[Part, ...]:
        """Gussets, or plates across box girders."""
        return self.design.plates or tuple(p for p in self.design.attached if p.kind == "plate")

    @property
    def least_cells(self) -> int:
        """How many cells there are at least along a side of a panel."""
        return 1 if self.is_bare else LEAST_STANDING

    @property
    def stops(self) -> Stops | None:
        """Where plates that stiffen the sheet end, or strips hang on it; None without any."""
        if self.carried:
            return stops_of(self.grid, self.carried)
        plates = [part.plate for part in self.design.plates if part.plate is not None]
        if not plates:
            return None
        assert len({each.share for each in plates}) == 1, "plates go along edges by one share"
        rows = [each.corner[0] for each in plates]
        return Stops.of_plates(self.grid, rows, plates[0].share)

    @property
    def carried(self) -> tuple[Carried, ...]:
        """What the sheet carries, over the sheet without its flaps."""
        return between_flaps(self.design.carried, self.before)

    @cached_property
    def sheet(self) -> SheetMesh:
        """The meshed sheet, with lines of nodes where what stiffens it ends, or hangs."""
        return mesh_sheet(self.positions, self.grid, self.cells, stops=self.stops)

    @cached_property
    def hung(self) -> tuple[MeshedPart, ...]:
        """What it carries: strips, as ``strips_of`` has them, then plates across box girders."""
        at, _ = plates_across(self.design, self.before)
        return parts_of(self.sheet, self.grid, self.carried, self.positions, at)

    @cached_property
    def joined(self) -> tuple[SheetMesh, tuple[Plates, ...]]:
        """The mesh of all, and in it all gussets, or strips that it carries and plates across."""
        if self.design.carried:
            return join_parts(self.sheet, self.hung)
        plates = [part.plate for part in self.design.plates if part.plate is not None]
        if not plates:
            return self.sheet, ()
        at = np.array([each.corner for each in plates]) - [0, self.before]
        line = plate_line(plates[0].share, self.cells)
        return join_parts(self.sheet, (mesh_plates(self.sheet, self.grid, at, line),))

    @cached_property
    def of_plates(self) -> Structure:
        """What is asked of plates that stiffen the sheet: the same, of their own material."""
        own = {part.material for part in self.design.plates if part.material}
        return self.structure.made_of(own.pop(), self.site.unit) if own else self.structure

    @cached_property
    def sections(self) -> tuple[Section, ...]:
        """Sections of what stiffens the sheet, as ``joined`` has it."""
        if self.design.carried:
            made = self.structure, self.design.panel, strips_of(self.design)
            return strip_sections(*made, self.hung)
        return tuple(whole_section(self.of_plates, each.panel) for each in self.design.plates[:1])

    @cached_property
    def masses(self) -> tuple[Array, ...]:
        """Mass of what stiffens the sheet, mesh by mesh, by nodes of its panels' own (kg).

        That of plates is at their edges.
        """
        every, strips = self.joined[1], self.strip_masses
        of = self.site.areal_mass, self.site.metres
        mass = np.array([part.mass(*of) for part in self.plate_parts])
        found, first = [*strips], 0
        for each in every[len(strips) :]:
            count = len(each.own.nodes)
            share = at_edges(each.own, fixed=(0, 1, 2, 3) if self.design.carried else (0, 3))
            found.append((mass[first : first + count, None] * share).ravel())
            first += count
        return tuple(found)

    @cached_property
    def strip_masses(self) -> tuple[Array, ...]:
        """Mass of every mesh of strips by nodes of its panels' own (kg)."""
        strips = strips_of(self.design)
        return strip_masses(strips, self.joined[1], self.design.panel, self.site)

    def hung_masses(self, count: int) -> Array:
        """Mass of strips at so many nodes (count,) (kg); plates are borne at vertices."""
        found = np.zeros(count)
        for strip, masses in zip(self.joined[1], self.strip_masses, strict=False):
            np.add.at(found, strip.nodes[strip.own.nodes.ravel()], masses)
        return found
