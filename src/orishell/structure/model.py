"""A design as a structure: its mesh, what holds it, and what it weighs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.deployment import Site
from orishell.design import Design
from orishell.motion import Mechanism
from orishell.motion.boards import Boards
from orishell.motion.grid import Grid, Panel, Vertex, VertexPair
from orishell.numerics.arrays import Array, Integers
from orishell.solids import BuiltPanels
from orishell.structure.changes import Changes, Stop
from orishell.structure.exposed import expose
from orishell.structure.flaps import between_flaps, kept_apart
from orishell.structure.grain import grain_turns
from orishell.structure.loads import Exposure
from orishell.structure.masses import point_masses
from orishell.structure.mesh.arms import joint_elements
from orishell.structure.mesh.boards import LEAST_CELLS, HingedPlates, mesh_boards
from orishell.structure.mesh.elements import Elements
from orishell.structure.mesh.frames import Frame
from orishell.structure.mesh.hinges import rigid_stiffness
from orishell.structure.mesh.parts import Plates
from orishell.structure.mesh.plane import strains_along
from orishell.structure.mesh.sections import Section, panel_sections
from orishell.structure.mesh.sheet import SheetMesh, centres
from orishell.structure.mesh.stresses import turns_in_panels
from orishell.structure.rail import lay_rails, rail_masses
from orishell.structure.settings import Structure
from orishell.structure.solve.conditions import Conditions, between, joined, on_ground
from orishell.structure.solve.factorise import factorise
from orishell.structure.solve.factorised import Factorised
from orishell.structure.stiffened import Stiffened
from orishell.structure.stiffness import Stiffness, stiffness_in_words
from orishell.structure.supports import Supports, find_supports
from orishell.structure.whole_boards import corners_at_vertices, plates_of


@record
class Model:
    """What is analysed."""

    REPORTED = (
        "nodes", "triangles", "freedoms", "cells", "change", "stopped", "mass", "height",
        "thickness", "structure.material", "structure.grain", "structure.sandwich",
        "structure.modulus",
        "structure.poisson", "structure.membrane_modulus", "membrane_stiffness",
        "bending_stiffness", "shear_stiffness", "crease_stiffness", "tie_stiffness",
        "structure.strength", "structure.crease_strength", "structure.tie_strength",
        "structure.line_strength", "structure.edge_strength", "lever",
        "structure.membrane_strength", "structure.arm_modulus", "structure.arm_strength",
        "displacement_limit", "structure.imperfection",
        "structure.supports", "structure.rail",
    )  # fmt: skip

    design: Design  # the design
    structure: Structure  # what is asked of it
    site: Site  # where it stands, what ties it, and what it weighs
    cells: int  # cells along every side of a panel
    built: BuiltPanels | None = None  # its panels, if they have a thickness
    change: Changes = Changes()  # by how much figures still change with the mesh
    stopped: Stop | None = None  # why cells are no finer although ``refine`` asks for it

    def with_refinement(self, change: Changes, stopped: Stop | None) -> Model:
        """The model with what refinement found; what was found of it is kept."""
        found = replace(self, change=change, stopped=stopped)
        named = {each.name for each in fields(self)}
        vars(found).update({k: v for k, v in vars(self).items() if k not in named})
        return found

    @property
    def least_cells(self) -> int:
        """How many cells there are at least along a side of a panel."""
        return LEAST_CELLS if self.design.has_whole_boards else self.stiffened.least_cells

    @property
    def nodes(self) -> int:
        """Nodes of the mesh."""
        return self.mesh.node_count

    @property
    def triangles(self) -> int:
        """Triangles of the mesh."""
        return len(self.mesh.facets.triangles)

    @property
    def freedoms(self) -> int:
        """Degrees of freedom of the mesh."""
        return self.mesh.count

    @property
    def mass(self) -> float:
        """Of all panels (kg)."""
        return float(point_masses(self.exposure).sum())

    @property
    def height(self) -> float:
        """Of the shell between its flaps."""
        facets = self.mesh.facets
        return float(np.ptp(facets.points[facets.triangles, 2]))

    @property
    def displacement_limit(self) -> float | None:
        """How far it may be displaced (length); None if nobody says so.

        A span is that between its feet; without feet, its longer side in plan.
        """
        asked = self.structure.displacement_limit
        if not isinstance(asked, str):
            return asked
        of, _, parts = asked.partition("/")
        facets = self.mesh.facets
        plan = np.ptp(facets.points[facets.triangles, :2], axis=(0, 1)).max()
        whole = self.height if of == "height" else self.exposure.span or float(plan)
        return whole / int(parts)

    @property
    def thickness(self) -> float:
        """Of panels."""
        panel = self.design.panel
        thickness = self.structure.thickness if panel is None else panel.thickness
        assert thickness is not None
        return thickness

    @property
    def lever(self) -> float:
        """Lever arm of what locks creases: as asked, or the most that there is room for.

        Hinges are at a face of solid panels, which meet at the other one; a membrane is in the
        middle.
        """
        asked, build = self.structure.crease_lever, self.design.panel
        between = build is not None and build.membrane
        return asked or (0.5 if between else 1.0) * self.thickness

    @property
    def membrane_stiffness(self) -> tuple[float, float]:
        """Of the sections of panels, the least and the largest: force per length by strain."""
        return _range(self.section.membrane)

    @property
    def bending_stiffness(self) -> tuple[float, float]:
        """Of the sections of panels, the least and the largest: moment per length by curvature."""
        return _range(self.section.bending)

    @property
    def shear_stiffness(self) -> tuple[float, float] | None:
        """Of boards with a core, across them, likewise: force per length by shear strain."""
        return None if self.structure.sandwich is None else _range(self.section.shear)

    @property
    def crease_stiffness(self) -> tuple[Stiffness, Stiffness]:
        """The least and the largest with which all is analysed."""
        low, high = self.structure.crease_stiffness
        return stiffness_in_words(low), stiffness_in_words(high)

    @property
    def tie_stiffness(self) -> float | None:
        """Force by strain; None if ties do not stretch."""
        stiffness = self.structure.tie_stiffness
        return stiffness if np.isfinite(stiffness) else None

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

    @cached_property
    def plates(self) -> tuple[Plates, ...]:
        """What stiffens the sheet: all gussets, or strips of box girders and plates across."""
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
        """Corners (F, 4, 2) of panels in the flat sheet, counter-clockwise."""
        return self.sheet.positions(0.0).reshape(-1, 3)[self.grid.faces_vertices(), :2]

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

    @cached_property
    def exposure(self) -> Exposure:
        """The mesh as loads see it."""
        asked, count = self.structure.rail, len(self.mesh.facets.points)
        hung = rail_masses(asked, self.rails, count, self.site.unit)
        if self.design.boxes:
            hung += self.stiffened.hung(count)
        return expose(self.design, self.site, self.mesh, (self.sheet, self.before), hung)

    @cached_property
    def rails(self) -> tuple[Frame, ...]:
        """Base rails that join its feet.

        Raises InputError: If one is asked for, and there are no feet that it could join.
        """
        asked, points = self.structure.rail, self.mesh.facets.points
        sheet = self.grid, self.before
        return lay_rails(asked, self.standing, points, sheet, self.site.unit)

    @cached_property
    def flaps(self) -> tuple[VertexPair, ...]:
        """Vertices that two neighbouring flaps keep apart: of the folding sheet, as all are."""
        return kept_apart(self.design.flapped, self.grid, self.before)

    def nodes_of(self, pairs: Sequence[VertexPair]) -> Integers:
        """Nodes (m, 2) at pairs of vertices of the folding sheet."""
        vertices = self.grid.vertices()
        nodes = [[vertices[row, column - self.before] for row, column in pair] for pair in pairs]
        return np.array(nodes, np.int64).reshape(-1, 2)

    def panel_at(self, number: int) -> Panel:
        """Row and column in the folding sheet of a panel of this grid."""
        row, column = divmod(number, self.grid.columns - 1)
        return row, column + self.before

    @property
    def supported(self) -> tuple[Vertex, ...]:
        """Supported vertices of the folding sheet."""
        rows, columns = np.divmod(self.supports.vertices(), self.grid.columns)
        return tuple(zip(rows.tolist(), (columns + self.before).tolist(), strict=True))

    @property
    def grounded(self) -> dict[Vertex, float]:
        """Vertices of the folding sheet that stand on the ground, and its friction there."""
        rows, columns = np.divmod(self.supports.ground, self.grid.columns)
        at = zip(rows.tolist(), (columns + self.before).tolist(), strict=True)
        return dict(zip(at, self.supports.friction.tolist(), strict=True))

    @property
    def standing(self) -> Integers | None:
        """Vertices (F,) that are its feet; None if it does not stand."""
        feet = self.site.feet
        if feet is None:
            return None
        if feet.points:
            at = [(row, column - self.before) for row, column in feet.points]
            return np.asarray(self.grid.vertices()[tuple(np.transpose(at))])
        rows = self.grid.vertices()[list(feet.rows), self.sheet.inner_columns]
        return np.asarray(rows.ravel())

    @cached_property
    def supports(self) -> Supports:
        """What holds it.

        Raises InputError: If vertices that are to be held are not there.
        """
        asked, inner = self.structure.supports, self.sheet.inner_columns
        return find_supports(asked, self.mesh, self.grid, inner, self.standing, before=self.before)

    def conditions(self) -> Conditions:
        """Ties, flaps and feet on the ground, one after the other."""
        points = self.mesh.facets.points
        ties, flaps = self.nodes_of(self.site.ties), self.nodes_of(self.flaps)
        stretch = np.full(len(ties), self.structure.tie_stiffness)
        return joined(
            [
                between(points, ties, stretch, approach=False),
                between(points, flaps, np.full(len(flaps), np.inf), approach=True),
                on_ground(self.supports.ground, self.supports.friction),
            ]
        )

    @cached_property
    def elements(self) -> Elements:
        """The triangles as elements."""
        return self.mesh.elements(self.section)

    def factorised(self, stiffness: float) -> Factorised:
        """The structure with creases of a stiffness (force per radian), factorised."""
        mesh = self.mesh
        springs = min(stiffness, rigid_stiffness(mesh, self.section))
        elements = [self.elements, *joint_elements(mesh, self.grid, springs)]
        elements += self.plate_elements
        elements += [rail.elements(mesh.count) for rail in self.rails]
        supported = self.supports.dofs(mesh)
        return factorise(elements, mesh, supported, self.conditions(), self.grid)


def _range(values: ArrayLike) -> tuple[float, float]:
    return float(np.min(values)), float(np.max(values))
