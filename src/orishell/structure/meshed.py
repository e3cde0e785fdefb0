"""A design as a mesh: panels between flaps, what stiffens them, and their sections."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np

from orishell.conventions.record import record
from orishell.deployment import Site
from orishell.design import Design
from orishell.motion import Mechanism
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.boards import Boards
from orishell.motion.grid import Grid, Panel, VertexPair
from orishell.numerics.arrays import Array, Integers
from orishell.solids import BuiltPanels
from orishell.structure.changes import Changes, Stop
from orishell.structure.flaps import between_flaps
from orishell.structure.grain import grain_turns
from orishell.structure.mesh.boards import LEAST_CELLS, HingedPlates, mesh_boards
from orishell.structure.mesh.elements import Elements
from orishell.structure.mesh.lines import centres
from orishell.structure.mesh.parts import Plates
from orishell.structure.mesh.plane import strains_along
from orishell.structure.mesh.sections import Section, panel_sections
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.mesh.stresses import turns_in_panels
from orishell.structure.settings import Structure
from orishell.structure.stiffened import Stiffened
from orishell.structure.whole_boards import corners_at_vertices, plates_of


@record
class MeshedShell:
    """A shell at its target, meshed."""

    design: Design  # the design
    structure: Structure  # what is asked of it
    site: Site  # where it stands, what ties it, and what it weighs
    cells: int  # cells along every side of a panel
    built: BuiltPanels | None = None  # its panels, if they have a thickness
    change: Changes = Changes()  # by how much figures still change with the mesh
    stopped: Stop | None = None  # why cells are no finer although ``refine`` asks for it

    @property
    def least_cells(self) -> int:
        """How many cells there are at least along a side of a panel."""
        return LEAST_CELLS if self.design.has_whole_boards else self.stiffened.least_cells

    @property
    def thickness(self) -> float:
        """Of panels."""
        panel = self.design.panel
        thickness = self.structure.thickness if panel is None else panel.thickness
        assert thickness is not None
        return thickness

    @cached_property
    def sheet(self) -> Mechanism:
        """The sheet without its flaps."""
        return self.design.flapped.without_flaps()

    @property
    def grid(self) -> Grid:
        """The grid of the sheet without its flaps."""
        return self.sheet.grid

    @property
    def before(self) -> int:
        """Number of columns of folded flaps before the first column of that grid."""
        mechanism = self.design.mechanism
        return int(mechanism.inner_columns.start - self.sheet.inner_columns.start)

    @cached_property
    def positions(self) -> Array:
        """Vertices (rows, columns, 3) of the sheet without its flaps, at the target."""
        return self.sheet.positions(self.sheet.target_drive)

    @property
    def size(self) -> float:
        """Diagonal of its bounding box (length)."""
        return float(np.linalg.norm(np.ptp(self.positions, axis=(0, 1))))

    @cached_property
    def mesh(self) -> SheetMesh:
        """The meshed sheet, or its whole boards."""
        if self.design.has_whole_boards:
            return mesh_boards(self._plates(self.sheet.target_drive), self.grid, self.cells)
        return self.stiffened.joined[0]

    @cached_property
    def stiffened(self) -> Stiffened:
        """The sheet with what stiffens it, as it is meshed."""
        sheet = self.grid, self.before, self.positions, self.cells
        return Stiffened(self.design, self.structure, self.site, *sheet)

    @property
    def has_skin(self) -> bool:
        """Whether the sheet carries a second skin."""
        return bool(self.design.carried and not self.design.boxes)

    @property
    def has_end_walls(self) -> bool:
        """Whether walls close its ends, which are no part of the model."""
        return bool(self.design.end_walls)

    @cached_property
    def plates(self) -> tuple[Plates, ...]:
        """What stiffens the sheet: all gussets, or strips that it carries and plates across."""
        return () if self.stiffened.is_bare else self.stiffened.joined[1]

    @property
    def plate_masses(self) -> tuple[Array, ...]:
        """Mass of what stiffens the sheet, as ``plates`` has it, by nodes of panels' own (kg)."""
        return () if self.stiffened.is_bare else self.stiffened.masses

    @cached_property
    def plate_elements(self) -> tuple[Elements, ...]:
        """The triangles of what stiffens the sheet, as elements."""
        both = zip(self.plates, self.stiffened.sections, strict=True)
        return tuple(each.elements(section, self.mesh.count) for each, section in both)

    def vertices(self, drive: float) -> Array:
        """Nodes (V, 3) at the vertices of the sheet without its flaps, at a drive (radians).

        Of whole boards they are those corners that stand, and that ties are fixed to.
        """
        if self.design.has_whole_boards:
            return corners_at_vertices(self._plates(drive), self.mesh, self.grid)
        return self.sheet.positions(drive).reshape(-1, 3)

    def _plates(self, drive: float) -> HingedPlates:
        return plates_of(self.design, self.structure, self.sheet, drive)

    @cached_property
    def section(self) -> Section:
        """Sections of the triangles."""
        middles = centres(self.positions, self.cells, self.stiffened.stops)
        asked = self.structure
        found = panel_sections(asked, self.design.panel, self.boards, self.flat, middles)
        if asked.grain_moduli is None:
            return found
        cosine, sine = turns_in_panels(self.mesh)
        inside = grain_turns(self.flat, asked.grain)[0][self.mesh.panels]
        angle = np.arctan2(sine, cosine) + inside
        seen = strains_along(np.cos(angle), np.sin(angle))
        plane, bending = (
            seen.swapaxes(1, 2) @ each @ seen
            for each in asked.grain_moduli.in_axes(asked.grain, found.poisson)
        )
        return replace(found, grain_in_plane=plane, grain_in_bending=bending)

    @cached_property
    def flat(self) -> Array:
        """Corners (F, 4, 2) of panels as they are cut, counter-clockwise."""
        return panels_laid_flat(self.sheet)

    @property
    def boards(self) -> Boards | None:
        """Boards between its flaps, by panels of this grid."""
        built = self.built
        if built is None:
            return None
        return between_flaps(built.boards, self.design.mechanism.grid, self.grid, self.before)

    @property
    def bevelled(self) -> bool:
        """Whether chamfers leave less of its panels beside creases."""
        build = self.design.panel
        return build is not None and self.boards is not None and build.construction == "bevel"

    def nodes_of(self, pairs: Sequence[VertexPair]) -> Integers:
        """Nodes (m, 2) at pairs of vertices of the folding sheet."""
        vertices = self.grid.vertices()
        nodes = [[vertices[row, column - self.before] for row, column in pair] for pair in pairs]
        return np.array(nodes, np.int64).reshape(-1, 2)

    def panel_at(self, number: int) -> Panel:
        """Row and column in the folding sheet of a panel of this grid."""
        row, column = divmod(number, self.grid.columns - 1)
        return row, column + self.before

    @cached_property
    def elements(self) -> Elements:
        """The triangles as elements."""
        return self.mesh.elements(self.section)
