"""A design as a structure: its mesh, what holds it, and what it weighs."""

from __future__ import annotations

from dataclasses import fields, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from orishell.motion.grid import Vertex, VertexPair
from orishell.numerics.arrays import Integers
from orishell.structure.changes import Changes, Stop
from orishell.structure.exposed import expose
from orishell.structure.flaps import kept_apart
from orishell.structure.loads import Exposure
from orishell.structure.masses import point_masses
from orishell.structure.mesh.arms import joint_elements
from orishell.structure.mesh.frames import Frame
from orishell.structure.mesh.hinges import rigid_stiffness
from orishell.structure.meshed import MeshedShell
from orishell.structure.rail import lay_rails, rail_masses
from orishell.structure.solve.conditions import Conditions, between, joined, on_ground
from orishell.structure.solve.factorise import factorise
from orishell.structure.solve.factorised import Factorised
from orishell.structure.stiffness import Stiffness, stiffness_in_words
from orishell.structure.supports import Supports, find_supports


class Model(MeshedShell):
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

    def with_refinement(self, change: Changes, stopped: Stop | None) -> Model:
        """The model with what refinement found; what was found of it is kept."""
        found = replace(self, change=change, stopped=stopped)
        named = {each.name for each in fields(self)}
        vars(found).update({k: v for k, v in vars(self).items() if k not in named})
        return found

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
    def exposure(self) -> Exposure:
        """The mesh as loads see it."""
        asked, count = self.structure.rail, len(self.mesh.facets.points)
        hung = rail_masses(asked, self.rails, count, self.site.unit)
        if self.design.carried:
            hung += self.stiffened.hung_masses(count)
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
