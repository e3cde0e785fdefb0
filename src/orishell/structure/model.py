"""A design as a structure: its mesh, what holds it, and what it weighs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from orishell.conventions.quantities import conversion
from orishell.conventions.record import record
from orishell.design import Design
from orishell.motion import Mechanism
from orishell.motion.boards import Boards
from orishell.motion.grid import Grid, Vertex, VertexPair
from orishell.motion.quads import area_vectors
from orishell.numerics.arrays import Array
from orishell.solids import BuiltPanels
from orishell.structure.conditions import Conditions, between, joined, on_ground
from orishell.structure.factorise import hold
from orishell.structure.held import Held
from orishell.structure.hinges import hinge_elements, rigid_stiffness
from orishell.structure.results import Exposure
from orishell.structure.sections import Section, panel_sections
from orishell.structure.settings import Structure
from orishell.structure.sheet import SheetMesh, mesh_sheet
from orishell.structure.supports import Supports, find_supports


@dataclass(frozen=True, slots=True)
class Frame:
    """What a design has that is no part of its sheet."""

    unit: str  # its unit of length
    feet: tuple[int, int] | None  # rows of vertices that are its feet; None if it does not stand
    ties: tuple[VertexPair, ...]  # its ties, as pairs of rows and columns of the folding sheet
    areal_mass: float  # mass of panels per area; 0 if it is not known (kg per square of the unit)
    # its panels as they are built; None if the design gives them no thickness
    built: BuiltPanels | None


@record
class Model:
    """A design as a structure."""

    design: Design  # the design
    structure: Structure  # what is asked of it
    frame: Frame  # what else it has
    cells: int  # cells along every side of a panel
    stiffness: float  # of creases (force per radian)

    @cached_property
    def flapped(self) -> Mechanism:
        """The sheet with its flaps."""
        return self.design.clipped or self.design.mechanism

    @cached_property
    def sheet(self) -> Mechanism:
        """The sheet without its flaps."""
        return self.flapped.without_flaps()

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
        """The meshed sheet."""
        return mesh_sheet(self.positions, self.grid, self.cells)

    @cached_property
    def section(self) -> Section:
        """Sections of the triangles."""
        flat = mesh_sheet(self.sheet.positions(0.0), self.grid, self.cells).facets
        corners = flat.points[flat.triangles][..., :2]
        return panel_sections(
            self.structure, self.design.panel, self._boards(), corners, self.mesh.panels
        )

    def _boards(self) -> Boards | None:
        built = self.frame.built
        if built is None:
            return None
        # Boards of folded flaps are numbered with the sheet.
        row, column = np.divmod(built.boards.panels, self.design.mechanism.grid.columns - 1)
        column = column - self.before
        own = (column >= 0) & (column < self.grid.columns - 1)
        boards = built.boards.chosen(own)
        number = row[own] * (self.grid.columns - 1) + column[own]
        return Boards(number, boards.sides, boards.outlines)

    @cached_property
    def exposure(self) -> Exposure:
        """The mesh as loads see it."""
        facets, mass = self.mesh.facets, self.frame.areal_mass
        points = self.positions[list(self.frame.feet or (0, -1))]
        span = float(np.linalg.norm(np.diff(points.mean(axis=1), axis=0)))
        standing = self.frame.feet is not None
        return Exposure(
            mesh=facets,
            panels=self.mesh.panels,
            grid=self.grid,
            before=self.before,
            areal_mass=np.full(len(facets.triangles), mass),
            hung=mass * self._hung(),
            unit=self.frame.unit,
            ground=float(points[..., 2].min() if standing else facets.points[:, 2].min()),
            span=span if standing else None,
        )

    def _hung(self) -> Array:
        """Area (N,) of flaps, half of every panel at each of the vertices that it hangs on."""
        hung = np.zeros(len(self.mesh.facets.points))
        vertices, flat = self.grid.vertices(), self.flapped.positions(0.0)
        for panel, column in self._flap_columns():
            corners = np.stack(
                [
                    flat[:-1, panel],
                    flat[1:, panel],
                    flat[1:, panel + 1],
                    flat[:-1, panel + 1],
                ],
                axis=1,
            )
            area = np.linalg.norm(area_vectors(corners), axis=1)
            hung[vertices[:-1, column]] += 0.5 * area
            hung[vertices[1:, column]] += 0.5 * area
        return hung

    def _flap_columns(self) -> list[tuple[int, int]]:
        """Columns of panels that are flaps, and the column of this grid that each hangs on."""
        last = self.grid.columns - 1
        return [(panel, 0 if panel == 0 else last) for panel in self.flapped.flap_columns]

    def flaps(self) -> tuple[VertexPair, ...]:
        """Vertices that two neighbouring flaps keep apart, rows and columns of this grid."""
        return tuple(
            ((row - 1, column), (row + 1, column))
            for _, column in self._flap_columns()
            for row in range(1, self.grid.rows - 1)
        )

    def ties(self) -> tuple[VertexPair, ...]:
        """Its ties, rows and columns of this grid."""
        return tuple((self._own(first), self._own(last)) for first, last in self.frame.ties)

    def _own(self, vertex: Vertex) -> Vertex:
        return vertex[0], vertex[1] - self.before

    @cached_property
    def supports(self) -> Supports:
        """What holds it.

        Raises
        ------
        InputError
            If vertices that are to be held are not there.
        """
        inner, feet = self.sheet.inner_columns, self.frame.feet
        return find_supports(self.structure.supports, self.grid, inner, feet, self.before)

    def conditions(self) -> Conditions:
        """Ties, flaps and feet on the ground, one after the other."""
        points = self.mesh.facets.points
        ties, flaps = (
            np.array(
                [[self.grid.vertices()[each] for each in pair] for pair in pairs], np.int64
            ).reshape(-1, 2)
            for pairs in (self.ties(), self.flaps())
        )
        stretch = np.full(len(ties), self.structure.tie_stiffness)
        return joined(
            [
                between(points, ties, stretch, approach=False),
                between(points, flaps, np.full(len(flaps), np.inf), approach=True),
                on_ground(self.supports.ground, self.supports.friction),
            ]
        )

    @cached_property
    def held(self) -> Held:
        """The structure, factorised."""
        mesh = self.mesh
        elements = [mesh.elements(self.section)]
        if self.stiffness:
            springs = min(self.stiffness, rigid_stiffness(mesh, self.section))
            elements.append(hinge_elements(mesh, self.grid, springs))
        supported = self.supports.freedoms(mesh)
        return hold(elements, mesh, supported, self.conditions(), self.grid)

    def free_loads(self, forces: Array) -> Array:
        """Loads on free freedoms (n,) of forces on nodes (N, 3)."""
        loads = np.zeros(self.mesh.count)
        loads[: forces.size] = forces.ravel()
        return np.asarray(loads[self.held.free])

    def moved(self, displacements: Array) -> Array:
        """Displacements and rotations (D,), by displacements of free freedoms (n,)."""
        moved = np.zeros(self.mesh.count)
        moved[self.held.free] = displacements
        return moved

    def shape(self, displacements: Array) -> Array:
        """Displacements (N, 3) of nodes, by displacements of free freedoms (n,)."""
        return np.asarray(self.moved(displacements)[self.mesh.translations()])

    def furthest(self, displacements: Array) -> float:
        """The largest displacement of a node, by displacements of free freedoms (n,)."""
        return float(np.linalg.norm(self.shape(displacements), axis=1).max())

    def mass(self) -> Array:
        """Mass (N,) at every node (kg)."""
        exposure = self.exposure
        share = exposure.areal_mass * exposure.mesh.areas() / 3
        lumped = exposure.hung.copy()
        np.add.at(lumped, exposure.mesh.triangles, share[:, None])
        return lumped

    def inertia(self) -> Array:
        """Force by acceleration (D,) of every freedom, the latter in the design's unit."""
        inertia = np.zeros(self.mesh.count)
        translations = self.mesh.translations()
        inertia[translations] = conversion(self.frame.unit, "m") * self.mass()[:, None]
        return inertia


def models(design: Design, structure: Structure, frame: Frame, cells: int) -> Sequence[Model]:
    """The design with every stiffness of its creases, the least first.

    Parameters
    ----------
    cells
        Cells along every side of a panel.
    """
    stiffness = dict.fromkeys(structure.crease_stiffness)
    return [Model(design, structure, frame, cells, each) for each in stiffness]
